//! Boundary segments: the edges that light which takes all paths comes by after the first surface.
//!
//! A path from the camera goes on from a surface point beside an edge, and what it sees there jumps from one side of the
//! edge to the other. How the jump moves is the part of a derivative that paths do not bring. Here it is estimated from
//! the edges of the scene (Zhang et al., "Path-Space Differentiable Rendering", 2020): a point of an edge and a ray
//! [along](contours) it are drawn, which leads to the last surface point backwards, and from there by random directions to
//! one that the camera sees ([segments](segment)). Paths of that way on [both sides](jump) of the edge bring the jump.
//! It goes with the speed of the edge beside the ray, which comes through the pullbacks of
//! [`edge`](crate::transport::edge) and of the path: what [`adjoint`](crate::adjoint) does, or, [forwards](forward), dual
//! numbers.
//!
//! Everything moves as it does in the interior term, which this completes: scattered directions stay, points of emitters
//! stay on these, and lights are where they are. So light from emitters, from lights, and all other light have speeds of
//! their own. Rays along edges are drawn in three ways: evenly; towards what shines, which counts together with the
//! first (the balance heuristic of Veach & Guibas 1995); and towards lights, for surfaces that the camera does not see
//! first. On those that it does, edges of [images](crate::edges) are the shadows of lights.
//!
//! Turned down: edges that are drawn from the surface points of paths (Li et al. 2018), where the distance between both
//! stands squared in the denominator, so that contact makes the noise infinite; here it cancels. And lights that stand
//! for emitters and the sky, with edges in the image: they are as many as one can afford, the same for all pixels, and
//! what they are off by does not vanish on average. They are left where mirrors or transparent surfaces show surfaces,
//! to which no path from an edge leads.
//!
//! Left out: curves in which surfaces pierce each other, edges of shapes of one's own, shadow edges that lights cast through
//! transparent surfaces, and all edges of what the camera sees by mirrors, through glass or transparent surfaces.

mod contours;
mod forward;
mod jump;
mod segment;

use contours::{Contour, Contours};
use segment::{Segment, Way};

pub use forward::add_derivative;
pub use jump::{Jump, Packet, jumps};
pub use segment::Sampler;

use crate::edges::Geometry;
use crate::number::Plain;
use crate::parallel;
use crate::primal::integrator::Integrator;
use crate::scene::PathTracing;
use crate::trace::bvh::PACKET_RAYS;
use crate::trace::layout::StandIns;
use crate::trace::sampling::hash;

/// So many segments at least are drawn one after the other.
const LEAST_CHUNK: u64 = 4096;

/// The most chunks in each way: every one has sums of its own.
const MOST_CHUNKS: u32 = 16;

/// So many segments are drawn to tell whose edges count.
const PILOTS: u32 = 2048;

/// The least importance of the edges of an object, as a part of the largest.
const LEAST_IMPORTANCE: f64 = 0.1;

/// So many draws at least tell how important the edges of an object are.
const LEAST_DRAWS: f64 = 16.0;

const WAYS: [Way; 3] = [Way::Evenly, Way::TowardsEmitters, Way::TowardsLights];

/// Some segments that are drawn in one way.
#[derive(Clone, Copy)]
pub struct Chunk {
    way: Way,
    index: u32,
}

