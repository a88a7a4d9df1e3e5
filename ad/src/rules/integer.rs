//! Methods of integers, which carry no derivative.
//!
//! Generated code does not always know an integer from a number: a pattern that takes a pair apart
//! does not tell.

use crate::Differentiable;

macro_rules! integers {
    ($(#[$doc:meta])* $rules:ident for $types:tt
        $($name:ident $jvp:ident $vjp:ident ($($argument:ident: $ty:ty),*) -> $result:ty;)*) => {
        $(#[$doc])*
        pub trait $rules: Copy + Differentiable<Tangent = ()> {$(
            #[doc = concat!("No derivative flows through `", stringify!($name), "`.")]
            fn $vjp(self $(, $argument: $ty)*) -> ($result, fn(()) -> integers!(@nothing $($argument)*));

            #[doc = concat!("No derivative flows through `", stringify!($name), "`.")]
            fn $jvp(self $(, $argument: $ty)*, _: () $(, _: integers!(@unit $argument))*) -> ($result, ());
        )*}

        integers!(@impls $rules $types
            $($name $jvp $vjp ($($argument: $ty),*) -> $result;)*);
    };
    (@impls $rules:ident ($($integer:ident)*) $($methods:tt)*) => {
        integers!(@each $rules ($($integer)*) ($($methods)*));
    };
    (@each $rules:ident ($($integer:ident)*) $methods:tt) => {
        $(integers!(@impl $rules $integer $methods);)*
    };
    (@impl $rules:ident $integer:ident ($($name:ident $jvp:ident $vjp:ident ($($argument:ident: $ty:ty),*) -> $result:ty;)*)) => {
        impl $rules for $integer {$(
            #[inline(always)]
            fn $vjp(self $(, $argument: $ty)*) -> ($result, fn(()) -> integers!(@nothing $($argument)*)) {
                ($integer::$name(self $(, $argument)*), |()| integers!(@zero $($argument)*))
            }

            #[inline(always)]
            fn $jvp(self $(, $argument: $ty)*, _: () $(, _: integers!(@unit $argument))*) -> ($result, ()) {
                ($integer::$name(self $(, $argument)*), ())
            }
        )*}
    };
    (@unit $argument:ident) => { () };
    (@nothing) => { () };
    (@nothing $($argument:ident)+) => { ((), $(integers!(@unit $argument)),+) };
    (@zero) => { () };
    (@zero $($argument:ident)+) => { ((), $(integers!(@unit $argument)),+) };
}

integers! {
    /// The `_vjp` and `_jvp` siblings of the methods of integers.
    IntegerRules for (u8 u16 u32 u64 u128 usize i8 i16 i32 i64 i128 isize)
    min min_jvp min_vjp (other: Self) -> Self;
    max max_jvp max_vjp (other: Self) -> Self;
    clamp clamp_jvp clamp_vjp (low: Self, high: Self) -> Self;
    pow pow_jvp pow_vjp (exponent: u32) -> Self;
    div_euclid div_euclid_jvp div_euclid_vjp (other: Self) -> Self;
    rem_euclid rem_euclid_jvp rem_euclid_vjp (other: Self) -> Self;
    saturating_add saturating_add_jvp saturating_add_vjp (other: Self) -> Self;
    saturating_sub saturating_sub_jvp saturating_sub_vjp (other: Self) -> Self;
    saturating_mul saturating_mul_jvp saturating_mul_vjp (other: Self) -> Self;
    wrapping_add wrapping_add_jvp wrapping_add_vjp (other: Self) -> Self;
    wrapping_sub wrapping_sub_jvp wrapping_sub_vjp (other: Self) -> Self;
    wrapping_mul wrapping_mul_jvp wrapping_mul_vjp (other: Self) -> Self;
}

integers! {
    /// Those of the methods of integers with a sign.
    SignedRules for (i8 i16 i32 i64 i128 isize)
    abs abs_jvp abs_vjp () -> Self;
    signum signum_jvp signum_vjp () -> Self;
}
