//! Levenberg-Marquardt.

use rsparse::data::Sprs;
use serde::{Deserialize, Serialize};

use super::{NO_LOWER_LOSS, divisor};
use crate::field::Field;
use crate::variable::Flat;
use crate::{Evaluation, Objective};

/// Levenberg-Marquardt (Marquardt, "An Algorithm for Least-Squares Estimation of Nonlinear Parameters", 1963),
/// with the damping of Nielsen ("Damping Parameter in Marquardt's Method", 1999).
///
/// A step solves for the minimum within the bounds of the loss whose images are linear in the parameters, which takes
/// [the derivative of every image by every number](Objective::curvature): right for a few dozens of numbers,
/// such as poses, cameras, lights and materials. Turned down: [`Coordinates`](crate::Coordinates), on whose flat ends
/// the curvature vanishes, so that a number at its bound shortened the steps of all. Steps that
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
}

impl LmState {
    /// Before the first step.
    pub fn new(settings: &Lm) -> Self {
        Self { damping: settings.damping, growth: 2.0 }
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
        let mut gradient = evaluation.gradient.clone();
        flat.pull_back_to_places(x, &mut gradient);
        let curvature = objective.curvature(x).ok_or("the loss is no sum of squares")?;
        let slopes: Vec<f64> =
            flat.scale.iter().zip(&*x).map(|(scale, &x)| scale.slope(x)).collect();
        let curvature = |row: usize, column: usize| {
            curvature[row * count + column] * slopes[row] * slopes[column]
        };
        let largest = (0..count).map(|i| curvature(i, i)).fold(0.0, f64::max);
        if !(largest > 0.0 && largest.is_finite()) {
            return Err(format!("the largest curvature is {largest}"));
        }
        let of_bound =
            |i: usize, bound: f64| flat.scale[i].place(bound) - flat.scale[i].place(x[i]);
        let bounds = |i| [of_bound(i, flat.lowest(i)), of_bound(i, flat.max[i])];
        let bounds: Vec<[f64; 2]> = (0..count).map(bounds).collect();
        for _ in 0..MOST_TRIES {
            let damped = |row: usize, column: usize| {
                let damping = self.damping * curvature(row, row).max(LEAST_CURVATURE * largest);
                curvature(row, column) + if row == column { damping } else { 0.0 }
            };
            let rows = |row| (0..count).map(|column| damped(row, column)).collect();
            let model = Model { gradient: &gradient, curvature: (0..count).map(rows).collect() };
            let step = model.least_within(&bounds);
            if let Some(step) = step.filter(|step| step.iter().all(|value| value.is_finite())) {
                let moved = |i: usize| match step[i] {
                    end if end == bounds[i][0] => flat.lowest(i),
                    end if end == bounds[i][1] => flat.max[i],
                    by => flat.scale[i].moved(x[i], by).clamp(flat.lowest(i), flat.max[i]),
                };
                let found: Vec<f64> = (0..count).map(moved).collect();
                let there = objective.evaluate(&found);
                // What the linear images promise.
                let along =
                    |row: usize| (0..count).map(|i| curvature(row, i) * step[i]).sum::<f64>();
                let promised: f64 =
                    -(0..count).map(|i| step[i] * (gradient[i] + 0.5 * along(i))).sum::<f64>();
                let gain = (evaluation.loss - there.loss) / promised;
                if there.is_finite() && there.loss < evaluation.loss {
                    let factor = 1.0 - (2.0 * gain - 1.0).powi(3);
                    self.damping = (self.damping * factor.clamp(1.0 / 3.0, 2.0)).max(1e-12);
                    self.growth = 2.0;
                    x.copy_from_slice(&found);
                    return Ok(there);
                }
            }
            self.damping *= self.growth;
            self.growth *= 2.0;
        }
        let tried = format!("{MOST_TRIES} ever shorter steps were tried");
        Err(format!("{tried}; {NO_LOWER_LOSS}"))
    }
}

/// A loss that is quadratic in a step.
struct Model<'a> {
    gradient: &'a [f64],
    /// By rows; positive definite.
    curvature: Vec<Vec<f64>>,
}

