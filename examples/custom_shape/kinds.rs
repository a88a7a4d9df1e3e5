//! A shape and a light that the renderer does not know: an ellipsoid and a spotlight. Their kernels
//! are `#[differentiable]`, which gives their pullbacks.

use ad::vector::Vector;
use ad::{Differentiable, Fields, Real, Vec3, differentiable, select};
use glam::DVec3;
use renderer::custom::{Bounded, Emitter, Intersection, Shape};
use renderer::transport::camera::Ray;
use renderer::transport::illumination::Illumination;
use renderer::transport::positive_part;

/// An ellipsoid along the axes.
#[derive(Clone, Copy, Debug, Differentiable, Fields)]
pub struct Ellipsoid<S: Real> {
    pub center: Vec3<S>,
    pub radii: Vec3<S>,
}

#[differentiable]
impl<S: Real> Shape for Ellipsoid<S> {
    type Scalar = S;

    fn intersect(self, ray: Ray<S>) -> Intersection<S> {
        // Where the ellipsoid is the unit sphere.
        let inverse = self.radii.recip();
        let origin = (ray.origin - self.center) * inverse;
        let direction = ray.direction * inverse;
        let a = direction.length_squared();
        let half_b = origin.dot(direction);
        let margin = half_b * half_b - a * (origin.length_squared() - S::ONE);
        let root = positive_part::<S>(margin).sqrt();
        let (near, far) = ((-half_b - root) / a, (root - half_b) / a);
        let distance = select(near.cmpgt(S::ZERO), near, far);
        let normal = (origin + direction * distance) * inverse;
        Intersection { distance, normal, margin }
    }
}

impl Bounded for Ellipsoid<f64> {
    fn bounds(&self) -> (DVec3, DVec3) {
        (self.center - self.radii, self.center + self.radii)
    }
}

/// A point light that shines mostly one way.
#[derive(Clone, Copy, Debug, Differentiable, Fields)]
pub struct Spotlight<S: Real> {
    pub position: Vec3<S>,
    /// The point that it shines at.
    pub target: Vec3<S>,
    /// The radiant intensity straight ahead, W/sr.
    pub radiant_intensity: S,
    /// How narrow its cone is.
    pub sharpness: S,
}

#[differentiable]
impl<S: Real> Emitter for Spotlight<S> {
    type Scalar = S;

    fn illuminate(self, point: Vec3<S>) -> Illumination<S> {
        let to_light = self.position - point;
        let (distance, direction) = (to_light.length(), to_light.normalize());
        let axis = (self.position - self.target).normalize();
        let cone = positive_part::<S>(axis.dot(direction)).powf(self.sharpness);
        let irradiance = self.radiant_intensity * cone / (distance * distance);
        Illumination { direction, distance, irradiance: <Vec3<S>>::splat(irradiance) }
    }
}
