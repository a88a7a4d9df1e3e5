//! The limb of spheres.
//!
//! Towards its silhouette the point of a sphere that a pixel shows moves ever faster when the sphere
//! does: its derivative grows like one over the root of the distance to the silhouette. The integral over
//! the image is finite, but a sample that happens to be next to the silhouette counts for far too much. So
//! each sample gets the mean over the strip that it stands for, along the normal of the silhouette: the
//! strip of the outermost sample reaches to the silhouette.

use ad::{Fields, Real, select};

use super::integrator::Integrator;
use super::wavefront::LaneGroup;
use crate::number::Number;
use crate::transport::camera::primary_ray;
use crate::transport::edge::sphere_margin;
use crate::transport::hit::Primitive;

impl<S: Number> Integrator<'_, S> {
    /// Weighs the derivatives of the surface points of a group that the camera sees, if samples are `spacing` pixels
    /// apart; those of other groups than of spheres have no limb.
    pub(super) fn weigh_limb(
        &self,
        group: &mut LaneGroup<S>,
        (x, y): (S::Lanes, S::Lanes),
        spacing: f64,
    ) {
        let Some(Primitive::Sphere(sphere)) = self.primitive(group.kind, &group.primitives) else {
            return;
        };
        let number = |value: f64| S::Lanes::from_f64(value);
        let (margin, pullback) =
            sphere_margin::vjp::<S::Lanes>(sphere.map(S::primal), group.ray.map(S::primal));
        let (_, of_ray) = pullback(S::Lanes::ONE);
        let (_, pullback) = primary_ray::vjp::<S::Lanes>(self.inputs.frame.map(S::primal), x, y);
        let (_, x, y) = pullback(of_ray);
        let (x, y) = (
            x * number(2.0 / f64::from(self.layout.width)),
            y * number(2.0 / f64::from(self.layout.height)),
        );
        let slope = (x * x + y * y).sqrt() * number(spacing);
        // In distances between samples.
        let distance = (margin / slope).max(S::Lanes::ZERO);
        let half = S::Lanes::HALF;
        let to_silhouette = S::Lanes::TWO * (distance * (distance + half)).sqrt();
        let beyond = (distance - half).max(S::Lanes::ZERO).sqrt();
        let strip = S::Lanes::TWO * distance.sqrt() * ((distance + half).sqrt() - beyond);
        let weight = select(distance.cmplt(S::Lanes::ONE), to_silhouette, strip);
        // Far from the silhouette the difference of roots loses digits, and the weight is 1.
        let weight = select(distance.cmplt(number(100.0)), weight, S::Lanes::ONE);
        let weight = select(weight.is_finite(), weight, S::Lanes::ONE);
        group.limb = Some(weight);
        group.surface = weighted(&group.surface, weight);
    }
}

/// The same values, with derivatives that are multiplied by a weight.
pub fn weighted<S: Number, T: Fields<S, With<S> = T>>(value: &T, weight: S::Lanes) -> T {
    value.map(|number| {
        let still = S::constant(number.primal());
        still + (number - still) * S::constant(weight)
    })
}
