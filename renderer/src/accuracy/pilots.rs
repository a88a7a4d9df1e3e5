//! What settings are worth and what they cost, tried on the scene.

use ad::lanes::f32x16;

use super::{GradientMetric, Pilot, Setting};
use crate::arithmetic::{Arithmetic, Precision};
use crate::integrator::{Prepared, Wanted, paths};
use crate::recovery::Recovery;

/// What a gradient costs in double precision, in single precision being 1 (measured on the teapot of
/// the README).
const WORK_IN_DOUBLE_PRECISION: f64 = 1.3;

/// Tries the settings: each precision with every number of mirrors up to the scene's.
pub(super) fn pilots(recovery: &Recovery<'_>, metric: &GradientMetric) -> Vec<Pilot> {
    let counts = Counts::new(recovery);
    let bounces = 0..=counts.most_bounces();
    let gradient = |setting: &Setting| {
        setting.apply(recovery).objective().evaluate(&recovery.initial()).gradient
    };
    let exact = |arithmetic| Setting { arithmetic, bounces: *bounces.end() };
    let reference = gradient(&exact(Arithmetic::F64x8));
    // Single numbers go through other functions than lanes: what they differ by is rounding.
    let rounding = metric.error(&gradient(&exact(Arithmetic::F64)), &reference);
    let mut pilots = Vec::new();
    for precision in [Precision::F32, Precision::F64] {
        let arithmetic = Arithmetic::fastest(precision);
        for bounces in bounces.clone() {
            let setting = Setting { arithmetic, bounces };
            let error = metric.error(&gradient(&setting), &reference).max(rounding);
            pilots.push(Pilot { setting, error, work: counts.of(&setting) });
        }
    }
    pilots
}

/// What a ray that a mirror sends on costs: it goes through the tree by itself, where those of the
/// camera go in packets (measured on `docs/tradeoff/glossy.toml`, a shaded point with its light being
/// 2).
const WORK_OF_MIRRORED_RAY: f64 = 4.0;

/// The work that light brings which meets so many mirrors, by that number: rays, shaded points, and
/// their lights.
struct Counts(Vec<f64>);

impl Counts {
    fn new(recovery: &Recovery<'_>) -> Self {
        let scene = recovery.scene();
        let prepared = Prepared::<f32x16>::with_settings(scene, *recovery.render_settings());
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

    fn most_bounces(&self) -> u32 {
        self.0.len() as u32 - 1
    }

    fn of(&self, setting: &Setting) -> f64 {
        let factor = match setting.arithmetic.precision() {
            Precision::F32 => 1.0,
            Precision::F64 => WORK_IN_DOUBLE_PRECISION,
        };
        factor * self.0.iter().take(setting.bounces as usize + 1).sum::<f64>()
    }
}
