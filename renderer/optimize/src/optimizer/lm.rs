//! Levenberg-Marquardt.

use rsparse::data::Sprs;
use serde::{Deserialize, Serialize};

use super::divisor;
use crate::field::Field;
use crate::variable::Flat;
use crate::{Coordinates, Evaluation, Objective};

/// Levenberg-Marquardt (Marquardt, "An Algorithm for Least-Squares Estimation of Nonlinear Parameters", 1963),
/// with the damping of Nielsen ("Damping Parameter in Marquardt's Method", 1999), within bounds by
/// [`Coordinates`].
///
/// A step solves for the minimum of the loss whose images are linear in the parameters, which takes
/// [the derivative of every image by every number](Objective::curvature): right for a few dozens of numbers,
/// such as poses, cameras, lights and materials. Steps that
/// find no lower loss are shortened and tried again; a step counts as one iteration and takes an evaluation for
/// each try.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Lm {
    /// The damping of the first step, in the curvature of each number; above 0. Large ones begin with short
    /// steps along the gradient.
    pub damping: f64,
}

impl Default for Lm {
    /// `damping` 1: the first steps are short, since images are linear over a pixel or two.
    fn default() -> Self {
        Self { damping: 1.0 }
    }
}

/// More numbers are not solved for: each takes an image, and their system is dense.
pub(super) const MOST_NUMBERS: usize = 256;
/// Tries of a step; the damping grows from each to the next, ever faster.
const MOST_TRIES: u32 = 16;
/// What stands for the curvature of a number that changes nothing, as a part of the largest.
const LEAST_CURVATURE: f64 = 1e-12;

impl Lm {
    pub(super) fn fields(&self) -> Vec<Field> {
        vec![divisor("damping", self.damping)]
    }
}

/// The method at work.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct LmState {
    damping: f64,
    /// What the damping is multiplied by if a step fails.
    growth: f64,
    /// Where it stands in coordinates without bounds; nothing before the first step.
    u: Option<Vec<f64>>,
}

impl LmState {
    /// Before the first step.
    pub fn new(settings: &Lm) -> Self {
        Self { damping: settings.damping, growth: 2.0, u: None }
    }

    /// Whether this is the memory of `len` elements.
    pub fn fits(&self, len: usize) -> bool {
        self.u.as_ref().is_none_or(|u| u.len() == len)
    }

