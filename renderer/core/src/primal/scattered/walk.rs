//! How paths go on: from wavefront to wavefront.

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Fields, Real, Vec3, select};

use super::refraction::refract_or_reflect;
use super::{Event, missed};
use crate::number::{MAX_LANES, Number, constant_vector, primal_vector};
use crate::primal::coalesce::select_lanes;
use crate::primal::integrator::Integrator;
use crate::primal::lanes::{lanes_of_numbers, numbers_of_lanes};
use crate::primal::path::{Path, zero_ray};
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::{LaneGroup, RayLanes, Source, Wavefront, blocks, put, repeated_ray};
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
struct Walk<'a, L: Lanes> {
    numbers: &'a PathNumbers,
    /// By block: the part of the radiance at their ends that paths bring to the camera.
    throughput: Vec<Vec3<L>>,
    /// By ray: the probability density of the direction that it was scattered to; infinite where it was
    /// not.
    density: [f64; PACKET_RAYS],
    /// By ray: what the radiance within a dielectric is larger by, which leaves it again.
    compression: [f64; PACKET_RAYS],
}

impl<L: Lanes> Walk<'_, L> {
    /// Lets paths of a group go on that bring this part of what they find, unless they end at random: `lanes`
    /// has a bit for each that may, and `ends` a number for each that decides.
    fn go_on<S: Number<Lanes = L>>(
        &mut self,
        depth: u32,
        group: &LaneGroup<S>,
        event: Event<S>,
        part: Vec3<L>,
        (mut lanes, ends): (u32, &[f64; MAX_LANES]),
    ) -> (Event<S>, u32) {
        let throughput = self.throughput[group.block()] * part;
        let mut survival = [1.0; MAX_LANES];
        if depth >= ROULETTE {
            let left = numbers_of_lanes::<L>(throughput.abs().max_element());
            for lane in rays(lanes.into()) {
                survival[lane] = survival_of(left[lane] * self.compression[group.first + lane]);
                if ends[lane] >= survival[lane] {
                    lanes &= !(1 << lane);
                }
            }
        }
        let survival = lanes_of_numbers::<L>(&survival);
        let throughput = throughput * (L::ONE / survival);
        let to = &mut self.throughput[group.block()];
        *to = select(L::mask_from_bits(lanes), throughput, *to);
        (Event { factor: S::constant(event.factor.primal() / survival), ..event }, lanes)
    }
}

