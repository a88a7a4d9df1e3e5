//! A loop with branches: robust differences of neighbours.

use ad::{Real, differentiable};

use crate::problem::Problem;
use crate::random::Random;

pub const N: usize = 1000;

#[differentiable]
pub fn robust<S: Real<Mask = bool>>(x: &[S; N]) -> S {
    let mut sum = S::ZERO;
    for i in 1..N {
        let error = x[i] - x[i - 1];
        if error.cmpgt(S::HALF) {
            sum += error - S::from_f64(0.25);
        } else if error.cmplt(S::from_f64(-0.5)) {
            sum -= error + S::from_f64(0.25);
        } else {
            sum += error * error;
        }
    }
    sum
}

/// The gradient, written by hand.
pub fn adjoint(x: &[f64; N]) -> [f64; N] {
    let mut gradient = [0.0; N];
    for i in 1..N {
        let error = x[i] - x[i - 1];
        let error_bar = if error > 0.5 {
            1.0
        } else if error < -0.5 {
            -1.0
        } else {
            2.0 * error
        };
        gradient[i] += error_bar;
        gradient[i - 1] -= error_bar;
    }
    gradient
}

pub struct Branches;

impl Problem for Branches {
    const NAME: &'static str = "branches 1000";
    const OUTPUTS: usize = 1;

    fn point(&self) -> Vec<f64> {
        Random::new(6).numbers::<N>().to_vec()
    }

    fn value<S: Real<Mask = bool>>(&self, x: &[S], outputs: &mut [S]) {
        outputs[0] = robust(x.first_chunk().expect("N numbers"));
    }

    fn generated(&self, x: &[f64], jacobian: &mut [f64]) {
        jacobian.copy_from_slice(&robust::grad(x.first_chunk().expect("N numbers")));
    }

    fn forward(&self, x: &[f64], direction: &[f64], tangents: &mut [f64]) {
        let [x, direction] = [x, direction].map(|x| x.first_chunk().expect("N numbers"));
        tangents[0] = robust::jvp(x, direction).1;
    }

    fn by_hand(&self, x: &[f64], jacobian: &mut [f64]) {
        jacobian.copy_from_slice(&adjoint(x.first_chunk().expect("N numbers")));
    }
}
