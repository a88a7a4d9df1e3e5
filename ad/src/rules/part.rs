//! Derivatives of the methods that lend parts of a slice, where its type goes by another name.
//!
//! Of what is seen to be a slice, an array or a `Vec` these methods are written out with indices, and a cotangent
//! goes to the element it belongs to. Behind `type Row = Vec<f64>` a type of the user's could stand, whose methods
//! would be others: there the compiler finds these, whose cotangents are those of a whole sequence.

use super::sequence::{Elements, SequenceRules};
use crate::{Additive, Tangent};

/// A method that gives one element, if there is one.
macro_rules! elements {
    ($($name:ident($($position:ident)?) $at:expr, $doc:literal;)*) => { pastey::paste! {$(
        #[doc = $doc]
        #[inline]
        #[allow(clippy::type_complexity, unused_parens)]
        fn [<$name _vjp>](
            &self
            $(, $position: usize)?
        ) -> (
            Option<&Self::Element>,
            impl FnOnce(Tangent<Self::Element>) -> elements!(@parts $($position)?) + use<Self>,
        ) {
            let elements = self.view();
            let (len, at) = (elements.len(), $at(elements.len()));
            (elements.get(at), move |cotangent| {
                let mut whole = Self::Tangent::zero();
                if at < len {
                    whole.elements(len)[at] = cotangent;
                }
                elements!(@pulled whole $($position)?)
            })
        }

        /// The tangent of that element.
        #[inline]
        fn [<$name _jvp>](
            &self,
            $($position: usize,)?
            tangent: &[Tangent<Self::Element>],
            $(_: elements!(@unit $position))?
        ) -> (Option<&Self::Element>, Tangent<Self::Element>) {
            let at = $at(self.view().len());
            let pushed = tangent.get(at).cloned().unwrap_or_else(Additive::zero);
            (self.view().get(at), pushed)
        }
    )*}};
    (@parts $position:ident) => { (Self::Tangent, ()) };
    (@parts) => { Self::Tangent };
    (@pulled $whole:ident $position:ident) => { ($whole, ()) };
    (@pulled $whole:ident) => { $whole };
    (@unit $position:ident) => { () };
}

/// A method that gives the element at one end and all others, if there is one.
macro_rules! ends {
    ($($name:ident $at:expr, $rest:expr, $doc:literal;)*) => { pastey::paste! {$(
        #[doc = $doc]
        #[inline]
        fn [<$name _vjp>](
            &self,
        ) -> (
            Option<(&Self::Element, &[Self::Element])>,
            impl FnOnce((Tangent<Self::Element>, Vec<Tangent<Self::Element>>)) -> Self::Tangent
            + use<Self>,
        ) {
            let len = self.view().len();
            (self.view().$name(), move |(end, rest)| {
                let mut whole = Self::Tangent::zero();
                if len > 0 {
                    let elements = whole.elements(len);
                    elements[$at(len)] = end;
                    place(rest, &mut elements[$rest(len)]);
                }
                whole
            })
        }

        /// The tangents of both.
        #[inline]
        fn [<$name _jvp>](
            &self,
            tangent: &[Tangent<Self::Element>],
        ) -> (
            Option<(&Self::Element, &[Self::Element])>,
            (Tangent<Self::Element>, Vec<Tangent<Self::Element>>),
        ) {
            let pushed = match tangent.$name() {
                Some((end, rest)) => (end.clone(), rest.to_vec()),
                None => (Additive::zero(), Vec::new()),
            };
            (self.view().$name(), pushed)
        }
    )*}};
}

/// The `_vjp` and `_jvp` siblings of methods that lend parts of slices and arrays.
pub trait PartRules: SequenceRules {
    elements! {
        get(position) |_| position, "To the element at that place.";
        first() |_| 0, "To the first element.";
        last() |len: usize| len.wrapping_sub(1), "To the last element.";
    }

    /// To the elements of both parts.
    #[inline]
    #[track_caller]
    fn split_at_vjp(
        &self,
        at: usize,
    ) -> (
        (&[Self::Element], &[Self::Element]),
        impl FnOnce((Vec<Tangent<Self::Element>>, Vec<Tangent<Self::Element>>)) -> (Self::Tangent, ())
        + use<Self>,
    ) {
        let len = self.view().len();
        (self.view().split_at(at), move |(left, right)| {
            let mut whole = Self::Tangent::zero();
            place(left, &mut whole.elements(len)[..at]);
            place(right, &mut whole.elements(len)[at..]);
            (whole, ())
        })
    }

    /// The tangents of both parts.
    #[inline]
    #[track_caller]
    fn split_at_jvp(
        &self,
        at: usize,
        tangent: &[Tangent<Self::Element>],
        (): (),
    ) -> (
        (&[Self::Element], &[Self::Element]),
        (Vec<Tangent<Self::Element>>, Vec<Tangent<Self::Element>>),
    ) {
        let (left, right) = tangent.split_at(at);
        (self.view().split_at(at), (left.to_vec(), right.to_vec()))
    }

    ends! {
        split_first |_| 0, |_| 1.., "To the first element, and to those behind it.";
        split_last |len: usize| len.wrapping_sub(1), |len: usize| ..len - 1, "To the last element, and to those before it.";
    }
}

/// Gives the cotangents of a part, of which those at its end may be left out, to the whole.
fn place<T>(part: Vec<T>, whole: &mut [T]) {
    for (element, cotangent) in whole.iter_mut().zip(part) {
        *element = cotangent;
    }
}

impl<S: SequenceRules + ?Sized> PartRules for S {}
