//! From pixels to boundary segments, and to what moves them.

use ad::{Additive, Tangent};
use glam::DVec3;

use super::chain::{AdjointState, Chain, SurfaceCotangent};
use super::request::Request;
use super::scatter::Sums;
use crate::boundary::{Jump, Packet, Sampler, each_chunk, jumps};
use crate::edges::Edge;
use crate::number::{MAX_LANES, Plain};
use crate::primal::integrator::Prepared;
use crate::primal::lanes::lanes_of_numbers;
use crate::primal::path::Path;
use crate::primal::scattered::EmitterSource;
use crate::primal::wavefront::{Wavefront, blocks, clear_blocks};
use crate::scene::Scene;
use crate::trace::bvh::PACKET_RAYS;
use crate::transport::camera::Ray;
use crate::transport::emitter::Sight;

/// The sums of boundary segments, by the cotangents of pixels.
pub fn sweep_boundary<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    request: &Request,
    cotangents: &[DVec3],
) -> Vec<Sums> {
    let integrator = prepared.integrator().with_zero_weight(request.zero_weight);
    let start = || Chain::new(integrator, scene, request);
    let counts = |pixel: usize| cotangents[pixel] != DVec3::ZERO;
    each_chunk(integrator, start, |chain, sampler, chunk| {
        sampler.each_packet(chunk, counts, |packet| {
            chain.pull_segments(sampler, packet, cotangents);
        });
        chain.scatter.take()
    })
}

impl<L: Plain> Chain<'_, L> {
    /// Adds what flows back from a packet of segments.
    fn pull_segments(&mut self, sampler: &Sampler<'_>, packet: &Packet<'_>, cotangents: &[DVec3]) {
        let (mut path, mut states) =
            (std::mem::take(&mut self.path), std::mem::take(&mut self.states));
        let jumps = jumps(self.integrator, sampler, packet, &mut path);
        if jumps.iter().any(Option::is_some) {
            self.pull_jumps(packet, &jumps, (&path, &mut states), cotangents);
        }
        (self.path, self.states) = (path, states);
    }

    /// From what changes pixels on both sides of edges to these, and to the paths there.
    fn pull_jumps(
        &mut self,
        packet: &Packet<'_>,
        jumps: &[Option<Jump>],
        (path, states): (&Path<L>, &mut Vec<AdjointState<L>>),
        cotangents: &[DVec3],
    ) {
        let count = packet[0].0.points.len();
        let wavefronts = &path.wavefronts()[..=count];
        states.resize_with((count + 1).max(states.len()), AdjointState::default);
        for (state, wavefront) in states.iter_mut().zip(wavefronts) {
            let zero = SurfaceCotangent { surface: Additive::zero(), uv: None };
            state.surfaces.clear();
            state.surfaces.resize(wavefront.groups.len(), Some(zero));
            clear_blocks::<L, _>(&mut state.rays);
            state.grazing = 0;
        }
        states[count].surfaces.fill(None);

        let copies = packet.iter().map(|(segment, _)| segment.edges.len()).max().unwrap_or(0);
        for copy in 0..copies {
            let segments = packet.iter().zip(jumps);
            let of_each = segments.filter_map(|((segment, _), jump)| {
                Some((*segment.edges.get(copy)?, cotangents[segment.pixel], jump.as_ref()?))
            });
            let (mut staying, mut emitted, mut lit) = (NONE, NONE, Vec::new());
            for (edge, cotangent, jump) in of_each {
                let seed = |to: &mut Seeds, ray: usize, by: DVec3| {
                    let seed = cotangent.dot(by);
                    if seed != 0.0 && seed.is_finite() {
                        (to.edges[ray], to.numbers[ray]) = (Some(edge), seed);
                    }
                };
                match jump.light {
                    Some((light, by)) => {
                        lit.resize_with((light + 1).max(lit.len()), || NONE);
                        seed(&mut lit[light], jump.paths[0].last, by);
                    }
                    None => {
                        seed(&mut staying, jump.paths[0].next, jump.staying);
                        for (path, by) in jump.paths.iter().zip(jump.emitted) {
                            seed(&mut emitted, path.last, by);
                        }
                    }
                }
            }
            for block in 0..blocks::<L>() {
                if let Some((edges, seeds)) = staying.of::<L>(block * L::COUNT, u32::MAX) {
                    let to_ray = self.pull_edges(&edges, wavefronts[count].rays[block], seeds);
                    states[count].rays[block].accumulate(to_ray);
                }
            }
            self.pull_emitted(&wavefronts[count - 1], &emitted, &mut states[count - 1]);
            self.pull_lit(&wavefronts[count - 1], &lit, &mut states[count - 1]);
        }
        self.pull_rays(wavefronts, states);
    }

    /// From the numbers of edges that points of emitters shine past to these, to the emitters and to the points that
    /// see them.
    fn pull_emitted(
        &mut self,
        wavefront: &Wavefront<L>,
        seeds: &Seeds,
        state: &mut AdjointState<L>,
    ) {
        for sample in &wavefront.scattering.emitters {
            let EmitterSource::Surfaces(points) = &sample.source else { continue };
            let group = &wavefront.groups[sample.group];
            let Some((edges, seeds)) = seeds.of::<L>(group.first, sample.lanes) else { continue };
            let origin = self.integrator.shadow_origin(group);
            let ray = Ray { origin, direction: sample.illumination.direction };
            let Tangent::<Ray<L>> { origin, direction } = self.pull_edges(&edges, ray, seeds);
            let to_sight = Tangent::<Sight<L>> { direction, ..Additive::zero() };
            let mut to_point = self.pull_sight_of(points, group.surface.point, to_sight);
            to_point.accumulate(self.pull_shadow_origin(group, origin));
            if let Some(SurfaceCotangent { surface, .. }) = &mut state.surfaces[group.index] {
                surface.point.accumulate(to_point);
            }
        }
    }

    /// From the numbers of edges that lights shine past, by light, to these, to the lights and to the points that they
    /// shine on.
    fn pull_lit(&mut self, wavefront: &Wavefront<L>, seeds: &[Seeds], state: &mut AdjointState<L>) {
        for (light, seeds) in seeds.iter().enumerate() {
            for group in &wavefront.groups {
                let Some((edges, seeds)) = seeds.of::<L>(group.first, group.alive) else {
                    continue;
                };
                self.pull_shadow_edge(light, group, (&edges, seeds), state);
            }
        }
    }
}

/// The cotangents of numbers of edges, by ray.
struct Seeds {
    edges: [Option<Edge>; PACKET_RAYS],
    numbers: [f64; PACKET_RAYS],
}

const NONE: Seeds = Seeds { edges: [None; PACKET_RAYS], numbers: [0.0; PACKET_RAYS] };

impl Seeds {
    /// Those of some lanes from a ray on, if there are any.
    fn of<L: Plain>(&self, first: usize, lanes: u32) -> Option<([Option<Edge>; MAX_LANES], L)> {
        let (mut edges, mut numbers) = ([None; MAX_LANES], [0.0; MAX_LANES]);
        for lane in (0..L::COUNT).filter(|lane| lanes >> lane & 1 == 1) {
            (edges[lane], numbers[lane]) = (self.edges[first + lane], self.numbers[first + lane]);
        }
        edges.iter().any(Option::is_some).then(|| (edges, lanes_of_numbers::<L>(&numbers)))
    }
}
