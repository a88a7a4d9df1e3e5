//! A wavefront: the rays of a tile at one depth of their paths, and what they hit, gathered into lanes.

use ad::lanes::Lanes;
use ad::vector::Vector3;
use ad::{Additive, Fields, Vec3, select};

use super::coalesce::{Coalesced, select_lanes};
use super::gather::Lookup;
use super::known::KnownPaths;
use super::lanes::{all_lanes, numbers_of_lanes, set_singles};
use super::scattered::{EmitterSample, Scattering};
use crate::number::Number;
use crate::trace::bvh::{PACKET_RAYS, PacketHits, PacketVectors, rays};
use crate::trace::layout::Kind;
use crate::trace::random::PathNumbers;
use crate::trace::sampling::Sampling;
use crate::trace::tile::Tile;
use crate::transport::camera::Ray;
use crate::transport::material::Bsdf;
use crate::transport::normal_map::NormalMap;
use crate::transport::surface::SurfacePoint;

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
    /// A bit for each ray that ends where an opaque surface is in the way of a light that the surface
    /// faces, by light.
    pub blocked: Vec<u64>,
    /// By ray: the [number](super::known::KnownHit::filters) of the materials that lights come through; empty if
    /// nothing is transparent.
    pub filters: Vec<u32>,
    /// For camera rays: where they meet the image plane, by block.
    pub film: Vec<(S::Lanes, S::Lanes)>,
    /// For rays that go on: the rays, by block.
    pub rays: Vec<Ray<S>>,
    /// For rays that go on: the radiance that they bring, by block of the wavefront before.
    pub radiance: Vec<Vec3<S>>,
    /// Where light takes all paths: how they were chosen.
    pub scattering: Scattering<S>,
}

/// Where the rays of a wavefront come from.
#[derive(Clone, Copy)]
pub enum Source<'a> {
    /// They are traced.
    Tile(TileSample<'a>),
    /// They go through any points of the film, and are traced.
    Film(&'a [[f64; 2]]),
    /// The same, where light takes all paths.
    ScatteredFilm(&'a [[f64; 2]], &'a PathNumbers),
    /// They were traced before.
    Traced(TileSample<'a>, &'a KnownPaths),
    /// They are known, through any points of the film.
    Known(&'a KnownPaths),
    /// The same, where light takes all paths: it is known what camera rays meet.
    Scattered(&'a KnownPaths, &'a PathNumbers),
}

impl<'a> Source<'a> {
    /// The paths, if they are known.
    pub fn known(self) -> Option<&'a KnownPaths> {
        match self {
            Self::Tile(_) | Self::Film(_) | Self::ScatteredFilm(..) => None,
            Self::Traced(_, paths) | Self::Known(paths) | Self::Scattered(paths, _) => Some(paths),
        }
    }
}

/// One ray through each of some pixels of a tile.
#[derive(Clone, Copy)]
pub struct TileSample<'a> {
    pub tile: &'a Tile,
    pub sampling: Sampling,
    /// The index of the ray among those of its pixel.
    pub index: u32,
}

/// The rays through the pixels of a tile, one for each at a time.
pub fn samples(tile: &Tile, sampling: Sampling) -> impl Iterator<Item = Source<'_>> {
    let of_part = move |sampling: Sampling| {
        let sample = move |index| Source::Tile(TileSample { tile, sampling, index });
        (0..sampling.count()).map(sample)
    };
    sampling.parts().flat_map(of_part)
}

/// Rays of a packet side by side.
#[derive(Clone, Copy, Debug)]
pub struct RayLanes {
    /// The ray in lane 0; the others follow.
    pub first: usize,
    /// A bit for each lane that counts.
    pub alive: u32,
}

impl RayLanes {
    /// The lanes that count, with their rays.
    #[inline]
    pub fn rays(self) -> impl Iterator<Item = (usize, usize)> {
        rays(self.alive.into()).map(move |lane| (lane, self.first + lane))
    }

    /// The block of the packet that the lanes are.
    #[inline]
    pub fn block<S: Number>(self) -> usize {
        self.first / <S::Lanes as Lanes>::COUNT
    }
}

/// Rays that hit primitives of one kind, one in each lane.
pub struct LaneGroup<S: Number> {
    /// Which of the groups of its wavefront it is.
    pub index: usize,
    /// The ray in lane 0; the others follow.
    pub first: usize,
    /// A bit for each lane that counts. The others repeat one of these.
    pub alive: u32,
    /// The lanes by primitive.
    pub primitives: Coalesced,
    pub kind: Kind,
    /// The BSDF of the materials: all of a group have the same.
    pub bsdf: Bsdf,
    /// A bit for each lane whose ray starts inside of a sphere, or behind a triangle of a dielectric.
    pub inside: u32,
    pub ray: Ray<S>,
    pub surface: SurfacePoint<S>,
    /// Whether the primitives are smooth triangles: all of a group are, or none is.
    pub is_smooth: bool,
    /// Where the shading normals are not those of the flat triangles: what these are.
    pub bent: Option<Bent<S>>,
    /// The normal maps, if any of the lanes has one. They have bent the normals of the surface points.
    pub mapped: Option<Box<Mapped<S>>>,
}

/// What a group of triangles with other shading normals than their own has beside its surface points.
pub struct Bent<S: Number> {
    /// The unit normals of the flat triangles, on the side of the viewer.
    pub outward: Vec3<S>,
    /// The places from which shadow rays start.
    pub curved: Vec3<S::Lanes>,
}

