//! What mirrors show, and what is behind transparent surfaces.

use std::mem;

use ad::lanes::Lanes;
use ad::vector::Vector3;
use ad::{Additive, Tangent, Vec3, select};

use super::gradient::Wanted;
use super::prepared::Prepared;
use super::settings::Pass;
use super::shade::Shaded;
use super::sharing::Sharing;
use super::view::{Group, Sample, View, repeated};
use crate::acceleration::{PACKET_RAYS, PacketHits, rays};
use crate::counts::count;
use crate::kernels::camera::{Ray, RayTangent};
use crate::kernels::surface::{SurfacePoint, mirrored_ray, straight_ray};
use crate::precision::vectors_of_lanes;

/// Whether what is black is looked at: the derivative by what a mirror reflects, or by what a light
/// sends, does not vanish where these do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Dark {
    /// Every opaque material is taken for a mirror.
    pub mirrors: bool,
    /// Lights that send nothing are followed.
    pub lights: bool,
}

impl Dark {
    /// What a gradient by the wanted parameters depends on.
    pub fn of_gradient(wanted: Wanted<'_>, pass: Pass) -> Self {
        Self { mirrors: wanted.mirrors && pass == Pass::Radiance, lights: wanted.lights() }
    }
}

/// What the camera sees in a tile: directly, by one mirror or behind one transparent surface, by two,
/// and so on. A pixel has the same ray in every view.
pub(super) struct Sight<L: Lanes> {
    /// None before the first tile, so that an empty sight takes no memory.
    views: Vec<View<L>>,
    /// How many of the views are of this tile.
    depth: usize,
}

impl<L: Lanes> Sight<L> {
    /// The views, from the camera on.
    pub fn views(&self) -> &[View<L>] {
        &self.views[..self.depth]
    }
}

/// To be filled by [`Prepared::see`].
impl<L: Lanes> Default for Sight<L> {
    fn default() -> Self {
        Self { views: Vec::new(), depth: 0 }
    }
}

