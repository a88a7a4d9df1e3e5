//! Derivatives of the methods that change the length of a `Vec`.
//!
//! As in [`sequence`](super::sequence): a pullback gets the cotangent of the result, then that of what
//! the `Vec` holds afterwards, which may be shorter than the `Vec`.

use super::in_place::in_place;
use super::sequence::Elements;
use crate::{Additive, Differentiable, Tangent};

/// Cotangents of the elements of a `Vec`.
type Tangents<T> = Vec<Tangent<T>>;

/// Those of its elements.
type Of<V> = Tangents<<V as VecRules>::Element>;

/// The first `len` cotangents, and no more.
fn fitted<T: Additive>(mut cotangent: Vec<T>, len: usize) -> Vec<T> {
    cotangent.elements(len);
    cotangent.truncate(len);
    cotangent
}

/// The cotangents of the elements from `len` on, which the `Vec` did not have before.
fn new_ones<T>(cotangent: &mut Vec<T>, len: usize) -> Vec<T> {
    if cotangent.len() > len { cotangent.split_off(len) } else { Vec::new() }
}

/// Rules of methods that keep some elements: a row tells of each whether it is kept.
macro_rules! keeping {
    ($(
        $(#[$doc:meta])*
        $name:ident[$($generics:tt)*]($($function:ident: $F:ty)?) $(where Element: $bound:ident)?
        => |$elements:ident| $kept:expr;
    )*) => { pastey::paste! {$(
        #[doc = concat!("The pullback of `", stringify!($name), "`: to the places that the elements had which were kept.")]
        #[doc = ""]
        $(#[$doc])*
        #[doc = ""]
        /// It is boxed: an opaque type would hold on to what the function borrows.
        #[inline]
        #[allow(unused_mut, unused_parens)]
        fn [<$name _vjp>]<$($generics)*>(
            &mut self,
            $(mut $function: $F)?
        ) -> ((), Box<dyn FnOnce((), Of<Self>) -> (Of<Self> $(, keeping!(@unit $function))?)>)
        $(where Self::Element: $bound)?
        {
            let $elements = self.elements_mut();
            let kept = $kept;
            let pullback =
                move |(), cotangent| (of_kept(&kept, cotangent) $(, keeping!(@unit $function))?);
            ((), Box::new(pullback))
        }

        #[doc = concat!("The pushforward of `", stringify!($name), "`: keeps the tangents of the elements that are kept.")]
        #[inline]
        #[allow(unused_mut)]
        fn [<$name _jvp>]<$($generics)*>(
            &mut self,
            $(mut $function: $F,)?
            tangent: &mut Of<Self>,
            $(_: keeping!(@unit $function))?
        ) -> ((), ())
        $(where Self::Element: $bound)?
        {
            let $elements = self.elements_mut();
            let mut kept = $kept.into_iter();
            tangent.retain(|_| kept.next().unwrap_or(false));
            ((), ())
        }
    )*}};
    (@unit $function:ident) => { () };
}

/// The `_vjp` and `_jvp` siblings of the methods of a `Vec`. What changes it changes its tangent alike.
pub trait VecRules {
    /// An element.
    type Element: Differentiable;

    /// The `Vec`.
    fn elements_mut(&mut self) -> &mut Vec<Self::Element>;

    in_place! {
        elements_mut [Of<Self>] [Of<Self>]

        /// Takes the cotangent of the new element out.
        push(; value: Element) => |before, after, (), g| {
            g.truncate(after);
            let last = if g.len() > before { g.pop() } else { None };
            (g, last.unwrap_or_else(Additive::zero))
        };
        /// Puts the cotangent of the removed element back. The tangent of `None` is zero.
        pop() -> Option<Self::Element>,
            |tangent| tangent.0.pop().unwrap_or_else(Additive::zero)
            => |before, after, last, g| {
                g.resize_with(after, Additive::zero);
                if before > after {
                    g.push(last);
                }
                g
            };
        /// Nothing to what was there.
        clear() => |_, _, (), g| Vec::new();
        /// Takes the cotangents of the new elements out.
        extend_from_slice(; source: Slice)
            where Element: Clone => |before, _, (), g| {
                let new = new_ones(&mut g, before);
                (g, new)
            };
        /// Takes the cotangent of the new element out.
        insert(index: usize; value: Element) => |_, after, (), g| {
            let mut before = fitted(g, after);
            let inserted = before.remove(index);
            (before, (), inserted)
        };
        /// Puts the cotangent of the removed element back.
        remove(index: usize) -> Self::Element => |_, after, removed, g| {
            let mut before = fitted(g, after);
            before.insert(index, removed);
            (before, ())
        };
        /// Puts the cotangent of the removed element back, and that of the last one at the end.
        swap_remove(index: usize) -> Self::Element
            => |_, after, removed, g| {
                let mut before = fitted(g, after);
                before.push(removed);
                before.swap(index, after);
                (before, ())
            };
        /// Nothing to what was removed.
        truncate(len: usize) => |_, after, (), g| (fitted(g, after), ());
        /// To the value, the sum of the cotangents of its copies; nothing to what was removed.
        resize(len: usize; value: Element)
            where Element: Clone => |before, after, (), g| {
                let mut kept = fitted(g, after);
                let to_value = crate::rt::sum(kept.drain(before.min(after)..));
                (kept, (), to_value)
            };
        /// Joins the cotangents of both parts.
        split_off(at: usize) -> Vec<Self::Element>
            => |_, after, rest, g| {
                let mut before = fitted(g, after);
                before.extend(rest);
                (before, ())
            };
    }

    /// The same for elements that are handed over.
    #[inline]
    fn extend_vjp<I>(
        &mut self,
        items: I,
    ) -> ((), impl FnOnce((), Of<Self>) -> (Of<Self>, Tangent<I>) + use<Self, I>)
    where
        I: IntoIterator<Item = Self::Element>
            + Differentiable<Tangent: Elements<Tangent<Self::Element>>>,
    {
        let elements = self.elements_mut();
        let len = elements.len();
        elements.extend(items);
        ((), move |(), mut cotangent| {
            let new = new_ones(&mut cotangent, len);
            (cotangent, Elements::from_copy(new))
        })
    }

    /// Appends the tangents of elements that are handed over.
    #[inline]
    fn extend_jvp<I>(
        &mut self,
        items: I,
        tangent: &mut Of<Self>,
        items_tangent: Tangent<I>,
    ) -> ((), ())
    where
        I: IntoIterator<Item = Self::Element>
            + Differentiable<Tangent: IntoIterator<Item = Tangent<Self::Element>>>,
    {
        self.elements_mut().extend(items);
        tangent.extend(items_tangent);
        ((), ())
    }

    /// Takes the cotangents of the new elements out. Nothing to what the other holds afterwards:
    /// it is empty.
    #[inline]
    fn append_vjp(
        &mut self,
        other: &mut Vec<Self::Element>,
    ) -> ((), impl FnOnce((), Of<Self>, Of<Self>) -> (Of<Self>, Of<Self>) + use<Self>) {
        let elements = self.elements_mut();
        let kept = elements.len();
        elements.append(other);
        let len = elements.len();
        ((), move |(), cotangent, _| {
            let mut before = fitted(cotangent, len);
            let appended = before.split_off(kept);
            (before, appended)
        })
    }

    /// Appends the tangents, too.
    #[inline]
    fn append_jvp(
        &mut self,
        other: &mut Vec<Self::Element>,
        tangent: &mut Of<Self>,
        other_tangent: &mut Of<Self>,
    ) -> ((), ()) {
        self.elements_mut().append(other);
        tangent.append(other_tangent);
        ((), ())
    }

    keeping! {
        /// Those of which it holds.
        retain[F: FnMut(&Self::Element) -> bool](keeps: F)
            => |elements| retained(elements, keeps);
        /// The first of equal neighbours.
        dedup[]() where Element: PartialEq
            => |elements| deduplicated(elements, |one, other| one == other);
        /// The first of neighbours that are the same. What tells may not change them.
        dedup_by[F: FnMut(&Self::Element, &Self::Element) -> bool](same: F)
            => |elements| deduplicated(elements, same);
        /// The first of neighbours with equal keys.
        dedup_by_key[K: PartialEq, F: FnMut(&Self::Element) -> K](key: F)
            => |elements| deduplicated(elements, |one, other| key(one) == key(other));
    }
}

/// The cotangents of elements of which some were kept.
fn of_kept<T: Additive>(kept: &[bool], cotangent: Vec<T>) -> Vec<T> {
    let count = kept.iter().filter(|kept| **kept).count();
    let mut after = fitted(cotangent, count).into_iter();
    let before = kept.iter().map(|kept| match kept {
        true => after.next().unwrap_or_else(Additive::zero),
        false => Additive::zero(),
    });
    before.collect()
}

/// Keeps the first of neighbours that are the same; says of each element whether it is kept.
fn deduplicated<T>(elements: &mut Vec<T>, mut same: impl FnMut(&T, &T) -> bool) -> Vec<bool> {
    let mut kept = Vec::with_capacity(elements.len());
    kept.extend(elements.first().map(|_| true));
    elements.dedup_by(|element, before| {
        let is_same = same(element, before);
        kept.push(!is_same);
        is_same
    });
    kept
}

/// Keeps some elements; says of each whether it is one of them.
fn retained<T>(elements: &mut Vec<T>, mut keeps: impl FnMut(&T) -> bool) -> Vec<bool> {
    let mut kept = Vec::with_capacity(elements.len());
    elements.retain(|element| {
        let keeps = keeps(element);
        kept.push(keeps);
        keeps
    });
    kept
}

impl<T: Differentiable> VecRules for Vec<T> {
    type Element = T;

    fn elements_mut(&mut self) -> &mut Vec<T> {
        self
    }
}

/// The elements in a range, which the `Vec` loses: what `drain` gives one by one.
#[doc(hidden)]
pub fn drained<T>(elements: &mut Vec<T>, from: usize, to: usize) -> Vec<T> {
    elements.drain(from..to).collect()
}

/// The derivative of [`drained`].
#[doc(hidden)]
#[allow(non_camel_case_types)]
pub enum drained {}

impl drained {
    /// Puts the cotangents of the removed elements back.
    #[inline]
    #[track_caller]
    pub fn vjp<T: Differentiable>(
        elements: &mut Vec<T>,
        from: usize,
        to: usize,
    ) -> (Vec<T>, impl FnOnce(Tangents<T>, Tangents<T>) -> (Tangents<T>, (), ()) + use<T>) {
        let removed = drained(elements, from, to);
        let len = elements.len();
        (removed, move |removed, cotangent| {
            let mut before = fitted(cotangent, len);
            before.splice(from..from, fitted(removed, to - from));
            (before, (), ())
        })
    }

    /// Removes the tangents alike.
    #[inline]
    #[track_caller]
    pub fn jvp<T: Differentiable>(
        elements: &mut Vec<T>,
        from: usize,
        to: usize,
        tangent: &mut Tangents<T>,
        _: (),
        _: (),
    ) -> (Vec<T>, Tangents<T>) {
        (drained(elements, from, to), drained(tangent, from, to))
    }
}
