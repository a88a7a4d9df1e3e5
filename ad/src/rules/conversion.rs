//! The rules of conversions.

use super::linear::{Linear, Maps, Same, Zero};
use crate::{Differentiable, Tangent};

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

#[cfg(feature = "glam")]
pub(crate) use into;

// On any other type `into` may be a method of its own.
into! {
    f32; f64; bool; i8; i16; i32; u8; u16; u32;
    (f32, f32); (f32, f32, f32); (f32, f32, f32, f32);
    (f64, f64); (f64, f64, f64); (f64, f64, f64, f64);
    [f32; N], N; [f64; N], N;
}

/// The rules of `from`, by what is converted, to what, and the linear map that this makes of tangents.
macro_rules! conversions {
    ($($($from:ty),+ => $to:ty: $map:expr;)*) => {$($(
        impl FromRules<$from> for $to {
            #[inline(always)]
            fn from_vjp(value: $from) -> (Self, impl FnOnce(Tangent<Self>) -> Tangent<$from>) {
                (Self::from(value), |cotangent| {
                    Linear::<Tangent<$from>, Tangent<Self>>::pull($map, cotangent)
                })
            }

            #[inline(always)]
            fn from_jvp(value: $from, tangent: Tangent<$from>) -> (Self, Tangent<Self>) {
                (Self::from(value), Linear::<Tangent<$from>, Tangent<Self>>::push($map, tangent))
            }
        }
    )+)*};
}

#[cfg(feature = "glam")]
pub(crate) use conversions;

conversions! {
    f32 => f32: Same();
    f64 => f64: Same();
    f32 => f64: Maps(f64::from, |cotangent| cotangent as f32);
    bool, i8, i16, u8, u16 => f32: Zero();
    bool, i8, i16, i32, u8, u16, u32 => f64: Zero();
}
