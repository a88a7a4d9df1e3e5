//! Shadow rays: the visibility mask of each light for the hits of a wavefront.

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Real, Vec3, select};
use glam::DVec3;

use super::integrator::Integrator;
use super::lanes::vectors_of_lanes;
use super::wavefront::{LaneGroup, Wavefront, set_vectors};
use crate::counts::count;
use crate::number::{MAX_LANES, Number, primal_vector};
use crate::trace::bvh::{NO_PRIMITIVE, PacketVectors};
use crate::trace::layout::Kind;

/// Up to this ratio of its distance to the coordinates of a surface point, shadow rays start at the
/// light; beyond, their ends would be too inexact.
const FARTHEST: f64 = 100.0;

/// How far a point may be from the surface that traversal sees, relative to the largest number that
/// went into it: that was rounded to single precision (the error analysis of Pharr, Jakob &
/// Humphreys, "Physically Based Rendering", section 6.8).
const SURFACE_ERROR: f64 = 8.0 * f32::EPSILON as f64;

impl<S: Number> Integrator<'_, S> {
    /// Finds which rays of a wavefront end where each light shines. Nothing is traced for lights that send
    /// nothing, unless they count.
    pub fn trace_shadows(&self, wavefront: &mut Wavefront<S>) {
        let mut visible = std::mem::take(&mut wavefront.visible);
        visible.clear();
        visible.extend(self.layout.lights.iter().enumerate().map(|(light, traits)| {
            if traits.is_black && !self.zero_weight.lights {
                return 0;
            }
            match self.tracer.position(light) {
                Some(position) => self.visible_from(light, position, wavefront),
                None => self.visible_along(light, wavefront),
            }
        }));
        wavefront.visible = visible;
        self.trace_transmissions(wavefront);
    }

    /// Shadow rays of a light with a position start at the light: from there they are coherent.
    fn visible_from(&self, light: usize, position: DVec3, wavefront: &Wavefront<S>) -> u64 {
        let [x, y, z] = position.to_array().map(S::Lanes::from_f64);
        let start: Vec3<S::Lanes> = ad::vector::Vector3::new(x, y, z);
        let mut directions = PacketVectors::ZERO;
        let mut from = wavefront.hits.primitive;
        let (mut facing, mut far) = (0, 0);
        for group in &wavefront.groups {
            let (point, normal) = group.values();
            let to_light = start - point;
            let lanes = group.facing(normal, to_light);
            if lanes == 0 {
                continue;
            }
            facing |= u64::from(lanes) << group.first;
            let (reach, distance) = (group.reach(), to_light.length());
            let is_far = distance.cmpgt(reach * S::Lanes::from_f64(FARTHEST));
            far |= u64::from(S::Lanes::mask_bits(is_far) & lanes) << group.first;

            let error = reach.max(distance) * S::Lanes::from_f64(SURFACE_ERROR);
            let end = normal * error - to_light;
            set_vectors::<S::Lanes>(&mut directions, group.first, group.alive, end);
            if group.kind != Kind::Triangle {
                for (_, ray) in group.rays() {
                    from[ray] = NO_PRIMITIVE;
                }
            }
        }
        if self.is_alone(wavefront) {
            return facing;
        }
        let (origin, near) = (position.as_vec3(), facing & !far);
        count(|counts| &counts.shadow_rays, u64::from(near.count_ones()));
        let occluded = self.tracer.bvh.occluded_packet(origin, &directions, 1.0, &from, near);
        near & !occluded | self.unoccluded(light, wavefront, facing & far)
    }

    /// Shadow rays of any other light start at the surfaces, one by one.
    fn visible_along(&self, light: usize, wavefront: &Wavefront<S>) -> u64 {
        let mut facing = 0;
        for group in &wavefront.groups {
            let illumination = self.inputs.lights[light].illuminate(group.surface.point);
            let (_, normal) = group.values();
            let lanes = group.facing(normal, primal_vector::<S>(illumination.direction));
            facing |= u64::from(lanes) << group.first;
        }
        self.unoccluded(light, wavefront, facing)
    }

    /// Whether a wavefront shows the only primitive there is, from outside: nothing casts a shadow on it.
    fn is_alone(&self, wavefront: &Wavefront<S>) -> bool {
        let primitives = self.layout.material_of.len();
        primitives == 1 && self.layout.customs() == 0 && wavefront.hits.leaves == 0
    }

    /// Those among `rays` that end at points from which nothing stands in the way to the light.
    fn unoccluded(&self, light: usize, wavefront: &Wavefront<S>, rays: u64) -> u64 {
        if rays == 0 || self.is_alone(wavefront) {
            return rays;
        }
        count(|counts| &counts.shadow_rays, u64::from(rays.count_ones()));
        let mut visible = rays;
        for group in &wavefront.groups {
            let (points, origins) = (group.points(), group.origins(0));
            for (lane, ray) in group.rays().filter(|(_, ray)| rays >> ray & 1 == 1) {
                let towards = self.tracer.illuminate(light, points[lane]);
                let from = group.starts_on(wavefront, ray);
                let (origin, direction) = (origins[lane].as_vec3(), towards.direction.as_vec3());
                let limit = towards.distance as f32;
                if self.tracer.bvh.is_occluded(origin, direction, limit, from) {
                    visible &= !(1 << ray);
                }
            }
        }
        visible
    }
}

impl<S: Number> LaneGroup<S> {
    /// The values of the surface points and of their normals.
    pub fn values(&self) -> (Vec3<S::Lanes>, Vec3<S::Lanes>) {
        (primal_vector::<S>(self.surface.point), primal_vector::<S>(self.surface.normal))
    }

    /// A bit for each lane whose surface is seen from the side that faces a light: from behind, a
    /// light brings nothing, whatever is in its way. A normal that is not a number faces every light,
    /// so that it shows in the image.
    #[inline]
    fn facing(&self, normal: Vec3<S::Lanes>, to_light: Vec3<S::Lanes>) -> u32 {
        !S::Lanes::mask_bits(normal.dot(to_light).cmple(S::Lanes::ZERO)) & self.alive
    }

    /// Where rays that leave the surface points start: far enough outside not to meet the surface that
    /// they leave. Rays in the lanes `behind` leave on the side that the viewer does not see.
    pub fn origins(&self, behind: u32) -> [DVec3; MAX_LANES] {
        let (point, normal) = self.values();
        let offset = normal * (self.reach() * S::Lanes::from_f64(SURFACE_ERROR));
        let offset = select(S::Lanes::mask_from_bits(behind), -offset, offset);
        vectors_of_lanes::<S::Lanes>(point + offset)
    }

    /// The largest numbers that went into the surface points.
    #[inline]
    fn reach(&self) -> S::Lanes {
        let (point, _) = self.values();
        let origin = primal_vector::<S>(self.ray.origin);
        let depth = (point - origin).dot(primal_vector::<S>(self.ray.direction));
        point.abs().max_element().max(depth)
    }
}
