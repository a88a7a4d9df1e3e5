//! The derivative of an image along a direction, by boundary segments.

use ad::Dual;
use glam::DVec3;

use super::jump::{Jump, Packet, jumps};
use super::{Sampler, each_chunk};
use crate::edges::{Edge, Moving, in_lane, margin_of};
use crate::number::Plain;
use crate::primal::integrator::Integrator;
use crate::primal::path::Path;
use crate::primal::scattered::{EmitterSource, Guided};
use crate::primal::wavefront::{LaneGroup, Wavefront};
use crate::transport::camera::Ray;

/// Adds the derivatives of pixels along the direction that the inputs of an integrator carry, by the edges that its
/// paths come by, of a scene that stands `still` otherwise.
pub fn add_derivative<L: Plain>(
    still: Integrator<'_, L>,
    moving: Integrator<'_, Dual<L>>,
    pixels: &mut [DVec3],
) {
    let start = Path::default;
    let of_chunks = each_chunk(still, start, |path, sampler: &Sampler<'_>, chunk| {
        let mut found = Vec::new();
        let counts = |_| true;
        sampler.each_packet(chunk, counts, |packet| {
            let jumps = jumps(moving, sampler, packet, path);
            found.extend(of_packet(moving, packet, &jumps, path.wavefronts()));
        });
        found
    });
    for (pixel, along) in of_chunks.into_iter().flatten() {
        pixels[pixel] += along;
    }
}

/// What the segments of a packet add to pixels.
fn of_packet<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    packet: &Packet<'_>,
    jumps: &[Option<Jump>],
    wavefronts: &[Wavefront<Dual<L>>],
) -> Vec<(usize, DVec3)> {
    let of_segments = packet.iter().zip(jumps).filter_map(|((segment, _), jump)| {
        let jump = jump.as_ref()?;
        let moved = |edge: &Edge| moved(integrator, *edge, jump, wavefronts, segment.points.len());
        Some((segment.pixel, segment.edges.iter().map(moved).sum()))
    });
    of_segments.collect()
}

/// What an edge adds to a pixel.
fn moved<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    edge: Edge,
    jump: &Jump,
    wavefronts: &[Wavefront<Dual<L>>],
    count: usize,
) -> DVec3 {
    let along =
        |ray: Ray<Moving>| margin_of(integrator, edge, ray).map_or(0.0, |number| number.derivative);
    let last = &wavefronts[count - 1];
    if let Some((light, by)) = jump.light {
        let ray = jump.paths[0].last;
        let of_light = last.group_of(ray).map_or(0.0, |group: &LaneGroup<Dual<L>>| {
            along(in_lane::<L, _>(&integrator.shadow_ray(light, group), ray - group.first))
        });
        return by * of_light;
    }
    let next = jump.paths[0].next;
    let ray = &wavefronts[count].rays[next / L::COUNT];
    let mut sum = jump.staying * along(in_lane::<L, _>(ray, next % L::COUNT));
    for (guided, by) in jump.paths.into_iter().zip(jump.emitted) {
        if by != DVec3::ZERO {
            sum += by * sight(integrator, last, guided).map_or(0.0, along);
        }
    }
    sum
}

/// The ray to the point of an emitter that a path has found beyond an edge.
fn sight<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    last: &Wavefront<Dual<L>>,
    guided: Guided,
) -> Option<Ray<Moving>> {
    let sample = last.emitter_of(guided.last)?;
    let EmitterSource::Surfaces(points) = &sample.source else { return None };
    let group = &last.groups[sample.group];
    let direction = integrator.sight(points, group.surface.point)?.direction;
    let origin = integrator.shadow_origin(group);
    Some(in_lane::<L, _>(&Ray { origin, direction }, guided.last - group.first))
}
