//! Transparent surfaces: what they cover of what lies behind them, and what they take away of the light
//! that goes through them.
//!
//! A surface of opacity `d` shows `d` of its own radiance and `1 - d` of what lies straight behind it.
//! The ray goes on behind it as one that a mirror sends on does, in the same [views](super::view::View)
//! and to the same depth; a material is a mirror, or transparent, or neither, so that every ray goes on
//! in one direction at most. Turned down: a ray in both directions, which makes a tree of every path. Of
//! light, every transparent surface on the way leaves `1 - d`; what shadow rays meet is looked for a
//! second time, one by one, where the tree said that there is something. So a scene without transparent
//! materials is rendered as if there were none. How far light goes through is not limited by the depth.

use ad::lanes::Lanes;
use ad::{Additive, Real, Vec3, select};

use super::mirrors::{Dark, blocks};
use super::prepared::Prepared;
use super::shadows::Lit;
use super::sharing::Sharing;
use super::view::{Group, View};
use crate::acceleration::PACKET_RAYS;
use crate::counts::count;
use crate::kernels::surface::seen_through;
use crate::precision::{numbers_of_lanes, splat, sum_of_lanes, vectors_of_lanes};
use crate::scene::Light;

/// What a group with transparent surfaces covers.
#[derive(Clone, Copy)]
pub(super) struct Cover<L: Lanes> {
    /// A bit for each lane whose surface is transparent.
    lanes: u32,
    /// 1 in the other lanes.
    opacity: L,
}

/// The cotangents of what is seen through a group.
#[derive(Clone, Copy)]
pub(super) struct PulledCover<L: Lanes> {
    pub opacity: L,
    /// Of the radiance from behind.
    pub behind: Vec3<L>,
}

impl<L: Lanes> Cover<L> {
    /// The radiance of a group that shows `own` and what is `behind` it.
    pub fn seen(&self, own: Vec3<L>, behind: Vec3<L>) -> Vec3<L> {
        let seen = seen_through::<L>(self.opacity, own, behind);
        select(L::mask_from_bits(self.lanes), seen, own)
    }

    /// Pulls the cotangent of [`seen`](Self::seen) back: first that of `own`.
    pub fn pull_back(
        &self,
        own: Vec3<L>,
        behind: Vec3<L>,
        cotangent: Vec3<L>,
    ) -> (Vec3<L>, PulledCover<L>) {
        let transparent = L::mask_from_bits(self.lanes);
        let through = select(transparent, cotangent, Additive::zero());
        let (_, pullback) = seen_through::vjp::<L>(self.opacity, own, behind);
        let (opacity, to_own, behind) = pullback(through);
        (select(transparent, to_own, cotangent), PulledCover { opacity, behind })
    }
}

/// What transparent surfaces leave of a light, by ray of a view.
pub(super) struct Passed<L: Lanes> {
    /// The part that is left, in vectors of lanes; 1 where nothing is in the way.
    weights: Vec<L>,
    /// A ray, and the index of an opacity that its light goes through; ray by ray.
    crossings: Vec<(usize, u32)>,
}

impl<L: Lanes> Passed<L> {
    fn nothing() -> Self {
        Self { weights: vec![L::ONE; blocks::<L>()], crossings: Vec::new() }
    }

    /// What is left in the lanes of a group.
    pub fn weight(&self, group: &Group<L>) -> L {
        self.weights[group.first / L::COUNT]
    }

    /// The opacities that the light of a ray goes through.
    pub fn crossed(&self, ray: usize) -> impl Iterator<Item = usize> {
        self.crossings.iter().filter(move |(of, _)| *of == ray).map(|&(_, index)| index as usize)
    }

    /// Whether the light of a ray of a group goes through anything.
    pub fn concerns(&self, group: &Group<L>) -> bool {
        self.crossings.iter().any(|(ray, _)| group.rays().any(|(_, of_group)| of_group == *ray))
    }
}

