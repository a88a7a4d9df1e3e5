//! Derivatives of the methods that only `f32` and `f64` have.

use super::chain;
use super::scalar::regular;
use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use crate::{Additive, Differentiable, Tangent};

macro_rules! float_rules {
    ($($(#[$doc:meta])* $name:ident = $method:ident($x:ident $(, $other:ident)?), $value:ident |$g:ident| $pulled:expr;)*) => {
        /// The `_vjp` siblings of methods of `f32` and `f64`.
        pub trait FloatRules: Differentiable<Tangent = Self> + Sized {
            $(
                $(#[$doc])*
                fn $name(self $(, $other: Self)?) -> (
                    Self,
                    impl FnOnce(Self) -> float_rules!(@parts $($other)?),
                );
            )*
        }

        float_rules!(@impl f32 f32: $([$name $method($x $(, $other)?), $value |$g| $pulled])*);
        float_rules!(@impl f64 f64: $([$name $method($x $(, $other)?), $value |$g| $pulled])*);
    };
    (@parts) => { Self };
    (@parts $other:ident) => { (Self, Self) };
    (@impl $type:ident $module:ident:
        $([$name:ident $method:ident($x:ident $(, $other:ident)?), $value:ident |$g:ident| $pulled:expr])*) => {
        impl FloatRules for $type {
            $(
                #[inline(always)]
                #[allow(refining_impl_trait, unused_variables)]
                fn $name(self $(, $other: Self)?) -> (
                    Self,
                    impl FnOnce(Self) -> float_rules!(@parts $($other)?),
                ) {
                    #[allow(unused_imports)]
                    use core::$module::consts::*;
                    let $x = self;
                    let $value = $type::$method($x $(, $other)?);
                    ($value, move |$g: Self| $pulled)
                }
            )*
        }
    };
}

float_rules! {
    /// x/|(x, y)| and y/|(x, y)|; 0 to both at the origin.
    hypot_vjp = hypot(x, y), norm |g| {
        let defined = norm != 0.0;
        (regular(defined, g, x / norm), regular(defined, g, y / norm))
    };
    /// A half to each.
    midpoint_vjp = midpoint(x, y), value |g| (0.5 * g, 0.5 * g);
    /// 1/(3 cbrt(x)^2); 0 at 0.
    cbrt_vjp = cbrt(x), root |g| regular(x != 0.0, g, 1.0 / (3.0 * root * root));
    /// cosh(x)
    sinh_vjp = sinh(x), value |g| chain(g, x.cosh());
    /// sinh(x)
    cosh_vjp = cosh(x), value |g| chain(g, x.sinh());
    /// 1/sqrt(x^2 + 1)
    asinh_vjp = asinh(x), value |g| chain(g, 1.0 / x.hypot(1.0));
    /// 1/sqrt(x^2 - 1); 0 at 1. One root for each factor: their product might overflow.
    acosh_vjp = acosh(x), value |g| {
        regular(x != 1.0, g, 1.0 / ((x - 1.0).sqrt() * (x + 1.0).sqrt()))
    };
    /// 1/(1 - x^2); 0 at -1 and 1.
    atanh_vjp = atanh(x), value |g| regular(x.abs() != 1.0, g, 1.0 / ((1.0 - x) * (1.0 + x)));
    /// 2^x ln(2)
    exp2_vjp = exp2(x), value |g| chain(g, value * LN_2);
    /// exp(x)
    exp_m1_vjp = exp_m1(x), value |g| chain(g, x.exp());
    /// 1/(1 + x); 0 at -1.
    ln_1p_vjp = ln_1p(x), value |g| regular(x != -1.0, g, 1.0 / (1.0 + x));
    /// 1/(x ln(2)); 0 at 0.
    log2_vjp = log2(x), value |g| regular(x != 0.0, g, LOG2_E / x);
    /// 1/(x ln(10)); 0 at 0.
    log10_vjp = log10(x), value |g| regular(x != 0.0, g, LOG10_E / x);
    /// 1/(x ln(b)) and -log(x)/(b ln(b)); 0 to both at x = 0, and where the base is 0 or 1.
    log_vjp = log(x, base), value |g| {
        let defined = x != 0.0 && base != 0.0 && base != 1.0;
        let recip = 1.0 / base.ln();
        (regular(defined, g, recip / x), regular(defined, g, -value * recip / base))
    };
    /// 1 and -div_euclid(x, y); the jumps carry no derivative.
    rem_euclid_vjp = rem_euclid(x, y), value |g| (g, -chain(g, x.div_euclid(y)));
    /// 0
    div_euclid_vjp = div_euclid(x, y), value |_g| (Self::zero(), Self::zero());
    /// 0
    ceil_vjp = ceil(x), value |_g| Self::zero();
    /// 0
    round_vjp = round(x), value |_g| Self::zero();
    /// 0
    round_ties_even_vjp = round_ties_even(x), value |_g| Self::zero();
    /// 0
    trunc_vjp = trunc(x), value |_g| Self::zero();
    /// 1; the jumps carry no derivative.
    fract_vjp = fract(x), value |g| g;
}

/// The siblings of `from` where it converts what has a derivative.
#[diagnostic::on_unimplemented(
    message = "the conversion from `{T}` to `{Self}` has no derivative",
    label = "is called with what has one",
    note = "convert it by a function or a method of your own, with `#[differentiable]` on it"
)]
pub trait FromRules<T: Differentiable>: Differentiable + Sized {
    /// The cotangent of what is converted.
    fn from_vjp(value: T) -> (Self, impl FnOnce(Tangent<Self>) -> Tangent<T>);

    /// The tangent, converted too.
    fn from_jvp(value: T, tangent: Tangent<T>) -> (Self, Tangent<Self>);
}

/// The siblings of `into`, which are those of `from`.
pub trait IntoRules<T: Differentiable>: Differentiable + Sized {
    /// The cotangent of what is converted.
    fn into_vjp(self) -> (T, impl FnOnce(Tangent<T>) -> Tangent<Self>);

    /// The tangent, converted too.
    fn into_jvp(self, tangent: Tangent<Self>) -> (T, Tangent<T>);
}

macro_rules! into {
    ($($type:ty $(, $length:ident)?;)*) => {$(
        impl<T: FromRules<Self> $(, const $length: usize)?> IntoRules<T> for $type {
            #[inline(always)]
            fn into_vjp(self) -> (T, impl FnOnce(Tangent<T>) -> Tangent<Self>) {
                T::from_vjp(self)
            }

            #[inline(always)]
            fn into_jvp(self, tangent: Tangent<Self>) -> (T, Tangent<T>) {
                T::from_jvp(self, tangent)
            }
        }
    )*};
}

// On any other type `into` may be a method of its own.
into! {
    f32; f64; bool; i8; i16; i32; u8; u16; u32;
    Vec2; Vec3; Vec4; DVec2; DVec3; DVec4;
    (f32, f32); (f32, f32, f32); (f32, f32, f32, f32);
    (f64, f64); (f64, f64, f64); (f64, f64, f64, f64);
    [f32; N], N; [f64; N], N;
}

macro_rules! from_floats {
    ($($from:ident $to:ident),*) => {$(
        impl FromRules<$from> for $to {
            #[inline(always)]
            fn from_vjp(value: $from) -> ($to, impl FnOnce($to) -> $from) {
                ($to::from(value), |g| g as $from)
            }

            #[inline(always)]
            fn from_jvp(value: $from, tangent: $from) -> ($to, $to) {
                ($to::from(value), $to::from(tangent))
            }
        }
    )*};
}

from_floats!(f32 f32, f32 f64, f64 f64);

macro_rules! from_integers {
    ($($from:ident $to:ident),*) => {$(
        impl FromRules<$from> for $to {
            #[inline(always)]
            fn from_vjp(value: $from) -> ($to, impl FnOnce($to)) {
                ($to::from(value), |_| ())
            }

            #[inline(always)]
            fn from_jvp(value: $from, (): ()) -> ($to, $to) {
                ($to::from(value), Self::zero())
            }
        }
    )*};
}

from_integers!(
    bool f32, i8 f32, i16 f32, u8 f32, u16 f32,
    bool f64, i8 f64, i16 f64, i32 f64, u8 f64, u16 f64, u32 f64
);
