//! A wavefront: the rays of a tile at one depth of their paths, and what they hit, gathered into lanes.

use ad::lanes::Lanes;
use ad::vector::Vector3;
use ad::{Additive, Fields, Real, Vec3};
use glam::DVec3;

use super::coalesce::{Coalesced, select_lanes};
use super::integrator::Integrator;
use super::lanes::{all_lanes, singles_of_lanes, vectors_of_lanes};
use super::transmission::Transmission;
use crate::counts::count;
use crate::number::{MAX_LANES, Number, primal_vector};
use crate::trace::bvh::{PACKET_RAYS, PacketHits, PacketVectors, rays, tile_position};
use crate::trace::layout::Kind;
use crate::trace::sampling::{Offsets, Sampling};
use crate::trace::tile::Tile;
use crate::transport::camera::{Ray, film_point, primary_ray};
use crate::transport::hit::SurfacePoint;

/// The rays of a tile at one depth: those of the camera, or those that go on from mirrors or through
/// transparent surfaces.
pub struct Wavefront<S: Number> {
    /// What each ray hits first.
    pub hits: PacketHits,
    /// A bit for each ray that hits nothing.
    pub missed: u64,
    /// The rays that hit something.
    pub groups: Vec<LaneGroup<S>>,
    /// The visibility mask of each light: a bit for each ray that ends where it shines.
    pub visible: Vec<u64>,
    /// The transmittance of transparent surfaces between each light and the points; empty if there are
    /// none.
    pub transmissions: Vec<Transmission<S>>,
    /// For camera rays: where within their pixels they go.
    pub offsets: Option<Offsets>,
    /// For rays that go on: the rays, by block.
    pub rays: Vec<Ray<S>>,
    /// For rays that go on: the radiance that they bring, by block.
    pub radiance: Vec<Vec3<S>>,
}

/// One ray through each pixel of a tile.
#[derive(Clone, Copy)]
pub struct TileSample<'a> {
    pub tile: &'a Tile,
    pub sampling: Sampling,
    /// The index of the ray among those of its pixel.
    pub index: u32,
}

/// The rays through the pixels of a tile, one for each at a time.
pub fn samples(tile: &Tile, sampling: Sampling) -> impl Iterator<Item = TileSample<'_>> {
    (0..sampling.count()).map(move |index| TileSample { tile, sampling, index })
}

/// Rays that hit primitives of one kind, one in each lane.
pub struct LaneGroup<S: Number> {
    /// The ray in lane 0; the others follow.
    pub first: usize,
    /// A bit for each lane that counts. The others repeat one of these.
    pub alive: u32,
    /// The lanes by primitive.
    pub primitives: Coalesced,
    pub kind: Kind,
    /// A bit for each lane whose ray starts inside of a sphere.
    pub inside: u32,
    pub ray: Ray<S>,
    pub surface: SurfacePoint<S>,
}

impl<S: Number> LaneGroup<S> {
    /// The lanes that count, with their rays.
    #[inline]
    pub fn rays(&self) -> impl Iterator<Item = (usize, usize)> + use<S> {
        let first = self.first;
        rays(self.alive.into()).map(move |lane| (lane, first + lane))
    }

    /// The block of the packet that the lanes are.
    #[inline]
    pub fn block(&self) -> usize {
        self.first / <S::Lanes as Lanes>::COUNT
    }

    /// The bits of the lanes among those of a packet.
    #[inline]
    pub fn lanes_of(&self, rays: u64) -> u32 {
        (rays >> self.first) as u32 & self.alive
    }

    /// The values of the surface points, in double precision.
    pub fn points(&self) -> [DVec3; MAX_LANES] {
        vectors_of_lanes::<S::Lanes>(primal_vector::<S>(self.surface.point))
    }
}

/// To be filled by tracing.
impl<S: Number> Default for Wavefront<S> {
    fn default() -> Self {
        Self {
            hits: PacketHits::NONE,
            missed: 0,
            groups: Vec::new(),
            visible: Vec::new(),
            transmissions: Vec::new(),
            offsets: None,
            rays: Vec::new(),
            radiance: Vec::new(),
        }
    }
}

