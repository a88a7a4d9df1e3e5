//! Tangents of what holds other values: references, boxes, options, tuples, arrays, slices, `Vec`.

use core::marker::PhantomData;
use core::ops::ControlFlow;
use std::collections::VecDeque;

use crate::{Additive, Boxed, Differentiable, NoDerivative, NoTangent, Shape, Tangent};

impl<T: Differentiable + ?Sized> Differentiable for &T {
    type Tangent = Tangent<T>;
    type Shape = T::Shape;

    #[inline(always)]
    fn shape(&self) -> T::Shape {
        T::shape(self)
    }

    #[inline(always)]
    fn zero_tangent(&self) -> Tangent<T> {
        T::zero_tangent(self)
    }
}

impl<T: Differentiable + ?Sized> Differentiable for &mut T {
    type Tangent = Tangent<T>;
    type Shape = T::Shape;

    #[inline(always)]
    fn shape(&self) -> T::Shape {
        T::shape(self)
    }

    #[inline(always)]
    fn zero_tangent(&self) -> Tangent<T> {
        T::zero_tangent(self)
    }
}

/// The cotangent of a box is a box that is made when something flows to it. Its content is not
/// brought to the size of the value: that could take a walk through a whole tree for each call. A
/// tangent has the size of its value, also in boxes, so that what holds one makes its zero of those
/// of its parts.
impl<T: Differentiable + ?Sized> Differentiable for Box<T> {
    type Tangent = Boxed<Tangent<T>>;
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}

    #[inline]
    fn zero_tangent(&self) -> Self::Tangent {
        Boxed::new(T::zero_tangent(self))
    }
}

/// The cotangent of an option is that of its content; nothing flows into a `None`.
impl<T: Differentiable> Differentiable for Option<T> {
    type Tangent = Tangent<T>;
    type Shape = Option<T::Shape>;

    #[inline(always)]
    fn shape(&self) -> Self::Shape {
        self.as_ref().map(T::shape)
    }

    #[inline(always)]
    fn zero_tangent(&self) -> Self::Tangent {
        self.as_ref().map_or_else(Additive::zero, T::zero_tangent)
    }
}

impl<T, S: Shape<T>> Shape<T> for Option<S> {
    #[inline(always)]
    fn fit(self, tangent: &mut T) {
        if let Some(shape) = self {
            shape.fit(tangent);
        }
    }
}

/// One cotangent for either outcome; that of the outcome which did not occur stays zero.
impl<T: Differentiable, E: Differentiable> Differentiable for Result<T, E> {
    type Tangent = (Tangent<T>, Tangent<E>);
    type Shape = Result<T::Shape, E::Shape>;

    #[inline(always)]
    fn shape(&self) -> Self::Shape {
        self.as_ref().map(T::shape).map_err(E::shape)
    }

    #[inline(always)]
    fn zero_tangent(&self) -> Self::Tangent {
        match self {
            Ok(value) => (value.zero_tangent(), Additive::zero()),
            Err(error) => (Additive::zero(), error.zero_tangent()),
        }
    }
}

impl<T, E, S: Shape<T>, F: Shape<E>> Shape<(T, E)> for Result<S, F> {
    #[inline(always)]
    fn fit(self, tangent: &mut (T, E)) {
        match self {
            Ok(shape) => shape.fit(&mut tangent.0),
            Err(shape) => shape.fit(&mut tangent.1),
        }
    }
}

/// One cotangent for either outcome; that of the outcome which did not occur stays zero.
impl<B: Differentiable, C: Differentiable> Differentiable for ControlFlow<B, C> {
    type Tangent = (Tangent<B>, Tangent<C>);
    type Shape = ControlFlow<B::Shape, C::Shape>;

    #[inline(always)]
    fn shape(&self) -> Self::Shape {
        match self {
            ControlFlow::Break(value) => ControlFlow::Break(value.shape()),
            ControlFlow::Continue(value) => ControlFlow::Continue(value.shape()),
        }
    }

