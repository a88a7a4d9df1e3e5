//! Rays that are traced, in single precision: what the path through a place of the image meets, and what is in the way
//! of lights.

use glam::DVec3;

use super::code::decode;
use super::geometry::{Geometry, Met};
use crate::primal::known::{KnownHit, Occluding};
use crate::primal::shadow::SURFACE_ERROR;
use crate::scene::MOST_EDGED_LIGHTS;
use crate::trace::bvh::NO_PRIMITIVE;
use crate::trace::layout::Kind;
use crate::transport::camera::Ray;
use crate::transport::smooth::curved_point;
use crate::transport::surface::SurfacePoint;
use crate::transport::triangle::triangle_point;

/// The cosine below which a shadow ray leaves its surface too slowly to begin farther on.
const GRAZING: f64 = 0.1;

/// How far apart rays of single precision have to be, beside the numbers that they are made of; and as a part of the
/// distance of samples, at the most.
const RESOLUTION: f64 = 128.0 * f32::EPSILON as f64;
const COARSEST: f64 = 0.2;

/// What is between a surface point and a light.
pub enum Shadow {
    /// Of the opaque primitives the one of the lowest number, in whatever order they are come to.
    Of(u32),
    /// These transparent surfaces, and nothing that is opaque. None where the point or the light faces away.
    Through(Vec<Occluding>),
}

