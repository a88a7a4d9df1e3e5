//! What the rays of a tile meet, gathered into lanes.

use ad::lanes::Lanes;
use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3, select};

use super::crossings::Passed;
use super::prepared::Prepared;
use super::sampling::{Offsets, Sampling};
use super::shadows::Lit;
use super::sharing::Sharing;
use super::tiles::Tile;
use crate::acceleration::{PACKET_RAYS, PacketHits, PacketVectors, rays, tile_position};
use crate::counts::count;
use crate::kernels::camera::{Ray, film_point, primary_ray};
use crate::kernels::material::Material;
use crate::kernels::sphere::{Sphere, sphere_surface};
use crate::kernels::surface::SurfacePoint;
use crate::kernels::triangle::triangle_surface;
use crate::precision::{singles_of_lanes, splat, splat_vector};

/// What the rays of a tile meet: those of the camera, or those that go on from mirrors or behind
/// transparent surfaces.
pub(super) struct View<L: Lanes> {
    /// What each ray meets first.
    pub hits: PacketHits,
    /// A bit for each ray that meets nothing.
    pub missed: u64,
    /// The rays that meet something.
    pub groups: Vec<Group<L>>,
    /// By light: the rays that end where it shines.
    pub lit: Vec<Lit>,
    /// By light: what transparent surfaces leave of it; empty if there are none.
    pub passed: Vec<Passed<L>>,
    /// Of rays from the camera: where within their pixels they go.
    pub offsets: Option<Offsets>,
    /// Of rays that go on: the rays, in vectors of lanes.
    pub rays: Vec<Ray<L>>,
    /// Of rays that go on: the radiance that they bring, in vectors of lanes.
    pub radiance: Vec<Vec3<L>>,
}

/// One ray for each pixel of a tile.
#[derive(Clone, Copy)]
pub(super) struct Sample<'a> {
    pub tile: &'a Tile,
    pub sampling: Sampling,
    /// Which of its rays, from 0 on.
    pub index: u32,
}

fn samples(tile: &Tile, sampling: Sampling) -> impl Iterator<Item = Sample<'_>> {
    (0..sampling.count()).map(move |index| Sample { tile, sampling, index })
}

/// Rays that meet primitives of one kind, one in each lane.
pub(super) struct Group<L: Lanes> {
    /// The ray in lane 0; the others follow.
    pub first: usize,
    /// A bit for each lane that counts. The others repeat one of these.
    pub alive: u32,
    /// The lanes by primitive.
    pub primitives: Sharing,
    pub ray: Ray<L>,
    pub shape: Shape<L>,
    pub surface: SurfacePoint<L>,
}

/// The kind of primitives that a group shows.
#[derive(Clone, Copy)]
pub(super) enum Shape<L: Lanes> {
    Triangles,
    /// With a mask that holds where the ray leaves the sphere instead of entering it.
    Spheres(L::Mask),
    /// Shapes that users add.
    Custom,
}

impl<L: Lanes> Group<L> {
    /// The lanes that count, with their rays.
    #[inline]
    pub fn rays(&self) -> impl Iterator<Item = (usize, usize)> + use<L> {
        let first = self.first;
        rays(self.alive.into()).map(move |lane| (lane, first + lane))
    }
}

/// To be filled by [`Prepared::look`], then by [`Prepared::light_up`].
impl<L: Lanes> Default for View<L> {
    fn default() -> Self {
        Self {
            hits: PacketHits::NONE,
            missed: 0,
            groups: Vec::new(),
            lit: Vec::new(),
            passed: Vec::new(),
            offsets: None,
            rays: Vec::new(),
            radiance: Vec::new(),
        }
    }
}