/// The normal maps of a group.
pub struct Mapped<S: Number> {
    /// The shading normals without them.
    pub normal: Vec3<S>,
    /// The texels, in the lanes that have a map.
    pub lookup: Lookup<S>,
    pub map: NormalMap<S>,
}

impl<S: Number> LaneGroup<S> {
    /// The rays.
    #[inline]
    pub fn lanes(&self) -> RayLanes {
        RayLanes { first: self.first, alive: self.alive }
    }

    /// The lanes that count, with their rays.
    #[inline]
    pub fn rays(&self) -> impl Iterator<Item = (usize, usize)> + use<S> {
        self.lanes().rays()
    }

    /// The block of the packet that the lanes are.
    #[inline]
    pub fn block(&self) -> usize {
        self.lanes().block::<S>()
    }

    /// The bits of the lanes among those of a packet.
    #[inline]
    pub fn lanes_of(&self, rays: u64) -> u32 {
        (rays >> self.first) as u32 & self.alive
    }
}

/// What transparent surfaces leave of a light, by ray of a wavefront.
pub struct Transmission<S: Number> {
    /// The transmittance, by block; 1 where nothing is in the way.
    pub transmittance: Vec<S>,
    /// The surfaces that light goes through, group after group, and from the points to the light.
    pub occluders: Vec<Occluder<S>>,
}

/// Transparent surfaces of one kind between lanes of a group and a light.
pub struct Occluder<S: Number> {
    /// The index of the group in its wavefront.
    pub group: usize,
    /// A bit for each lane whose light goes through a surface here.
    pub lanes: u32,
    pub primitives: Coalesced,
    pub kind: Kind,
    /// A bit for each lane whose light leaves a sphere here.
    pub inside: u32,
    /// The transmittance of the surfaces before this one.
    pub before: S,
    /// The opacity of this one.
    pub opacity: S,
}

impl<S: Number> Transmission<S> {
    /// The transmittance in the lanes of a group.
    #[inline]
    pub fn of(&self, group: &LaneGroup<S>) -> S {
        self.transmittance[group.block()]
    }

    /// The surfaces between the light and the group of this index, from the points on.
    pub fn occluders_of(&self, group: usize) -> &[Occluder<S>] {
        let end = self.occluders.partition_point(|occluder| occluder.group <= group);
        let start = self.occluders.partition_point(|occluder| occluder.group < group);
        &self.occluders[start..end]
    }
}

impl<S: Number> Wavefront<S> {
    /// The group that a ray is in, if it hits something.
    pub fn group_of(&self, ray: usize) -> Option<&LaneGroup<S>> {
        self.groups.iter().find(|group| group.rays().any(|(_, of_group)| of_group == ray))
    }

    /// Where camera rays meet the film, by ray.
    pub fn film_points(&self) -> impl Iterator<Item = [f64; 2]> {
        self.film.iter().flat_map(|&(x, y)| {
            let [x, y] = [x, y].map(numbers_of_lanes::<S::Lanes>);
            (0..<S::Lanes as Lanes>::COUNT).map(move |lane| [x[lane], y[lane]])
        })
    }

    /// The first emitter that is seen from where a ray ends.
    pub fn emitter_of(&self, ray: usize) -> Option<&EmitterSample<S>> {
        self.scattering.emitters.iter().find(|sample| {
            let lane = ray.checked_sub(self.groups[sample.group].first);
            let is_seen = |lane| lane < <S::Lanes as Lanes>::COUNT && sample.lanes >> lane & 1 == 1;
            lane.is_some_and(is_seen)
        })
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
            blocked: Vec::new(),
            filters: Vec::new(),
            film: Vec::new(),
            rays: Vec::new(),
            radiance: Vec::new(),
            scattering: Scattering::default(),
        }
    }
}

/// A ray with that of the first living lane in the lanes that do not count.
pub fn repeated_ray<S: Number>(ray: &Ray<S>, alive: u32) -> Ray<S> {
    if alive == all_lanes::<S::Lanes>() {
        return *ray;
    }
    let first = alive.trailing_zeros() as usize;
    let repeat = |x: S| select(S::mask(alive), x, S::splat(x.lane(first)));
    Ray::from_fn(&mut |index| repeat(ray.number(index)))
}

/// How many vectors of lanes the rays of a packet make.
pub fn blocks<S: Number>() -> usize {
    PACKET_RAYS / <S::Lanes as Lanes>::COUNT
}

/// Fills `values` with as many zeros as there are blocks.
pub fn clear_blocks<S: Number, T: Additive>(values: &mut Vec<T>) {
    values.clear();
    values.resize(blocks::<S>(), T::zero());
}

/// Puts lanes into their block.
#[inline]
pub fn put<S: Number, T: Fields<S>>(rays: RayLanes, lanes: u32, value: &T, blocks: &mut [T]) {
    let block = &mut blocks[rays.block::<S>()];
    *block = select_lanes::<S, T>(lanes, value, block);
}

/// Sets the vectors of the rays from `first` on, in the lanes whose bits are set.
#[inline]
pub fn set_vectors<L: Lanes>(to: &mut PacketVectors, first: usize, lanes: u32, v: Vec3<L>) {
    for (to, from) in [(&mut to.x, v.x()), (&mut to.y, v.y()), (&mut to.z, v.z())] {
        set_singles(&mut to[first..], lanes, from);
    }
}