impl Geometry<'_> {
    /// How many lights have shadows with edges.
    pub fn edged_lights(&self) -> usize {
        self.layout.lights.len().min(MOST_EDGED_LIGHTS)
    }

    /// The path of the ray through a place of the image, traced.
    pub fn trace(&self, place: [f64; 2], path: &mut Vec<KnownHit>) {
        let Self { layout, tracer, .. } = self;
        let mut ray = self.ray(&[], place);
        let (mut origin, mut from) = (ray.origin, None);
        for _ in 0..=layout.bounces {
            let met = tracer.bvh.nearest_but(from, origin.as_vec3(), ray.direction.as_vec3());
            let Some(met) = met else {
                path.push(decode(NO_PRIMITIVE));
                return;
            };
            let (blocked, filters) = (0, 0);
            let mut known =
                KnownHit { primitive: met.primitive, leaves: met.leaves, blocked, filters };
            let met_at = self.meet(&known, ray);
            for light in 0..self.edged_lights() {
                match self.shadow(light, &known, &met_at) {
                    Shadow::Of(_) => known.blocked |= 1 << light,
                    Shadow::Through(surfaces) => {
                        let filters = self.filters(light, &surfaces);
                        known.filters = known.filters.wrapping_add(filters);
                    }
                }
            }
            path.push(known);
            if !self.zero_weight.goes_on_from(layout, met.primitive as usize) {
                return;
            }
            let is_flat = self.is_triangle(met.primitive);
            let side = if self.is_transparent(met.primitive) { -1.0 } else { 1.0 };
            origin = met_at.surface.point + met_at.outward * (side * error_of(&met_at.surface));
            from = is_flat.then_some(met.primitive);
            ray = self.next(&known, &met_at);
        }
    }

    /// The cosine of the angle between the normal of a surface point and the direction of a light.
    pub fn facing(&self, light: usize, Met { surface, .. }: &Met) -> f64 {
        let towards = self.tracer.illuminate(light, surface.point);
        surface.normal.dot(towards.direction)
    }

    /// Whether a surface point and a light face each other.
    pub fn face_each_other(&self, light: usize, Met { surface, .. }: &Met) -> bool {
        let to_light = self.tracer.illuminate(light, surface.point).direction;
        self.face_along(light, surface.normal, to_light)
    }

    fn face_along(&self, light: usize, normal: DVec3, to_light: DVec3) -> bool {
        let known = self.tracer.known::<f64>(light);
        let is_turned_away = known.and_then(|light| light.is_turned_away(to_light));
        normal.dot(to_light) > 0.0 && is_turned_away != Some(true)
    }

    /// How much a light faces the shading normal where a ray meets a smooth triangle that has turned its back to it.
    pub fn facing_turned(&self, light: usize, triangle: u32, ray: Ray<f64>) -> Option<f64> {
        let met = self.meet(&KnownHit::of_triangle(triangle), ray);
        let to_light = self.tracer.illuminate(light, met.surface.point).direction;
        (met.outward.dot(to_light) <= 0.0).then(|| met.surface.normal.dot(to_light))
    }

    /// What is between a surface point and a light that face each other.
    pub fn shadow(&self, light: usize, known: &KnownHit, met: &Met) -> Shadow {
        let (blocker, through) = self.between(light, known, met);
        blocker.map_or(Shadow::Through(through), Shadow::Of)
    }

    /// The same: what is opaque, and the transparent surfaces, whether there is anything opaque or not.
    pub fn between(
        &self,
        light: usize,
        known: &KnownHit,
        Met { surface, outward, start }: &Met,
    ) -> (Option<u32>, Vec<Occluding>) {
        let Self { layout, tracer, zero_weight, .. } = self;
        if layout.lights[light].is_black && !zero_weight.lights {
            return (None, Vec::new());
        }
        let to_light = tracer.illuminate(light, surface.point).direction;
        let is_behind = outward.dot(to_light) <= 0.0;
        if is_behind
            && self.is_triangle(known.primitive)
            && layout.shades_itself(known.primitive as usize)
        {
            return (Some(known.primitive), Vec::new());
        }
        if !self.face_along(light, surface.normal, to_light) {
            return (None, Vec::new());
        }
        let towards = tracer.illuminate(light, *start);
        let cannot_return =
            self.is_triangle(known.primitive) && outward.dot(towards.direction) > 0.0;
        let from = cannot_return.then_some(known.primitive);
        // On the way to the light if that leads away from the surface: beside it, the ray would pass the edges of what
        // casts the shadow elsewhere.
        let error = error_of(surface);
        let cosine = outward.dot(towards.direction);
        let along = error / cosine.max(GRAZING);
        let origin = *start + towards.direction * along + *outward * (error - along * cosine);
        let (origin, direction) = (origin.as_vec3(), towards.direction.as_vec3());
        let (mut blocker, mut through) = (None, Vec::new());
        let limit = (towards.distance - along) as f32;
        tracer.bvh.visit_crossings(origin, direction, limit, from, |primitive, leaves| {
            // From outside no ray comes back to a sphere that it leaves.
            let is_itself =
                primitive == known.primitive && !known.leaves && !self.is_custom(primitive);
            if is_itself {
                return true;
            }
            if self.is_transparent(primitive) {
                through.push(Occluding { primitive, leaves });
            } else {
                blocker = Some(blocker.map_or(primitive, |other: u32| other.min(primitive)));
            }
            true
        });
        through.sort_unstable();
        (blocker, through)
    }

    /// How far apart shadow rays of single precision start that see the same, as a part of the way between the points
    /// that two places of the image show.
    pub fn resolution(&self, from: &Met, to: &Met) -> f64 {
        let [from, to] = [from, to].map(|met| met.surface.point);
        let reach = from.abs().max_element().max(from.distance(self.frame.origin));
        (RESOLUTION * reach / from.distance(to)).min(COARSEST)
    }

    /// The [number](crate::trace::layout::Layout::filters) of the materials of surfaces that a light comes through.
    pub fn filters(&self, light: usize, surfaces: &[Occluding]) -> u32 {
        let primitives = surfaces.iter().map(|surface| surface.primitive);
        self.layout.filters(light, primitives)
    }

    /// The ray from where a ray meets a primitive to a light.
    pub fn shadow_ray(&self, light: usize, known: &KnownHit, ray: Ray<f64>) -> Ray<f64> {
        let origin = match self.layout.kind_of(known.primitive as usize) {
            (Kind::Triangle, index) => {
                let triangle = self.triangle(index);
                let flat = triangle_point::<f64>(triangle, ray);
                self.normals(index).map_or(flat.point, |normals| {
                    curved_point::<f64>(triangle, normals, flat.point, flat.normal)
                })
            }
            _ => self.meet(known, ray).start,
        };
        Ray { origin, direction: self.tracer.illuminate(light, origin).direction }
    }
}

/// How far from a surface point its rays start. The point itself is exact: it need not be as far as where rays of single
/// precision come from afar.
fn error_of(surface: &SurfacePoint<f64>) -> f64 {
    SURFACE_ERROR * surface.point.abs().max_element()
}
