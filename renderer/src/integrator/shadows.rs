//! Which rays end at points that a light reaches.

use std::mem;

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Vec3, select};
use glam::DVec3;

use super::mirrors::Dark;
use super::prepared::Prepared;
use super::settings::Pass;
use super::view::{Group, Shape, View, set_vectors};
use crate::acceleration::{NO_PRIMITIVE, PacketVectors, rays};
use crate::counts::count;
use crate::precision::{MOST_LANES, narrow, vectors_of_lanes};
use crate::scene::Light;

/// The rays of a tile that end at points which a light reaches, a bit for each.
#[derive(Clone, Copy)]
pub(super) struct Lit {
    reached: u64,
}

impl Lit {
    /// Whether the light reaches the point at which a ray ends.
    pub fn reaches(self, ray: usize) -> bool {
        self.reached >> ray & 1 == 1
    }

    /// The light reaches the point at which a ray ends.
    pub fn add(&mut self, ray: usize) {
        self.reached |= 1 << ray;
    }

    /// The lanes of a group that the light reaches.
    #[inline]
    pub fn of<L: Lanes>(self, group: &Group<L>) -> L::Mask {
        L::mask_from_bits((self.reached >> group.first) as u32 & group.alive)
    }
}

/// Up to this ratio of its distance to the coordinates of a surface point, shadow rays start at the
/// light; beyond, their ends would be too inexact.
const FARTHEST: f64 = 100.0;

/// How far a point may be from the surface that traversal sees, relative to the largest number that
/// went into it: that was rounded to single precision (the error analysis of Pharr, Jakob &
/// Humphreys, "Physically Based Rendering", section 6.8).
const SURFACE_ERROR: f64 = 8.0 * f32::EPSILON as f64;