impl<S: Number> Integrator<'_, S> {
    /// Traces the camera rays through one point of every pixel of a tile.
    pub fn trace_primary(&self, sample: &TileSample<'_>, wavefront: &mut Wavefront<S>) {
        let tile = sample.tile;
        let offsets = sample.sampling.offsets(tile, sample.index);
        let mut directions = PacketVectors::ZERO;
        for first in (0..PACKET_RAYS).step_by(<S::Lanes as Lanes>::COUNT) {
            let (x, y) = self.film(tile, offsets.as_ref(), first);
            let direction = film_point::<S>(self.inputs.frame, constant(x), constant(y));
            set_vectors::<S::Lanes>(
                &mut directions,
                first,
                all_lanes::<S::Lanes>(),
                primal_vector::<S>(direction),
            );
        }
        let wanted = tile.rays();
        count(|counts| &counts.primary_rays, u64::from(wanted.count_ones()));
        self.tracer.primary(tile, &directions, wanted, &mut wavefront.hits);

        let ray = |first: usize, alive: u32| {
            let (x, y) = self.film(tile, offsets.as_ref(), first);
            let (x, y) = (repeated::<S::Lanes>(x, alive), repeated::<S::Lanes>(y, alive));
            primary_ray::<S>(self.inputs.frame, constant(x), constant(y))
        };
        self.gather_hits(wavefront, wanted, ray);
        wavefront.offsets = offsets;
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
        for first in (0..PACKET_RAYS).step_by(<S::Lanes as Lanes>::COUNT) {
            let lanes = |rays: u64| (rays >> first) as u32 & all_lanes::<S::Lanes>();
            for (kind, rays) in kinds {
                let alive = lanes(rays);
                if alive == 0 {
                    continue;
                }
                let primitives = Coalesced::new(&hits.primitive, first, alive);
                let (ray, inside) = (ray(first, alive), lanes(hits.leaves));
                let surface = self.surface(kind, &primitives, inside, ray);
                let group = LaneGroup { first, alive, primitives, kind, inside, ray, surface };
                wavefront.groups.push(group);
            }
        }
    }

    /// A bit for each ray that hits a primitive of each kind.
    fn by_kind(&self, primitives: &[u32; PACKET_RAYS], hit: u64) -> [(Kind, u64); 3] {
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
        [
            (Kind::Triangle, triangle),
            (Kind::Sphere, sphere),
            (Kind::Custom, hit & !triangle & !sphere),
        ]
    }

    /// Where the rays from `first` on meet the image plane.
    #[inline]
    pub fn film(
        &self,
        tile: &Tile,
        offsets: Option<&Offsets>,
        first: usize,
    ) -> (S::Lanes, S::Lanes) {
        let position = |middle: S::Lanes, axis: usize, start: usize, size: u32| {
            // In halves of pixels from the middle of the image: whole numbers for middles of pixels,
            // so exact.
            let start = S::Lanes::from_f64(2.0 * start as f64 + 1.0 - f64::from(size));
            let within = offsets.map_or(S::Lanes::ZERO, |offsets| {
                S::Lanes::from_lanes(|lane| {
                    Real::from_f64(2.0 * f64::from(offsets[axis][first + lane]))
                })
            });
            (middle + start + within) * S::Lanes::from_f64(1.0 / f64::from(size))
        };
        let (x, y) = self.film_offsets[first / <S::Lanes as Lanes>::COUNT];
        let (width, height) = (self.layout.width, self.layout.height);
        (position(x, 0, tile.left, width), -position(y, 1, tile.top, height))
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

/// A ray with that of the first living lane in the lanes that do not count.
pub fn repeated_ray<S: Number>(ray: &Ray<S>, alive: u32) -> Ray<S> {
    if alive == all_lanes::<S::Lanes>() {
        return *ray;
    }
    let first = alive.trailing_zeros() as usize;
    let repeat =
        |x: S| S::from_each(|lane| x.lane(if alive >> lane & 1 == 1 { lane } else { first }));
    Ray::from_fn(&mut |index| repeat(ray.number(index)))
}

/// How many vectors of lanes the rays of a packet make.
pub fn blocks<S: Number>() -> usize {
    PACKET_RAYS / <S::Lanes as Lanes>::COUNT
}

/// As many zeros as there are blocks.
pub fn clear_blocks<S: Number, T: Additive>(values: &mut Vec<T>) {
    values.clear();
    values.resize(blocks::<S>(), T::zero());
}

/// Puts lanes of a group into their block.
#[inline]
pub fn put<S: Number, T: Fields<S>>(group: &LaneGroup<S>, lanes: u32, value: &T, blocks: &mut [T]) {
    let block = &mut blocks[group.block()];
    *block = select_lanes::<S, T>(lanes, value, block);
}

/// Twice the columns and the rows of the rays of a packet, within their tile, by block.
pub fn film_offsets<L: Lanes>() -> Vec<(L, L)> {
    let offset = |ray: usize, axis: usize| {
        let (column, row) = tile_position(ray);
        <L::Element as Real>::from_f64(2.0 * [column, row][axis] as f64)
    };
    let blocks = (0..PACKET_RAYS).step_by(L::COUNT);
    blocks
        .map(|first| {
            let along = |axis: usize| L::from_lanes(|lane| offset(first + lane, axis));
            (along(0), along(1))
        })
        .collect()
}

/// Sets the vectors of the rays from `first` on, in the lanes whose bits are set.
#[inline]
pub fn set_vectors<L: Lanes>(to: &mut PacketVectors, first: usize, lanes: u32, v: Vec3<L>) {
    for (to, from) in [(&mut to.x, v.x()), (&mut to.y, v.y()), (&mut to.z, v.z())] {
        let (to, from) = (&mut to[first..first + L::COUNT], singles_of_lanes(from));
        if lanes == all_lanes::<L>() {
            to.copy_from_slice(&from[..L::COUNT]);
        } else {
            rays(lanes.into()).for_each(|lane| to[lane] = from[lane]);
        }
    }
}
