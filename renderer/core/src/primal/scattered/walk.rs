//! How paths go on: from wavefront to wavefront.

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Fields, Real, Vec3, select};

use super::refraction::refract_or_reflect;
use super::{Event, Packing, missed};
use crate::number::{MAX_LANES, Number, constant_vector, primal_vector};
use crate::primal::coalesce::{Coalesced, select_lanes};
use crate::primal::integrator::Integrator;
use crate::primal::known::KnownHits;
use crate::primal::lanes::{all_lanes, lanes_of_numbers, numbers_of_lanes};
use crate::primal::path::{Path, zero_ray};
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::{LaneGroup, Source, Wavefront, blocks, put, repeated_ray};
use crate::scene::PathTracing;
use crate::trace::bvh::{Batch, PACKET_RAYS, PacketHits, rays};
use crate::trace::random::{PathNumbers, Purpose, RayNumbers};
use crate::transport::camera::Ray;
use crate::transport::dielectric::{relative_ior, sent_on_by_dielectric};
use crate::transport::emitter::scattered_weight;
use crate::transport::material::Bsdf;
use crate::transport::scatter::sent_on;

/// From this depth on paths may end at random.
const ROULETTE: u32 = 3;
/// The least probability with which a path goes on: it goes on from what is black too, for the derivative
/// by its colour.
const LEAST: f64 = 1.0 / 16.0;

/// What the paths of a tile carry along.
pub(super) struct Walk<S: Number> {
    numbers: PathNumbers,
    /// By block: the part of the radiance at their ends that paths bring to the camera.
    throughput: Vec<Vec3<S>>,
    /// By block: the probability density of the direction that a ray was scattered to; infinite where it was not.
    pub density: Vec<S>,
    /// By ray: what the radiance within a dielectric is larger by, which leaves it again.
    compression: [f64; PACKET_RAYS],
    /// Whether rays start where shadow rays do.
    pub is_lit: bool,
}

impl<S: Number> Walk<S> {
    /// Of paths that bring all of the radiance at their ends.
    pub fn new(numbers: PathNumbers) -> Self {
        Self {
            numbers,
            throughput: vec![Vec3::<S>::splat(S::ONE); blocks::<S>()],
            density: vec![S::ZERO; blocks::<S>()],
            compression: [1.0; PACKET_RAYS],
            is_lit: false,
        }
    }

    /// Lets paths of a group go on that bring this part of what they find, unless they end at random: `lanes`
    /// has a bit for each that may, and `ends` a number for each that decides.
    fn go_on(
        &mut self,
        depth: u32,
        group: &LaneGroup<S>,
        event: Event<S>,
        part: Vec3<S::Lanes>,
        (mut lanes, ends): (u32, S::Lanes),
    ) -> (Event<S>, u32) {
        let before = primal_vector::<S>(self.throughput[group.block()]);
        let throughput = before * part;
        let mut survival = S::Lanes::ONE;
        if depth >= ROULETTE {
            let left = numbers_of_lanes::<S::Lanes>(throughput.abs().max_element());
            let compression = &self.compression[group.first..];
            survival = S::Lanes::from_lanes(|lane| {
                Real::from_f64(survival_of(left[lane] * compression[lane]))
            });
            lanes &= S::Lanes::mask_bits(ends.cmplt(survival));
        }
        let throughput = constant_vector::<S>(throughput * (S::Lanes::ONE / survival));
        put(group.lanes(), lanes, &throughput, &mut self.throughput);
        (Event { factor: S::constant(event.factor.primal() / survival), ..event }, lanes)
    }
}

impl<S: Number> Walk<S> {
    /// Packs the paths.
    fn pack(&mut self, packing: &Packing) {
        packing.pack(&mut self.numbers.seeds);
        packing.pack(&mut self.compression);
        packing.pack_blocks::<S, _>(&mut self.density);
        packing.pack_blocks::<S, _>(&mut self.throughput);
    }
}

