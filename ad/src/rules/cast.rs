//! Pullbacks of `as`.

use crate::{Additive, Differentiable, Tangent};

/// The pullback of `self as To`.
///
/// There is none from a float to an integer: such a cast cuts the derivative, which has to be
/// said in so many words (`stop_gradient(x) as i32`).
#[diagnostic::on_unimplemented(
    message = "casting `{Self}` to `{To}` would cut the derivative without a word",
    label = "no derivative passes this cast",
    note = "write `ad::stop_gradient(x) as {To}` if that is what you mean"
)]
pub trait CastPullback<To: Differentiable>: Differentiable {
    /// The cotangent of the number before the cast.
    fn cast_pullback(self, cotangent: Tangent<To>) -> Tangent<Self>;

    /// The tangent of the number after the cast.
    fn cast_pushforward(self, tangent: Tangent<Self>) -> Tangent<To>;
}

/// A number that is cast to a type of which only the compiler knows what it is.
#[doc(hidden)]
#[inline(always)]
pub fn castable<From: CastPullback<To>, To: Differentiable>(number: From) -> From {
    number
}

macro_rules! between_floats {
    ($($from:ident $to:ident),*) => {$(
        impl CastPullback<$to> for $from {
            #[inline(always)]
            fn cast_pullback(self, cotangent: $to) -> $from {
                cotangent as $from
            }

            #[inline(always)]
            fn cast_pushforward(self, tangent: $from) -> $to {
                tangent as $to
            }
        }
    )*};
}

between_floats!(f32 f32, f32 f64, f64 f32, f64 f64);

macro_rules! from_integer {
    ($($from:ident)*) => {$(
        impl<To: Differentiable> CastPullback<To> for $from {
            #[inline(always)]
            fn cast_pullback(self, _: Tangent<To>) {}

            #[inline(always)]
            fn cast_pushforward(self, (): ()) -> Tangent<To> {
                Additive::zero()
            }
        }
    )*};
}

from_integer!(bool char i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize);
