//! The operators of integers.

use super::{
    AddPullback, Arithmetic, DivPullback, MulPullback, NegPullback, Nothing, RemPullback,
    SubPullback,
};

/// Integers compute without a derivative, in differentiable functions too.
macro_rules! integer_operators {
    ($($type:ty),* $(,)?) => {$(
        impl Arithmetic for $type {}

        integer_operators!(@linear $type: AddPullback add_pullback add_jvp +, SubPullback sub_pullback sub_jvp -);
        integer_operators!(@binary $type:
            MulPullback mul_pullback mul_jvp *, DivPullback div_pullback div_jvp /,
            RemPullback rem_pullback rem_jvp %);
    )*};
    (@linear $type:ty: $($name:ident $method:ident $jvp:ident $operator:tt),*) => {$(
        impl $name for $type {
            type Kept = Nothing;

            #[inline(always)]
            fn $method(_: &Nothing, (): ()) -> ((), ()) {
                ((), ())
            }

            #[inline(always)]
            fn $jvp(self, rhs: Self, (): (), (): ()) -> (Self, ()) {
                (self $operator rhs, ())
            }
        }
    )*};
    (@binary $type:ty: $($name:ident $method:ident $jvp:ident $operator:tt),*) => {$(
        impl $name for $type {
            #[inline(always)]
            fn $method(self, _: Self, (): ()) -> ((), ()) {
                ((), ())
            }

            #[inline(always)]
            fn $jvp(self, rhs: Self, (): (), (): ()) -> (Self, ()) {
                (self $operator rhs, ())
            }
        }
    )*};
}

integer_operators!(i8, i16, i32, i64, i128, isize, u8, u16, u32, u64, u128, usize);

macro_rules! signed_integers {
    ($($type:ty),*) => {$(
        impl NegPullback for $type {
            type Kept = Nothing;

            #[inline(always)]
            fn neg_pullback(_: &Nothing, (): ()) {}

            #[inline(always)]
            fn neg_jvp(self, (): ()) -> (Self, ()) {
                (-self, ())
            }
        }
    )*};
}

signed_integers!(i8, i16, i32, i64, i128, isize);
