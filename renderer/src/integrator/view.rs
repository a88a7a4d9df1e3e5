//! What the camera sees in a tile: which primitive each pixel shows, gathered into lanes.

use super::prepared::{Kind, Prepared};
use super::tiles::Tile;
use crate::acceleration::{Hit, PACKET_RAYS, PacketDirections};
use crate::kernels::camera::{Frame, Ray, primary_ray};
use crate::kernels::material::Material;
use crate::kernels::sphere::{Sphere, sphere_surface};
use crate::kernels::surface::SurfacePoint;
use crate::kernels::triangle::triangle_surface;
use crate::precision::{lanes_of_vectors, vectors_of_lanes};
use std::ops::Range;

use ad::lanes::Lanes;
use ad::{Real, Vec3};

/// A pixel that shows a primitive.
#[derive(Clone, Copy)]
pub(super) struct Seen {
    /// Column.
    pub x: u32,
    /// Row.
    pub y: u32,
    /// What is seen.
    pub hit: Hit,
    /// Its kind.
    pub kind: Kind,
    /// Its index among those of its kind.
    pub index: usize,
}

/// The pixels of a tile.
pub(super) struct View {
    /// Those that show something, triangles before spheres.
    pub seen: Vec<Seen>,
    /// Those that show nothing.
    pub missed: Vec<(u32, u32)>,
}

/// As many pixels as there are lanes, all of which show primitives of one kind. Lanes beyond the
/// last pixel repeat it.
pub(super) struct Group<L: Lanes> {
    /// The pixels, by index into [`View::seen`].
    pub pixels: Range<usize>,
    pub film: (L, L),
    pub ray: Ray<L>,
    pub shape: GroupShape<L>,
    pub surface: SurfacePoint<L>,
    pub material: Material<L>,
}

/// The primitives that a group shows.
pub(super) enum GroupShape<L: Lanes> {
    /// Their corners.
    Triangles([Vec3<L>; 3]),
    /// The spheres, and where the ray leaves instead of entering.
    Spheres(Sphere<L>, L::Mask),
}

impl<L: Lanes> Prepared<'_, L> {
    /// Looks through the middle of every pixel of a tile.
    pub(super) fn view(&self, tile: &Tile) -> View {
        let frame = self.frame.narrow::<L>();
        let pixels: Vec<_> = tile.pixels().collect();
        let mut directions = PacketDirections::ZERO;
        for (i, group) in pixels.chunks(L::COUNT).enumerate() {
            let (x, y) = self.film(|lane| group[lane.min(group.len() - 1)]);
            let ray = primary_ray::<L>(frame, x, y);
            for (lane, direction) in
                vectors_of_lanes::<L>(ray.direction)[..group.len()].iter().enumerate()
            {
                directions.set(i * L::COUNT + lane, direction.as_vec3());
            }
        }
        let active = u64::MAX >> (PACKET_RAYS - pixels.len());
        let origin = self.frame.origin.as_vec3();
        let hits = self.acceleration.nearest_packet(origin, &directions, active);

        let mut view = View { seen: Vec::with_capacity(pixels.len()), missed: Vec::new() };
        for (i, (x, y)) in pixels.into_iter().enumerate() {
            match hits.get(i) {
                Some(hit) => {
                    let (kind, index) = self.kind(hit.primitive);
                    view.seen.push(Seen { x, y, hit, kind, index });
                }
                None => view.missed.push((x, y)),
            }
        }
        if !self.spheres.is_empty() {
            view.seen.sort_by_key(|seen| seen.kind == Kind::Sphere);
        }
        view
    }

    /// Where pixels stand on the image plane.
    fn film(&self, pixel: impl Fn(usize) -> (u32, u32)) -> (L, L) {
        let position = |index: u32, size: u32| {
            let position = (f64::from(index) + 0.5) / f64::from(size) * 2.0 - 1.0;
            L::Element::from_f64(position)
        };
        (
            L::from_lanes(|lane| position(pixel(lane).0, self.scene.width)),
            -L::from_lanes(|lane| position(pixel(lane).1, self.scene.height)),
        )
    }

    /// The pixels of a view in groups, as the lanes take them.
    pub(super) fn groups(&self, view: &View) -> Vec<Group<L>> {
        let frame = self.frame.narrow::<L>();
        let all = view.seen.len();
        let triangles = view.seen.partition_point(|seen| seen.kind == Kind::Triangle);
        let chunks = |from: usize, to: usize| {
            (from..to).step_by(L::COUNT).map(move |start| start..(start + L::COUNT).min(to))
        };
        chunks(0, triangles)
            .chain(chunks(triangles, all))
            .map(|pixels| self.gather(frame, view, pixels))
            .collect()
    }

    /// Gathers what a group of pixels shows, and computes the points that are seen.
    fn gather(&self, frame: Frame<L>, view: &View, pixels: Range<usize>) -> Group<L> {
        let seen = &view.seen[pixels.clone()];
        let seen = |lane: usize| &seen[lane.min(seen.len() - 1)];
        let film = self.film(|lane| (seen(lane).x, seen(lane).y));
        let ray = primary_ray::<L>(frame, film.0, film.1);
        let shape = match seen(0).kind {
            Kind::Triangle => {
                let corner = |corner: usize| {
                    lanes_of_vectors::<L>(|lane| {
                        let triangle = self.triangles[seen(lane).index];
                        self.vertices[triangle[corner] as usize]
                    })
                };
                GroupShape::Triangles([corner(0), corner(1), corner(2)])
            }
            Kind::Sphere => {
                let sphere = |lane: usize| &self.spheres[seen(lane).index];
                let spheres = Sphere {
                    center: lanes_of_vectors::<L>(|lane| sphere(lane).center),
                    radius: L::from_lanes(|lane| sphere(lane).radius),
                };
                GroupShape::Spheres(spheres, L::mask_from_lanes(|lane| seen(lane).hit.leaves))
            }
        };
        let surface = match &shape {
            GroupShape::Triangles([a, b, c]) => triangle_surface::<L>(ray, *a, *b, *c),
            GroupShape::Spheres(sphere, leaves) => sphere_surface::<L>(ray, *sphere, *leaves),
        };
        Group {
            pixels,
            film,
            ray,
            shape,
            surface,
            material: self.gather_materials(|lane| seen(lane)),
        }
    }

    fn gather_materials<'s>(&self, seen: impl Fn(usize) -> &'s Seen) -> Material<L> {
        let material = |lane: usize| &self.materials[self.material_of(seen(lane).hit.primitive)];
        Material {
            ambient: lanes_of_vectors::<L>(|lane| material(lane).ambient),
            diffuse: lanes_of_vectors::<L>(|lane| material(lane).diffuse),
            specular: lanes_of_vectors::<L>(|lane| material(lane).specular),
            exponent: L::from_lanes(|lane| material(lane).exponent),
        }
    }
}
