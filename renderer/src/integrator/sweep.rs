//! The work of a gradient on the tiles of the image.

use std::mem;

use ad::lanes::Lanes;
use ad::{Additive, Mask, Tangent, Vec3, select};
use glam::DVec3;

use super::gradient::Wanted;
use super::mirrors::{Mirrors, Sight, blocks};
use super::prepared::Prepared;
use super::radiance::{PixelLoss, black_pixels};
use super::shade::{LightCotangent, Pulled, Shaded};
use super::sums::{Slots, StripSums};
use super::tiles::{Strip, Tile, for_each_strip};
use super::view::{Group, Shape, View};
use crate::kernels::camera::{Frame, Ray, RayTangent, primary_ray};
use crate::kernels::sphere::sphere_surface;
use crate::kernels::surface::{SurfacePoint, mirrored_ray};
use crate::kernels::triangle::triangle_surface;
use crate::precision::{MOST_LANES, lanes_of_vectors, sum_of_vectors, vectors_of_lanes};

/// What the strips of the image add up to, each by itself.
pub(crate) fn sweep<L: Lanes>(
    prepared: &Prepared<'_, L>,
    loss: &impl PixelLoss,
    wanted: Wanted,
) -> Vec<StripSums> {
    let (width, height) = (prepared.scene.width, prepared.scene.height);
    let start = || Sweep::new(prepared, loss, wanted);
    for_each_strip(width, height, start, Sweep::strip)
}

/// The work on strips that follow each other on a thread.
struct Sweep<'a, L: Lanes, P> {
    prepared: &'a Prepared<'a, L>,
    loss: &'a P,
    wanted: Wanted,
    mirrors: Mirrors,
    sight: Sight<L>,
    back: Back<L>,
    sums: StripSums,
    materials: Slots,
    spheres: Slots,
    vertices: Slots,
}

impl<'a, L: Lanes, P: PixelLoss> Sweep<'a, L, P> {
    fn new(prepared: &'a Prepared<'a, L>, loss: &'a P, wanted: Wanted) -> Self {
        let slots = |wanted: bool, count: usize| Slots::new(if wanted { count } else { 0 });
        Self {
            prepared,
            loss,
            wanted,
            mirrors: if wanted.mirrors { Mirrors::All } else { Mirrors::Bright },
            sight: Sight::default(),
            back: Back::default(),
            sums: StripSums::zero(&prepared.lights),
            materials: slots(wanted.materials, prepared.materials.len()),
            spheres: slots(wanted.spheres, prepared.spheres.len()),
            vertices: slots(wanted.vertices, prepared.vertices.len()),
        }
    }

    fn strip(&mut self, strip: Strip) -> StripSums {
        for tile in strip.tiles() {
            self.add_tile(&tile);
        }
        mem::replace(&mut self.sums, StripSums::zero(&self.prepared.lights))
    }

    fn add_tile(&mut self, tile: &Tile) {
        let (mut sight, mut back) = (mem::take(&mut self.sight), mem::take(&mut self.back));
        self.prepared.see(tile, self.mirrors, &mut sight);
        let views = sight.views();
        self.sums.loss += black_pixels(tile, views[0].missed, self.loss);
        back.start(views);
        for depth in 0..views.len() {
            self.pull_shading(tile, views, depth, &mut back);
        }
        if self.wanted.surface() {
            for (depth, view) in views.iter().enumerate().rev() {
                self.pull_surfaces(tile, view, depth, &mut back);
            }
        }
        (self.sight, self.back) = (sight, back);
    }

    /// From the radiance of a view to its materials, lights and surface points, and to the radiance
    /// that mirrors in it show.
    fn pull_shading(&mut self, tile: &Tile, views: &[View<L>], depth: usize, back: &mut Back<L>) {
        let Self { prepared, loss, wanted, sums, materials: slots, .. } = self;
        let view = &views[depth];
        for group in &view.groups {
            let block = group.first / L::COUNT;
            let respond = |radiance| match depth {
                0 => {
                    let (loss, cotangent) = respond(*loss, tile, group, radiance);
                    sums.loss += loss;
                    cotangent
                }
                _ => {
                    let alive = L::mask_from_bits(group.alive);
                    Some(select(alive, back.radiance[depth][block], Additive::zero()))
                }
            };
            let to_light = |light: usize, cotangent: LightCotangent<L>| {
                if wanted.lights {
                    sums.lights[light].add(&cotangent);
                }
            };
            let materials = prepared.materials(group);
            let shaded = Shaded::new(prepared, group, &materials, &view.lit, views.get(depth + 1));
            let pulled = shaded.pull_back(respond, to_light);
            if let (true, Some(Pulled { material, .. })) = (wanted.materials, &pulled) {
                for (index, lanes) in materials.iter() {
                    let sum = material.sum(L::mask_from_bits(lanes));
                    slots.add(&mut sums.materials, index, sum);
                }
            }
            if let (Some(mirrored), Some(pulled)) = (back.radiance.get_mut(depth + 1), &pulled) {
                mirrored[block].accumulate(pulled.mirrored);
            }
            back.surfaces[depth].push(pulled.map(|pulled| pulled.surface));
        }
    }

