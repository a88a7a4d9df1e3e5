//! Emitters that scattered rays find.
//!
//! What a scattered ray finds counts where it was scattered, like what was looked for there, and not where it
//! ends: as the scene moves, the point that was found stays on its emitter, and the direction follows. So the
//! borders of emitters, over which a direction that stays would come, are no edges; and the weights of both
//! ways to a point, which add up to 1, do so wherever it moves.

use ad::lanes::Lanes;
use ad::{Fields, Real, select};

use super::{Chosen, EmitterPoints, EmitterSample, EmitterSource};
use crate::number::{MAX_LANES, Number};
use crate::primal::coalesce::Coalesced;
use crate::primal::integrator::Integrator;
use crate::primal::lanes::lanes_of_numbers;
use crate::primal::wavefront::{LaneGroup, Wavefront};
use crate::trace::bvh::{PacketHits, rays};
use crate::trace::layout::Kind;
use crate::transport::camera::Ray;
use crate::transport::emitter::{cone_numbers, found_spread, illuminate_by_emitter, sight_of};
use crate::transport::hit::Primitive;
use crate::transport::triangle::{barycentric, triangle_point};

/// Two lists in the order of their groups as one; of a group, what the first one has comes first.
fn merged<S: Number>(
    first: Vec<EmitterSample<S>>,
    second: Vec<EmitterSample<S>>,
) -> Vec<EmitterSample<S>> {
    let mut merged = Vec::with_capacity(first.len() + second.len());
    let mut second = second.into_iter().peekable();
    for sample in first {
        while let Some(before) = second.next_if(|before| before.group < sample.group) {
            merged.push(before);
        }
        merged.push(sample);
    }
    merged.extend(second);
    merged
}

impl<S: Number> Integrator<'_, S> {
    /// Adds what rays have found that were scattered from a wavefront, of emitters that are also looked for, to
    /// what was looked for there; returns a bit for each of these rays.
    pub(super) fn add_found(&self, from: &mut Wavefront<S>, hits: &PacketHits) -> u64 {
        let (mut given, mut found) = (Vec::new(), 0);
        for group in &from.groups {
            let event = from.scattering.events[group.block()];
            let scattered = group.lanes_of(hits.met()) & !(event.straight | event.mirrored);
            let mut choices = [1.0; MAX_LANES];
            let mut of_kind = [0; 2];
            for lane in rays(scattered.into()) {
                let primitive = hits.primitive[group.first + lane];
                let choice = self.emitters.choices(primitive);
                if choice.is_finite() {
                    let (kind, _) = self.layout.kind_of(primitive as usize);
                    choices[lane] = choice;
                    of_kind[usize::from(kind == Kind::Sphere)] |= 1 << lane;
                }
            }
            for (kind, lanes) in [(Kind::Triangle, of_kind[0]), (Kind::Sphere, of_kind[1])] {
                let sample = self.found_sample(from, group, hits, &choices, (kind, lanes));
                found |= sample.as_ref().map_or(0, |sample| u64::from(sample.lanes)) << group.first;
                given.extend(sample);
            }
        }
        if !given.is_empty() {
            let looked_for = std::mem::take(&mut from.scattering.emitters);
            from.scattering.emitters = merged(looked_for, given);
        }
        found
    }

    /// What rays from some lanes of a group have found, of one kind, by one over the probabilities with which it
    /// is looked for.
    fn found_sample(
        &self,
        from: &Wavefront<S>,
        group: &LaneGroup<S>,
        hits: &PacketHits,
        choices: &[f64; MAX_LANES],
        (kind, lanes): (Kind, u32),
    ) -> Option<EmitterSample<S>> {
        if lanes == 0 {
            return None;
        }
        let event = from.scattering.events[group.block()];
        let ray = Ray { origin: group.surface.point, direction: event.direction }.map(S::primal);
        let primitives = Coalesced::new(&hits.primitive, group.first, lanes);
        let inside = group.lanes_of(hits.leaves);
        let choices = lanes_of_numbers::<S::Lanes>(choices);
        let primitive = self.primitive(kind, &primitives)?;
        let at = match primitive {
            Primitive::Triangle(triangle) => {
                let triangle = triangle.map(S::primal);
                let met = triangle_point::<S::Lanes>(triangle, ray).point;
                barycentric::<S::Lanes>(triangle, met)
            }
            Primitive::Sphere(sphere) => {
                let inside = S::Lanes::mask_from_bits(inside);
                let Ray { origin, direction } = ray;
                cone_numbers::<S::Lanes>(sphere.map(S::primal), inside, origin, direction)
            }
        };
        let sight = sight_of::<S>(
            primitive,
            S::mask(inside),
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
        let factor = event.factor.primal();
        let points = EmitterPoints {
            kind,
            primitives,
            inside,
            choices,
            at,
            chosen: Chosen::Scattered { spread, factor },
        };
        let density = self.scatterer_of(from, group).density(sight.direction);
        let [spread, factor] = [spread, factor].map(S::constant);
        let weighted = found_spread::<S>(sight.spread, density, spread, factor);
        let emission =
            self.emission(&points, group.surface.point, (sight.direction, sight.distance));
        let illumination =
            illuminate_by_emitter::<S>(emission, sight.direction, sight.distance, weighted);
        let source = EmitterSource::Surfaces(points);
        Some(EmitterSample { group: group.index, lanes, source, emission, weighted, illumination })
    }
}
