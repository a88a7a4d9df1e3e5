//! Derivatives of the methods of a queue: of a `VecDeque`.

use std::collections::VecDeque;

use super::in_place::in_place;
use crate::{Additive, Differentiable, Tangent};

/// Cotangents of the elements of a queue.
type Of<Q> = VecDeque<Tangent<<Q as DequeRules>::Element>>;

/// The first `len` cotangents, and no more.
fn fitted<T: Additive>(mut cotangent: VecDeque<T>, len: usize) -> VecDeque<T> {
    cotangent.resize_with(len, T::zero);
    cotangent
}

/// The `_vjp` and `_jvp` siblings of the methods of a `VecDeque`. What changes it changes its tangent
/// alike.
pub trait DequeRules {
    /// An element.
    type Element: Differentiable;

    /// The queue.
    fn queue(&mut self) -> &mut VecDeque<Self::Element>;

    in_place! {
        queue [Of<Self>] [Of<Self>]

        /// Takes the cotangent of the new element out.
        push_back(; value: Element) => |before, after, (), g| {
            g.truncate(after);
            let last = if g.len() > before { g.pop_back() } else { None };
            (g, last.unwrap_or_else(Additive::zero))
        };
        /// Takes the cotangent of the new element out.
        push_front(; value: Element) => |_, _, (), g| {
            let first = g.pop_front();
            (g, first.unwrap_or_else(Additive::zero))
        };
        /// Puts the cotangent of the removed element back. The tangent of `None` is zero.
        pop_back() -> Option<Self::Element>,
            |tangent| tangent.0.pop_back().unwrap_or_else(Additive::zero)
            => |before, after, last, g| {
                let mut g = fitted(g, after);
                if before > after {
                    g.push_back(last);
                }
                g
            };
        /// Puts the cotangent of the removed element back. The tangent of `None` is zero.
        pop_front() -> Option<Self::Element>,
            |tangent| tangent.0.pop_front().unwrap_or_else(Additive::zero)
            => |before, after, first, g| {
                if before > after {
                    g.push_front(first);
                }
                g
            };
        /// Nothing to what was there.
        clear() => |_, _, (), g| VecDeque::new();
        /// Nothing to what was removed.
        truncate(len: usize) => |_, after, (), g| (fitted(g, after), ());
        /// Changes places back.
        swap(i: usize, j: usize) => |_, len, (), g| {
            let mut g = fitted(g, len);
            g.swap(i, j);
            (g, (), ())
        };
        /// Turns the elements back.
        rotate_left(by: usize) => |_, len, (), g| {
            let mut g = fitted(g, len);
            g.rotate_right(by);
            (g, ())
        };
        /// Turns the elements back.
        rotate_right(by: usize) => |_, len, (), g| {
            let mut g = fitted(g, len);
            g.rotate_left(by);
            (g, ())
        };
    }
}

impl<T: Differentiable> DequeRules for VecDeque<T> {
    type Element = T;

    fn queue(&mut self) -> &mut VecDeque<T> {
        self
    }
}