    /// From the surface points of a view to its primitives, and to where its rays come from: the
    /// mirrors in the view before, or the camera.
    fn pull_surfaces(&mut self, tile: &Tile, view: &View<L>, depth: usize, back: &mut Back<L>) {
        let mut to_frame = Tangent::<Frame<L>>::zero();
        for (index, group) in view.groups.iter().enumerate() {
            let Some(mut surface) = back.surfaces[depth][index] else { continue };
            let block = group.first / L::COUNT;
            if let Some(rays) = back.rays.get(depth + 1) {
                let alive = L::mask_from_bits(group.alive);
                let (_, pullback) = mirrored_ray::vjp::<L>(group.surface);
                let RayTangent { origin, direction } = rays[block];
                surface.accumulate(pullback(RayTangent {
                    origin: select(alive, origin, Additive::zero()),
                    direction: select(alive, direction, Additive::zero()),
                }));
            }
            let to_ray = self.pull_surface(group, surface);
            if depth > 0 {
                back.rays[depth][block].accumulate(to_ray);
            } else if self.wanted.camera {
                let (x, y) = self.prepared.film(tile, group.first);
                let (_, pullback) = primary_ray::vjp::<L>(self.prepared.frame, x, y);
                to_frame.accumulate(pullback(to_ray).0);
            }
        }
        if depth == 0 && self.wanted.camera {
            self.sums.frame.accumulate(to_frame.sum(Mask::splat(true)));
        }
    }

    /// Pulls the cotangent of surface points back to primitives; returns that of the rays.
    #[inline]
    fn pull_surface(
        &mut self,
        group: &Group<L>,
        cotangent: Tangent<SurfacePoint<L>>,
    ) -> Tangent<Ray<L>> {
        let Self { prepared, wanted, sums, .. } = self;
        match group.shape {
            Shape::Triangles => {
                let [a, b, c] = prepared.corners(&group.primitives);
                let (_, pullback) = triangle_surface::vjp::<L>(group.ray, a, b, c);
                let (ray, a, b, c) = pullback(cotangent);
                if wanted.vertices {
                    for (triangle, lanes) in group.primitives.iter() {
                        let mask = L::mask_from_bits(lanes);
                        for (&vertex, corner) in prepared.triangles[triangle].iter().zip([a, b, c])
                        {
                            let sum = sum_of_vectors::<L>(corner, mask);
                            self.vertices.add(&mut sums.vertices, vertex as usize, sum);
                        }
                    }
                }
                ray
            }
            Shape::Spheres(leaves) => {
                let spheres = prepared.spheres(&group.primitives);
                let (_, pullback) = sphere_surface::vjp::<L>(group.ray, spheres, leaves);
                let (ray, sphere, ()) = pullback(cotangent);
                if wanted.spheres {
                    for (primitive, lanes) in group.primitives.iter() {
                        let sum = sphere.sum(L::mask_from_bits(lanes));
                        let index = prepared.sphere_of(primitive);
                        self.spheres.add(&mut sums.spheres, index, sum);
                    }
                }
                ray
            }
        }
    }
}

/// The loss of the pixels of a group, and the cotangent of their radiance, unless it is zero: what
/// the loss does not care about has no gradient.
#[inline]
fn respond<L: Lanes>(
    loss: &impl PixelLoss,
    tile: &Tile,
    group: &Group<L>,
    radiance: Vec3<L>,
) -> (f64, Option<Vec3<L>>) {
    let radiance = vectors_of_lanes::<L>(radiance);
    let mut sum = 0.0;
    // The lanes that do not count keep a cotangent of zero.
    let mut cotangents = [DVec3::ZERO; MOST_LANES];
    for (lane, ray) in group.rays() {
        let (x, y) = tile.pixel(ray);
        let (value, derivative) = loss.evaluate(x, y, radiance[lane]);
        sum += value;
        cotangents[lane] = derivative;
    }
    let matters = cotangents.iter().any(|&cotangent| cotangent != DVec3::ZERO);
    (sum, matters.then(|| lanes_of_vectors::<L>(&cotangents)))
}

/// What flows back through the views of a tile.
struct Back<L: Lanes> {
    /// By view, in vectors of lanes: the cotangents of the radiance that rays from mirrors bring.
    radiance: Vec<Vec<Vec3<L>>>,
    /// By view and group: the cotangents of the surface points, unless they are zero.
    surfaces: Vec<Vec<Option<Tangent<SurfacePoint<L>>>>>,
    /// By view, in vectors of lanes: the cotangents of the rays from mirrors.
    rays: Vec<Vec<Tangent<Ray<L>>>>,
}

impl<L: Lanes> Default for Back<L> {
    fn default() -> Self {
        Self { radiance: Vec::new(), surfaces: Vec::new(), rays: Vec::new() }
    }
}

impl<L: Lanes> Back<L> {
    /// Nothing flows yet.
    fn start(&mut self, views: &[View<L>]) {
        let Self { radiance, surfaces, rays } = self;
        surfaces.resize_with(views.len(), Vec::new);
        surfaces.iter_mut().for_each(Vec::clear);
        radiance.resize_with(views.len(), Vec::new);
        rays.resize_with(views.len(), Vec::new);
        for (radiance, rays) in radiance.iter_mut().zip(rays).skip(1) {
            radiance.clear();
            radiance.resize(blocks::<L>(), Additive::zero());
            rays.clear();
            rays.resize(blocks::<L>(), Additive::zero());
        }
    }
}
