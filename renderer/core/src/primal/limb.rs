//! The limb of spheres.
//!
//! Towards its silhouette the point of a sphere that a pixel shows moves ever faster when the sphere
//! does: its derivative grows like one over the root of the distance to the silhouette. The integral over
//! the image is finite, but a sample that happens to be next to the silhouette counts for far too much. So
//! each sample gets the mean over the strip that it stands for, along the normal of the silhouette: the
//! strip of the outermost sample reaches to the silhouette.

use ad::select;

use super::chain::Chain;
use crate::number::Plain;
use crate::primal::wavefront::LaneGroup;
use crate::transport::camera::primary_ray;
use crate::transport::edge::sphere_margin;
use crate::transport::hit::Primitive;

impl<L: Plain> Chain<'_, L> {
    /// By how much the derivatives of the surface points of a group that the camera sees are multiplied,
    /// if samples are `spacing` pixels apart; nothing if the group is not of spheres.
    pub(super) fn limb_weight(
        &self,
        group: &LaneGroup<L>,
        (x, y): (L, L),
        spacing: f64,
    ) -> Option<L> {
        let Some(Primitive::Sphere(sphere)) =
            self.integrator.primitive(group.kind, &group.primitives)
        else {
            return None;
        };
        let (margin, pullback) = sphere_margin::vjp::<L>(sphere, group.ray);
        let (_, of_ray) = pullback(L::ONE);
        let (_, pullback) = primary_ray::vjp::<L>(self.integrator.inputs.frame, x, y);
        let (_, x, y) = pullback(of_ray);
        let layout = self.integrator.layout;
        let (x, y) = (
            x * L::from_f64(2.0 / f64::from(layout.width)),
            y * L::from_f64(2.0 / f64::from(layout.height)),
        );
        let slope = (x * x + y * y).sqrt() * L::from_f64(spacing);
        // In distances between samples.
        let distance = (margin / slope).max(L::ZERO);
        let half = L::HALF;
        let to_silhouette = L::TWO * (distance * (distance + half)).sqrt();
        let beyond = (distance - half).max(L::ZERO).sqrt();
        let strip = L::TWO * distance.sqrt() * ((distance + half).sqrt() - beyond);
        let weight = select(distance.cmplt(L::ONE), to_silhouette, strip);
        // Far from the silhouette the difference of roots loses digits, and the weight is 1.
        let weight = select(distance.cmplt(L::from_f64(100.0)), weight, L::ONE);
        Some(select(weight.is_finite(), weight, L::ONE))
    }
}
