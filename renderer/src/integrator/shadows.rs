//! Which pixels of a tile each light reaches.

use ad::lanes::Lanes;
use glam::DVec3;

use super::prepared::{Kind, Prepared};
use super::view::{Group, Seen, View};
use crate::acceleration::{NO_PRIMITIVE, PACKET_RAYS, PacketDirections};
use crate::precision::vectors_of_lanes;
use crate::scene::Light;

/// The pixels that a light reaches, a bit for each of [`View::seen`].
#[derive(Clone, Copy)]
pub(super) struct Lit(u64);

impl Lit {
    /// Those among the pixels of a group.
    pub(super) fn of<L: Lanes>(self, group: &Group<L>) -> L::Mask {
        let bits = self.0 >> group.pixels.start;
        let count = group.pixels.len();
        L::mask_from_lanes(|lane| lane < count && bits >> lane & 1 == 1)
    }
}

/// A point that may be in shadow.
struct Target<'v> {
    seen: &'v Seen,
    point: DVec3,
    normal: DVec3,
}

/// Up to this ratio of its distance to the coordinates of a surface point, shadow rays start at the
/// light; beyond, their ends would be too inexact.
const FARTHEST: f64 = 100.0;

impl<L: Lanes> Prepared<'_, L> {
    /// For each light the pixels that it reaches.
    pub(super) fn lit(&self, view: &View, groups: &[Group<L>]) -> Vec<Lit> {
        let mut targets = Vec::with_capacity(view.seen.len());
        for group in groups {
            let points = vectors_of_lanes::<L>(group.surface.point);
            let normals = vectors_of_lanes::<L>(group.surface.normal);
            let surface = view.seen[group.pixels.clone()].iter().zip(points).zip(normals);
            targets.extend(surface.map(|((seen, point), normal)| Target { seen, point, normal }));
        }
        self.lights
            .iter()
            .map(|light| match light {
                Light::Point(light) => self.lit_from(light.position, &targets),
                Light::Distant(light) => self.lit_along(light.direction, &targets),
            })
            .collect()
    }

    /// Shadow rays of a point light start at the light: from there they are coherent.
    fn lit_from(&self, position: DVec3, targets: &[Target<'_>]) -> Lit {
        let mut directions = PacketDirections::ZERO;
        let mut from = [NO_PRIMITIVE; PACKET_RAYS];
        let (mut near, mut far) = (0, 0);
        for (i, target) in targets.iter().enumerate() {
            let to_light = position - target.point;
            // From behind, a light brings nothing, whatever is in its way.
            if target.normal.dot(to_light) <= 0.0 {
                continue;
            }
            let distance = to_light.length();
            if distance > FARTHEST * reach(target) {
                far |= 1 << i;
                let shadowed = self.is_shadowed(target, to_light / distance, distance);
                near |= u64::from(!shadowed) << i;
                continue;
            }
            let error = surface_error(reach(target).max(distance));
            let end = target.point + target.normal * error - position;
            directions.set(i, end.as_vec3());
            from[i] = self.flat_primitive(target);
            near |= 1 << i;
        }
        let occluded = self.acceleration.occluded_packet(
            position.as_vec3(),
            &directions,
            1.0,
            &from,
            near & !far,
        );
        Lit(near & !occluded)
    }

    fn lit_along(&self, direction: DVec3, targets: &[Target<'_>]) -> Lit {
        let unit = direction.normalize();
        let is_lit = |target: &Target<'_>| {
            target.normal.dot(unit) > 0.0 && !self.is_shadowed(target, unit, f64::INFINITY)
        };
        let bits = targets.iter().enumerate().map(|(i, target)| u64::from(is_lit(target)) << i);
        Lit(bits.fold(0, |all, bit| all | bit))
    }

    /// Whether something stands between a point and `limit` along a unit direction.
    fn is_shadowed(&self, target: &Target<'_>, direction: DVec3, limit: f64) -> bool {
        let origin = target.point + target.normal * surface_error(reach(target));
        let from = Some(self.flat_primitive(target)).filter(|&from| from != NO_PRIMITIVE);
        self.acceleration.is_occluded(origin.as_vec3(), direction.as_vec3(), limit as f32, from)
    }

    /// The primitive that a point lies on, if a ray that leaves it cannot come back to it.
    fn flat_primitive(&self, target: &Target<'_>) -> u32 {
        match target.seen.kind {
            Kind::Triangle => target.seen.hit.primitive,
            Kind::Sphere => NO_PRIMITIVE,
        }
    }
}

/// The largest number that went into a surface point.
fn reach(target: &Target<'_>) -> f64 {
    target.point.abs().max_element().max(f64::from(target.seen.hit.distance))
}

/// How far a point may be from the surface that traversal sees: numbers up to `reach` were rounded
/// to single precision (the error analysis of Pharr, Jakob & Humphreys, "Physically Based
/// Rendering", section 6.8).
fn surface_error(reach: f64) -> f64 {
    8.0 * f64::from(f32::EPSILON) * reach
}
