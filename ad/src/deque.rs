//! Tangents of queues: as of a `Vec`, a cotangent may be shorter, and lacks zeros at the end.

use std::collections::VecDeque;

use crate::containers::{Shapes, shapes};
use crate::{Additive, Differentiable, Shape, Tangent};

impl<T: Differentiable> Differentiable for VecDeque<T> {
    type Tangent = VecDeque<Tangent<T>>;
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

impl<T: Additive, S: Shape<T>> Shape<VecDeque<T>> for Shapes<S> {
    #[inline]
    fn fit(self, tangent: &mut VecDeque<T>) {
        let mut elements = Vec::from(core::mem::take(tangent));
        self.fit(&mut elements);
        *tangent = elements.into();
    }
}
