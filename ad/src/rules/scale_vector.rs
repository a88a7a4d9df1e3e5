//! [`scale`] for vectors.

use super::scale::scale;
use crate::vector::Vector;

/// [`scale`] of every element of `partial` by one cotangent.
#[inline(always)]
pub(crate) fn scale_vector<V: Vector>(cotangent: V::Scalar, partial: V) -> V {
    partial.map_elements(|p| scale(cotangent, p))
}

/// [`scale`] element by element.
#[inline(always)]
pub(crate) fn scale_elements<V: Vector>(cotangent: V, partial: V) -> V {
    cotangent.zip_elements(partial, scale)
}
