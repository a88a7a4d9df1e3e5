//! Points of surfaces that shine, as lights: the edges of their shadows are found by them.

use ad::vector::Vector;
use ad::{Tangent, Vec3};

use crate::number::Number;
use crate::trace::emitters::ShiningPoint;
use crate::transport::emitter::illuminate_by_point_of;
use crate::transport::hit::Primitive;
use crate::transport::illumination::Illumination;

/// A point of a surface that shines.
pub struct ShiningInputs<S: Number> {
    /// The index of the primitive.
    pub index: usize,
    primitive: Primitive<S>,
    /// Where the point is, and what it counts for: see [`ShiningPoint`].
    at: [S; 3],
    is_even: bool,
    choices: S,
    emission: Vec3<S>,
}

impl<S: Number> ShiningInputs<S> {
    /// A point of a primitive, of which this emission is seen.
    pub fn new(point: &ShiningPoint, primitive: Primitive<S>, emission: Vec3<S>) -> Self {
        let at = point.at.map(S::from_f64);
        let (index, choices) = (point.primitive as usize, S::from_f64(point.choices));
        Self { index, primitive, at, is_even: point.is_even, choices, emission }
    }

    /// The illumination of a point, if nothing is between them.
    pub fn illuminate(&self, point: Vec3<S>) -> Illumination<S> {
        let inside = self.inside(point);
        illuminate_by_point_of::<S>(
            self.primitive,
            inside,
            self.at,
            self.is_even,
            self.choices,
            self.emission,
            point,
        )
    }

    /// The pullback of [`illuminate`](Self::illuminate) to the primitive and the point.
    pub fn pull_illuminate(
        &self,
        point: Vec3<S>,
        cotangent: Tangent<Illumination<S>>,
    ) -> (Tangent<Primitive<S>>, Vec3<S>) {
        let (_, pullback) = illuminate_by_point_of::vjp::<S>(
            self.primitive,
            self.inside(point),
            self.at,
            self.is_even,
            self.choices,
            self.emission,
            point,
        );
        let (primitive, .., point) = pullback(cotangent);
        (primitive, point)
    }

    /// Where the point is inside of a sphere that shines.
    fn inside(&self, point: Vec3<S>) -> S::Mask {
        let Primitive::Sphere(sphere) = self.primitive else { return S::mask(0) };
        (sphere.center - point).length().cmplt(sphere.radius)
    }
}