impl<S: Number> Integrator<'_, S> {
    /// Traces paths that these numbers choose, and finds the radiance that each ray brings but for those of the
    /// camera.
    pub fn trace_scattered(
        &self,
        source: Source<'_>,
        numbers: &PathNumbers,
        limits: PathTracing,
        path: &mut Path<S>,
    ) {
        let mut walk = Walk::new(numbers.clone());
        let (_, wavefront) = path.at(0);
        self.trace_primary(source, wavefront);
        self.weigh_missed(None, wavefront);
        let known = source.known().and_then(|known| known.at(0));
        let depth = self.follow(1, known, &mut walk, limits, path);
        self.shade_path(path, 1, depth);
    }

    /// Follows paths on from the wavefront at a depth; returns how many wavefronts they have then. What lights see of
    /// the first may be known.
    pub(super) fn follow(
        &self,
        mut depth: u32,
        mut known: Option<&KnownHits>,
        walk: &mut Walk<S>,
        limits: PathTracing,
        path: &mut Path<S>,
    ) -> usize {
        loop {
            let (_, wavefront) = path.at(depth as usize - 1);
            if depth == limits.max_depth {
                self.end(wavefront);
                return depth as usize;
            }
            self.trace_shadows(known.take(), wavefront);
            self.look_for_emitters(depth, &walk.numbers, wavefront);
            self.choose_events(depth, walk, wavefront);
            let (Some(before), next) = path.at(depth as usize) else {
                return depth as usize;
            };
            if !self.trace_events(before, walk, next) {
                return depth as usize;
            }
            depth += 1;
        }
    }

    /// Where paths have their greatest depth, what is met counts for what it emits alone.
    fn end(&self, wavefront: &mut Wavefront<S>) {
        wavefront.scattering.emitters.clear();
        wavefront.scattering.events.clear();
    }

    /// Weighs the environment that rays have found, unless they are those of the camera; all else counts.
    pub(super) fn weigh_missed(&self, walk: Option<&Walk<S>>, wavefront: &mut Wavefront<S>) {
        let found = &mut wavefront.scattering.found;
        found.clear();
        found.resize(blocks::<S>(), S::ONE);
        let Some(walk) = walk.filter(|_| !self.emitters.is_empty()) else { return };
        for lanes in missed::<S>(wavefront) {
            let Some(spread) = self.spread_of_missed(wavefront, lanes) else { break };
            let weight =
                scattered_weight::<S::Lanes>(spread, walk.density[lanes.block::<S>()].primal());
            put(lanes, lanes.alive, &S::constant(weight), &mut wavefront.scattering.found);
        }
    }

    /// Chooses how the paths go on from a wavefront.
    fn choose_events(&self, depth: u32, walk: &mut Walk<S>, wavefront: &mut Wavefront<S>) {
        let mut events = std::mem::take(&mut wavefront.scattering.events);
        events.clear();
        events.resize(blocks::<S>(), Event::end());
        let numbers = walk.numbers.at(depth, Purpose::Scatter);
        for group in &wavefront.groups {
            let (event, lanes) = self.event(depth, &numbers, walk, wavefront, group);
            events[group.block()].put(lanes, &event);
        }
        wavefront.scattering.events = events;
    }

    /// How the paths of a group go on, and a bit for each that does.
    fn event(
        &self,
        depth: u32,
        numbers: &RayNumbers,
        walk: &mut Walk<S>,
        wavefront: &Wavefront<S>,
        group: &LaneGroup<S>,
    ) -> (Event<S>, u32) {
        let vertex = self.vertex(group, wavefront, None);
        if group.bsdf == Bsdf::Dielectric {
            return self.event_at_dielectric(depth, numbers, walk, &vertex);
        }
        let scatterer = self.scatterer(&vertex);
        let [u, v, lobe, ends] = [0, 1, 2, 3].map(|axis| numbers.lanes::<S::Lanes>(axis, group));
        let part_unscattered = lanes_of_numbers::<S::Lanes>(&scatterer.unscattered);
        let is_unscattered = lobe.cmplt(part_unscattered);
        let unscattered = S::Lanes::mask_bits(is_unscattered) & group.alive;
        let straight = unscattered & vertex.transparent;
        let mirrored = unscattered & !straight;
        let of_lanes = scatterer.probability();
        let scattered = scatterer.scatter((lobe - part_unscattered) / of_lanes, [u, v]);
        let of_lanes = select(is_unscattered, part_unscattered, of_lanes);
        let mut direction = constant_vector::<S>(scattered.direction);
        if unscattered != 0 {
            let next = group.next_rays(straight).direction;
            direction = select_lanes::<S, _>(unscattered, &next, &direction);
        }
        let leaves = group.leave_surface(primal_vector::<S>(direction)) | unscattered;
        let lanes = group.alive & leaves & !self.absorbing(&vertex.materials, unscattered);
        if lanes == 0 {
            return (Event::end(), 0);
        }

        let is_possible = scattered.likelihood.cmpgt(S::Lanes::ZERO);
        let of_scattered = select(is_possible, S::Lanes::PI / scattered.likelihood, S::Lanes::ZERO);
        let factor = select(is_unscattered, S::Lanes::ONE, of_scattered) / of_lanes;
        let part = sent_on::<S::Lanes>(
            vertex.material.map(S::primal),
            vertex.lobes,
            group.surface.map(S::primal),
            primal_vector::<S>(direction),
            S::Lanes::mask_from_bits(straight),
            S::Lanes::mask_from_bits(mirrored),
            factor,
        );
        let density = scattered.likelihood * of_lanes / S::Lanes::PI;
        let density = select(is_unscattered, S::Lanes::ONE / S::Lanes::ZERO, density);
        put(group.lanes(), lanes, &S::constant(density), &mut walk.density);
        let event = Event { direction, straight, mirrored, factor: S::constant(factor) };
        walk.go_on(depth, group, event, part, (lanes, ends))
    }

    /// How the paths of a group go on at dielectrics.
    fn event_at_dielectric(
        &self,
        depth: u32,
        numbers: &RayNumbers,
        walk: &mut Walk<S>,
        vertex: &Vertex<'_, S>,
    ) -> (Event<S>, u32) {
        let group = vertex.group;
        let [choice, ends] = [2, 3].map(|axis| numbers.lanes::<S::Lanes>(axis, group));
        let infinite = S::constant(S::Lanes::ONE / S::Lanes::ZERO);
        put(group.lanes(), group.alive, &infinite, &mut walk.density);
        let inside = S::Lanes::mask_from_bits(group.inside);
        let relative = relative_ior::<S::Lanes>(vertex.material.ior.primal(), inside);
        let relative = numbers_of_lanes::<S::Lanes>(relative);
        let event = refract_or_reflect(vertex, choice);
        let part = sent_on_by_dielectric::<S::Lanes>(
            vertex.material.map(S::primal),
            group.surface.map(S::primal),
            inside,
            S::Lanes::mask_from_bits(event.mirrored),
            event.factor.primal(),
        );
        let squared = relative.map(|ior| ior * ior);
        for (lane, ray) in group.rays().filter(|(lane, _)| event.straight >> lane & 1 == 1) {
            walk.compression[ray] *= squared[lane];
        }
        // Smooth normals may refract out of the surface again.
        let along = group.geometry().1.dot(primal_vector::<S>(event.direction));
        let enters = S::Lanes::mask_bits(along.cmplt(S::Lanes::ZERO));
        let lanes = group.alive & (event.mirrored | enters);
        walk.go_on(depth, group, event, part, (lanes, ends))
    }

    /// Follows the rays that go on from a wavefront to what they meet, and weighs that; returns whether there are
    /// any.
    pub(super) fn trace_events(
        &self,
        from: &mut Wavefront<S>,
        walk: &mut Walk<S>,
        to: &mut Wavefront<S>,
    ) -> bool {
        let mut sent_on = std::mem::take(&mut to.rays);
        sent_on.clear();
        sent_on.resize_with(blocks::<S>(), zero_ray::<S>);
        to.hits = PacketHits::NONE;
        let mut batch = Batch::from(&from.hits);
        let infinite = S::Lanes::ONE / S::Lanes::ZERO;
        for group in &from.groups {
            let event = from.scattering.events[group.block()];
            let goes_on = event.factor.primal().cmpgt(S::Lanes::ZERO);
            let lanes = S::Lanes::mask_bits(goes_on) & group.alive;
            if lanes == 0 {
                continue;
            }
            let ray = Ray { origin: group.surface.point, direction: event.direction };
            put(group.lanes(), lanes, &ray, &mut sent_on);
            let direction = primal_vector::<S>(ray.direction);
            match walk.is_lit {
                true => group.add_shadow_rays(&mut batch, lanes, direction, infinite),
                false => group.add_to(&mut batch, lanes, event.straight, direction),
            }
        }
        self.find_next(&batch, &mut to.hits);
        let (mut sent, mut found) = (batch.active, self.add_found(from, &to.hits));
        to.scattering.packing = Packing::new::<S>(sent);
        if let Some(packing) = &to.scattering.packing {
            packing.pack_hits(&mut to.hits);
            packing.pack_blocks::<S, _>(&mut sent_on);
            walk.pack(packing);
            (sent, found) = (packing.rays(), packing.pack_bits(found));
        }
        self.gather_hits(to, sent, |first, alive| {
            repeated_ray::<S>(&sent_on[first / <S::Lanes as Lanes>::COUNT], alive)
        });
        to.rays = sent_on;
        self.weigh_missed(Some(walk), to);
        // What was found counts where it was looked for.
        for (block, weight) in to.scattering.found.iter_mut().enumerate() {
            let lanes = (found >> (block * <S::Lanes as Lanes>::COUNT)) as u32;
            *weight = select_lanes::<S, S>(lanes & all_lanes::<S::Lanes>(), &S::ZERO, weight);
        }
        sent != 0
    }

    /// By lane: the probability with which a path is not scattered.
    pub(super) fn unscattered(&self, group: &LaneGroup<S>) -> [f64; MAX_LANES] {
        let mut unscattered = [0.0; MAX_LANES];
        if group.bsdf == Bsdf::Dielectric {
            return [1.0; MAX_LANES];
        }
        if !self.zero_weight.mirrors && !self.layout.has_mirrors && !self.layout.has_transparency {
            return unscattered;
        }
        for (material, lanes) in self.materials(&group.primitives).iter() {
            let traits = &self.layout.materials[material];
            let is_mirror = self.zero_weight.mirrors || traits.is_mirror;
            let part = match traits.is_black && !self.zero_weight.reflections {
                _ if !is_mirror && !traits.is_transparent => 0.0,
                true if !traits.is_transparent => 1.0,
                _ => f64::from(traits.unscattered),
            };
            rays(lanes.into()).for_each(|lane| unscattered[lane] = part);
        }
        unscattered
    }

    /// A bit for each lane whose path ends because its surface scatters nothing.
    fn absorbing(&self, materials: &Coalesced, unscattered: u32) -> u32 {
        if self.zero_weight.reflections {
            return 0;
        }
        materials.lanes_where(|material| self.layout.materials[material].is_black) & !unscattered
    }
}

