//! How paths go on: from wavefront to wavefront.

use ad::lanes::Lanes;
use ad::vector::{Vector, Vector3};
use ad::{Fields, Real, Vec3, select};

use super::Event;
use crate::number::{MAX_LANES, Number, primal_vector};
use crate::primal::coalesce::select_lanes;
use crate::primal::integrator::Integrator;
use crate::primal::lanes::{lanes_of_numbers, numbers_of_lanes};
use crate::primal::path::{Path, zero_ray};
use crate::primal::wavefront::{
    LaneGroup, Source, TileSample, Wavefront, blocks, put, repeated_ray,
};
use crate::scene::PathTracing;
use crate::trace::bvh::{PACKET_RAYS, PacketHits, rays};
use crate::trace::random::{PathNumbers, Purpose};
use crate::transport::camera::Ray;
use crate::transport::emitter::scattered_weight;
use crate::transport::scatter::{cosine_direction, sent_on, turn};

/// From this depth on paths may end at random.
const ROULETTE: u32 = 3;
/// The least probability with which a path goes on: it goes on from what is black too, for the derivative
/// by its colour.
const LEAST: f64 = 1.0 / 16.0;

/// What the paths of a tile carry along.
struct Walk<L: Lanes> {
    numbers: PathNumbers,
    /// By block: the part of the radiance at their ends that paths bring to the camera.
    throughput: Vec<Vec3<L>>,
    /// By ray: the probability density of the direction that it was scattered to; infinite where it was
    /// not.
    density: [f64; PACKET_RAYS],
}

