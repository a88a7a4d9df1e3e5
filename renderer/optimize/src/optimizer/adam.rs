//! Adam, and Adam with weight decay.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::{decay, divisor, running_rms};
use crate::Carry;
use crate::field::Field;

/// The hyper-parameters of Adam (Kingma and Ba, "Adam: a method for stochastic optimization", ICLR
/// 2015, algorithm 1 with bias correction).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
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
    /// Whether the elements of a variable are divided by the largest of their root mean squares, all by the
    /// same, instead of each by its own: steps keep the direction of the mean of gradients, so vertices move
    /// as the surface does, and not along diagonals (`AdamUniform` of Nicolet, Jacobson and Jakob, "Large Steps
    /// in Inverse Rendering of Geometry", 2021).
    pub uniform: bool,
}

impl Default for Adam {
    /// `beta1` 0.9 and `beta2` 0.999 as in the paper, `epsilon` 1e-30, not uniform.
    fn default() -> Self {
        Self { beta1: 0.9, beta2: 0.999, epsilon: 1e-30, uniform: false }
    }
}

/// The hyper-parameters of Adam with decoupled weight decay (Loshchilov and Hutter, "Decoupled
/// weight decay regularization", ICLR 2019, algorithm 2): beside Adam's step, every step takes
/// `rate * weight_decay` of each element towards 0.
///
/// Meant for parameters that are 0 unless the image says otherwise. A light or a camera has no such
/// place to return to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct AdamW {
    /// The decay of the mean of gradients, as for [`Adam`].
    pub beta1: f64,
    /// The decay of the mean of squared gradients, as for [`Adam`].
    pub beta2: f64,
    /// What keeps the divisor from zero, as for [`Adam`].
    pub epsilon: f64,
    /// What a step of learning rate 1 takes from each element, as a part of it, in `[0, 1)`.
    pub weight_decay: f64,
}

impl Default for AdamW {
    /// As [`Adam`], and `weight_decay` 0.01.
    fn default() -> Self {
        let Adam { beta1, beta2, epsilon, .. } = Adam::default();
        Self { beta1, beta2, epsilon, weight_decay: 0.01 }
    }
}

/// What Adam remembers from step to step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Moments {
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

    /// Returns `true` if the memory is that of `len` elements.
    pub fn fits(&self, len: usize) -> bool {
        self.mean.len() == len && self.root_mean_square.len() == len
    }

    /// The memory of other elements.
    pub fn carry(&mut self, carry: &Carry) {
        self.mean = carry(&self.mean);
        self.root_mean_square = carry(&self.root_mean_square);
    }
}

impl Adam {
    pub(super) fn fields(&self) -> Vec<Field> {
        vec![
            decay("beta1", self.beta1),
            decay("beta2", self.beta2),
            divisor("epsilon", self.epsilon),
            ("uniform", f64::from(u8::from(self.uniform)), true, "true or false"),
        ]
    }

    /// Of the order of 1, however large or small the gradient is.
    pub(super) fn direction(
        &self,
        moments: &mut Moments,
        gradient: &mut [f64],
        blocks: &[Range<usize>],
    ) {
        moments.beta1_power *= self.beta1;
        moments.beta2_power *= self.beta2;
        let correction = (1.0 - moments.beta2_power).sqrt() / (1.0 - moments.beta1_power);
        let memory = moments.mean.iter_mut().zip(&mut moments.root_mean_square);
        for (g, (mean, rms)) in gradient.iter_mut().zip(memory) {
            *mean = self.beta1 * *mean + (1.0 - self.beta1) * *g;
            *rms = running_rms(*rms, self.beta2, *g);
            *g = *mean;
        }
        let rms = &moments.root_mean_square;
        for block in blocks {
            let largest = || rms[block.clone()].iter().copied().fold(0.0, f64::max);
            let largest = self.uniform.then(largest);
            for (g, rms) in gradient[block.clone()].iter_mut().zip(&rms[block.clone()]) {
                *g = correction * (*g / (largest.unwrap_or(*rms) + self.epsilon));
            }
        }
    }
}

impl AdamW {
    fn adam(&self) -> Adam {
        Adam { beta1: self.beta1, beta2: self.beta2, epsilon: self.epsilon, uniform: false }
    }

    pub(super) fn fields(&self) -> Vec<Field> {
        let mut fields = self.adam().fields();
        fields.retain(|(name, ..)| *name != "uniform");
        fields.push(decay("weight_decay", self.weight_decay));
        fields
    }

    pub(super) fn direction(
        &self,
        moments: &mut Moments,
        x: &[f64],
        gradient: &mut [f64],
        blocks: &[Range<usize>],
    ) {
        self.adam().direction(moments, gradient, blocks);
        for (g, x) in gradient.iter_mut().zip(x) {
            *g += self.weight_decay * x;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::slice::from_ref;

    use super::*;

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
        let (mut x, mut moments) = (0.0, Moments::new(1));
        for &g in &gradients {
            let mut step = [g];
            Adam::default().direction(&mut moments, &mut step, from_ref(&(0..1)));
            x -= 0.03 * step[0];
        }
        let expected = paper(&gradients, 0.03);
        assert!((x - expected).abs() < 1e-12 * expected.abs(), "{x} {expected}");
    }

    #[test]
    fn first_direction_is_a_unit_at_every_scale_of_the_gradient() {
        for scale in [1e-20, 1e-8, 1.0, 1e200, 1e308] {
            let (mut gradient, mut moments) = ([scale, -scale], Moments::new(2));
            Adam::default().direction(&mut moments, &mut gradient, from_ref(&(0..2)));
            let [a, b] = gradient;
            assert!((a - 1.0).abs() < 1e-8 && (b + 1.0).abs() < 1e-8, "{scale}: {gradient:?}");
        }
    }

    #[test]
    fn zero_gradient_moves_nothing() {
        let mut gradient = [0.0];
        Adam::default().direction(&mut Moments::new(1), &mut gradient, from_ref(&(0..1)));
        assert_eq!(gradient, [0.0]);
    }

    #[test]
    fn uniform_steps_keep_the_direction_of_the_gradient() {
        let (uniform, mut moments) = (Adam { uniform: true, ..Adam::default() }, Moments::new(5));
        let mut gradient = [3.0, -4.0, 0.5, 1e-3, 2e-3];
        uniform.direction(&mut moments, &mut gradient, &[0..3, 3..5]);
        let expected = [0.75, -1.0, 0.125, 0.5, 1.0];
        let error = gradient.iter().zip(expected).map(|(a, b)| (a - b).abs()).sum::<f64>();
        assert!(error < 1e-9, "{gradient:?}");
    }

    #[test]
    fn weight_decay_is_apart_from_the_gradient() {
        let (mut with, mut without) = (Moments::new(2), Moments::new(2));
        for i in 0..10 {
            let gradient = [f64::from(i) - 3.0, 0.5];
            let (mut decayed, mut plain) = (gradient, gradient);
            AdamW::default().direction(&mut with, &[2.0, -50.0], &mut decayed, from_ref(&(0..2)));
            Adam::default().direction(&mut without, &mut plain, from_ref(&(0..2)));
            assert_eq!(decayed, [plain[0] + 0.01 * 2.0, plain[1] - 0.01 * 50.0]);
        }
        assert_eq!(with, without);
    }
}
