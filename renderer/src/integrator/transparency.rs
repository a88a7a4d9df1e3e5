//! Transparent surfaces: what they cover of what lies behind them. What they take away of the light that
//! goes through them is in [`crossings`](super::crossings).
//!
//! A surface of opacity `d` shows `d` of its own radiance and `1 - d` of what lies straight behind it.
//! The ray goes on behind it as one that a mirror sends on does, in the same [views](super::view::View)
//! and to the same depth; a material is a mirror, or transparent, or neither, so that every ray goes on
//! in one direction at most. Turned down: a ray in both directions, which makes a tree of every path.

use ad::lanes::Lanes;
use ad::{Additive, Vec3, select};

use super::prepared::Prepared;
use super::sharing::Sharing;
use super::textures::Textured;
use crate::kernels::surface::seen_through;
use crate::kernels::texture::varied_opacity;
use crate::precision::{splat, sum_of_lanes};

/// What a group with transparent surfaces covers.
#[derive(Clone, Copy)]
pub(super) struct Cover<L: Lanes> {
    /// A bit for each lane whose surface is transparent.
    lanes: u32,
    /// That of the materials; 1 in the other lanes.
    plain: L,
    /// The colours of the textures that vary it, if any.
    varied: Option<Vec3<L>>,
    opacity: L,
}

/// The cotangents of what is seen through a group.
#[derive(Clone, Copy)]
pub(super) struct PulledCover<L: Lanes> {
    /// Of the opacities of the materials.
    pub plain: L,
    /// Of the colours that vary them.
    pub varied: Option<Vec3<L>>,
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
        let (plain, varied) = match self.varied {
            None => (opacity, None),
            Some(color) => {
                let (_, pullback) = varied_opacity::vjp::<L>(self.plain, color);
                let (plain, color) = pullback(opacity);
                (plain, Some(color))
            }
        };
        (select(transparent, to_own, cotangent), PulledCover { plain, varied, behind })
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
    pub(super) fn cover(
        &self,
        materials: &Sharing,
        textured: Option<&Textured<L>>,
    ) -> Option<Cover<L>> {
        let lanes = self.transparent_among(materials);
        if lanes == 0 {
            return None;
        }
        let plain =
            materials.gather::<L, L>(|material| match self.scene.materials[material].opacity {
                Some(index) => splat::<L>(self.opacities[index as usize]),
                None => L::ONE,
            });
        let varied = textured.and_then(Textured::of_opacity);
        let opacity = varied.map_or(plain, |color| varied_opacity::<L>(plain, color));
        Some(Cover { lanes, plain, varied, opacity })
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