    /// Moves `x`, where `evaluation` took place, to parameters of a lower loss; the evaluation there.
    ///
    /// # Errors
    ///
    /// If it finds none, or there is no curvature; the text says why.
    pub fn step(
        &mut self,
        flat: &Flat,
        x: &mut [f64],
        evaluation: &Evaluation,
        objective: &mut dyn Objective,
    ) -> Result<Evaluation, String> {
        let count = x.len();
        let coordinates = Coordinates::of(flat);
        let (u, evaluation) = match &self.u {
            Some(u) => (u.clone(), evaluation.clone()),
            None => {
                // A start on a bound is moved off it.
                let u = coordinates.from_bounded(x);
                let evaluation = objective.evaluate(&coordinates.to_bounded(&u));
                (u, evaluation)
            }
        };
        let at = coordinates.to_bounded(&u);
        let gradient = coordinates.pull_back(&u, &evaluation.gradient);
        let curvature = objective.curvature(&at).ok_or("the loss is no sum of squares")?;
        let slopes = coordinates.pull_back(&u, &vec![1.0; count]);
        let curvature: Vec<f64> = (0..count * count)
            .map(|index| curvature[index] * slopes[index / count] * slopes[index % count])
            .collect();
        let largest = (0..count).map(|i| curvature[i * count + i]).fold(0.0, f64::max);
        if !(largest > 0.0 && largest.is_finite()) {
            return Err(format!("the largest curvature is {largest}"));
        }
        let scale = |i: usize| curvature[i * count + i].max(LEAST_CURVATURE * largest);
        for _ in 0..MOST_TRIES {
            let mut step = gradient.clone();
            let rows = (0..count).map(|row| {
                let entry = |column: usize| {
                    let damped = if row == column { self.damping * scale(row) } else { 0.0 };
                    curvature[row * count + column] + damped
                };
                (0..count).map(entry).collect::<Vec<f64>>()
            });
            let matrix = Sprs::new_from_vec(&rows.collect::<Vec<_>>());
            // Without an order of its own: a dense matrix fills anyway.
            let solved = rsparse::cholsol(&matrix, &mut step, -1).is_ok();
            if solved && step.iter().all(|value| value.is_finite()) {
                let moved: Vec<f64> = u.iter().zip(&step).map(|(u, step)| u - step).collect();
                let found = coordinates.to_bounded(&moved);
                let there = objective.evaluate(&found);
                // What the linear images promise.
                let promised: f64 = (0..count)
                    .map(|i| 0.5 * step[i] * (gradient[i] + self.damping * scale(i) * step[i]))
                    .sum();
                let gain = (evaluation.loss - there.loss) / promised;
                if there.is_finite() && there.loss < evaluation.loss {
                    let factor = 1.0 - (2.0 * gain - 1.0).powi(3);
                    self.damping = (self.damping * factor.clamp(1.0 / 3.0, 2.0)).max(1e-12);
                    self.growth = 2.0;
                    x.copy_from_slice(&found);
                    self.u = Some(moved);
                    return Ok(there);
                }
            }
            self.damping *= self.growth;
            self.growth *= 2.0;
        }
        Err(format!("none of {MOST_TRIES} ever shorter steps"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Variable;

    /// Residuals `r(x)`, with their derivatives; the loss is the sum of their squares.
    struct Squares<F>(F);

    impl<F: FnMut(&[f64]) -> (Vec<f64>, Vec<Vec<f64>>)> Objective for Squares<F> {
        fn evaluate(&mut self, x: &[f64]) -> Evaluation {
            let (residuals, rows) = (self.0)(x);
            let loss = residuals.iter().map(|r| r * r).sum();
            let of = |i: usize| residuals.iter().zip(&rows).map(|(r, row)| 2.0 * r * row[i]).sum();
            Evaluation { loss, gradient: (0..x.len()).map(of).collect() }
        }

        fn curvature(&mut self, x: &[f64]) -> Option<Vec<f64>> {
            let (_, rows) = (self.0)(x);
            let n = x.len();
            let entry = |at: usize| rows.iter().map(|row| 2.0 * row[at / n] * row[at % n]).sum();
            Some((0..n * n).map(entry).collect())
        }
    }

    fn run(variable: &Variable, objective: &mut dyn Objective, steps: usize) -> (Vec<f64>, f64) {
        let flat = Flat::new(std::slice::from_ref(variable)).unwrap();
        let (mut x, mut method) = (flat.x.clone(), LmState::new(&Lm::default()));
        let mut evaluation = objective.evaluate(&x);
        for _ in 0..steps {
            match method.step(&flat, &mut x, &evaluation, objective) {
                Ok(found) => evaluation = found,
                Err(_) => break,
            }
        }
        (x, evaluation.loss)
    }

    /// The valley of Rosenbrock is a sum of squares, and few steps lead through it.
    #[test]
    fn it_follows_a_bent_valley() {
        let mut valley = Squares(|x: &[f64]| {
            let residuals = vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]];
            (residuals, vec![vec![-20.0 * x[0], 10.0], vec![-1.0, 0.0]])
        });
        let (x, loss) = run(&Variable::new("x", vec![-1.2, 1.0], 0.1), &mut valley, 40);
        assert!(loss < 1e-20 && (x[0] - 1.0).abs() < 1e-9, "{x:?} {loss}");
    }

    #[test]
    fn bounds_hold() {
        let mut line = Squares(|x: &[f64]| {
            (vec![x[0] - 5.0, x[1] + 1.0], vec![vec![1.0, 0.0], vec![0.0, 1.0]])
        });
        let variable = Variable::new("x", vec![1.0, 0.5], 0.5).bounded(0.0, 3.0);
        let (x, _) = run(&variable, &mut line, 60);
        assert!(x.iter().all(|value| (0.0..=3.0).contains(value)), "{x:?}");
        assert!((x[0] - 3.0).abs() < 1e-2 && x[1] < 1e-2, "{x:?}");
    }

    #[test]
    fn numbers_that_change_nothing_stay() {
        let mut flat = Squares(|x: &[f64]| (vec![x[0] - 2.0], vec![vec![1.0, 0.0]]));
        let (x, loss) = run(&Variable::new("x", vec![0.0, 7.0], 1.0), &mut flat, 30);
        assert!(loss < 1e-20 && x[1] == 7.0, "{x:?} {loss}");
    }
}
