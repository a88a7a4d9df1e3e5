//! How vertices look for emitters.

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Real, Vec3, select};
use glam::DVec3;

use super::directions::{Facets, likelihood};
use super::{EmitterSample, EmitterSource};
use crate::counts::count;
use crate::number::{MAX_LANES, Number, constant_vector, primal_vector};
use crate::primal::coalesce::Coalesced;
use crate::primal::integrator::Integrator;
use crate::primal::lanes::{lanes_of_numbers, lanes_of_vectors, singles_of_lanes};
use crate::primal::wavefront::{LaneGroup, Wavefront};
use crate::trace::bvh::{Batch, NO_PRIMITIVE, PACKET_RAYS, rays};
use crate::trace::layout::Kind;
use crate::trace::random::{PathNumbers, Purpose, RayNumbers};
use crate::transport::emitter::{
    Sight, emitter_spread, illuminate_by_emitter, sight_of_sphere, sight_of_triangle,
    sphere_spread, triangle_spread,
};
use crate::transport::hit::Primitive;
use crate::transport::material::Bsdf;

/// How far before an emitter a shadow ray ends, relative to its length: its neighbours touch it.
const BEFORE: f64 = 1e-4;

/// The rays to emitters.
struct Shadows {
    batch: Batch,
    /// By ray: where they end.
    limits: [f32; PACKET_RAYS],
    /// By ray: the emitters.
    targets: [u32; PACKET_RAYS],
}

impl Default for Shadows {
    fn default() -> Self {
        let targets = [NO_PRIMITIVE; PACKET_RAYS];
        Self { batch: Batch::default(), limits: [0.0; PACKET_RAYS], targets }
    }
}

/// Surfaces that look for emitters.
struct Place<'a, S: Number> {
    wavefront: &'a Wavefront<S>,
    group: &'a LaneGroup<S>,
    unscattered: [f64; MAX_LANES],
    facets: Option<Facets<S::Lanes>>,
}

impl Shadows {
    /// Adds the rays from some lanes of a group to what they look for, and returns that, whether they see it
    /// or not; nothing if it is behind all of them.
    fn look<S: Number>(
        &mut self,
        from: &Place<'_, S>,
        lanes: u32,
        sight: &Sight<S>,
        (source, emission): (EmitterSource, Vec3<S>),
    ) -> Option<EmitterSample<S>> {
        let &Place { wavefront, group, ref unscattered, ref facets } = from;
        let direction = primal_vector::<S>(sight.direction);
        let spreads = sight.spread.primal().cmpgt(S::Lanes::ZERO);
        // Light reaches no surface from behind its geometry, whatever it is shaded with.
        let lanes = lanes & group.leave_surface(direction) & S::Lanes::mask_bits(spreads);
        if lanes == 0 {
            return None;
        }
        group.add_to(&mut self.batch, wavefront, lanes, 0, direction);
        let before = sight.distance.primal() * S::Lanes::from_f64(1.0 - BEFORE);
        let before = singles_of_lanes::<S::Lanes>(before);
        rays(lanes.into()).for_each(|lane| self.limits[group.first + lane] = before[lane]);
        let scattered = lanes_of_numbers::<S::Lanes>(&unscattered.map(|part| 1.0 - part));
        let likelihood = likelihood::<S>(group, facets.as_ref(), sight.direction);
        let density = likelihood * (S::constant(scattered) / S::PI);
        let weighted = emitter_spread::<S>(sight.spread, density);
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
            let mut shadows = Shadows::default();
            for group in &wavefront.groups {
                self.look_from(&numbers, wavefront, group, &mut shadows, &mut found);
            }
            let Shadows { batch, limits, targets } = &shadows;
            count(|counts| &counts.shadow_rays, u64::from(batch.active.count_ones()));
            let seen = batch.active & !self.tracer.bvh.occluded_batch(batch, limits, targets);
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
        let unscattered = self.unscattered(group);
        let facets = match group.bsdf {
            Bsdf::MetallicRoughness => self.facets(&self.vertex(group, wavefront, None)),
            Bsdf::BlinnPhong | Bsdf::Dielectric => None,
        };
        let place = Place { wavefront, group, unscattered, facets };
        let chosen = &mut shadows.targets;
        let mut choices = [0.0; MAX_LANES];
        let mut within = [[0.0; 2]; MAX_LANES];
        let (mut of_kind, mut itself, mut in_sky) = ([0; 2], 0, 0);
        let first_cell = self.layout.material_of.len() as u32;
        let mut directions = [DVec3::ZERO; MAX_LANES];
        let mut spreads = [0.0; MAX_LANES];
        for (lane, ray) in group.rays() {
            // A path that is never scattered here has no use for them.
            if unscattered[lane] >= 1.0 {
                continue;
            }
            let [choice, fine, u, v] = numbers.of(ray).map(f64::from);
            // One number of 23 bits does not tell a million emitters apart.
            let (primitive, one_of) = self.emitters.choose(choice + fine / f64::from(1 << 23));
            if let (Some(sky), Some(rank)) = (&self.layout.sky, primitive.checked_sub(first_cell)) {
                let cell = sky.cell(rank);
                directions[lane] = sky.direction(cell, [u, v]);
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
            let materials = self.materials(&primitives);
            let emission = materials.gather::<S, Vec3<S>>(|material| {
                crate::number::splat_vector::<S>(self.inputs.materials[material].emission)
            });
            let source = EmitterSource::Surfaces(materials);
            found.extend(shadows.look(&place, lanes, &sight, (source, emission)));
        }
        if in_sky != 0 {
            let sight = Sight {
                direction: constant_vector::<S>(lanes_of_vectors::<S::Lanes>(&directions)),
                distance: S::ONE / S::ZERO,
                spread: S::constant(lanes_of_numbers::<S::Lanes>(&spreads)),
            };
            let Some(light) = self.sky_light(in_sky, sight.direction) else { return };
            let source = (EmitterSource::Sky, light.radiance());
            found.extend(shadows.look(&place, in_sky, &sight, source));
        }
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
