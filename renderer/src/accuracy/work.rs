//! What gradients cost, counted on the scene.

use ad::lanes::f32x16;

use super::Setting;
use crate::arithmetic::Precision;
use crate::integrator::{Prepared, RenderSettings, Sampling, Wanted, paths};
use crate::recovery::Recovery;

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
        let settings = RenderSettings { sampling: Sampling::Center, ..*recovery.render_settings() };
        let prepared = Prepared::<f32x16>::with_settings(scene, settings);
        let lights = scene.light_names.len() + scene.custom_lights.len();
        let paths = paths(&prepared, Wanted::by(recovery.ids()));
        // More mirrors show nothing more.
        let deepest = paths.iter().map(|path| path.meetings.len()).max().unwrap_or(0);
        let mut work = vec![0.0; deepest.max(1)];
        for path in paths {
            for (depth, work) in work.iter_mut().enumerate() {
                if depth < path.rays {
                    *work += if depth == 0 { 1.0 } else { WORK_OF_MIRRORED_RAY };
                }
                if depth < path.meetings.len() {
                    *work += 1.0 + lights as f64;
                }
            }
        }
        Self(work)
    }

    /// As many mirrors as show anything.
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
