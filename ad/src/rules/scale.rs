//! Products of cotangents and partial derivatives, either of which may be infinite where the other is 0.

use crate::Real;

/// `cotangent * partial`, and 0 where the cotangent is 0, whatever the partial is.
#[inline(always)]
pub fn scale<S: Real>(cotangent: S, partial: S) -> S {
    S::select(cotangent.vanishes(), S::zero(), cotangent * partial)
}

/// [`scale`], and 0 where the partial is 0, whatever the tangent is: for the rules that forward mode
/// has part in. A tangent overflows where a number does, and the partial that follows is often 0.
#[inline(always)]
pub(crate) fn chain<S: Real>(tangent: S, partial: S) -> S {
    S::select(tangent.vanishes() | partial.vanishes(), S::zero(), tangent * partial)
}

/// Whether a number is infinite, and not NaN.
#[inline(always)]
pub(crate) fn is_infinite<S: Real>(number: S) -> S::Mask {
    number.cmpeq(number) & !number.is_finite()
}
