//! L-BFGS, by `argmin`.

use argmin::core::{IterState, Problem, Solver, State as _};
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::quasinewton::LBFGS;
use serde::{Deserialize, Serialize};

use super::NO_LOWER_LOSS;
use crate::field::Field;
use crate::variable::Flat;
use crate::{ArgminProblem, Coordinates, Evaluation, Objective};

/// Evaluations that a line search may take. A good one takes one or two.
const MOST_EVALUATIONS: u32 = 30;

/// L-BFGS (Liu and Nocedal, Mathematical Programming 45, 1989) with the line search of Moré and
/// Thuente, as `argmin` has them, within bounds by [`Coordinates`].
///
/// An iteration is a whole line search, so it may take several evaluations. The first trial step
/// is one learning rate long altogether; from then on the method finds its own lengths, so no
/// schedule applies. Right for losses that are smooth and exact; where edges or single precision
/// make them rough, the line search soon finds nothing lower, and the run stops with that reason.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Lbfgs {
    /// How many steps it remembers to estimate the curvature from; at least 1.
    pub history: u32,
}

impl Default for Lbfgs {
    /// `history` 7.
    fn default() -> Self {
        Self { history: 7 }
    }
}

impl Lbfgs {
    pub(super) fn fields(&self) -> Vec<Field> {
        vec![("history", self.history.into(), self.history > 0, "at least 1")]
    }
}

type Inner = LBFGS<MoreThuenteLineSearch<Vec<f64>, Vec<f64>, f64>, Vec<f64>, Vec<f64>, f64>;

/// The method at work.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct LbfgsState {
    settings: Lbfgs,
    /// Where it stands, and what losses are multiplied by; nothing before the first step.
    place: Option<Place>,
    #[serde(with = "as_toml")]
    inner: Inner,
    /// Steps that `inner` has taken.
    steps: u64,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct Place {
    /// In coordinates without bounds. They lead to the parameters exactly; the parameters lead
    /// back to them only almost.
    u: Vec<f64>,
    /// One over the length of the gradient at the beginning, so that the first trial step is one
    /// learning rate long.
    scale: f64,
}

/// A step that lowered the loss.
struct Lowered {
    u: Vec<f64>,
    evaluation: Evaluation,
}

impl LbfgsState {
    /// The state of a run that has no memory of steps yet.
    pub fn new(settings: &Lbfgs) -> Self {
        Self { settings: *settings, place: None, inner: fresh(settings), steps: 0 }
    }

    /// Returns `true` if the memory is that of `len` elements.
    pub fn fits(&self, len: usize) -> bool {
        self.place.as_ref().is_none_or(|place| place.u.len() == len)
    }

    /// Moves `x`, where `evaluation` took place, to parameters of a lower loss; the evaluation
    /// there.
    ///
    /// # Errors
    ///
    /// If it finds none, even straight along the gradient; the text says why.
    pub fn step(
        &mut self,
        flat: &Flat,
        x: &mut [f64],
        evaluation: &Evaluation,
        objective: &mut dyn Objective,
    ) -> Result<Evaluation, String> {
        let coordinates = Coordinates::of(flat);
        let start = match self.place.take() {
            Some(place) => (place, evaluation.clone()),
            None => begin(&coordinates, x, objective)?,
        };
        let (place, evaluation) = start;
        let lowered = match self.search(&coordinates, &place, &evaluation, objective) {
            // What was learned elsewhere may be wrong here.
            Err(_) if self.steps > 0 => {
                (self.inner, self.steps) = (fresh(&self.settings), 0);
                self.search(&coordinates, &place, &evaluation, objective)
            }
            result => result,
        };
        let Lowered { u, evaluation } =
            lowered.inspect_err(|_| self.place = Some(place.clone()))?;
        x.copy_from_slice(&coordinates.to_bounded(&u));
        self.place = Some(Place { u, ..place });
        Ok(evaluation)
    }

    /// One iteration of `argmin`.
    fn search(
        &mut self,
        coordinates: &Coordinates,
        place: &Place,
        evaluation: &Evaluation,
        objective: &mut dyn Objective,
    ) -> Result<Lowered, String> {
        let Place { u, scale } = place;
        let mut gradient = coordinates.pull_back(u, &evaluation.gradient);
        gradient.iter_mut().for_each(|g| *g *= scale);
        let mut state =
            IterState::new().param(u.clone()).gradient(gradient).cost(scale * evaluation.loss);
        state.iter = self.steps;
        let problem =
            ArgminProblem::new(objective, coordinates).scaled(*scale).limited(MOST_EVALUATIONS);
        let refusal = problem.refusal();
        // What the method itself cannot go on with.
        let disagree = || "losses and gradients do not agree along its direction".to_owned();
        let failed = || refusal.take().unwrap_or_else(disagree);
        let mut problem = Problem::new(problem);
        let (mut state, _) = self.inner.next_iter(&mut problem, state).map_err(|_| failed())?;
        if state.terminated() {
            return Err(failed());
        }
        let (u, problem) = state.take_param().zip(problem.problem).ok_or_else(failed)?;
        let lowered = Lowered { evaluation: problem.evaluation(&u).map_err(|_| failed())?, u };
        if lowered.evaluation.loss >= evaluation.loss {
            return Err(format!("not even straight along the gradient; {NO_LOWER_LOSS}"));
        }
        self.steps += 1;
        Ok(lowered)
    }
}

/// Where to begin: at `x`, or close to it if it is on a bound.
fn begin(
    coordinates: &Coordinates,
    x: &[f64],
    objective: &mut dyn Objective,
) -> Result<(Place, Evaluation), String> {
    let u = coordinates.from_bounded(x);
    let evaluation = ArgminProblem::new(objective, coordinates)
        .evaluation(&u)
        .map_err(|error| error.to_string())?;
    let gradient = coordinates.pull_back(&u, &evaluation.gradient);
    let length = gradient.iter().fold(0.0, |length: f64, g| length.hypot(*g));
    let scale = 1.0 / length;
    if !(scale * evaluation.loss).is_finite() {
        return Err(format!("the gradient, {length:e}, is out of proportion to the loss"));
    }
    Ok((Place { u, scale }, evaluation))
}

fn fresh(settings: &Lbfgs) -> Inner {
    LBFGS::new(MoreThuenteLineSearch::new(), settings.history as usize)
}

/// As a string of TOML, which knows infinity and "not a number" where JSON does not.
mod as_toml {
    use serde::de::{DeserializeOwned, Deserializer, Error as _};
    use serde::ser::{Error as _, Serializer};
    use serde::{Deserialize, Serialize};

    pub fn serialize<T: Serialize, S: Serializer>(
        value: &T,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&toml::to_string(value).map_err(S::Error::custom)?)
    }

    pub fn deserialize<'de, T: DeserializeOwned, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<T, D::Error> {
        toml::from_str(&String::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}