impl Model<'_> {
    /// The step of the least loss within bounds: the active set changes for all numbers at once (Hintermueller,
    /// Ito and Kunisch, "The Primal-Dual Active Set Strategy as a Semismooth Newton Method", 2002). Where the set
    /// comes to no rest, which strong damping rules out, the last step is cut off at the bounds.
    fn least_within(&self, bounds: &[[f64; 2]]) -> Option<Vec<f64>> {
        let count = bounds.len();
        let mut held = vec![None; count];
        let mut step = vec![0.0; count];
        for _ in 0..=2 * count {
            let free: Vec<usize> = (0..count).filter(|&i| held[i].is_none()).collect();
            step = held.iter().map(|end: &Option<f64>| end.unwrap_or(0.0)).collect();
            let mut of_free: Vec<f64> = free.iter().map(|&row| -self.slope(row, &step)).collect();
            if !free.is_empty() {
                let row = |&row: &usize| free.iter().map(|&i| self.curvature[row][i]).collect();
                let matrix = Sprs::new_from_vec(&free.iter().map(row).collect::<Vec<_>>());
                // Without an order of its own: a dense matrix fills anyway.
                rsparse::cholsol(&matrix, &mut of_free, -1).ok()?;
            }
            free.iter().zip(of_free).for_each(|(&i, value)| step[i] = value);
            let end = |i: usize| {
                let [low, high] = bounds[i];
                match held[i] {
                    None if step[i] < low => Some(low),
                    None if step[i] > high => Some(high),
                    Some(end) if end == low && self.slope(i, &step) >= 0.0 => Some(low),
                    Some(end) if end == high && self.slope(i, &step) <= 0.0 => Some(high),
                    _ => None,
                }
            };
            let next: Vec<_> = (0..count).map(end).collect();
            if next == held {
                break;
            }
            held = next;
        }
        Some(step.iter().zip(bounds).map(|(step, [low, high])| step.clamp(*low, *high)).collect())
    }

    /// The derivative of the loss by a number of the step.
    fn slope(&self, row: usize, step: &[f64]) -> f64 {
        let products =
            self.curvature[row].iter().zip(step).map(|(curvature, step)| curvature * step);
        self.gradient[row] + products.sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Scale, Variable};

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

    /// Residuals that are linear in numbers, each of which all residuals depend on.
    fn linear(x: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
        let rows: Vec<Vec<f64>> = (0..6)
            .map(|r| {
                (0..x.len()).map(|i| ((3 * r + 5 * i) as f64).sin() + f64::from(r == i)).collect()
            })
            .collect();
        let products = |row: &Vec<f64>| row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
        (rows.iter().enumerate().map(|(r, row)| products(row) - 2.0 + r as f64).collect(), rows)
    }

    /// The minimum on bounds is found exactly, from starts on bounds too, and what is left of the gradient points out.
    #[test]
    fn minima_on_bounds_are_reached() {
        let mut on_bounds = 0;
        for start in [vec![0.5; 4], vec![0.0, 1.0, 0.0, 1.0]] {
            let variable = Variable::new("x", start, 0.5).bounded(0.0, 1.0);
            let mut objective = Squares(linear);
            let (x, _) = run(&variable, &mut objective, 40);
            let gradient = objective.evaluate(&x).gradient;
            for (&x, g) in x.iter().zip(gradient) {
                let rests = if x == 0.0 {
                    g > 0.0
                } else if x == 1.0 {
                    g < 0.0
                } else {
                    g.abs() < 1e-6
                };
                assert!(rests, "{x} {g}");
                on_bounds += u32::from(x == 0.0 || x == 1.0);
            }
        }
        assert!((1..8).contains(&on_bounds), "{on_bounds}");
    }

    /// So is one of a number on a logarithmic scale, at which the other one is held.
    #[test]
    fn logarithms_have_bounds() {
        let mut objective = Squares(|x: &[f64]| {
            let residuals = vec![x[0] * x[1] - 6.0, x[1] - 1.0];
            (residuals, vec![vec![x[1], x[0]], vec![0.0, 1.0]])
        });
        let variable = Variable::new("x", vec![0.1, 5.0], 0.1).bounded(0.01, 4.0);
        let variable = Variable { scale: Scale::Log, max: vec![4.0, 9.0], ..variable };
        let (x, _) = run(&variable, &mut objective, 60);
        assert!(x[0] == 4.0 && (x[1] - 25.0 / 17.0).abs() < 1e-6, "{x:?}");
    }

    #[test]
    fn numbers_that_change_nothing_stay() {
        let mut flat = Squares(|x: &[f64]| (vec![x[0] - 2.0], vec![vec![1.0, 0.0]]));
        let (x, loss) = run(&Variable::new("x", vec![0.0, 7.0], 1.0), &mut flat, 30);
        assert!(loss < 1e-20 && x[1] == 7.0, "{x:?} {loss}");
    }
}