impl RayNumbers {
    /// Those of one axis of the rays of a group.
    #[inline]
    fn lanes<L: Lanes>(&self, axis: usize, group: &LaneGroup<impl Number<Lanes = L>>) -> L {
        let numbers = &self.along(axis)[group.first..group.first + L::COUNT];
        L::from_lanes(|lane| Real::from_f64(numbers[lane].into()))
    }
}

/// The probability with which a path goes on that brings this part of what it finds: a power of two, at
/// least as large, which does not jump where the part is a power of two itself.
fn survival_of(left: f64) -> f64 {
    // So that it shows in the image.
    if left.is_nan() {
        return 1.0;
    }
    const FRACTION: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
    let bits = (1.37 * left).clamp(LEAST, 1.0).to_bits();
    f64::from_bits((bits + FRACTION) & !FRACTION)
}

#[cfg(test)]
mod tests {
    use super::{LEAST, survival_of};

    #[test]
    fn paths_go_on_with_powers_of_two_no_less_than_what_they_bring() {
        for (left, expected) in
            [(0.0, LEAST), (1e-300, LEAST), (0.1, 0.25), (0.09, 0.125), (0.25, 0.5), (0.7, 1.0)]
        {
            assert_eq!(survival_of(left), expected, "{left}");
        }
        assert_eq!(survival_of(1e30), 1.0);
        assert_eq!(survival_of(f64::NAN), 1.0);
    }
}
