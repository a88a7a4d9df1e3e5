//! Paths that first come by given points, and then go on as they like.

use ad::lanes::Lanes;
use ad::{Fields, Real};
use glam::DVec3;

use super::walk::Walk;
use super::{Event, Scattering};
use crate::number::{MAX_LANES, Number, constant_vector};
use crate::primal::integrator::Integrator;
use crate::primal::lanes::{lanes_of_vectors, vectors_of_lanes};
use crate::primal::path::Path;
use crate::primal::wavefront::{Source, Wavefront, blocks};
use crate::scene::PathTracing;
use crate::trace::bvh::PACKET_RAYS;
use crate::trace::random::PathNumbers;
use crate::transport::material::Bsdf;
use crate::transport::scatter::sent_on;

/// How far from where it should a point may be, as a part of the distance to where its path goes on to.
const FARTHEST: f64 = 1e-3;

/// The first points of paths, by ray.
#[derive(Default)]
pub struct Guide {
    pub film: Vec<[f64; 2]>,
    /// The points that paths come by, by depth.
    pub points: Vec<Vec<DVec3>>,
    /// The points that they go on to from the last of these.
    pub targets: Vec<DVec3>,
    /// Whether they come from there as shadow rays do.
    pub is_lit: bool,
}

/// A path that has come by all points.
#[derive(Clone, Copy)]
pub struct Guided {
    /// The part of the radiance that the surfaces send on to the camera, with cosines.
    pub part: DVec3,
    /// The ray in the wavefront of the last point.
    pub last: usize,
    /// The ray that goes on from there.
    pub next: usize,
}

impl<S: Number> Integrator<'_, S> {
    /// Traces paths that come by given points; by ray, those that do.
    pub fn trace_guided(
        &self,
        guide: &Guide,
        numbers: PathNumbers,
        limits: PathTracing,
        path: &mut Path<S>,
    ) -> [Option<Guided>; PACKET_RAYS] {
        let mut walk = Walk::<S>::new(numbers);
        walk.density.fill(S::constant(S::Lanes::ONE / S::Lanes::ZERO));
        let mut paths = std::array::from_fn(|ray| {
            (ray < guide.film.len()).then_some(Guided { part: DVec3::ONE, last: ray, next: ray })
        });
        let (_, wavefront) = path.at(0);
        self.trace_primary(Source::Film(&guide.film), wavefront);
        self.weigh_missed(None, wavefront);
        let count = guide.points.len();
        for depth in 0..count {
            let (_, from) = path.at(depth);
            walk.is_lit = guide.is_lit && depth + 1 == count;
            let targets = guide.points.get(depth + 1).unwrap_or(&guide.targets);
            self.guide(from, walk.is_lit, (&guide.points[depth], targets), &mut paths);
            let (Some(from), to) = path.at(depth + 1) else { unreachable!("there is one before") };
            if !self.trace_events(from, &mut walk, to) {
                return [None; PACKET_RAYS];
            }
            for guided in &mut paths {
                *guided = guided.and_then(|guided| {
                    let next = match &to.scattering.packing {
                        None => Some(guided.next),
                        Some(packing) => packing.after(guided.next),
                    };
                    Some(Guided { last: guided.next, next: next?, ..guided })
                });
            }
        }
        walk.is_lit = false;
        let depth = self.follow(count as u32 + 1, None, &mut walk, limits, path);
        self.shade_path(path, count, depth);
        paths
    }

    /// Sends paths on from the wavefront that has come to points, to others.
    fn guide(
        &self,
        wavefront: &mut Wavefront<S>,
        is_lit: bool,
        (points, targets): (&[DVec3], &[DVec3]),
        paths: &mut [Option<Guided>; PACKET_RAYS],
    ) {
        let mut of_rays = [None; PACKET_RAYS];
        for (index, guided) in paths.iter().enumerate() {
            if let Some(guided) = guided {
                of_rays[guided.next] = Some(index);
            }
        }
        let mut events = vec![Event::end(); blocks::<S>()];
        let mut sent = [false; PACKET_RAYS];
        for group in &wavefront.groups {
            if group.bsdf == Bsdf::Dielectric {
                continue;
            }
            let (point, _) = group.values();
            let start = if is_lit && group.is_smooth { group.geometry().0 } else { point };
            let [met, starts] = [point, start].map(vectors_of_lanes::<S::Lanes>);
            let mut directions = [DVec3::ZERO; MAX_LANES];
            let mut lanes = 0;
            for (lane, ray) in group.rays() {
                let Some(index) = of_rays[ray] else { continue };
                let to = targets[index] - starts[lane];
                if met[lane].distance(points[index]) <= FARTHEST * to.length() {
                    directions[lane] = to.normalize();
                    lanes |= 1 << lane;
                }
            }
            let direction = lanes_of_vectors::<S::Lanes>(&directions);
            lanes &=
                if is_lit { group.lit_from(direction) } else { group.leave_surface(direction) };
            if lanes == 0 {
                continue;
            }
            let vertex = self.vertex(group, wavefront, None);
            let none = S::Lanes::mask_from_bits(0);
            let part = sent_on::<S::Lanes>(
                vertex.material.map(S::primal),
                vertex.lobes,
                group.surface.map(S::primal),
                direction,
                none,
                none,
                S::Lanes::ONE,
            );
            let parts = vectors_of_lanes::<S::Lanes>(part);
            for (lane, ray) in group.rays().filter(|(lane, _)| lanes >> lane & 1 == 1) {
                if let Some(guided) = of_rays[ray].and_then(|index| paths[index].as_mut()) {
                    guided.part *= parts[lane];
                    sent[ray] = true;
                }
            }
            let direction = constant_vector::<S>(direction);
            let event = Event { direction, straight: 0, mirrored: 0, factor: S::ONE };
            events[group.block()].put(lanes, &event);
        }
        for path in paths.iter_mut() {
            *path = path.filter(|guided| sent[guided.next]);
        }
        let Scattering { emitters, events: to, .. } = &mut wavefront.scattering;
        emitters.clear();
        *to = events;
    }
}
