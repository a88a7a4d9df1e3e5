//! Paths: from the camera by mirrors and through transparent surfaces.

use ad::Vec3;
use ad::lanes::Lanes;

use super::coalesce::Coalesced;
use super::integrator::Integrator;
use super::known::KnownHits;
use super::scattered::{EmitterSample, Event};
use super::wavefront::{
    LaneGroup, Source, TileSample, Wavefront, blocks, clear_blocks, put, repeated_ray, set_vectors,
};
use crate::counts::count;
use crate::number::{Number, primal_vector};
use crate::trace::bvh::{Batch, NO_PRIMITIVE, PacketHits, rays};
use crate::trace::layout::Kind;
use crate::trace::random::PathNumbers;
use crate::transport::camera::Ray;

/// The paths of one sample of a tile: a wavefront for each depth. A pixel has the same ray in each.
pub struct Path<S: Number> {
    /// None before the first tile, so that an empty path takes no memory.
    wavefronts: Vec<Wavefront<S>>,
    /// How many of the wavefronts belong to this tile.
    depth: usize,
}

impl<S: Number> Path<S> {
    /// The wavefronts, from the camera on.
    pub fn wavefronts(&self) -> &[Wavefront<S>] {
        &self.wavefronts[..self.depth]
    }

    /// The wavefronts that the path of a ray of the camera comes by, each with the ray that it has there.
    pub fn followed(&self, mut ray: usize) -> impl Iterator<Item = (&Wavefront<S>, usize)> {
        self.wavefronts().iter().map_while(move |wavefront| {
            if let Some(packing) = &wavefront.scattering.packing {
                ray = packing.after(ray)?;
            }
            Some((wavefront, ray))
        })
    }

    /// About how many bytes a path of so many wavefronts takes.
    pub fn bytes(depth: usize) -> usize {
        let scattering = size_of::<EmitterSample<S>>() + size_of::<Event<S>>() + size_of::<S>();
        let block = size_of::<LaneGroup<S>>() + size_of::<Ray<S>>() + size_of::<Vec3<S>>();
        depth * (size_of::<Wavefront<S>>() + blocks::<S>() * (block + scattering))
    }

    /// The wavefront of this index, and the one before it.
    pub(super) fn at(&mut self, index: usize) -> (Option<&mut Wavefront<S>>, &mut Wavefront<S>) {
        if self.wavefronts.len() == index {
            self.wavefronts.push(Wavefront::default());
        }
        let (before, after) = self.wavefronts.split_at_mut(index);
        (before.last_mut(), &mut after[0])
    }

    /// The wavefront of this index, and the one behind it.
    fn beyond(&mut self, index: usize) -> (&mut Wavefront<S>, Option<&Wavefront<S>>) {
        let (wavefronts, deeper) = self.wavefronts[..self.depth].split_at_mut(index + 1);
        (&mut wavefronts[index], deeper.first())
    }
}

/// To be filled by [`Integrator::trace_path`].
impl<S: Number> Default for Path<S> {
    fn default() -> Self {
        Self { wavefronts: Vec::new(), depth: 0 }
    }
}

