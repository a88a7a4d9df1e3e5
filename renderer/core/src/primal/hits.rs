//! From traced rays to lanes: what the rays of a packet hit, gathered by kind of primitive.

use ad::Real;
use ad::lanes::Lanes;
use ad::vector::Vector;

use super::coalesce::Coalesced;
use super::film::film_lanes;
use super::integrator::Integrator;
use super::lanes::all_lanes;
use super::wavefront::{LaneGroup, Source, TileSample, Wavefront, set_vectors};
use crate::counts::count;
use crate::number::{Number, primal_vector};
use crate::trace::bvh::{PACKET_RAYS, PacketHits, PacketVectors, first_rays, rays};
use crate::trace::layout::Kind;
use crate::trace::tile::Tile;
use crate::transport::camera::{Ray, film_point, primary_ray};
use crate::transport::material::Bsdf;
use crate::transport::smooth::weighted_normal;

impl<S: Number> Integrator<'_, S> {
    /// Finds what camera rays meet, and gathers it.
    pub fn trace_primary(&self, source: Source<'_>, wavefront: &mut Wavefront<S>) {
        let mut film = std::mem::take(&mut wavefront.film);
        film.clear();
        let blocks = (0..PACKET_RAYS).step_by(<S::Lanes as Lanes>::COUNT);
        let wanted = match source {
            Source::Tile(sample) | Source::Traced(sample, _) => {
                let offsets = sample.sampling.offsets(sample.tile, sample.index);
                film.extend(blocks.map(|first| self.film(sample.tile, offsets.as_ref(), first)));
                sample.tile.rays()
            }
            Source::Film(points) | Source::ScatteredFilm(points, _) => {
                film.extend(blocks.map(|first| film_lanes::<S::Lanes>(points, first)));
                first_rays(points.len())
            }
            Source::Known(paths) | Source::Scattered(paths, _) => {
                film.extend(blocks.map(|first| film_lanes::<S::Lanes>(paths.film(), first)));
                paths.rays()
            }
        };
        match source {
            Source::Tile(TileSample { tile, .. }) => {
                self.find_primary(Some(tile), wanted, &film, &mut wavefront.hits);
            }
            Source::Film(_) | Source::ScatteredFilm(..) => {
                self.find_primary(None, wanted, &film, &mut wavefront.hits);
            }
            Source::Traced(_, paths) | Source::Known(paths) | Source::Scattered(paths, _) => {
                wavefront.hits = paths.at(0).map_or(PacketHits::NONE, |known| known.hits.clone());
            }
        }
        self.gather_hits(wavefront, wanted, |first, alive| {
            let (x, y) = film[first / <S::Lanes as Lanes>::COUNT];
            let (x, y) = (repeated::<S::Lanes>(x, alive), repeated::<S::Lanes>(y, alive));
            primary_ray::<S>(self.inputs.frame, constant(x), constant(y))
        });
        wavefront.film = film;
    }

    /// Traces camera rays: those of a tile, or any.
    fn find_primary(
        &self,
        tile: Option<&Tile>,
        wanted: u64,
        film: &[(S::Lanes, S::Lanes)],
        hits: &mut PacketHits,
    ) {
        let mut directions = PacketVectors::ZERO;
        for (block, &(x, y)) in film.iter().enumerate() {
            let direction = film_point::<S>(self.inputs.frame, constant(x), constant(y));
            set_vectors::<S::Lanes>(
                &mut directions,
                block * <S::Lanes as Lanes>::COUNT,
                all_lanes::<S::Lanes>(),
                primal_vector::<S>(direction),
            );
        }
        count(|counts| &counts.primary_rays, u64::from(wanted.count_ones()));
        self.tracer.primary(tile, &directions, wanted, hits);
    }

    /// Gathers what the wanted rays of a packet hit. `ray` gives those from an index on; in lanes
    /// that do not count it repeats one that does.
    #[inline]
    pub fn gather_hits(
        &self,
        wavefront: &mut Wavefront<S>,
        wanted: u64,
        ray: impl Fn(usize, u32) -> Ray<S>,
    ) {
        let hits = &wavefront.hits;
        let hit = wanted & hits.met();
        wavefront.missed = wanted & !hit;
        wavefront.groups.clear();
        let kinds = self.by_kind(&hits.primitive, hit);
        let bsdfs = self.by_bsdf(&hits.primitive, hit);
        for first in (0..PACKET_RAYS).step_by(<S::Lanes as Lanes>::COUNT) {
            let lanes = |rays: u64| (rays >> first) as u32 & all_lanes::<S::Lanes>();
            let parts = kinds.iter().flat_map(|kind| bsdfs.iter().map(move |bsdf| (kind, bsdf)));
            for (&(kind, is_smooth, of_kind), &(bsdf, of_bsdf)) in parts {
                let alive = lanes(of_kind & of_bsdf);
                if alive == 0 {
                    continue;
                }
                let primitives = Coalesced::new(&hits.primitive, first, alive);
                let (ray, mut inside) = (ray(first, alive), lanes(hits.leaves));
                if kind == Kind::Triangle && bsdf == Bsdf::Dielectric {
                    inside = self.behind(&primitives, ray) & alive;
                }
                let (surface, bent) = if is_smooth {
                    let (surface, bent) = self.smooth_surface(&primitives, ray);
                    (surface, Some(bent))
                } else {
                    (self.surface(kind, &primitives, inside, ray), None)
                };
                let (surface, bent, mapped) = match self.layout.has_normal_maps {
                    false => (surface, bent, None),
                    true => self.map_normals(kind, &primitives, surface, bent),
                };
                let index = wavefront.groups.len();
                wavefront.groups.push(LaneGroup {
                    index,
                    first,
                    alive,
                    primitives,
                    kind,
                    bsdf,
                    inside,
                    ray,
                    surface,
                    is_smooth,
                    bent,
                    mapped,
                });
            }
        }
    }

    /// A bit for each ray that hits a material of each kind of BSDF.
    fn by_bsdf(&self, primitives: &[u32; PACKET_RAYS], hit: u64) -> [(Bsdf, u64); 3] {
        let mut bsdfs = Bsdf::ALL.map(|(_, bsdf)| (bsdf, 0));
        if !self.layout.has_other_bsdfs {
            bsdfs[0].1 = hit;
            return bsdfs;
        }
        for ray in rays(hit) {
            let bsdf = self.layout.traits_of(primitives[ray] as usize).bsdf;
            bsdfs[bsdf as usize].1 |= 1 << ray;
        }
        bsdfs
    }

    /// A bit for each lane whose ray meets a triangle from behind: from where its corners go round clockwise in its mesh.
    fn behind(&self, primitives: &Coalesced, ray: Ray<S>) -> u32 {
        let triangle = self.triangle(primitives);
        let normal = weighted_normal::<S>(triangle);
        let along = normal.dot(ray.direction).primal();
        let mirrored = primitives.lanes_where(|triangle| self.layout.is_mirrored(triangle));
        S::Lanes::mask_bits(along.cmpgt(S::Lanes::ZERO)) ^ mirrored
    }

    /// A bit for each ray that hits a primitive of each kind, with whether these are smooth.
    fn by_kind(&self, primitives: &[u32; PACKET_RAYS], hit: u64) -> [(Kind, bool, u64); 4] {
        let (spheres, customs) = (self.layout.spheres, self.layout.customs());
        let triangles = self.layout.triangles.len();
        let below = |end: usize, are_more: bool| match are_more {
            false => u64::MAX,
            true => primitives.iter().enumerate().fold(0, |bits, (ray, &primitive)| {
                bits | u64::from((primitive as usize) < end) << ray
            }),
        };
        let triangle = hit & below(triangles, spheres + customs > 0);
        let sphere = hit & !triangle & below(triangles + spheres, customs > 0);
        let smooth = self.on_smooth(primitives, triangle);
        [
            (Kind::Triangle, false, triangle & !smooth),
            (Kind::Triangle, true, smooth),
            (Kind::Sphere, false, sphere),
            (Kind::Custom, false, hit & !triangle & !sphere),
        ]
    }
}

#[inline(always)]
fn constant<S: Number>(x: S::Lanes) -> S {
    S::constant(x)
}

/// Puts the number of the first living lane into the lanes that do not count.
#[inline]
fn repeated<L: Lanes>(x: L, alive: u32) -> L {
    if alive == all_lanes::<L>() {
        return x;
    }
    let first = alive.trailing_zeros() as usize;
    let number = x.lanes().as_ref()[first];
    ad::select(L::mask_from_bits(alive), x, L::from_lanes(|_| number))
}
