//! Shapes and lights that users add: one ray, and one lane, at a time.

use std::array;

use ad::Vec3;
use ad::lanes::Lanes;
use glam::DVec3;

use super::prepared::Prepared;
use super::settings::Pass;
use super::sharing::Sharing;
use super::view::Group;
use crate::acceleration::{Hit, PacketHits, PacketVectors, rays};
use crate::kernels::camera::{Ray, RayTangent};
use crate::kernels::light::{Illumination, IlluminationTangent};
use crate::kernels::surface::{SurfacePoint, SurfacePointTangent};
use crate::precision::{MOST_LANES, lanes_of_vectors, vectors_of_lanes};
use crate::scene::CustomLightObject;

impl<L: Lanes> Prepared<'_, L> {
    /// Where custom shapes are nearer than what the wanted rays of a packet have met so far.
    pub(super) fn nearer_custom_shapes(
        &self,
        origin: glam::Vec3,
        directions: &PacketVectors,
        wanted: u64,
        hits: &mut PacketHits,
    ) {
        if self.scene.shapes.is_empty() {
            return;
        }
        for ray in rays(wanted) {
            let so_far = hits.get(ray);
            let nearer = self.nearer_custom_shape(origin, directions.get(ray), so_far);
            if let Some(hit) = nearer {
                hits.set(ray, hit);
            }
        }
    }

    /// What a ray meets first: a custom shape, or what it has met so far.
    pub(super) fn nearer_custom_shape(
        &self,
        origin: glam::Vec3,
        direction: glam::Vec3,
        so_far: Option<Hit>,
    ) -> Option<Hit> {
        let mut nearest = so_far;
        for index in 0..self.scene.shapes.len() {
            if let Some(distance) = self.meet_custom_shape(index, origin, direction)
                && nearest.is_none_or(|hit| distance < hit.distance)
            {
                let primitive = (self.triangles.len() + self.spheres.len() + index) as u32;
                nearest = Some(Hit { primitive, distance, leaves: false });
            }
        }
        nearest
    }

    /// Whether a custom shape is met before `limit`.
    pub(super) fn is_behind_custom_shape(
        &self,
        origin: glam::Vec3,
        direction: glam::Vec3,
        limit: f32,
    ) -> bool {
        let mut distances = (0..self.scene.shapes.len())
            .filter_map(|index| self.meet_custom_shape(index, origin, direction));
        distances.any(|distance| distance < limit)
    }

    /// The distance at which a ray meets a custom shape, in lengths of its direction.
    fn meet_custom_shape(
        &self,
        index: usize,
        origin: glam::Vec3,
        direction: glam::Vec3,
    ) -> Option<f32> {
        let shape = &self.scene.shapes[index].shape;
        let parameters = &self.parameters.shapes[index];
        let (origin, direction) = (origin.as_dvec3() + self.middle, direction.as_dvec3());
        let (low, high) = shape.bounds(parameters);
        let (to_low, to_high) = ((low - origin) / direction, (high - origin) / direction);
        // Where the ray runs within a plane of the box, 0 / 0 leaves the other planes to decide.
        let enter = to_low.min(to_high).to_array().into_iter().fold(0.0, f64::max);
        let leave = to_low.max(to_high).to_array().into_iter().fold(f64::INFINITY, f64::min);
        if enter > leave {
            return None;
        }
        let length = direction.length();
        let ray = Ray { origin, direction: direction / length };
        shape.intersect(parameters, ray).map(|distance| (distance / length) as f32)
    }

    /// The points at which rays meet custom shapes; the normal is turned to the viewer.
    pub(super) fn custom_surface(
        &self,
        primitives: &Sharing,
        ray: Ray<L>,
        alive: u32,
    ) -> SurfacePoint<L> {
        let (mut points, mut normals) = ([DVec3::ZERO; MOST_LANES], [DVec3::ZERO; MOST_LANES]);
        self.each_custom(primitives, ray, alive, |lane, index, ray| {
            let shape = &self.scene.shapes[index].shape;
            let surface = shape.surface(&self.parameters.shapes[index], ray);
            points[lane] = surface.point - self.middle;
            normals[lane] = surface.normal * facing(&surface);
        });
        let first = alive.trailing_zeros() as usize % MOST_LANES;
        let repeated = |v: [DVec3; MOST_LANES]| {
            let counts = |lane: usize| if alive >> lane & 1 == 1 { lane } else { first };
            lanes_of_vectors::<L>(&array::from_fn(|lane| v[counts(lane)]))
        };
        SurfacePoint { point: repeated(points), normal: repeated(normals), view: -ray.direction }
    }

    /// Pulls the cotangent of [`custom_surface`](Self::custom_surface) back: to the parameters of each
    /// shape, and to the rays.
    pub(super) fn pull_custom_surface(
        &self,
        group: &Group<L>,
        cotangent: SurfacePointTangent<L>,
        to_parameters: &mut [Vec<f64>],
    ) -> RayTangent<L> {
        let SurfacePointTangent { point, normal, view } = cotangent;
        let [points, normals, views] = [point, normal, view].map(vectors_of_lanes::<L>);
        let (mut origins, mut directions) = ([DVec3::ZERO; MOST_LANES], [DVec3::ZERO; MOST_LANES]);
        self.each_custom(&group.primitives, group.ray, group.alive, |lane, index, ray| {
            let shape = &self.scene.shapes[index].shape;
            let parameters = &self.parameters.shapes[index];
            let side = facing(&shape.surface(parameters, ray));
            let cotangent = SurfacePointTangent {
                point: points[lane],
                normal: normals[lane] * side,
                view: views[lane],
            };
            let sums = &mut to_parameters[index];
            let to_ray = shape.surface_pullback(parameters, ray, cotangent, sums);
            (origins[lane], directions[lane]) = (to_ray.origin, to_ray.direction);
        });
        RayTangent {
            origin: lanes_of_vectors::<L>(&origins),
            direction: lanes_of_vectors::<L>(&directions),
        }
    }

    /// Calls `visit` with each lane that counts, the index of its custom shape, and its ray, in the
    /// coordinates of the scene.
    fn each_custom(
        &self,
        primitives: &Sharing,
        ray: Ray<L>,
        alive: u32,
        mut visit: impl FnMut(usize, usize, Ray<f64>),
    ) {
        let (origins, directions) =
            (vectors_of_lanes::<L>(ray.origin), vectors_of_lanes::<L>(ray.direction));
        for (primitive, lanes) in primitives.iter() {
            let index = primitive - self.triangles.len() - self.spheres.len();
            for lane in rays((lanes & alive).into()) {
                let origin = origins[lane] + self.middle;
                visit(lane, index, Ray { origin, direction: directions[lane].normalize() });
            }
        }
    }

    /// What custom lights bring to the points of a group.
    pub(super) fn custom_illuminations(&self, group: &Group<L>) -> Vec<Illumination<L>> {
        if self.pass == Pass::Albedo || self.scene.custom_lights.is_empty() {
            return Vec::new();
        }
        let points = vectors_of_lanes::<L>(group.surface.point);
        let lights = self.scene.custom_lights.iter().zip(&self.parameters.custom_lights);
        let illumination = |(object, parameters): (&CustomLightObject, &Vec<f64>)| {
            let at: [Illumination<f64>; MOST_LANES] = array::from_fn(|lane| {
                // Lanes beyond the last one have no point.
                let point = points[lane.min(L::COUNT - 1)] + self.middle;
                object.light.illumination(parameters, point)
            });
            Illumination {
                direction: lanes_of_vectors::<L>(&at.map(|it| it.direction)),
                irradiance: lanes_of_vectors::<L>(&at.map(|it| it.irradiance)),
            }
        };
        lights.map(illumination).collect()
    }

    /// Pulls the cotangent of what a custom light brings to a group back: to its parameters, and to
    /// the points.
    pub(super) fn pull_custom_illumination(
        &self,
        group: &Group<L>,
        light: usize,
        cotangent: IlluminationTangent<L>,
        to_parameters: &mut [f64],
    ) -> Vec3<L> {
        let points = vectors_of_lanes::<L>(group.surface.point);
        let directions = vectors_of_lanes::<L>(cotangent.direction);
        let irradiances = vectors_of_lanes::<L>(cotangent.irradiance);
        let mut to_points = [DVec3::ZERO; MOST_LANES];
        for lane in rays(group.alive.into()) {
            let cotangent =
                IlluminationTangent { direction: directions[lane], irradiance: irradiances[lane] };
            if cotangent.direction != DVec3::ZERO || cotangent.irradiance != DVec3::ZERO {
                to_points[lane] = self.scene.custom_lights[light].light.illumination_pullback(
                    &self.parameters.custom_lights[light],
                    points[lane] + self.middle,
                    cotangent,
                    to_parameters,
                );
            }
        }
        lanes_of_vectors::<L>(&to_points)
    }
}

/// 1 if the normal of a point is on the side of the viewer, else -1.
fn facing(surface: &SurfacePoint<f64>) -> f64 {
    1.0_f64.copysign(surface.normal.dot(surface.view))
}
