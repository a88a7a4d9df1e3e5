//! Emitters that scattered rays find.
//!
//! What a scattered ray finds counts where it was scattered, like what was looked for there, and not where it
//! ends: as the scene moves, the point that was found stays on its emitter, and the direction follows. So the
//! borders of emitters, over which a direction that stays would come, are no edges; and the weights of both
//! ways to a point, which add up to 1, do so wherever it moves.

use ad::lanes::Lanes;
use ad::{Fields, Real, select};

use super::{Chosen, EmitterPoints, EmitterSample, EmitterSource};
use crate::number::{MAX_LANES, Number, primal_vector};
use crate::primal::coalesce::Coalesced;
use crate::primal::integrator::Integrator;
use crate::primal::lanes::lanes_of_numbers;
use crate::primal::wavefront::{LaneGroup, Wavefront, put};
use crate::trace::bvh::rays;
use crate::transport::emitter::{cone_numbers, found_spread, illuminate_by_emitter, sight_of};
use crate::transport::hit::Primitive;
use crate::transport::triangle::barycentric;

impl<S: Number> Integrator<'_, S> {
    /// Moves what rays found that were scattered from a wavefront, of emitters that are also looked for, to the
    /// places that they come from.
    pub(super) fn give_found(&self, from: &mut Wavefront<S>, to: &mut Wavefront<S>) {
        let mut given = Vec::new();
        for met in &to.groups {
            let is_looked_for = |primitive| self.emitters.choices(primitive as u32).is_finite();
            let shining = met.primitives.lanes_where(is_looked_for);
            if shining == 0 {
                continue;
            }
            for group in from.groups.iter().filter(|group| group.first == met.first) {
                let event = from.scattering.events[group.block()];
                let lanes = shining & group.alive & !(event.straight | event.mirrored);
                let sample = self.found_sample((from, group), (to, met), lanes);
                let lanes = sample.as_ref().map_or(0, |sample| sample.lanes);
                put(group.lanes(), lanes, &S::ZERO, &mut to.scattering.found);
                given.extend(sample);
            }
        }
        if !given.is_empty() {
            from.scattering.emitters.extend(given);
            from.scattering.emitters.sort_by_key(|sample| sample.group);
        }
    }

    /// What rays from some lanes of a group have found, of groups in two wavefronts.
    fn found_sample(
        &self,
        (from, group): (&Wavefront<S>, &LaneGroup<S>),
        (to, met): (&Wavefront<S>, &LaneGroup<S>),
        lanes: u32,
    ) -> Option<EmitterSample<S>> {
        if lanes == 0 {
            return None;
        }
        let point = primal_vector::<S>(group.surface.point);
        let primitives = Coalesced::new(&to.hits.primitive, met.first, lanes);
        let mut choices = [1.0; MAX_LANES];
        for lane in rays(lanes.into()) {
            choices[lane] = self.emitters.choices(to.hits.primitive[met.first + lane]);
        }
        let choices = lanes_of_numbers::<S::Lanes>(&choices);
        let primitive = self.primitive(met.kind, &primitives)?;
        let at = match primitive {
            Primitive::Triangle(triangle) => {
                let met = primal_vector::<S>(met.surface.point);
                barycentric::<S::Lanes>(triangle.map(S::primal), met)
            }
            Primitive::Sphere(sphere) => {
                let inside = S::Lanes::mask_from_bits(met.inside);
                let direction = primal_vector::<S>(met.ray.direction);
                cone_numbers::<S::Lanes>(sphere.map(S::primal), inside, point, direction)
            }
        };
        let sight = sight_of::<S>(
            primitive,
            S::mask(met.inside),
            at.map(S::constant),
            S::constant(choices),
            group.surface.point,
        );
        let spread = sight.spread.primal();
        let counts = spread.cmpgt(S::Lanes::ZERO) & Real::is_finite(spread);
        let lanes = lanes & S::Lanes::mask_bits(counts);
        if lanes == 0 {
            return None;
        }
        let spread = select(counts, spread, S::Lanes::ONE);
        let factor = from.scattering.events[group.block()].factor.primal();
        let points = EmitterPoints {
            kind: met.kind,
            primitives,
            inside: met.inside,
            choices,
            at,
            chosen: Chosen::Scattered { spread, factor },
        };
        let density = self.scatterer_of(from, group).density(sight.direction);
        let [spread, factor] = [spread, factor].map(S::constant);
        let weighted = found_spread::<S>(sight.spread, density, spread, factor);
        let emission = self.emission(&points);
        let illumination =
            illuminate_by_emitter::<S>(emission, sight.direction, sight.distance, weighted);
        let source = EmitterSource::Surfaces(points);
        Some(EmitterSample { group: group.index, lanes, source, emission, weighted, illumination })
    }
}