impl<L: Lanes> Prepared<'_, L> {
    /// Finds what each light reaches of a view. Nothing is traced for lights that send nothing, unless
    /// `dark` wants to know what they would reach.
    pub(super) fn light_up(&self, dark: Dark, view: &mut View<L>) {
        let mut lit = mem::take(&mut view.lit);
        lit.clear();
        lit.extend(self.lights.iter().enumerate().map(|(index, light)| match light {
            _ if light.is_black() && !dark.lights => Lit { reached: 0 },
            Light::Point(light) => self.lit_from(index, light.position, view),
            Light::Distant(light) => self.lit_along(light.direction.normalize(), view),
        }));
        if self.pass == Pass::Radiance {
            let custom = 0..self.scene.custom_lights.len();
            lit.extend(custom.map(|custom| self.lit_by(self.lights.len() + custom, view)));
        }
        view.lit = lit;
        self.light_through(dark, view);
    }

    /// The unit vector from a point towards a light, those of users last, and the distance to it.
    pub(super) fn towards_light(&self, light: usize, point: DVec3) -> (DVec3, f64) {
        match self.lights.get(light) {
            Some(Light::Point(light)) => {
                let to_light = light.position - point;
                let distance = to_light.length();
                (to_light / distance, distance)
            }
            Some(Light::Distant(light)) => (light.direction.normalize(), f64::INFINITY),
            None => {
                let index = light - self.lights.len();
                let parameters = &self.parameters.custom_lights[index];
                let (light, point) = (&self.scene.custom_lights[index].light, point + self.middle);
                let direction = light.illumination(parameters, point).direction;
                (direction, light.distance(parameters, point))
            }
        }
    }

    /// What a light reaches that a user adds.
    fn lit_by(&self, light: usize, view: &View<L>) -> Lit {
        let to_light = |point: DVec3| self.towards_light(light, point);
        let mut facing = 0;
        for group in &view.groups {
            let points = vectors_of_lanes::<L>(group.surface.point);
            let normals = vectors_of_lanes::<L>(group.surface.normal);
            let faces =
                |&(lane, _): &(usize, usize)| normals[lane].dot(to_light(points[lane]).0) > 0.0;
            facing |= group.rays().filter(faces).fold(0, |bits, (_, ray)| bits | 1 << ray);
        }
        let reached = self.unshadowed(view, facing, to_light);
        Lit { reached }
    }

    /// Shadow rays of a point light start at the light: from there they are coherent.
    fn lit_from(&self, index: usize, light: DVec3, view: &View<L>) -> Lit {
        let position = narrow::<L>(light);
        let mut directions = PacketVectors::ZERO;
        let mut from = view.hits.primitive;
        let (mut facing, mut far) = (0, 0);
        for group in &view.groups {
            let to_light = position - group.surface.point;
            let lanes = group.facing(to_light);
            if lanes == 0 {
                continue;
            }
            facing |= u64::from(lanes) << group.first;
            let (reach, distance) = (group.reach(), to_light.length());
            let lanes = L::mask_bits(distance.cmpgt(reach * L::from_f64(FARTHEST))) & lanes;
            far |= u64::from(lanes) << group.first;

            let error = reach.max(distance) * L::from_f64(SURFACE_ERROR);
            let end = group.surface.normal * error - to_light;
            set_vectors::<L>(&mut directions, group.first, group.alive, end);
            if !matches!(group.shape, Shape::Triangles) {
                for (_, ray) in group.rays() {
                    from[ray] = NO_PRIMITIVE;
                }
            }
        }
        if self.is_alone(view) {
            return Lit { reached: facing };
        }
        let (origin, near) = (light.as_vec3(), facing & !far);
        count(|counts| &counts.shadow_rays, u64::from(near.count_ones()));
        let mut occluded = self.acceleration.occluded_packet(origin, &directions, 1.0, &from, near);
        if !self.scene.shapes.is_empty() {
            let behind =
                |&ray: &usize| self.is_behind_custom_shape(origin, directions.get(ray), 1.0);
            occluded |= rays(near & !occluded).filter(behind).fold(0, |bits, ray| bits | 1 << ray);
        }
        let straight = |point: DVec3| self.towards_light(index, point);
        let reached = near & !occluded | self.unshadowed(view, facing & far, straight);
        Lit { reached }
    }

    fn lit_along(&self, direction: DVec3, view: &View<L>) -> Lit {
        let towards = narrow::<L>(direction);
        let facing = view
            .groups
            .iter()
            .fold(0, |facing, group| facing | u64::from(group.facing(towards)) << group.first);
        let reached = self.unshadowed(view, facing, |_| (direction, f64::INFINITY));
        Lit { reached }
    }

    /// Whether a view shows the only primitive there is, from outside: nothing casts a shadow on it.
    fn is_alone(&self, view: &View<L>) -> bool {
        let primitives = self.triangles.len() + self.spheres.len();
        primitives == 1 && self.scene.shapes.is_empty() && view.hits.leaves == 0
    }

    /// Those among `rays` that end at points from which nothing stands in the way to the light:
    /// `to_light` gives the unit vector towards it, and its distance.
    fn unshadowed(
        &self,
        view: &View<L>,
        rays: u64,
        to_light: impl Fn(DVec3) -> (DVec3, f64),
    ) -> u64 {
        if rays == 0 || self.is_alone(view) {
            return rays;
        }
        count(|counts| &counts.shadow_rays, u64::from(rays.count_ones()));
        let mut lit = rays;
        for group in &view.groups {
            let points = vectors_of_lanes::<L>(group.surface.point);
            let origins = group.origins();
            for (lane, ray) in group.rays().filter(|(_, ray)| rays >> ray & 1 == 1) {
                let (direction, distance) = to_light(points[lane]);
                let from = group.start(view, ray);
                let (origin, direction) = (origins[lane].as_vec3(), direction.as_vec3());
                let limit = distance as f32;
                if self.acceleration.is_occluded(origin, direction, limit, from)
                    || self.is_behind_custom_shape(origin, direction, limit)
                {
                    lit &= !(1 << ray);
                }
            }
        }
        lit
    }
}

impl<L: Lanes> Group<L> {
    /// A bit for each lane whose surface is seen from the side that faces a light: from behind, a
    /// light brings nothing, whatever is in its way. A normal that is not a number faces every light,
    /// so that it shows in the image.
    #[inline]
    fn facing(&self, to_light: Vec3<L>) -> u32 {
        !L::mask_bits(self.surface.normal.dot(to_light).cmple(L::ZERO)) & self.alive
    }

    /// Where rays that leave the surface points start: far enough outside not to meet the surface
    /// that they leave.
    pub(super) fn origins(&self) -> [DVec3; MOST_LANES] {
        self.origins_behind(0)
    }

    /// [`origins`](Self::origins), in the given lanes of rays that leave the surface on the side that
    /// the viewer does not see.
    pub(super) fn origins_behind(&self, lanes: u32) -> [DVec3; MOST_LANES] {
        let offset = self.surface.normal * (self.reach() * L::from_f64(SURFACE_ERROR));
        let offset = select(L::mask_from_bits(lanes), -offset, offset);
        vectors_of_lanes::<L>(self.surface.point + offset)
    }

    /// The flat primitive that a ray of the group ends on: one that leaves it cannot come back to
    /// it.
    pub(super) fn start(&self, view: &View<L>, ray: usize) -> Option<u32> {
        match self.shape {
            Shape::Triangles => Some(view.hits.primitive[ray]),
            Shape::Spheres(_) | Shape::Custom => None,
        }
    }

    /// The largest numbers that went into the surface points.
    #[inline]
    fn reach(&self) -> L {
        let depth = (self.surface.point - self.ray.origin).dot(self.ray.direction);
        self.surface.point.abs().max_element().max(depth)
    }
}
