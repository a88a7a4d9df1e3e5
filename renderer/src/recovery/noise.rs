//! What makes gradients noisy, for people.

use super::Recovery;
use crate::scene::{Integrator, MaterialObject};
use crate::transport::material::Bsdf;

/// The roughness below which the derivative by what moves a metal takes thousands of paths through each pixel: at 0.2 it
/// is off by 1.9 times its norm with 64 paths and by 0.4 with 1,024, at 0.1 by 9 and 2 times.
const SMOOTH: f64 = 0.2;

impl Recovery<'_> {
    /// A warning where light takes all paths and something moves, for each material whose facets are so narrow that the
    /// derivative, for which scattered directions stay, is mostly noise.
    pub fn noisy_materials(&self) -> Vec<String> {
        let scene = &self.scene;
        let moves = self.ids.iter().any(|&id| scene.moves_edges(id));
        if !moves || scene.integrator == Integrator::Direct {
            return Vec::new();
        }
        let materials = scene.materials().iter();
        let smooth = materials.filter(|material| {
            material.bsdf == Bsdf::MetallicRoughness && material.values.roughness < SMOOTH
        });
        let warning = |material: &MaterialObject| {
            let (name, roughness) = (&material.name, material.values.roughness);
            format!(
                "material.{name}: derivatives by what moves are noisy where paths meet facets of the roughness {roughness}: \
                 {SMOOTH} or more takes fewer paths, a `mirror` of `blinn_phong` none"
            )
        };
        smooth.map(warning).collect()
    }
}