    #[inline(always)]
    fn zero_tangent(&self) -> Self::Tangent {
        match self {
            ControlFlow::Break(value) => (value.zero_tangent(), Additive::zero()),
            ControlFlow::Continue(value) => (Additive::zero(), value.zero_tangent()),
        }
    }
}

impl<B, C, S: Shape<B>, R: Shape<C>> Shape<(B, C)> for ControlFlow<S, R> {
    #[inline(always)]
    fn fit(self, tangent: &mut (B, C)) {
        match self {
            ControlFlow::Break(shape) => shape.fit(&mut tangent.0),
            ControlFlow::Continue(shape) => shape.fit(&mut tangent.1),
        }
    }
}

impl<T: ?Sized> Differentiable for PhantomData<T> {
    type Tangent = NoTangent<T>;
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}
}

/// That of a `#[constant]` field, which stands for its type only.
impl<T, U: ?Sized> Shape<T> for PhantomData<U> {
    const FIXED: bool = true;

    #[inline(always)]
    fn fit(self, _: &mut T) {}
}

impl<T: NoDerivative, const N: usize> NoDerivative for [T; N] {}

impl<T: Differentiable, const N: usize> Differentiable for [T; N] {
    type Tangent = [Tangent<T>; N];
    type Shape = [T::Shape; N];

    #[inline(always)]
    fn shape(&self) -> Self::Shape {
        self.each_ref().map(T::shape)
    }

    #[inline(always)]
    fn zero_tangent(&self) -> Self::Tangent {
        self.each_ref().map(T::zero_tangent)
    }

    #[inline(always)]
    fn irregularity(&self) -> f64 {
        self.iter().map(T::irregularity).sum()
    }
}

impl<T, S: Shape<T>, const N: usize> Shape<[T; N]> for [S; N] {
    const FIXED: bool = S::FIXED;

    #[inline(always)]
    fn fit(self, tangent: &mut [T; N]) {
        for (shape, tangent) in self.into_iter().zip(tangent) {
            shape.fit(tangent);
        }
    }
}

impl<T: Additive, const N: usize> Additive for [T; N] {
    #[inline(always)]
    fn zero() -> Self {
        core::array::from_fn(|_| T::zero())
    }

    #[inline(always)]
    fn accumulate(&mut self, other: Self) {
        for (mine, theirs) in self.iter_mut().zip(other) {
            mine.accumulate(theirs);
        }
    }
}

/// The shapes of the elements of a slice or a `Vec`: their number alone where it says it all, which
/// costs neither an allocation nor, in a debug build, a walk.
pub struct Shapes<S> {
    length: usize,
    each: Vec<S>,
}

/// Those of so many elements.
#[inline]
pub(crate) fn shapes<'a, T: Differentiable + 'a>(
    length: usize,
    elements: impl IntoIterator<Item = &'a T>,
) -> Shapes<T::Shape> {
    let walked = if T::Shape::FIXED { 0 } else { length };
    Shapes { length, each: elements.into_iter().take(walked).map(T::shape).collect() }
}

impl<T: Differentiable> Differentiable for [T] {
    type Tangent = Vec<Tangent<T>>;
    type Shape = Shapes<T::Shape>;

    #[inline]
    fn shape(&self) -> Self::Shape {
        shapes(self.len(), self)
    }

    #[inline]
    fn zero_tangent(&self) -> Self::Tangent {
        self.iter().map(T::zero_tangent).collect()
    }
}

impl<T: Differentiable> Differentiable for Vec<T> {
    type Tangent = Vec<Tangent<T>>;
    type Shape = Shapes<T::Shape>;

    #[inline]
    fn shape(&self) -> Self::Shape {
        self.as_slice().shape()
    }

    #[inline]
    fn zero_tangent(&self) -> Self::Tangent {
        self.as_slice().zero_tangent()
    }
}

