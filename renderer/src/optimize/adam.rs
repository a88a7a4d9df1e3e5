//! Adam, with bounds by projection.

use serde::{Deserialize, Serialize};

use super::variable::Flat;

/// The hyper-parameters of Adam (Kingma and Ba, "Adam: a method for stochastic optimization", ICLR
/// 2015, algorithm 1 with bias correction).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adam {
    /// Decay of the running mean of the gradient, in `[0, 1)`.
    pub beta1: f64,
    /// Decay of the running mean of the squared gradient, in `[0, 1)`.
    pub beta2: f64,
    /// Added to the root mean square of the gradient, to divide by; positive.
    ///
    /// The customary 1e-8 ties the optimiser to one scale of the loss: the gradient of a mean
    /// square over pixels with respect to a distant light is far smaller than that, and the steps
    /// would shrink with it. Here it only has to make 0/0 a zero step, so it stands below every
    /// gradient of use: adjoints computed in `f32` have lost their digits by 1e-38.
    pub epsilon: f64,
}

impl Default for Adam {
    /// `beta1` 0.9 and `beta2` 0.999 as in the paper, `epsilon` 1e-30.
    fn default() -> Self {
        Self { beta1: 0.9, beta2: 0.999, epsilon: 1e-30 }
    }
}

/// What Adam remembers from step to step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Moments {
    /// Running mean of the gradient, before bias correction.
    mean: Vec<f64>,
    /// Square root of the running mean of the squared gradient, before bias correction. The root
    /// is kept because the squares of gradients below 1e-154 are zero.
    root_mean_square: Vec<f64>,
    /// `beta1` to the power of the number of steps.
    beta1_power: f64,
    /// `beta2` to the power of the number of steps.
    beta2_power: f64,
}

impl Moments {
    /// The memory of no step, for `len` elements.
    pub fn new(len: usize) -> Self {
        Self {
            mean: vec![0.0; len],
            root_mean_square: vec![0.0; len],
            beta1_power: 1.0,
            beta2_power: 1.0,
        }
    }

    /// Whether this is the memory of `len` elements.
    pub fn fits(&self, len: usize) -> bool {
        self.mean.len() == len && self.root_mean_square.len() == len
    }
}

impl Adam {
    /// Moves `x` one step against `gradient` and projects it onto the bounds.
    ///
    /// An element moves by about its learning rate, however large or small its gradient is. A
    /// finite `x` stays finite.
    pub(super) fn step(
        &self,
        moments: &mut Moments,
        x: &mut [f64],
        gradient: &[f64],
        variables: &Flat,
    ) {
        moments.beta1_power *= self.beta1;
        moments.beta2_power *= self.beta2;
        let correction = (1.0 - moments.beta2_power).sqrt() / (1.0 - moments.beta1_power);
        let keep = self.beta2.sqrt();
        let take = (1.0 - self.beta2).sqrt();

        for (i, (x, &g)) in x.iter_mut().zip(gradient).enumerate() {
            let mean = &mut moments.mean[i];
            let rms = &mut moments.root_mean_square[i];
            *mean = self.beta1 * *mean + (1.0 - self.beta1) * g;
            *rms = (keep * *rms).hypot(take * g).min(f64::MAX);
            // The quotient is of order one, so no product here can overflow before the last.
            let step = variables.learning_rate[i] * (correction * (*mean / (*rms + self.epsilon)));
            // No bound means the largest finite number.
            let lowest = variables.min[i].max(f64::MIN);
            let highest = variables.max[i].min(f64::MAX);
            *x = (*x - step).clamp(lowest, highest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unbounded(learning_rate: &[f64]) -> Flat {
        let len = learning_rate.len();
        Flat {
            x: vec![0.0; len],
            learning_rate: learning_rate.to_vec(),
            min: vec![f64::NEG_INFINITY; len],
            max: vec![f64::INFINITY; len],
        }
    }

    /// Algorithm 1 of the paper, word for word, for one element.
    fn paper(gradients: &[f64], learning_rate: f64) -> f64 {
        let (mut m, mut v, mut x) = (0.0, 0.0, 0.0);
        for (t, g) in (1..).zip(gradients) {
            m = 0.9 * m + 0.1 * g;
            v = 0.999 * v + 0.001 * g * g;
            let m_hat = m / (1.0 - f64::powi(0.9, t));
            let v_hat = v / (1.0 - f64::powi(0.999, t));
            x -= learning_rate * m_hat / (v_hat.sqrt() + 1e-30);
        }
        x
    }

    #[test]
    fn follows_the_paper() {
        let gradients: Vec<f64> = (0..200).map(|i| (0.7 * i as f64).sin() * 3.0 + 0.4).collect();
        let variables = unbounded(&[0.03]);
        let (mut x, mut moments) = ([0.0], Moments::new(1));
        for &g in &gradients {
            Adam::default().step(&mut moments, &mut x, &[g], &variables);
        }
        let expected = paper(&gradients, 0.03);
        assert!((x[0] - expected).abs() < 1e-12 * expected.abs(), "{} {expected}", x[0]);
    }

    #[test]
    fn first_step_is_the_learning_rate_at_every_scale_of_the_gradient() {
        for scale in [1e-20, 1e-8, 1.0, 1e200, 1e308] {
            let variables = unbounded(&[0.5, 0.01]);
            let (mut x, mut moments) = ([0.0; 2], Moments::new(2));
            Adam::default().step(&mut moments, &mut x, &[scale, -scale], &variables);
            assert!((x[0] + 0.5).abs() < 1e-8 && (x[1] - 0.01).abs() < 1e-9, "{scale}: {x:?}");
        }
    }

    #[test]
    fn zero_gradient_moves_nothing() {
        let (mut x, mut moments) = ([3.0], Moments::new(1));
        Adam::default().step(&mut moments, &mut x, &[0.0], &unbounded(&[1.0]));
        assert_eq!(x, [3.0]);
    }

    #[test]
    fn stays_within_bounds_and_finite() {
        let mut variables = unbounded(&[0.3, 1e308]);
        variables.min[0] = -0.5;
        let (mut x, mut moments) = ([0.0, 0.0], Moments::new(2));
        for _ in 0..10 {
            Adam::default().step(&mut moments, &mut x, &[1.0, 1e308], &variables);
        }
        assert_eq!(x, [-0.5, f64::MIN]);
    }
}
