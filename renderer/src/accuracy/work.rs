//! What gradients cost, counted on the scene.

use super::Setting;
use crate::arithmetic::Precision;
use crate::recovery::Recovery;
use crate::render::Renderer;
use crate::settings::{Sampling, Settings};

/// What a gradient costs in double precision, in single precision being 1 (measured on the teapot of
/// the README).
const WORK_IN_DOUBLE_PRECISION: f64 = 1.3;

/// What a ray that a mirror sends on costs: it goes through the tree by itself, where those of the
/// camera go in packets (measured on `docs/tradeoff/glossy.toml`, a shaded point with its light being
/// 2).
const WORK_OF_MIRRORED_RAY: f64 = 4.0;

/// The work that one ray through each pixel brings, by the number of mirrors that its light meets:
/// rays, shaded points, and their lights.
pub(super) struct Work(Vec<f64>);

impl Work {
    pub fn new(recovery: &Recovery<'_>) -> Self {
        let scene = recovery.scene();
        let settings = Settings { sampling: Sampling::Center, ..*recovery.render_settings() };
        let renderer = Renderer::unchecked(scene, &settings);
        let lights = scene.lights.len() as f64;
        let of_depth = |(depth, (rays, hits)): (usize, (u64, u64))| {
            let of_ray = if depth == 0 { 1.0 } else { WORK_OF_MIRRORED_RAY };
            of_ray * rays as f64 + (1.0 + lights) * hits as f64
        };
        let depths = renderer.rays_by_depth(scene, recovery.ids());
        // Depths at which nothing is hit show nothing more.
        let deepest = depths.iter().rposition(|&(_, hits)| hits > 0).unwrap_or(0);
        let work = depths.into_iter().take(deepest + 1).enumerate().map(of_depth).collect();
        Self(work)
    }

    /// The number of mirrors on a path beyond which nothing is seen.
    pub fn most_bounces(&self) -> u32 {
        self.0.len() as u32 - 1
    }

    /// What a gradient costs in a setting.
    pub fn of(&self, setting: &Setting) -> f64 {
        let factor = match setting.arithmetic.precision() {
            Precision::F32 => 1.0,
            Precision::F64 => WORK_IN_DOUBLE_PRECISION,
        };
        let of_one_ray: f64 = self.0.iter().take(setting.bounces as usize + 1).sum();
        factor * f64::from(setting.sampling.count()) * of_one_ray
    }
}
