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
            pilots.push(Pilot { setting, error, work: counts.work(&setting) });
        }
    }
    pilots
}

/// How many shaded points, and shadow rays of them, light that meets so many mirrors brings, at most.
struct Counts(Vec<f64>);

impl Counts {
    fn new(recovery: &Recovery<'_>) -> Self {
        let scene = recovery.scene();
        let prepared = Prepared::<f32x16>::with_settings(scene, *recovery.render_settings());
        let lights = scene.light_names.len() + scene.custom_lights.len();
        let mut points = vec![0.0];
        for path in paths(&prepared, Wanted::by(recovery.ids())) {
            for depth in 0..path.meetings.len() {
                if points.len() <= depth {
                    points.push(0.0);
                }
                points[depth] += 1.0 + lights as f64;
            }
        }
        // Every pixel has a ray, whatever it meets.
        points[0] += f64::from(scene.width) * f64::from(scene.height);
        Self(points)
    }

    /// More mirrors show nothing more.
    fn most_bounces(&self) -> u32 {
        self.0.len() as u32 - 1
    }

    fn work(&self, setting: &Setting) -> f64 {
        let factor = match setting.arithmetic.precision() {
            Precision::F32 => 1.0,
            Precision::F64 => WORK_IN_DOUBLE_PRECISION,
        };
        factor * self.0.iter().take(setting.bounces as usize + 1).sum::<f64>()
    }
}