impl<T: Additive, S: Shape<T>> Shape<Vec<T>> for Shapes<S> {
    #[inline]
    fn fit(self, tangent: &mut Vec<T>) {
        if tangent.len() != self.length {
            tangent.resize_with(self.length, T::zero);
        }
        for (shape, tangent) in self.each.into_iter().zip(tangent) {
            shape.fit(tangent);
        }
    }
}

macro_rules! lists {
    ($($list:ident)*) => {$(
        /// The shorter one lacks zeros.
        impl<T: Additive> Additive for $list<T> {
            #[inline(always)]
            fn zero() -> Self {
                Self::new()
            }

            #[inline]
            fn accumulate(&mut self, mut other: Self) {
                if self.len() < other.len() {
                    core::mem::swap(self, &mut other);
                }
                for (mine, theirs) in self.iter_mut().zip(other) {
                    mine.accumulate(theirs);
                }
            }
        }
    )*};
}

lists!(Vec VecDeque);

macro_rules! tuples {
    (@shape) => {};
    (@shape $($name:ident $shape:ident $index:tt),*) => {
        impl<$($name, $shape: Shape<$name>),*> Shape<($($name,)*)> for ($($shape,)*) {
            const FIXED: bool = true $(&& $shape::FIXED)*;

            #[inline(always)]
            fn fit(self, tangent: &mut ($($name,)*)) {
                $(self.$index.fit(&mut tangent.$index);)*
            }
        }
    };
    ($(($($name:ident $shape:ident $index:tt),*))*) => {$(
        impl<$($name: Differentiable),*> Differentiable for ($($name,)*) {
            type Tangent = ($(Tangent<$name>,)*);
            type Shape = ($($name::Shape,)*);

            #[inline(always)]
            fn shape(&self) -> Self::Shape {
                ($(self.$index.shape(),)*)
            }

            #[inline(always)]
            fn zero_tangent(&self) -> Self::Tangent {
                ($(self.$index.zero_tangent(),)*)
            }
        }

        impl<$($name: NoDerivative),*> NoDerivative for ($($name,)*) {}

        impl<$($name),*> Parts for ($($name,)*) {
            type Parts = ($(NoTangent<$name>,)*);

            #[inline(always)]
            fn parts() -> Self::Parts {
                ($(NoTangent::<$name>::new(),)*)
            }
        }

        // The unit type is the shape of everything that has one size.
        tuples!(@shape $($name $shape $index),*);

        impl<$($name: Additive),*> Additive for ($($name,)*) {
            #[inline(always)]
            fn zero() -> Self {
                ($($name::zero(),)*)
            }

            #[inline(always)]
            #[allow(unused_variables)]
            fn accumulate(&mut self, other: Self) {
                $(self.$index.accumulate(other.$index);)*
            }
        }
    )*};
}

#[allow(clippy::unused_unit)]
mod tuples {
    use super::{Additive, Differentiable, NoDerivative, NoTangent, Shape, Tangent};
    use crate::differentiable::Parts;

    tuples! {
        ()
        (A M 0)
        (A M 0, B N 1)
        (A M 0, B N 1, C O 2)
        (A M 0, B N 1, C O 2, D P 3)
        (A M 0, B N 1, C O 2, D P 3, E Q 4)
        (A M 0, B N 1, C O 2, D P 3, E Q 4, F R 5)
        (A M 0, B N 1, C O 2, D P 3, E Q 4, F R 5, G S 6)
        (A M 0, B N 1, C O 2, D P 3, E Q 4, F R 5, G S 6, H T 7)
        (A M 0, B N 1, C O 2, D P 3, E Q 4, F R 5, G S 6, H T 7, I U 8)
        (A M 0, B N 1, C O 2, D P 3, E Q 4, F R 5, G S 6, H T 7, I U 8, J V 9)
        (A M 0, B N 1, C O 2, D P 3, E Q 4, F R 5, G S 6, H T 7, I U 8, J V 9, K W 10)
        (A M 0, B N 1, C O 2, D P 3, E Q 4, F R 5, G S 6, H T 7, I U 8, J V 9, K W 10, L X 11)
    }
}