impl<L: Lanes> Walk<'_, L> {
    /// The densities of some rays.
    fn densities(&self, rays: RayLanes) -> L {
        let mut densities = [f64::INFINITY; MAX_LANES];
        rays.rays().for_each(|(lane, ray)| densities[lane] = self.density[ray]);
        lanes_of_numbers::<L>(&densities)
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
        let mut walk = Walk::<'_, S::Lanes> {
            numbers,
            throughput: vec![Vec3::<S::Lanes>::splat(S::Lanes::ONE); blocks::<S>()],
            density: [f64::INFINITY; PACKET_RAYS],
            compression: [1.0; PACKET_RAYS],
        };
        let mut depth = 1;
        loop {
            let (before, wavefront) = path.at(depth as usize - 1);
            let goes_on = match &before {
                None => {
                    self.trace_primary(source, wavefront);
                    true
                }
                Some(before) => self.trace_events(before, wavefront),
            };
            if !goes_on {
                depth -= 1;
                break;
            }
            self.weigh_found(&walk, before, wavefront);
            if depth == limits.max_depth {
                self.end(wavefront);
                break;
            }
            self.trace_shadows(None, wavefront);
            self.look_for_emitters(depth, walk.numbers, wavefront);
            self.choose_events(depth, &mut walk, wavefront);
            depth += 1;
        }
        self.shade_path(path, depth as usize);
    }

    /// Where paths have their greatest depth, what is met counts for what it emits alone.
    fn end(&self, wavefront: &mut Wavefront<S>) {
        wavefront.scattering.emitters.clear();
        wavefront.scattering.events.clear();
    }

    /// Weighs what rays have found: of surfaces, that which counts where it was found; and the environment.
    fn weigh_found(
        &self,
        walk: &Walk<'_, S::Lanes>,
        before: Option<&mut Wavefront<S>>,
        wavefront: &mut Wavefront<S>,
    ) {
        let found = &mut wavefront.scattering.found;
        found.clear();
        found.resize(blocks::<S>(), S::ONE);
        if self.emitters.is_empty() {
            return;
        }
        if let Some(before) = before {
            self.give_found(before, wavefront);
        }
        for lanes in missed::<S>(wavefront) {
            let Some(spread) = self.spread_of_missed(wavefront, lanes) else { break };
            let weight = scattered_weight::<S::Lanes>(spread, walk.densities(lanes));
            put(lanes, lanes.alive, &S::constant(weight), &mut wavefront.scattering.found);
        }
    }

    /// Chooses how the paths go on from a wavefront.
    fn choose_events(
        &self,
        depth: u32,
        walk: &mut Walk<'_, S::Lanes>,
        wavefront: &mut Wavefront<S>,
    ) {
        let mut events = std::mem::take(&mut wavefront.scattering.events);
        events.clear();
        events.resize(blocks::<S>(), Event::end());
        let numbers = walk.numbers.at(depth, Purpose::Scatter);
        for group in &wavefront.groups {
            let (event, lanes) = self.event(depth, &numbers, walk, wavefront, group);
            let of_block = &mut events[group.block()];
            *of_block = Event {
                direction: select_lanes::<S, _>(lanes, &event.direction, &of_block.direction),
                straight: of_block.straight | event.straight & lanes,
                mirrored: of_block.mirrored | event.mirrored & lanes,
                factor: select_lanes::<S, _>(lanes, &event.factor, &of_block.factor),
            };
        }
        wavefront.scattering.events = events;
    }

    /// How the paths of a group go on, and a bit for each that does.
    fn event(
        &self,
        depth: u32,
        numbers: &RayNumbers,
        walk: &mut Walk<'_, S::Lanes>,
        wavefront: &Wavefront<S>,
        group: &LaneGroup<S>,
    ) -> (Event<S>, u32) {
        let vertex = self.vertex(group, wavefront, None);
        if group.bsdf == Bsdf::Dielectric {
            return self.event_at_dielectric(depth, numbers, walk, &vertex);
        }
        let scatterer = self.scatterer(&vertex);
        let unscattered = scatterer.unscattered;
        let (mut straight, mut mirrored) = (0, 0);
        let mut within = [[0.0; 3]; MAX_LANES];
        let mut ends = [0.0; MAX_LANES];
        let mut probability = [1.0; MAX_LANES];
        for (lane, ray) in group.rays() {
            let [u, v, lobe, end] = numbers.of(ray).map(f64::from);
            let of_scattered = (lobe - unscattered[lane]) / (1.0 - unscattered[lane]);
            (within[lane], ends[lane]) = ([u, v, of_scattered], end);
            if lobe < unscattered[lane] {
                let bits =
                    if vertex.transparent >> lane & 1 == 1 { &mut straight } else { &mut mirrored };
                *bits |= 1 << lane;
                probability[lane] = unscattered[lane];
            } else {
                probability[lane] = 1.0 - unscattered[lane];
            }
        }
        let lane_numbers = |axis: usize| lanes_of_numbers::<S::Lanes>(&within.map(|at| at[axis]));
        let numbers = [lane_numbers(0), lane_numbers(1)];
        let scattered = scatterer.scatter(lane_numbers(2), numbers);
        let unscattered = straight | mirrored;
        let mut direction = constant_vector::<S>(scattered.direction);
        if unscattered != 0 {
            let next = group.next_rays(straight).direction;
            direction = select_lanes::<S, _>(unscattered, &next, &direction);
        }
        let leaves = group.leave_surface(primal_vector::<S>(direction)) | unscattered;
        let lanes = group.alive & leaves & !self.absorbing(group, unscattered);
        if lanes == 0 {
            return (Event::end(), 0);
        }

        let of_lanes = lanes_of_numbers::<S::Lanes>(&probability);
        let is_unscattered = S::Lanes::mask_from_bits(unscattered);
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
        let likelihoods = numbers_of_lanes::<S::Lanes>(scattered.likelihood);
        for lane in rays(lanes.into()) {
            walk.density[group.first + lane] = match unscattered >> lane & 1 {
                1 => f64::INFINITY,
                _ => likelihoods[lane] * probability[lane] / std::f64::consts::PI,
            };
        }
        let event = Event { direction, straight, mirrored, factor: S::constant(factor) };
        walk.go_on(depth, group, event, part, (lanes, &ends))
    }

    /// How the paths of a group go on at dielectrics.
    fn event_at_dielectric(
        &self,
        depth: u32,
        numbers: &RayNumbers,
        walk: &mut Walk<'_, S::Lanes>,
        vertex: &Vertex<'_, S>,
    ) -> (Event<S>, u32) {
        let group = vertex.group;
        let (mut choice, mut ends) = ([0.0; MAX_LANES], [0.0; MAX_LANES]);
        for (lane, ray) in group.rays() {
            let [_, _, lobe, end] = numbers.of(ray).map(f64::from);
            (choice[lane], ends[lane]) = (lobe, end);
            walk.density[ray] = f64::INFINITY;
        }
        let inside = S::Lanes::mask_from_bits(group.inside);
        let relative = relative_ior::<S::Lanes>(vertex.material.ior.primal(), inside);
        let relative = numbers_of_lanes::<S::Lanes>(relative);
        let event = refract_or_reflect(vertex, lanes_of_numbers::<S::Lanes>(&choice));
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
        walk.go_on(depth, group, event, part, (lanes, &ends))
    }

    /// Follows the rays that go on from a wavefront to what they meet; returns whether there are any.
    fn trace_events(&self, from: &Wavefront<S>, to: &mut Wavefront<S>) -> bool {
        let mut sent_on = std::mem::take(&mut to.rays);
        sent_on.clear();
        sent_on.resize_with(blocks::<S>(), zero_ray::<S>);
        to.hits = PacketHits::NONE;
        let mut sent = 0;
        let mut batch = Batch::default();
        for group in &from.groups {
            let event = from.scattering.events[group.block()];
            let goes_on = event.factor.primal().cmpgt(S::Lanes::ZERO);
            let lanes = S::Lanes::mask_bits(goes_on) & group.alive;
            if lanes == 0 {
                continue;
            }
            sent |= u64::from(lanes) << group.first;
            let ray = Ray { origin: group.surface.point, direction: event.direction };
            put(group.lanes(), lanes, &ray, &mut sent_on);
            let direction = primal_vector::<S>(ray.direction);
            group.add_to(&mut batch, from, lanes, event.straight, direction);
        }
        self.find_next(&batch, &mut to.hits);
        self.gather_hits(to, sent, |first, alive| {
            repeated_ray::<S>(&sent_on[first / <S::Lanes as Lanes>::COUNT], alive)
        });
        to.rays = sent_on;
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
    fn absorbing(&self, group: &LaneGroup<S>, unscattered: u32) -> u32 {
        if self.zero_weight.reflections {
            return 0;
        }
        let black = |material: usize| self.layout.materials[material].is_black;
        self.materials(&group.primitives).lanes_where(black) & !unscattered
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
