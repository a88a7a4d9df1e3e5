//! How vertices look for emitters.

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Real, Vec3};

use super::directions::Scatterer;
use super::{Chosen, EmitterPoints, EmitterSample, EmitterSource};
use crate::number::{MAX_LANES, Number, constant_vector, primal_vector};
use crate::primal::coalesce::Coalesced;
use crate::primal::integrator::Integrator;
use crate::primal::lanes::{lanes_of_numbers, set_singles};
use crate::primal::shadow::Shadows;
use crate::primal::wavefront::{LaneGroup, Wavefront};
use crate::trace::layout::Kind;
use crate::trace::random::{PathNumbers, Purpose, RayNumbers};
use crate::transport::emitter::{
    BEFORE, Sight, barycentric_of, emitter_spread, illuminate_by_emitter, sight_of,
};
use crate::transport::environment::direction_of;
use crate::transport::hit::Primitive;

impl Shadows {
    /// Adds the rays from some lanes of a group to what they look for, and returns that, whether they see it
    /// or not; nothing if it is behind all of them.
    fn look<S: Number>(
        &mut self,
        from: &Scatterer<'_, S>,
        lanes: u32,
        sight: &Sight<S>,
        (source, emission): (EmitterSource<S::Lanes>, Vec3<S>),
    ) -> Option<EmitterSample<S>> {
        let group = from.group;
        let direction = primal_vector::<S>(sight.direction);
        let spreads = sight.spread.primal().cmpgt(S::Lanes::ZERO);
        let lanes = lanes & group.lit_from(direction) & S::Lanes::mask_bits(spreads);
        if lanes == 0 {
            return None;
        }
        let distance = sight.distance.primal();
        group.add_shadow_rays(&mut self.batch, lanes, direction, distance);
        let before = distance * S::Lanes::from_f64(1.0 - BEFORE);
        set_singles(&mut self.limits[group.first..], lanes, before);
        let weighted = emitter_spread::<S>(sight.spread, from.density(sight.direction));
        let Sight { direction, distance, .. } = *sight;
        let illumination = illuminate_by_emitter::<S>(emission, direction, distance, weighted);
        Some(EmitterSample { group: group.index, lanes, source, emission, weighted, illumination })
    }
}

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
            let numbers = numbers.at(depth, Purpose::Emitter);
            let mut shadows = Shadows::new(&wavefront.hits);
            for group in &wavefront.groups {
                self.look_from(&numbers, wavefront, group, &mut shadows, &mut found);
            }
            let seen = shadows.unoccluded(&self.tracer.bvh);
            found.retain_mut(|sample| {
                sample.lanes &= wavefront.groups[sample.group].lanes_of(seen);
                sample.lanes != 0
            });
        }
        wavefront.scattering.emitters = found;
    }

    /// Adds the emitters that a group looks for, whether it sees them or not, and the rays there.
    fn look_from(
        &self,
        numbers: &RayNumbers,
        wavefront: &Wavefront<S>,
        group: &LaneGroup<S>,
        shadows: &mut Shadows,
        found: &mut Vec<EmitterSample<S>>,
    ) {
        let scatterer = self.scatterer_of(wavefront, group);
        let chosen = &mut shadows.targets;
        let mut choices = [0.0; MAX_LANES];
        let mut within = [[0.0; 2]; MAX_LANES];
        let (mut of_kind, mut itself, mut in_sky) = ([0; 2], 0, 0);
        let first_cell = self.layout.material_of.len() as u32;
        let mut places = [[0.0; 3]; MAX_LANES];
        let mut spreads = [0.0; MAX_LANES];
        for (lane, ray) in group.rays() {
            // A path that is never scattered here has no use for them.
            if scatterer.unscattered[lane] >= 1.0 {
                continue;
            }
            let [choice, fine, u, v] = numbers.of(ray).map(f64::from);
            // One number of 23 bits does not tell a million emitters apart.
            let (primitive, one_of) = self.emitters.choose(choice + fine / f64::from(1 << 23));
            if let (Some(sky), Some(rank)) = (&self.layout.sky, primitive.checked_sub(first_cell)) {
                let cell = sky.cell(rank);
                places[lane] = sky.place(cell, [u, v]);
                spreads[lane] = sky.solid_angle(cell.1) * one_of;
                in_sky |= 1 << lane;
                continue;
            }
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
            let primitives = Coalesced::new(&shadows.targets, group.first, lanes);
            let at = match kind {
                Kind::Triangle => barycentric_of(numbers),
                _ => [numbers[0], numbers[1], S::Lanes::ZERO],
            };
            let chosen = Chosen::LookedFor;
            let mut points = EmitterPoints { kind, primitives, inside: 0, choices, at, chosen };
            if let Some(Primitive::Sphere(sphere)) = self.primitive(kind, &points.primitives) {
                let away = (sphere.center - group.surface.point).length().primal();
                points.inside = S::Lanes::mask_bits(away.cmplt(sphere.radius.primal())) | itself;
            }
            let Some(sight) = self.sight(&points, group.surface.point) else { continue };
            let seen = (sight.direction, sight.distance);
            let emission = self.emission(&points, group.surface.point, seen);
            let source = EmitterSource::Surfaces(points);
            found.extend(shadows.look(&scatterer, lanes, &sight, (source, emission)));
        }
        if in_sky != 0 {
            let place = [0, 1, 2]
                .map(|number| lanes_of_numbers::<S::Lanes>(&places.map(|place| place[number])));
            let sight = Sight {
                direction: constant_vector::<S>(direction_of::<S::Lanes>(place)),
                distance: S::constant(S::Lanes::ONE / S::Lanes::ZERO),
                spread: S::constant(lanes_of_numbers::<S::Lanes>(&spreads)),
            };
            let Some(light) = self.sky_light(in_sky, sight.direction) else { return };
            let source = (EmitterSource::Sky, light.radiance());
            found.extend(shadows.look(&scatterer, in_sky, &sight, source));
        }
    }

    /// How points of surfaces are seen that shine; nothing for shapes of one's own, which are not looked for.
    pub fn sight(&self, points: &EmitterPoints<S::Lanes>, from: Vec3<S>) -> Option<Sight<S>> {
        let (at, choices) = (points.at.map(S::constant), S::constant(points.choices));
        let primitive = self.primitive(points.kind, &points.primitives)?;
        Some(sight_of::<S>(primitive, S::mask(points.inside), at, choices, from))
    }
}
