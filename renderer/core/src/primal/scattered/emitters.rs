//! How vertices look for emitters.

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Real, Vec3, select};
use glam::DVec3;

use super::EmitterSample;
use crate::counts::count;
use crate::number::{MAX_LANES, Number, primal_vector};
use crate::primal::coalesce::Coalesced;
use crate::primal::integrator::Integrator;
use crate::primal::lanes::{lanes_of_numbers, numbers_of_lanes, vectors_of_lanes};
use crate::primal::wavefront::{LaneGroup, Wavefront};
use crate::trace::bvh::{NO_PRIMITIVE, PACKET_RAYS, rays};
use crate::trace::layout::Kind;
use crate::trace::random::{PathNumbers, Purpose};
use crate::transport::emitter::{
    Sight, emitter_spread, illuminate_by_emitter, sight_of_sphere, sight_of_triangle,
    sphere_spread, triangle_spread,
};
use crate::transport::hit::Primitive;

/// How far before an emitter a shadow ray ends, relative to its length: its neighbours touch it.
const BEFORE: f64 = 1e-4;

impl<S: Number> Integrator<'_, S> {
    /// Looks for one emitter from every surface point.
    pub(super) fn look_for_emitters(
        &self,
        depth: u32,
        numbers: &PathNumbers,
        wavefront: &mut Wavefront<S>,
    ) {
        let mut found = std::mem::take(&mut wavefront.scattering.emitters);
        found.clear();
        if !self.emitters.is_empty() {
            for group in &wavefront.groups {
                self.look_from(depth, numbers, wavefront, group, &mut found);
            }
        }
        wavefront.scattering.emitters = found;
    }

    fn look_from(
        &self,
        depth: u32,
        numbers: &PathNumbers,
        wavefront: &Wavefront<S>,
        group: &LaneGroup<S>,
        found: &mut Vec<EmitterSample<S>>,
    ) {
        let unscattered = self.unscattered(group);
        let mut chosen = [NO_PRIMITIVE; PACKET_RAYS];
        let mut choices = [0.0; MAX_LANES];
        let mut within = [[0.0; 2]; MAX_LANES];
        let (mut of_kind, mut itself) = ([0; 2], 0);
        for (lane, ray) in group.rays() {
            // A path that is never scattered here has no use for them.
            if unscattered[lane] >= 1.0 {
                continue;
            }
            let [choice, fine, u, v] = numbers.at(ray, depth, Purpose::Emitter).map(f64::from);
            // One number of 24 bits does not tell a million emitters apart.
            let (primitive, one_of) = self.emitters.choose(choice + fine / f64::from(1 << 24));
            (chosen[ray], choices[lane], within[lane]) = (primitive, one_of, [u, v]);
            let (kind, _) = self.layout.kind_of(primitive as usize);
            // A surface sees itself only from inside of a sphere.
            let is_itself = primitive == wavefront.hits.primitive[ray];
            if is_itself && group.inside >> lane & 1 == 0 {
                continue;
            }
            itself |= u32::from(is_itself) << lane;
            of_kind[usize::from(kind == Kind::Sphere)] |= 1 << lane;
        }
        let numbers = [0, 1].map(|axis| lanes_of_numbers::<S::Lanes>(&within.map(|at| at[axis])));
        let choices = lanes_of_numbers::<S::Lanes>(&choices);
        for (kind, lanes) in [(Kind::Triangle, of_kind[0]), (Kind::Sphere, of_kind[1])] {
            if lanes == 0 {
                continue;
            }
            let primitives = Coalesced::new(&chosen, group.first, lanes);
            let Some(primitive) = self.primitive(kind, &primitives) else { continue };
            let constant = S::constant;
            let (numbers, choices, point) =
                (numbers.map(constant), constant(choices), group.surface.point);
            let sight = match primitive {
                Primitive::Triangle(triangle) => {
                    let barycentric = barycentric_of(numbers);
                    sight_of_triangle::<S>(triangle, barycentric, choices, point)
                }
                Primitive::Sphere(sphere) => {
                    let away = (sphere.center - point).length().primal();
                    let inside = S::Lanes::mask_bits(away.cmplt(sphere.radius.primal())) | itself;
                    sight_of_sphere::<S>(sphere, S::mask(inside), numbers, choices, point)
                }
            };
            let seen = self.seen(wavefront, group, lanes, &chosen, &sight);
            if seen == 0 {
                continue;
            }
            let scattered = lanes_of_numbers::<S::Lanes>(&unscattered.map(|part| 1.0 - part));
            let cosine = group.surface.normal.dot(sight.direction);
            let density = cosine * (constant(scattered) / S::PI);
            let weighted = emitter_spread::<S>(sight.spread, density);
            let materials = self.materials(&primitives);
            let emission = materials.gather::<S, Vec3<S>>(|material| {
                crate::number::splat_vector::<S>(self.inputs.materials[material].emission)
            });
            let Sight { direction, distance, .. } = sight;
            found.push(EmitterSample {
                group: group.index,
                lanes: seen,
                materials,
                emission,
                weighted,
                illumination: illuminate_by_emitter::<S>(emission, direction, distance, weighted),
            });
        }
    }

    /// Which of some lanes see what they look for. Light reaches no surface from behind its geometry,
    /// whatever it is shaded with.
    fn seen(
        &self,
        wavefront: &Wavefront<S>,
        group: &LaneGroup<S>,
        lanes: u32,
        chosen: &[u32; PACKET_RAYS],
        sight: &Sight<S>,
    ) -> u32 {
        let direction = primal_vector::<S>(sight.direction);
        let spreads = sight.spread.primal().cmpgt(S::Lanes::ZERO);
        let lanes = lanes & group.leave_surface(direction) & S::Lanes::mask_bits(spreads);
        count(|counts| &counts.shadow_rays, u64::from(lanes.count_ones()));
        let origins = group.origins(0);
        let directions = vectors_of_lanes::<S::Lanes>(direction);
        let distances = numbers_of_lanes::<S::Lanes>(sight.distance.primal());
        let is_seen = |&lane: &usize| {
            let ray = group.first + lane;
            let (from, emitter) = (group.starts_on(wavefront, ray), chosen[ray]);
            let limit = distances[lane] * (1.0 - BEFORE);
            let origin: DVec3 = origins[lane];
            !self.tracer.bvh.is_occluded_but(
                origin.as_vec3(),
                directions[lane].as_vec3(),
                limit as f32,
                |primitive| primitive == emitter || from == Some(primitive),
            )
        };
        rays(lanes.into()).filter(is_seen).fold(0, |seen, lane| seen | 1 << lane)
    }

    /// The spreads of the directions in which a group was found, had its primitives been looked for;
    /// infinite where they would not have been.
    pub(super) fn spread_of_found(
        &self,
        wavefront: &Wavefront<S>,
        group: &LaneGroup<S>,
    ) -> S::Lanes {
        let mut choices = [f64::INFINITY; MAX_LANES];
        for (lane, ray) in group.rays() {
            choices[lane] = self.emitters.choices(wavefront.hits.primitive[ray]);
        }
        let of_lanes = lanes_of_numbers::<S::Lanes>(&choices);
        let chosen = Real::is_finite(of_lanes);
        let infinite = S::Lanes::ONE / S::Lanes::ZERO;
        if S::Lanes::mask_bits(chosen) & group.alive == 0 {
            return infinite;
        }
        let choices = S::constant(select(chosen, of_lanes, S::Lanes::ONE));
        let spread = match self.primitive(group.kind, &group.primitives) {
            Some(Primitive::Triangle(triangle)) => {
                let distance = (group.surface.point - group.ray.origin).length();
                triangle_spread::<S>(triangle, choices, group.ray.direction, distance)
            }
            Some(Primitive::Sphere(sphere)) => {
                let inside = S::mask(group.inside);
                sphere_spread::<S>(sphere, inside, choices, group.ray.origin)
            }
            None => return infinite,
        };
        select(chosen, spread.primal(), infinite)
    }
}

/// Two even numbers as the barycentric coordinates of an even point of a triangle (Turk 1990).
fn barycentric_of<S: Real>([u, v]: [S; 2]) -> [S; 3] {
    let root = u.sqrt();
    let (at_a, at_b) = (S::ONE - root, root * (S::ONE - v));
    [at_a, at_b, root * v]
}
