//! What is seen on both sides of edges.

use ad::lanes::Lanes;
use glam::DVec3;

use super::contours::Contour;
use super::segment::{Sampler, Segment, Source};
use crate::number::{Number, primal_vector};
use crate::primal::integrator::Integrator;
use crate::primal::known::KnownHit;
use crate::primal::lanes::vectors_of_lanes;
use crate::primal::path::Path;
use crate::primal::scattered::{Guide, Guided};
use crate::primal::wavefront::Wavefront;
use crate::trace::bvh::NO_PRIMITIVE;
use crate::trace::random::PathNumbers;
use crate::transport::camera::Ray;

/// What changes a pixel as the number of each edge of a segment does.
pub struct Jump {
    /// By light from directions that stay as the surface moves that it comes to.
    pub staying: DVec3,
    /// By light from points of emitters, against and along the normal: these stay where they are on their surfaces.
    pub emitted: [DVec3; 2],
    /// By a light.
    pub light: Option<(usize, DVec3)>,
    /// The paths, against and along the normal.
    pub paths: [Guided; 2],
}

/// The paths of a packet to the same number of surfaces.
pub type Packet<'a> = [(Segment, Contour<'a>)];

/// Traces paths on both sides of edges, and compares what they bring; nothing where the camera does not see them.
pub fn jumps<S: Number>(
    integrator: Integrator<'_, S>,
    sampler: &Sampler<'_>,
    packet: &Packet<'_>,
    path: &mut Path<S>,
) -> Vec<Option<Jump>> {
    let count = packet[0].0.points.len();
    let mut limits = sampler.limits;
    let on_sides = |depth: usize| packet.iter().flat_map(move |(of, _)| [of.points[depth]; 2]);
    let guide = Guide {
        film: packet.iter().flat_map(|(segment, _)| [segment.film; 2]).collect(),
        points: (0..count).map(|depth| on_sides(depth).collect()).collect(),
        targets: packet.iter().flat_map(|(segment, _)| segment.targets).collect(),
        is_lit: packet[0].0.source != Source::Evenly,
    };
    if guide.is_lit {
        limits.max_depth = count as u32 + 1;
    }
    let seed = |ray: usize| packet.get(ray / 2).map_or(0, |(segment, _)| segment.seed);
    let numbers = PathNumbers::of_seeds(std::array::from_fn(seed));
    let paths = integrator.trace_guided(&guide, numbers, limits, path);
    let wavefronts = path.wavefronts();
    let (Some(last), Some(next)) = (wavefronts.get(count - 1), wavefronts.get(count)) else {
        return Vec::new();
    };
    let jump = |(pair, (segment, contour)): (&[Option<Guided>], &(Segment, Contour<'_>))| {
        let &[Some(against), Some(along)] = pair else { return None };
        let paths = [against, along];
        let mut jump = Jump { staying: DVec3::ZERO, emitted: [DVec3::ZERO; 2], light: None, paths };
        if let Source::Light { light, side, irradiance } = segment.source {
            let sign = [1.0, -1.0][side];
            jump.light = Some((light, paths[side].part * irradiance * (sign * segment.weight)));
            return Some(jump);
        }
        let beyond = paths.map(|guided| Beyond::new(last, next, guided));
        // Direct light comes through transparent surfaces, too.
        if sampler.knows_direct && count == 1 && beyond.iter().any(|of| sampler.goes_on(of)) {
            return None;
        }
        for (side, (beyond, sign)) in beyond.iter().zip([1.0, -1.0]).enumerate() {
            let [staying, emitted] = sampler.densities(segment, contour, beyond);
            let part = paths[side].part * (sign * segment.weight);
            jump.staying += part * beyond.radiance * staying;
            jump.emitted[side] = part * beyond.emitted * emitted;
        }
        Some(jump)
    };
    paths.chunks(2).zip(packet).map(jump).collect()
}

/// What a path brings beyond an edge.
struct Beyond {
    radiance: DVec3,
    /// The radiance of emitters that are looked for, which is none of this.
    emitted: DVec3,
    met: Option<KnownHit>,
}

impl Beyond {
    fn new<S: Number>(last: &Wavefront<S>, next: &Wavefront<S>, guided: Guided) -> Self {
        let lanes = <S::Lanes as Lanes>::COUNT;
        let block = primal_vector::<S>(next.radiance[guided.last / lanes]);
        let radiance = vectors_of_lanes::<S::Lanes>(block)[guided.last % lanes];
        let primitive = next.hits.primitive[guided.next];
        let leaves = next.hits.leaves >> guided.next & 1 == 1;
        let met = KnownHit { leaves, ..KnownHit::of_triangle(primitive) };
        let emitted = last.emitter_of(guided.last).map(|sample| {
            let emission = vectors_of_lanes::<S::Lanes>(primal_vector::<S>(sample.emission));
            emission[guided.last % lanes]
        });
        Self {
            radiance,
            emitted: emitted.unwrap_or(DVec3::ZERO),
            met: (primitive != NO_PRIMITIVE).then_some(met),
        }
    }
}

impl Sampler<'_> {
    /// What the radiance beyond an edge counts for, and that of an emitter there.
    fn densities(&self, segment: &Segment, contour: &Contour<'_>, beyond: &Beyond) -> [f64; 2] {
        let ray = Ray { origin: contour.point, direction: contour.direction };
        // Both ways to draw a ray towards the same light count by their densities.
        let together = || {
            let (distance, spread) = self.spread(ray, beyond.met);
            (segment.even.recip() + contour.towards_light(distance, spread).recip()).recip()
        };
        let is_own = beyond.met.is_some_and(|met| contour.is_of(met.primitive));
        let sees_sky = beyond.met.is_none();
        let of_emitter = || if beyond.emitted == DVec3::ZERO || is_own { 0.0 } else { together() };
        match segment.source {
            Source::Evenly if self.knows_direct && segment.points.len() == 1 => {
                [if sees_sky { 0.0 } else { segment.even }, 0.0]
            }
            Source::Evenly if sees_sky && self.geometry.layout.sky.is_some() => [together(), 0.0],
            Source::Evenly => [segment.even, of_emitter()],
            Source::Emitter(None) => [if sees_sky { together() } else { 0.0 }, 0.0],
            Source::Emitter(Some(primitive)) => {
                let is_it = beyond.met.is_some_and(|met| met.primitive == primitive);
                [0.0, if is_it { of_emitter() } else { 0.0 }]
            }
            Source::Light { .. } => [0.0; 2],
        }
    }

    /// Whether light goes straight through what is beyond an edge.
    fn goes_on(&self, beyond: &Beyond) -> bool {
        beyond.met.is_some_and(|met| self.geometry.is_transparent(met.primitive))
    }
}