impl<L: Lanes> Prepared<'_, L> {
    /// The rays through the pixels of a tile, one for each at a time.
    pub(super) fn samples<'t>(
        &self,
        tile: &'t Tile,
    ) -> impl Iterator<Item = Sample<'t>> + use<'t, L> {
        samples(tile, self.sampling)
    }

    /// Those that the derivative of the radiance is computed from.
    pub(super) fn gradient_samples<'t>(
        &self,
        tile: &'t Tile,
    ) -> impl Iterator<Item = Sample<'t>> + use<'t, L> {
        samples(tile, self.sampling.of_gradient())
    }

    /// Looks through one point of every pixel of a tile.
    pub(super) fn look(&self, sample: &Sample<'_>, view: &mut View<L>) {
        let tile = sample.tile;
        let offsets = sample.sampling.offsets(tile, sample.index);
        let mut directions = PacketVectors::ZERO;
        for first in (0..PACKET_RAYS).step_by(L::COUNT) {
            let (x, y) = self.film(tile, offsets.as_ref(), first);
            set_vectors::<L>(
                &mut directions,
                first,
                all_lanes::<L>(),
                film_point::<L>(self.frame, x, y),
            );
        }
        let wanted = tile.rays();
        count(|counts| &counts.primary_rays, u64::from(wanted.count_ones()));
        self.nearest_into(tile, &directions, wanted, &mut view.hits);

        let ray = |first: usize, alive: u32| {
            let (x, y) = self.film(tile, offsets.as_ref(), first);
            primary_ray::<L>(self.frame, repeated(x, alive), repeated(y, alive))
        };
        self.group(view, wanted, ray);
        view.offsets = offsets;
    }

    /// Gathers what the wanted rays of a packet meet. `ray` gives those from an index on; in lanes
    /// that do not count it repeats one that does.
    #[inline]
    pub(super) fn group(
        &self,
        view: &mut View<L>,
        wanted: u64,
        ray: impl Fn(usize, u32) -> Ray<L>,
    ) {
        let hits = &view.hits;
        let met = wanted & hits.met();
        view.missed = wanted & !met;
        view.groups.clear();
        let (triangles, others) = (self.triangles.len(), self.spheres.len());
        let triangles = met & below(triangles, &hits.primitive, others + self.scene.shapes.len());
        let spheres = met
            & !triangles
            & below(self.triangles.len() + others, &hits.primitive, self.scene.shapes.len());
        let custom = met & !triangles & !spheres;
        for first in (0..PACKET_RAYS).step_by(L::COUNT) {
            let lanes = |rays: u64| (rays >> first) as u32 & all_lanes::<L>();
            let leaves = L::mask_from_bits(lanes(hits.leaves));
            for (shape, rays) in [
                (Shape::Triangles, triangles),
                (Shape::Spheres(leaves), spheres),
                (Shape::Custom, custom),
            ] {
                let alive = lanes(rays);
                if alive == 0 {
                    continue;
                }
                let primitives = Sharing::new(&hits.primitive, first, alive);
                let ray = ray(first, alive);
                let surface = match shape {
                    Shape::Triangles => {
                        let [a, b, c] = self.corners(&primitives);
                        triangle_surface::<L>(ray, a, b, c)
                    }
                    Shape::Spheres(leaves) => {
                        sphere_surface::<L>(ray, self.spheres(&primitives), leaves)
                    }
                    Shape::Custom => self.custom_surface(&primitives, ray, alive),
                };
                view.groups.push(Group { first, alive, primitives, ray, shape, surface });
            }
        }
    }

    /// The corners of triangles.
    #[inline]
    pub(super) fn corners(&self, triangles: &Sharing) -> [Vec3<L>; 3] {
        let vertex = |vertex: u32| splat_vector::<L>(self.vertices[vertex as usize]);
        triangles.gather::<L, _>(|triangle| {
            let [a, b, c] = self.triangles[triangle];
            [vertex(a), vertex(b), vertex(c)]
        })
    }

    /// Spheres, by primitive.
    #[inline]
    pub(super) fn spheres(&self, primitives: &Sharing) -> Sphere<L> {
        primitives.gather::<L, _>(|primitive| self.spheres[self.sphere_of(primitive)].splat())
    }

    /// The lanes of a group by material.
    #[inline]
    pub(super) fn materials(&self, group: &Group<L>) -> Sharing {
        group.primitives.map(|primitive| self.material_of[primitive])
    }

    /// Materials, by index.
    #[inline]
    pub(super) fn material(&self, materials: &Sharing) -> Material<L> {
        materials.gather::<L, _>(|material| self.materials[material].splat())
    }

    /// Whether a material reflects like a mirror.
    pub(super) fn is_mirror(&self, material: usize) -> bool {
        self.materials[material].reflection != Vec3::<L::Element>::splat(Real::ZERO)
    }

    /// Whether a material has no highlight.
    pub(super) fn is_matte(&self, material: usize) -> bool {
        self.materials[material].specular == Vec3::<L::Element>::splat(Real::ZERO)
    }

    /// Where the rays from `first` on meet the image plane.
    #[inline]
    pub(super) fn film(&self, tile: &Tile, offsets: Option<&Offsets>, first: usize) -> (L, L) {
        let position = |middle: L, axis: usize, start: usize, size: u32| {
            // In halves of pixels from the middle of the image: whole numbers for middles of pixels,
            // so exact.
            let start = L::from_f64(2.0 * start as f64 + 1.0 - f64::from(size));
            let within = offsets.map_or(L::ZERO, |offsets| {
                L::from_lanes(|lane| {
                    let offset = offsets[axis][first + lane];
                    <L::Element as Real>::from_f64(2.0 * f64::from(offset))
                })
            });
            (middle + start + within) * L::from_f64(1.0 / f64::from(size))
        };
        let (x, y) = self.film_offsets[first / L::COUNT];
        let (width, height) = (self.scene.width, self.scene.height);
        (position(x, 0, tile.left, width), -position(y, 1, tile.top, height))
    }
}