impl<S: Number> Integrator<'_, S> {
    /// Traces paths, or follows those that are known, with the visibility of lights, and finds the
    /// radiance that each ray brings but for those of the camera.
    pub fn trace_path(&self, source: Source<'_>, path: &mut Path<S>) {
        match (self.layout.path_tracing, source) {
            (Some(limits), Source::Tile(TileSample { tile, sampling, index })) => {
                let numbers = PathNumbers::new(tile, sampling, index);
                return self.trace_scattered(source, &numbers, limits, path);
            }
            (Some(limits), Source::Scattered(_, numbers) | Source::ScatteredFilm(_, numbers)) => {
                return self.trace_scattered(source, numbers, limits, path);
            }
            _ => {}
        }
        let known = |depth: usize| source.known()?.at(depth);
        let mut depth = 0;
        while depth < self.depths() {
            let (before, wavefront) = path.at(depth);
            let goes_on = match before {
                None => {
                    self.trace_primary(source, wavefront);
                    true
                }
                Some(_) if source.known().is_some() && known(depth).is_none() => false,
                Some(before) => self.trace_secondary(known(depth), before, wavefront),
            };
            if !goes_on {
                break;
            }
            self.trace_shadows(known(depth), wavefront);
            depth += 1;
        }
        self.shade_path(path, 1, depth);
    }

    /// Finds the radiance that the rays of a path of so many wavefronts bring, from one of them on.
    pub(super) fn shade_path(&self, path: &mut Path<S>, first: usize, depth: usize) {
        path.depth = depth;
        for depth in (first..depth).rev() {
            let (wavefront, deeper) = path.beyond(depth);
            self.shade(wavefront, deeper);
        }
    }

    /// Finds what the rays that go on from a wavefront meet; returns whether there are any.
    fn trace_secondary(
        &self,
        known: Option<&KnownHits>,
        from: &Wavefront<S>,
        to: &mut Wavefront<S>,
    ) -> bool {
        let mut sent_on = std::mem::take(&mut to.rays);
        sent_on.clear();
        sent_on.resize_with(blocks::<S>(), zero_ray::<S>);
        to.hits = known.map_or(PacketHits::NONE, |known| known.hits.clone());
        let mut sent = 0;
        let mut batch = Batch::from(&from.hits);
        for group in &from.groups {
            let materials = self.materials(&group.primitives);
            let transparent = self.transparent_lanes(&materials);
            let mirrors = self.mirror_lanes(&materials) & !transparent;
            let lanes = (mirrors | transparent) & group.alive;
            if lanes == 0 {
                continue;
            }
            sent |= u64::from(lanes) << group.first;
            let ray = group.next_rays(transparent);
            put(group.lanes(), lanes, &ray, &mut sent_on);
            if known.is_none() {
                let direction = primal_vector::<S>(ray.direction);
                group.add_to(&mut batch, lanes, transparent, direction);
            }
        }
        if known.is_none() {
            self.find_next(&batch, &mut to.hits);
        }
        self.gather_hits(to, sent, |first, alive| {
            repeated_ray::<S>(&sent_on[first / <S::Lanes as Lanes>::COUNT], alive)
        });
        to.rays = sent_on;
        sent != 0
    }

    /// Finds what the rays of a batch that go on meet.
    pub(super) fn find_next(&self, batch: &Batch, hits: &mut PacketHits) {
        count(|counts| &counts.secondary_rays, u64::from(batch.active.count_ones()));
        self.tracer.bvh.nearest_batch(batch, hits);
    }

    /// Finds the radiance that the rays of a wavefront bring, from that of the rays that go on.
    fn shade(&self, wavefront: &mut Wavefront<S>, beyond: Option<&Wavefront<S>>) {
        let mut radiance = std::mem::take(&mut wavefront.radiance);
        clear_blocks::<S, _>(&mut radiance);
        for group in &wavefront.groups {
            let vertex = self.vertex(group, wavefront, beyond);
            put(group.lanes(), group.alive, &vertex.radiance(), &mut radiance);
        }
        self.visit_missed(wavefront, |rays, of_missed| {
            put(rays, rays.alive, &of_missed, &mut radiance);
        });
        if let Some(packing) = &wavefront.scattering.packing {
            packing.unpack_blocks::<S, _>(&mut radiance);
        }
        wavefront.radiance = radiance;
    }

    /// A bit for each lane whose material is a mirror, or counts as one.
    fn mirror_lanes(&self, materials: &Coalesced) -> u32 {
        materials.lanes_where(|material| {
            self.zero_weight.mirrors || self.layout.materials[material].is_mirror
        })
    }
}

impl<S: Number> LaneGroup<S> {
    /// Adds rays that leave the surfaces of some lanes to a batch; those `behind` leave on the side that the
    /// viewer does not see.
    pub(super) fn add_to(
        &self,
        batch: &mut Batch,
        lanes: u32,
        behind: u32,
        direction: Vec3<S::Lanes>,
    ) {
        set_vectors::<S::Lanes>(&mut batch.origins, self.first, lanes, self.origins(behind));
        set_vectors::<S::Lanes>(&mut batch.directions, self.first, lanes, direction);
        if self.kind != Kind::Triangle {
            rays(lanes.into()).for_each(|lane| batch.from[self.first + lane] = NO_PRIMITIVE);
        }
        batch.active |= u64::from(lanes) << self.first;
    }

    /// The flat primitive that a ray of the group ends on: one that leaves it cannot come back to it.
    pub fn starts_on(&self, wavefront: &Wavefront<S>, ray: usize) -> Option<u32> {
        match self.kind {
            Kind::Triangle => Some(wavefront.hits.primitive[ray]),
            Kind::Sphere | Kind::Custom => None,
        }
    }
}

pub(super) fn zero_ray<S: Number>() -> Ray<S> {
    ad::Fields::from_fn(&mut |_| S::ZERO)
}