impl<S: Number> Integrator<'_, S> {
    /// Traces the paths of one sample of a tile, and finds the radiance that each ray brings but for those
    /// of the camera.
    pub fn trace_scattered(&self, sample: TileSample<'_>, limits: PathTracing, path: &mut Path<S>) {
        let mut walk = Walk::<S::Lanes> {
            numbers: PathNumbers::new(sample.tile, sample.sampling, sample.index),
            throughput: vec![Vec3::<S::Lanes>::splat(S::Lanes::ONE); blocks::<S>()],
            density: [f64::INFINITY; PACKET_RAYS],
        };
        let mut depth = 1;
        loop {
            let (before, wavefront) = path.at(depth as usize - 1);
            let goes_on = match before {
                None => {
                    self.trace_primary(Source::Tile(sample), wavefront);
                    true
                }
                Some(before) => self.trace_events(before, wavefront),
            };
            if !goes_on {
                depth -= 1;
                break;
            }
            self.weigh_found(&walk, wavefront);
            if depth == limits.max_depth {
                self.end(wavefront);
                break;
            }
            self.trace_shadows(None, wavefront);
            self.look_for_emitters(depth, &walk.numbers, wavefront);
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

    /// Weighs what the surfaces emit that rays have found.
    fn weigh_found(&self, walk: &Walk<S::Lanes>, wavefront: &mut Wavefront<S>) {
        let mut found = std::mem::take(&mut wavefront.scattering.found);
        found.clear();
        found.resize(blocks::<S>(), S::ONE);
        if !self.emitters.is_empty() {
            for group in &wavefront.groups {
                let spread = self.spread_of_found(wavefront, group);
                let mut density = [f64::INFINITY; MAX_LANES];
                group.rays().for_each(|(lane, ray)| density[lane] = walk.density[ray]);
                let density = lanes_of_numbers::<S::Lanes>(&density);
                let weight = S::constant(scattered_weight::<S::Lanes>(spread, density));
                put(group.lanes(), group.alive, &weight, &mut found);
            }
        }
        wavefront.scattering.found = found;
    }

    /// Chooses how the paths go on from a wavefront.
    fn choose_events(&self, depth: u32, walk: &mut Walk<S::Lanes>, wavefront: &mut Wavefront<S>) {
        let mut events = std::mem::take(&mut wavefront.scattering.events);
        events.clear();
        events.resize(blocks::<S>(), Event::end());
        for group in &wavefront.groups {
            let (event, lanes) = self.event(depth, walk, wavefront, group);
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
        walk: &mut Walk<S::Lanes>,
        wavefront: &Wavefront<S>,
        group: &LaneGroup<S>,
    ) -> (Event<S>, u32) {
        let vertex = self.vertex(group, wavefront, None);
        let unscattered = self.unscattered(group);
        let (mut straight, mut mirrored) = (0, 0);
        let mut within = [[0.0; 2]; MAX_LANES];
        let mut ends = [0.0; MAX_LANES];
        let mut probability = [1.0; MAX_LANES];
        for (lane, ray) in group.rays() {
            let [u, v, lobe, end] = walk.numbers.at(ray, depth, Purpose::Scatter).map(f64::from);
            (within[lane], ends[lane]) = ([u, v], end);
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
        let local = cosine_direction::<S::Lanes>([lane_numbers(0), lane_numbers(1)]);
        let turned = turn::<S>(group.surface.normal, constant_vector::<S>(local));
        let unscattered = straight | mirrored;
        let direction = match unscattered {
            0 => turned,
            _ => {
                let next = group.next_rays(straight).direction;
                select_lanes::<S, _>(unscattered, &next, &turned)
            }
        };
        let leaves = group.leave_surface(primal_vector::<S>(direction)) | unscattered;
        let mut lanes = group.alive & leaves & !self.absorbing(group, unscattered);
        if lanes == 0 {
            return (Event::end(), 0);
        }

        let of_lanes = lanes_of_numbers::<S::Lanes>(&probability);
        let is_unscattered = S::Lanes::mask_from_bits(unscattered);
        let factor = select(is_unscattered, S::Lanes::ONE, S::Lanes::PI) / of_lanes;
        let part = sent_on::<S::Lanes>(
            vertex.material.map(S::primal),
            vertex.lobes,
            group.surface.map(S::primal),
            primal_vector::<S>(direction),
            S::Lanes::mask_from_bits(straight),
            S::Lanes::mask_from_bits(mirrored),
            factor,
        );
        let throughput = walk.throughput[group.block()] * part;
        let mut survival = [1.0; MAX_LANES];
        if depth >= ROULETTE {
            let left = numbers_of_lanes::<S::Lanes>(throughput.abs().max_element());
            for lane in rays(lanes.into()) {
                survival[lane] = survival_of(left[lane]);
                if ends[lane] >= survival[lane] {
                    lanes &= !(1 << lane);
                }
            }
        }
        let survival = lanes_of_numbers::<S::Lanes>(&survival);
        let throughput = throughput * (S::Lanes::ONE / survival);
        let cosines = numbers_of_lanes::<S::Lanes>(local.z());
        for lane in rays(lanes.into()) {
            walk.density[group.first + lane] = match unscattered >> lane & 1 {
                1 => f64::INFINITY,
                _ => cosines[lane] * probability[lane] / std::f64::consts::PI,
            };
        }
        let to = &mut walk.throughput[group.block()];
        *to = select(S::Lanes::mask_from_bits(lanes), throughput, *to);
        (Event { direction, straight, mirrored, factor: S::constant(factor / survival) }, lanes)
    }

    /// Follows the rays that go on from a wavefront to what they meet; returns whether there are any.
    fn trace_events(&self, from: &Wavefront<S>, to: &mut Wavefront<S>) -> bool {
        let mut sent_on = std::mem::take(&mut to.rays);
        sent_on.clear();
        sent_on.resize_with(blocks::<S>(), zero_ray::<S>);
        to.hits = PacketHits::NONE;
        let mut sent = 0;
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
            self.find_next(from, group, (lanes, event.straight), &ray, &mut to.hits);
        }
        self.gather_hits(to, sent, |first, alive| {
            repeated_ray::<S>(&sent_on[first / <S::Lanes as Lanes>::COUNT], alive)
        });
        to.rays = sent_on;
        sent != 0
    }

    /// By lane: the probability with which a path is not scattered.
    pub(super) fn unscattered(&self, group: &LaneGroup<S>) -> [f64; MAX_LANES] {
        let mut unscattered = [0.0; MAX_LANES];
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

/// A vector that does not vary.
fn constant_vector<S: Number>(v: Vec3<S::Lanes>) -> Vec3<S> {
    Vector3::new(S::constant(v.x()), S::constant(v.y()), S::constant(v.z()))
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
