//! RMSProp.

use serde::{Deserialize, Serialize};

use super::{decay, divisor, running_rms};
use crate::field::Field;

/// RMSProp (Hinton, "Neural networks for machine learning", lecture 6e, 2012): the gradient over
/// the root of its running mean square.
///
/// The mean starts at 0 and is not corrected for that, as in the lecture: the first step is
/// `1 / sqrt(1 - decay)` learning rates long, 3.2 with the default, and later ones come down to
/// one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RmsProp {
    /// Decay of the running mean of the squared gradient, in `[0, 1)`.
    pub decay: f64,
    /// Added to the root mean square, to divide by; positive. Small for the reason that
    /// [`Adam::epsilon`](super::Adam::epsilon) is.
    pub epsilon: f64,
}

impl Default for RmsProp {
    /// `decay` 0.9 as in the lecture, `epsilon` 1e-30.
    fn default() -> Self {
        Self { decay: 0.9, epsilon: 1e-30 }
    }
}

impl RmsProp {
    pub(super) fn fields(&self) -> Vec<Field> {
        vec![decay("decay", self.decay), divisor("epsilon", self.epsilon)]
    }

    pub(super) fn direction(&self, rms: &mut [f64], gradient: &mut [f64]) {
        for (rms, g) in rms.iter_mut().zip(gradient) {
            *rms = running_rms(*rms, self.decay, *g);
            *g /= *rms + self.epsilon;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn follows_the_lecture() {
        let method = RmsProp::default();
        let (mut rms, mut mean_square) = ([0.0], 0.0);
        for i in 0..200 {
            let g = (0.7 * f64::from(i)).sin() * 3.0 + 0.4;
            mean_square = 0.9 * mean_square + 0.1 * g * g;
            let mut gradient = [g];
            method.direction(&mut rms, &mut gradient);
            let expected = g / f64::sqrt(mean_square);
            assert!((gradient[0] - expected).abs() < 1e-12, "{i}: {gradient:?} {expected}");
        }
    }

    #[test]
    fn steps_do_not_depend_on_the_scale_of_the_gradient() {
        for scale in [1e-200, 1e-8, 1.0, 1e200] {
            let mut rms = [0.0];
            let mut gradient = [-scale];
            // The epsilon is 0 to every one of these but the first, which is below it.
            RmsProp { epsilon: f64::MIN_POSITIVE, ..RmsProp::default() }
                .direction(&mut rms, &mut gradient);
            assert!((gradient[0] + 10.0_f64.sqrt()).abs() < 1e-12, "{scale}: {gradient:?}");
        }
    }

    #[test]
    fn zero_gradient_moves_nothing() {
        let mut gradient = [0.0];
        RmsProp::default().direction(&mut [0.0], &mut gradient);
        assert_eq!(gradient, [0.0]);
    }
}
