//! How the learning rate changes in the course of a run.

use std::f64::consts::PI;

use renderer_core::Error;
use serde::{Deserialize, Serialize};

use super::Fingerprint;
use super::field::{Field, check_fields};

/// The factor by which all learning rates are multiplied, over the iterations of a run.
///
/// A schedule spans the whole run, whatever its number of iterations is, so that one that suits a
/// short run suits a long one. Its other side: more iterations are another run from the first step
/// on, so a run with a schedule that is not constant cannot be resumed with more of them.
///
/// Serialises to a table with the name as `type`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Schedule {
    /// 1 throughout.
    #[default]
    Constant,
    /// Falls by the same part in every step.
    Exponential(Exponential),
    /// Falls at once, a few times.
    Step(Step),
    /// Falls slowly, then fast, then slowly.
    Cosine(Cosine),
}

/// `end ^ t`, where `t` goes from 0 to 1 in the course of the run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Exponential {
    /// What the factor has come to at the end, in `(0, 1]`.
    pub end: f64,
}

impl Default for Exponential {
    /// `end` 0.01.
    fn default() -> Self {
        Self { end: 0.01 }
    }
}

/// The run in equal stages.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Step {
    /// How many; at least 1.
    pub stages: u32,
    /// The factor of a stage over that of the one before, in `(0, 1]`.
    pub decay: f64,
}

impl Default for Step {
    /// 3 stages, `decay` 0.1.
    fn default() -> Self {
        Self { stages: 3, decay: 0.1 }
    }
}

/// `end + (1 - end) (1 + cos(pi t)) / 2`, where `t` goes from 0 to 1 in the course of the run
/// (Loshchilov and Hutter, "SGDR: stochastic gradient descent with warm restarts", ICLR 2017,
/// without restarts).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Cosine {
    /// What the factor comes to at the end, in `[0, 1]`; 0 by default, which no step has.
    pub end: f64,
}

impl Schedule {
    /// Every schedule with its default numbers.
    pub fn all() -> [Self; 4] {
        [
            Self::Constant,
            Self::Exponential(Exponential::default()),
            Self::Step(Step::default()),
            Self::Cosine(Cosine::default()),
        ]
    }

    /// The schedule `name`, with its default numbers.
    ///
    /// # Errors
    ///
    /// If there is none of this name; the text says which there are.
    pub fn named(name: &str) -> Result<Self, String> {
        let found = Self::all().into_iter().find(|schedule| schedule.name() == name);
        found.ok_or_else(|| {
            format!("no schedule `{name}`; there is {}", Self::all().map(|s| s.name()).join(", "))
        })
    }

    /// What files and the command line call it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Exponential(_) => "exponential",
            Self::Step(_) => "step",
            Self::Cosine(_) => "cosine",
        }
    }

    /// The factor of the step that follows iteration `iteration` of at most `iterations`.
    pub fn factor(&self, iteration: u64, iterations: u64) -> f64 {
        let t = iteration as f64 / iterations.max(1) as f64;
        match *self {
            Self::Constant => 1.0,
            Self::Exponential(Exponential { end }) => end.powf(t),
            Self::Step(Step { stages, decay }) => decay.powf((t * f64::from(stages)).floor()),
            Self::Cosine(Cosine { end }) => end + (1.0 - end) * 0.5 * (1.0 + (PI * t).cos()),
        }
    }

    /// # Errors
    ///
    /// If a number is out of its range; the place is its field in a scene file.
    pub fn check(&self) -> Result<(), Error> {
        check_fields("optimize.schedule", self.fields())
    }

    /// Its numbers.
    pub(super) fn fields(&self) -> Vec<Field> {
        let above_zero = "above 0 and at most 1";
        let part = |value: f64| value > 0.0 && value <= 1.0;
        match *self {
            Self::Constant => vec![],
            Self::Exponential(Exponential { end }) => vec![("end", end, part(end), above_zero)],
            Self::Step(Step { stages, decay }) => vec![
                ("stages", stages.into(), stages > 0, "at least 1"),
                ("decay", decay, part(decay), above_zero),
            ],
            Self::Cosine(Cosine { end }) => {
                vec![("end", end, (0.0..=1.0).contains(&end), "from 0 to 1")]
            }
        }
    }

    /// Adds what tells it from other schedules to a fingerprint.
    pub(super) fn mark(&self, fingerprint: Fingerprint) -> Fingerprint {
        let values: Vec<f64> = self.fields().iter().map(|(_, value, ..)| *value).collect();
        fingerprint.text(self.name()).numbers(&values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factors(schedule: Schedule, iterations: u64) -> Vec<f64> {
        (0..=iterations).map(|k| schedule.factor(k, iterations)).collect()
    }

    fn close(a: &[f64], b: &[f64]) {
        assert_eq!(a.len(), b.len());
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12), "{a:?} {b:?}");
    }

    #[test]
    fn schedules_follow_their_formulas() {
        close(&factors(Schedule::Constant, 2), &[1.0, 1.0, 1.0]);
        let exponential = Schedule::Exponential(Exponential { end: 1e-4 });
        close(&factors(exponential, 4), &[1.0, 0.1, 0.01, 1e-3, 1e-4]);
        let step = Schedule::Step(Step { stages: 2, decay: 0.5 });
        close(&factors(step, 4), &[1.0, 1.0, 0.5, 0.5, 0.25]);
        let cosine = Schedule::Cosine(Cosine { end: 0.5 });
        let half = f64::sqrt(0.5);
        close(&factors(cosine, 4), &[1.0, 0.75 + 0.25 * half, 0.75, 0.75 - 0.25 * half, 0.5]);
    }

    #[test]
    fn every_factor_is_a_part() {
        for schedule in Schedule::all() {
            for iterations in [0, 1, 3, 1000, u64::MAX] {
                for iteration in
                    [0, 1, 2, 999, u64::MAX - 1].into_iter().filter(|k| *k <= iterations)
                {
                    let factor = schedule.factor(iteration, iterations);
                    assert!((0.0..=1.0).contains(&factor), "{schedule:?} {iteration} {iterations}");
                }
            }
        }
    }

    #[test]
    fn names_lead_to_schedules() {
        for schedule in Schedule::all() {
            assert_eq!(Schedule::named(schedule.name()), Ok(schedule));
            let table = serde_json::json!({ "type": schedule.name() });
            assert_eq!(serde_json::from_value::<Schedule>(table).unwrap(), schedule);
        }
        assert_eq!(
            Schedule::named("linear"),
            Err("no schedule `linear`; there is constant, exponential, step, cosine".to_owned())
        );
    }
}