/// Puts that of the first living lane into the lanes that do not count.
#[inline]
pub(super) fn repeated<L: Lanes>(x: L, alive: u32) -> L {
    if alive == all_lanes::<L>() {
        return x;
    }
    let first = alive.trailing_zeros() as usize;
    select(L::mask_from_bits(alive), x, splat::<L>(x.lanes().as_ref()[first]))
}

/// A bit for each lane.
#[inline]
pub(super) fn all_lanes<L: Lanes>() -> u32 {
    u32::MAX >> (32 - L::COUNT)
}

/// Twice the columns and the rows of the rays of a packet, within their tile, by groups of lanes.
pub(super) fn film_offsets<L: Lanes>() -> Vec<(L, L)> {
    let offset = |ray: usize, axis: usize| {
        let (column, row) = tile_position(ray);
        <L::Element as Real>::from_f64(2.0 * [column, row][axis] as f64)
    };
    let groups = (0..PACKET_RAYS).step_by(L::COUNT);
    groups
        .map(|first| {
            let along = |axis: usize| L::from_lanes(|lane| offset(first + lane, axis));
            (along(0), along(1))
        })
        .collect()
}

/// Sets the vectors of the rays from `first` on, in the lanes whose bits are set.
#[inline]
pub(super) fn set_vectors<L: Lanes>(to: &mut PacketVectors, first: usize, lanes: u32, v: Vec3<L>) {
    for (to, from) in [(&mut to.x, v.x()), (&mut to.y, v.y()), (&mut to.z, v.z())] {
        let (to, from) = (&mut to[first..first + L::COUNT], singles_of_lanes(from));
        if lanes == all_lanes::<L>() {
            to.copy_from_slice(&from[..L::COUNT]);
        } else {
            rays(lanes.into()).for_each(|lane| to[lane] = from[lane]);
        }
    }
}

/// A bit for each ray whose primitive has an index below `end`, beyond which there are `rest` more.
fn below(end: usize, primitives: &[u32; PACKET_RAYS], rest: usize) -> u64 {
    if rest == 0 {
        return u64::MAX;
    }
    let bits = primitives.iter().enumerate();
    bits.fold(0, |bits, (ray, &primitive)| bits | u64::from((primitive as usize) < end) << ray)
}