impl<L: Lanes> Prepared<'_, L> {
    /// Looks through one point of every pixel of a tile and finds what lights reach; then the same
    /// in what mirrors show, and behind transparent surfaces.
    pub(super) fn see(&self, sample: &Sample<'_>, dark: Dark, sight: &mut Sight<L>) {
        let Sight { views, depth } = sight;
        if views.is_empty() {
            views.push(View::default());
        }
        self.look(sample, &mut views[0]);
        self.light_up(dark, &mut views[0]);
        *depth = 1;
        if !dark.mirrors && !self.has_mirrors && !self.has_transparency {
            return;
        }
        while *depth <= self.bounces as usize {
            if views.len() == *depth {
                views.push(View::default());
            }
            let (before, after) = views.split_at_mut(*depth);
            let beyond = &mut after[0];
            if !self.look_beyond(&before[*depth - 1], dark, beyond) {
                break;
            }
            self.light_up(dark, beyond);
            *depth += 1;
        }
        for depth in (1..*depth).rev() {
            let (views, deeper) = views[..sight.depth].split_at_mut(depth + 1);
            self.shade(&mut views[depth], deeper.first());
        }
    }

    /// Traces what the mirrors in a view show and what is behind its transparent surfaces. Whether
    /// there are any.
    fn look_beyond(&self, from: &View<L>, dark: Dark, to: &mut View<L>) -> bool {
        let mut sent_on = mem::take(&mut to.rays);
        sent_on.clear();
        sent_on
            .resize(blocks::<L>(), Ray { origin: Additive::zero(), direction: Additive::zero() });
        to.hits = PacketHits::NONE;
        let mut sent = 0;
        for group in &from.groups {
            let materials = self.materials(group);
            let transparent = self.transparent_among(&materials);
            let mirrors = self.mirrors_among(&materials, dark) & !transparent;
            let lanes = (mirrors | transparent) & group.alive;
            if lanes == 0 {
                continue;
            }
            sent |= u64::from(lanes) << group.first;
            count(|counts| &counts.mirrored_rays, u64::from(lanes.count_ones()));
            let ray = next_ray(group, transparent);
            let block = &mut sent_on[group.first / L::COUNT];
            *block = select(L::mask_from_bits(lanes), ray, *block);
            let origins = group.origins_behind(transparent);
            let directions = vectors_of_lanes::<L>(ray.direction);
            for lane in rays(lanes.into()) {
                let ray = group.first + lane;
                let start = group.start(from, ray);
                let (origin, direction) = (origins[lane].as_vec3(), directions[lane].as_vec3());
                let hit = self.acceleration.nearest_but(start, origin, direction);
                if let Some(hit) = self.nearer_custom_shape(origin, direction, hit) {
                    to.hits.set(ray, hit);
                }
            }
        }
        self.group(to, sent, |first, alive| {
            let Ray { origin, direction } = sent_on[first / L::COUNT];
            let repeated = |v: Vec3<L>| {
                let [x, y, z] = [v.x(), v.y(), v.z()].map(|x| repeated(x, alive));
                Vector3::new(x, y, z)
            };
            Ray { origin: repeated(origin), direction: repeated(direction) }
        });
        to.rays = sent_on;
        sent != 0
    }

    /// Finds the radiance that the rays of a view bring, from that of the rays that go on.
    fn shade(&self, view: &mut View<L>, beyond: Option<&View<L>>) {
        let mut radiance = mem::take(&mut view.radiance);
        radiance.clear();
        radiance.resize(blocks::<L>(), Additive::zero());
        for group in &view.groups {
            let materials = self.materials(group);
            let appearance = self.appearance(group, &materials);
            let shaded = Shaded::new(self, group, &appearance, view, beyond);
            let block = &mut radiance[group.first / L::COUNT];
            *block = select(L::mask_from_bits(group.alive), shaded.radiance(), *block);
        }
        view.radiance = radiance;
    }

    /// A bit for each lane whose material is a mirror, or taken for one.
    fn mirrors_among(&self, materials: &Sharing, dark: Dark) -> u32 {
        let is_mirror = |material: usize| dark.mirrors || self.is_mirror(material);
        let mirrors = materials.iter().filter(|&(material, _)| is_mirror(material));
        mirrors.fold(0, |bits, (_, lanes)| bits | lanes)
    }
}

/// The ray that goes on from each lane of a group: straight from transparent surfaces, mirrored from
/// the others.
pub(super) fn next_ray<L: Lanes>(group: &Group<L>, transparent: u32) -> Ray<L> {
    let mirrored = mirrored_ray::<L>(group.surface);
    match transparent {
        0 => mirrored,
        _ => select(L::mask_from_bits(transparent), straight_ray::<L>(group.surface), mirrored),
    }
}

/// Pulls the cotangent of [`next_ray`] back to the surface.
pub(super) fn pull_next_ray<L: Lanes>(
    group: &Group<L>,
    transparent: u32,
    cotangent: Tangent<Ray<L>>,
) -> Tangent<SurfacePoint<L>> {
    let lanes = |lanes: u32| {
        let mask = L::mask_from_bits(lanes & group.alive);
        let RayTangent { origin, direction } = cotangent;
        RayTangent {
            origin: select(mask, origin, Additive::zero()),
            direction: select(mask, direction, Additive::zero()),
        }
    };
    let (_, pullback) = mirrored_ray::vjp::<L>(group.surface);
    let mut surface = pullback(lanes(!transparent));
    if transparent != 0 {
        let (_, pullback) = straight_ray::vjp::<L>(group.surface);
        surface.accumulate(pullback(lanes(transparent)));
    }
    surface
}

/// How many vectors of lanes the rays of a packet make.
pub(super) fn blocks<L: Lanes>() -> usize {
    PACKET_RAYS / L::COUNT
}