/// The results of `work` for chunks of boundary segments, in their order: in each way as many are drawn as there are paths.
pub fn each_chunk<L: Plain, W: Send, R: Send>(
    integrator: Integrator<'_, L>,
    start: impl Fn() -> W + Sync,
    work: impl Fn(&mut W, &Sampler<'_>, Chunk) -> R + Sync,
) -> Vec<R> {
    let layout = integrator.layout;
    let Some(limits) = layout.path_tracing.filter(|limits| limits.max_depth > 1) else {
        return Vec::new();
    };
    let leads = WAYS.map(|way| leads_to_light(integrator, limits, way));
    if leads == [false; WAYS.len()] {
        return Vec::new();
    }
    let geometry = Geometry::new(integrator);
    let contours = Contours::new(&geometry);
    let pixels = u64::from(layout.width) * u64::from(layout.height);
    let paths = pixels * u64::from(layout.sampling.count());
    // Indices are numbers of 32 bits.
    let most = u64::from(u32::MAX / MOST_CHUNKS);
    let chunk = paths.div_ceil(MOST_CHUNKS.into()).clamp(LEAST_CHUNK, most);
    let chunks = paths.div_ceil(chunk).clamp(1, MOST_CHUNKS.into()) as u32;
    let chunk = chunk as u32;
    let seed = hash(!layout.sampling.seed());
    let pilot = Sampler {
        geometry: &geometry,
        contours: &contours,
        emitters: integrator.emitters,
        lights: layout.lights.len(),
        limits,
        knows_direct: layout.stand_ins() == StandIns::Everywhere,
        seed: hash(!seed),
        chunk,
        count: PILOTS,
    };
    let importances = importances(&pilot);
    let mut weighed = contours.clone();
    weighed.weigh(|primitive| importances[layout.object_of(primitive)]);
    let sampler = Sampler { contours: &weighed, seed, count: chunks * chunk, ..pilot };
    let ways = (0..chunks).flat_map(|chunk| WAYS.into_iter().zip(leads).map(move |of| (of, chunk)));
    let chunks =
        ways.filter(|((_, leads), _)| *leads).map(|((way, _), index)| Chunk { way, index });
    parallel::map_init(chunks.collect(), start, |scratch, chunk| work(scratch, &sampler, chunk))
}

/// Whether any light comes by the rays that are drawn in a way.
fn leads_to_light<L: Plain>(integrator: Integrator<'_, L>, limits: PathTracing, way: Way) -> bool {
    let Integrator { layout, inputs, emitters, .. } = integrator;
    let is_indirect = limits.max_depth > 2;
    let shines = !emitters.is_empty();
    match way {
        Way::Evenly => {
            is_indirect || shines || inputs.environment.is_some() || layout.customs() > 0
        }
        Way::TowardsEmitters => shines,
        Way::TowardsLights => is_indirect && !layout.lights.is_empty(),
    }
}

/// How often the edges of each object, meshes and then spheres, are to be drawn: about as often as what a pixel changes
/// by deviates from draw to draw.
fn importances(pilot: &Sampler<'_>) -> Vec<f64> {
    let layout = pilot.geometry.layout;
    let mut squares = vec![(0.0, 0.0); layout.meshes() + layout.spheres];
    for index in 0..pilot.count {
        let Some(contour) = pilot.evenly(index) else { continue };
        let of_object = &mut squares[layout.object_of(contour.primitive())];
        of_object.0 += 1.0;
        if let Some((segment, _)) = pilot.draw(Way::Evenly, index) {
            let change = segment.weight / contour.slope;
            of_object.1 += change * change;
        }
    }
    let roots: Vec<Option<f64>> = squares
        .into_iter()
        .map(|(count, sum): (f64, f64)| (count >= LEAST_DRAWS).then(|| (sum / count).sqrt()))
        .collect();
    let largest = roots.iter().flatten().fold(0.0, |largest: f64, &root| largest.max(root));
    // Of an object that is hardly drawn nothing is known.
    let importance = |root: Option<f64>| match largest > 0.0 {
        true => (root.unwrap_or(largest) / largest).max(LEAST_IMPORTANCE),
        false => 1.0,
    };
    roots.into_iter().map(importance).collect()
}

impl<'a> Sampler<'a> {
    /// Draws the segments of a chunk that end in pixels which count, and uses them in packets.
    pub fn each_packet(
        &self,
        chunk: Chunk,
        counts: impl Fn(usize) -> bool,
        mut use_packet: impl FnMut(&Packet<'a>),
    ) {
        let Chunk { way, index } = chunk;
        let mut packets: Vec<Vec<(Segment, Contour<'a>)>> = Vec::new();
        for index in index * self.chunk..(index + 1) * self.chunk {
            let Some(drawn) = self.draw(way, index).filter(|(segment, _)| counts(segment.pixel))
            else {
                continue;
            };
            let surfaces = drawn.0.points.len();
            packets.resize_with(surfaces.max(packets.len()), Vec::new);
            let packet = &mut packets[surfaces - 1];
            packet.push(drawn);
            if 2 * packet.len() == PACKET_RAYS {
                use_packet(packet);
                packet.clear();
            }
        }
        packets.iter().filter(|packet| !packet.is_empty()).for_each(|packet| use_packet(packet));
    }
}
