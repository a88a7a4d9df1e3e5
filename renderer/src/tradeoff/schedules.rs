//! Whole optimisations, from coarse images to fine ones.

use crate::Error;
use crate::accuracy::GradientMetric;
use crate::optimize::{Optimization, Point, Quiet, Record, Settings, Variable};
use crate::recovery::Recovery;
use crate::scene::Scene;

/// An optimisation with images of one size after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct ScheduleRun {
    /// What each size is the full one divided by, in order.
    pub factors: Vec<u32>,
    /// Seconds since the start, and the distance of the parameters to the true ones then, relative to
    /// the distance at the start; each parameter is measured in its natural scale.
    pub way: Vec<(f64, f64)>,
}

impl ScheduleRun {
    /// The factors in words: `1/4, 1/2, full`.
    pub fn name(&self) -> String {
        let size = |&factor: &u32| match factor {
            1 => "full".to_owned(),
            _ => format!("1/{factor}"),
        };
        self.factors.iter().map(size).collect::<Vec<_>>().join(", ")
    }
}

/// The schedules that are compared.
const SCHEDULES: [&[u32]; 4] = [&[1], &[2, 1], &[4, 2, 1], &[4, 1]];

/// Optimises with every schedule whose sizes divide the image's, all with as many steps: so many
/// in total as the settings allow, the same number at each size. Nothing if the true parameters are
/// not known.
///
/// The target of a coarse image is the mean of the pixels that become one, so its minimum lies a
/// little elsewhere; that is why the last size is the full one.
///
/// # Errors
///
/// If the optimisation does not start: a number in the settings is out of its range, or the loss is
/// not finite.
pub fn measure_schedules(
    recovery: &Recovery<'_>,
    settings: &Settings,
) -> Result<Vec<ScheduleRun>, Error> {
    let Some(distance) = Distance::new(recovery) else { return Ok(Vec::new()) };
    let scene = recovery.scene();
    let divides =
        |&factor: &u32| scene.width.is_multiple_of(factor) && scene.height.is_multiple_of(factor);
    let possible = SCHEDULES.into_iter().filter(|factors| factors.iter().all(divides));
    possible.map(|factors| run(recovery, settings, &distance, factors)).collect()
}

fn run(
    recovery: &Recovery<'_>,
    settings: &Settings,
    distance: &Distance,
    factors: &[u32],
) -> Result<ScheduleRun, Error> {
    let settings =
        Settings { iterations: settings.iterations / factors.len() as u64, ..settings.clone() };
    let mut variables = recovery.variables().to_vec();
    let mut way = Vec::new();
    let mut seconds = 0.0;
    for &factor in factors {
        let scene = recovery.scene();
        let (width, height) = (scene.width / factor, scene.height / factor);
        let coarse_scene = Scene { width, height, ..scene.clone() };
        let coarse = recovery.coarser(&coarse_scene);
        let optimization = Optimization::start(&variables, &settings)?;
        let outcome = optimization.run(coarse.objective().as_mut(), &mut Quiet)?;
        let at = |point: &Point| {
            let record = outcome.history.iter().find(|record| record.iteration == point.iteration);
            seconds + record.map_or(0.0, |record: &Record| record.seconds)
        };
        way.extend(outcome.trajectory.iter().map(|point| (at(point), distance.of(&point.x))));
        seconds += outcome.seconds;
        take_over(&mut variables, &outcome.best.x);
    }
    Ok(ScheduleRun { factors: factors.to_vec(), way })
}

/// Starts variables where an optimisation ended.
fn take_over(variables: &mut [Variable], mut x: &[f64]) {
    for variable in variables {
        let (mine, rest) = x.split_at(variable.initial.len());
        variable.initial.copy_from_slice(mine);
        x = rest;
    }
}

/// How far parameters are from the true ones.
struct Distance {
    metric: GradientMetric,
    truth: Vec<f64>,
    initial: f64,
}

impl Distance {
    /// Nothing if the truth is not known, or is where the optimisation starts.
    fn new(recovery: &Recovery<'_>) -> Option<Self> {
        let truth: Option<Vec<_>> =
            recovery.variables().iter().map(|variable| variable.target.clone()).collect();
        let metric = GradientMetric::new(recovery.scene(), recovery.ids());
        let mut distance = Self { metric, truth: truth?.concat(), initial: 1.0 };
        distance.initial = distance.of(&recovery.initial());
        (distance.initial > 0.0).then_some(distance)
    }

    fn of(&self, x: &[f64]) -> f64 {
        let pairs = x.iter().zip(&self.truth).enumerate();
        let terms = pairs.map(|(i, (x, truth))| ((x - truth) / self.metric.scale(i)).powi(2));
        terms.sum::<f64>().sqrt() / self.initial
    }
}