impl<L: Lanes> Prepared<'_, L> {
    /// The lanes whose materials are transparent.
    pub(super) fn transparent_among(&self, materials: &Sharing) -> u32 {
        if !self.has_transparency {
            return 0;
        }
        let transparent = materials.iter().filter(|&(material, _)| !self.is_opaque(material));
        transparent.fold(0, |bits, (_, lanes)| bits | lanes)
    }

    /// What materials cover, if one of them is transparent.
    pub(super) fn cover(&self, materials: &Sharing) -> Option<Cover<L>> {
        let lanes = self.transparent_among(materials);
        let opacity = |material: usize| match self.scene.materials[material].opacity {
            Some(index) => splat::<L>(self.opacities[index as usize]),
            None => L::ONE,
        };
        (lanes != 0).then(|| Cover { lanes, opacity: materials.gather::<L, _>(opacity) })
    }

    /// Adds to what lights reach of a view what they reach through transparent surfaces.
    pub(super) fn light_through(&self, dark: Dark, view: &mut View<L>) {
        view.passed.clear();
        if !self.has_transparency {
            return;
        }
        for index in 0..view.lit.len() {
            let is_black = self.lights.get(index).is_some_and(Light::is_black);
            let mut reached = view.lit[index];
            let mut passed = Passed::nothing();
            if !is_black || dark.lights {
                self.light_through_to(index, view, &mut reached, &mut passed);
            }
            view.lit[index] = reached;
            view.passed.push(passed);
        }
    }

    /// [`light_through`](Self::light_through) of one light.
    fn light_through_to(
        &self,
        light: usize,
        view: &View<L>,
        reached: &mut Lit,
        passed: &mut Passed<L>,
    ) {
        let mut left = [1.0; PACKET_RAYS];
        for group in &view.groups {
            let points = vectors_of_lanes::<L>(group.surface.point);
            let normals = vectors_of_lanes::<L>(group.surface.normal);
            let origins = group.origins();
            for (lane, ray) in group.rays().filter(|&(_, ray)| !view.lit[light].reaches(ray)) {
                let (direction, distance) = self.towards_light(light, points[lane]);
                if normals[lane].dot(direction) <= 0.0 {
                    continue;
                }
                count(|counts| &counts.shadow_rays, 1);
                let from = group.start(view, ray);
                let (origin, direction) = (origins[lane].as_vec3(), direction.as_vec3());
                let Some(crossed) = self.crossed(origin, direction, distance as f32, from) else {
                    continue;
                };
                let weights = crossed.iter().map(|&index| 1.0 - self.opacity_of(index as usize));
                left[ray] = weights.product();
                passed.crossings.extend(crossed.iter().map(|&opacity| (ray, opacity)));
                reached.add(ray);
            }
        }
        for (block, weights) in passed.weights.iter_mut().enumerate() {
            let weight = |lane: usize| L::Element::from_f64(left[block * L::COUNT + lane]);
            *weights = L::from_lanes(weight);
        }
    }

    /// The opacities of what a ray meets before `limit`, but for `from`; nothing if any of it is opaque.
    fn crossed(
        &self,
        origin: glam::Vec3,
        direction: glam::Vec3,
        limit: f32,
        from: Option<u32>,
    ) -> Option<Vec<u32>> {
        if self.is_behind_custom_shape(origin, direction, limit) {
            return None;
        }
        let (mut crossed, mut is_blocked) = (Vec::new(), false);
        self.acceleration.visit_met(origin, direction, limit, from, |primitive| {
            let material = self.material_of[primitive as usize] as usize;
            match self.scene.materials[material].opacity {
                Some(opacity) => crossed.push(opacity),
                None => is_blocked = true,
            }
            !is_blocked
        });
        (!is_blocked).then_some(crossed)
    }

    fn opacity_of(&self, index: usize) -> f64 {
        self.parameters.opacities[index]
    }

    /// Pulls the cotangent of what is left of the light of a group back to the opacities that it goes
    /// through.
    pub(super) fn pull_passed(
        &self,
        group: &Group<L>,
        passed: &Passed<L>,
        cotangent: L,
        to_opacities: &mut [f64],
    ) {
        let cotangents = numbers_of_lanes(cotangent);
        for (lane, ray) in group.rays() {
            for (i, of) in passed.crossed(ray).enumerate() {
                let others = passed.crossed(ray).enumerate().filter(|&(j, _)| j != i);
                let left: f64 = others.map(|(_, other)| 1.0 - self.opacity_of(other)).product();
                to_opacities[of] -= cotangents[lane] * left;
            }
        }
    }

    /// Adds the cotangents of the opacities of a group, by material.
    pub(super) fn pull_opacity(&self, materials: &Sharing, cotangent: L, to_opacities: &mut [f64]) {
        for (material, lanes) in materials.iter() {
            if let Some(index) = self.scene.materials[material].opacity {
                let sum = sum_of_lanes(cotangent, L::mask_from_bits(lanes));
                to_opacities[index as usize] += sum;
            }
        }
    }

    /// Whether a material is not transparent.
    pub(super) fn is_opaque(&self, material: usize) -> bool {
        self.scene.materials[material].opacity.is_none()
    }
}
