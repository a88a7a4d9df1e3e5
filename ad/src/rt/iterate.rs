//! What loops over elements run over: the positions of elements.

use core::iter::{Product, StepBy, Sum, empty};
use core::ops::Range;

/// The starts of the windows of `size` elements, as `slice::windows` has them.
///
/// Panics where `size` is 0.
#[inline(always)]
pub fn windows(len: usize, size: usize) -> Range<usize> {
    assert!(size != 0, "window size must be non-zero");
    0..(len + 1).saturating_sub(size)
}

/// The starts of the whole chunks of `size` elements, as `slice::chunks_exact` has them.
///
/// Panics where `size` is 0.
#[inline(always)]
pub fn chunks_exact(len: usize, size: usize) -> StepBy<Range<usize>> {
    assert!(size != 0, "chunk size must be non-zero");
    (0..len - len % size).step_by(size)
}

/// The sum of nothing, bit for bit that of the standard library.
#[inline(always)]
pub fn empty_sum<T: Sum>() -> T {
    empty().sum()
}

/// The product of nothing.
#[inline(always)]
pub fn empty_product<T: Product>() -> T {
    empty().product()
}

/// The best item so far, of the type of `_candidate`.
#[inline(always)]
pub fn held<'b, T>(best: &'b Option<T>, _candidate: &T) -> Option<&'b T> {
    best.as_ref()
}
