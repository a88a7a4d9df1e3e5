//! Finite differences with step control: a check of gradients that shares no code with them.

mod coordinates;
mod forward;
mod rule;

pub use coordinates::Coordinates;
pub use forward::{assert_forward, worst_forward};
pub use rule::{Component, Function, Rule, Settings, assert_rule, worst};

/// A numerical derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The derivative.
    pub value: f64,
    /// An estimate of its absolute error. Large where the function is not smooth near the point.
    pub error: f64,
}

/// How much the step shrinks from one row of the extrapolation table to the next.
const SHRINK: f64 = 1.4;

/// The number of step sizes tried.
const ROWS: usize = 20;

/// The derivative of `f` at `x` by Ridders' method: central differences over shrinking steps,
/// extrapolated to step 0 (Ridders 1982; Numerical Recipes, 3rd ed., section 5.7).
///
/// `step` is the first and largest step, a length over which `f` changes noticeably and stays
/// smooth. The entry of the table with the least estimated error is returned; where `f` is not
/// finite at every step, value and error are NaN and infinite.
///
/// ```
/// let slope = ad::check::derivative(|x| x.sin(), 1.0, 0.1);
/// assert!((slope.value - 1.0_f64.cos()).abs() <= 1e-11);
/// ```
pub fn derivative(mut f: impl FnMut(f64) -> f64, x: f64, step: f64) -> Estimate {
    let mut best = Estimate { value: f64::NAN, error: f64::INFINITY };
    let mut previous: Vec<f64> = Vec::new();
    let mut h = step;
    for _ in 0..ROWS {
        // The step that is really taken, free of the rounding of x + h.
        let (above, below) = (x + h, x - h);
        let mut row = vec![(f(above) - f(below)) / (above - below)];

        // Richardson's extrapolation removes one even power of the step per column.
        let mut factor = 1.0;
        for (column, &coarser) in previous.iter().enumerate() {
            factor *= SHRINK * SHRINK;
            let finer = row[column];
            let extrapolated = finer + (finer - coarser) / (factor - 1.0);
            let error = (extrapolated - finer).abs().max((extrapolated - coarser).abs());
            row.push(extrapolated);
            if error <= best.error {
                best = Estimate { value: extrapolated, error };
            }
        }

        // Higher orders stopped helping: rounding has taken over.
        if let (Some(&last), Some(&before)) = (row.last(), previous.last())
            && (last - before).abs() >= 2.0 * best.error
            && best.error.is_finite()
        {
            break;
        }
        previous = row;
        h /= SHRINK;
    }
    best
}

/// The gradient of `f` at `x`, element by element. See [`derivative`].
pub fn gradient(mut f: impl FnMut(&[f64]) -> f64, x: &[f64], step: f64) -> Vec<Estimate> {
    let mut point = x.to_vec();
    (0..x.len())
        .map(|i| {
            let estimate = derivative(
                |value| {
                    point[i] = value;
                    f(&point)
                },
                x[i],
                step,
            );
            point[i] = x[i];
            estimate
        })
        .collect()
}
