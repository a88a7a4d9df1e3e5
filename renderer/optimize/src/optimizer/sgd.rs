//! Gradient descent with momentum.

use serde::{Deserialize, Serialize};

use super::decay;
use crate::field::Field;

/// Gradient descent with momentum (Polyak's heavy ball): `v = momentum v + g`, `x = x - rate v`.
///
/// The learning rate multiplies the gradient itself, so it has to suit the scale of the loss: a
/// rate that works for a mean of squares is too large for a sum of squares. Named for its use with
/// stochastic gradients, as everywhere; those of this renderer are not.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Sgd {
    /// What is kept of the velocity from step to step, in `[0, 1)`; 0 for plain gradient descent.
    pub momentum: f64,
}

impl Default for Sgd {
    /// `momentum` 0.9.
    fn default() -> Self {
        Self { momentum: 0.9 }
    }
}

impl Sgd {
    pub(super) fn fields(&self) -> Vec<Field> {
        vec![decay("momentum", self.momentum)]
    }

    pub(super) fn direction(&self, velocity: &mut [f64], gradient: &mut [f64]) {
        for (v, g) in velocity.iter_mut().zip(gradient) {
            *v = (self.momentum * *v + *g).clamp(f64::MIN, f64::MAX);
            *g = *v;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_gradient_adds_up_as_a_geometric_series() {
        let sgd = Sgd { momentum: 0.5 };
        let mut velocity = [0.0];
        for n in 1..20 {
            let mut gradient = [3.0];
            sgd.direction(&mut velocity, &mut gradient);
            let sum = 3.0 * (1.0 - 0.5_f64.powi(n)) / 0.5;
            assert!((gradient[0] - sum).abs() < 1e-12, "{n}: {gradient:?} {sum}");
        }
    }

    #[test]
    fn without_momentum_the_direction_is_the_gradient() {
        let mut gradient = [1e-300, -7.0];
        Sgd { momentum: 0.0 }.direction(&mut [5.0, 5.0], &mut gradient);
        assert_eq!(gradient, [1e-300, -7.0]);
    }

    #[test]
    fn stays_finite() {
        let mut velocity = [0.0];
        for _ in 0..100 {
            let mut gradient = [f64::MAX];
            Sgd::default().direction(&mut velocity, &mut gradient);
            assert_eq!(gradient, [f64::MAX]);
        }
    }
}
