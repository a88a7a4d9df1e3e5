//! The Rosenbrock function of 1000 variables.

use ad::{Real, differentiable};

use crate::peers::{Number, Peers, peers};
use crate::problem::Problem;
use crate::random::Random;

pub const N: usize = 1000;

#[differentiable]
pub fn rosenbrock<S: Real>(x: &[S; N]) -> S {
    let mut sum = S::ZERO;
    for i in 0..N - 1 {
        let a = S::ONE - x[i];
        let b = x[i + 1] - x[i] * x[i];
        sum = sum + a * a + S::from_f64(100.0) * b * b;
    }
    sum
}

/// [`rosenbrock`], for the numbers of other crates.
fn rosenbrock_of_numbers<T: Number>(x: &[T]) -> T {
    let term = |i: usize| {
        let a = x[i] * -1.0 + 1.0;
        let b = x[i + 1] - x[i] * x[i];
        a * a + b * b * 100.0
    };
    (1..x.len() - 1).fold(term(0), |sum, i| sum + term(i))
}

/// The gradient, written by hand.
pub fn adjoint(x: &[f64; N]) -> [f64; N] {
    let mut gradient = [0.0; N];
    for i in 0..N - 1 {
        let a = 1.0 - x[i];
        let b = x[i + 1] - x[i] * x[i];
        let b_bar = 200.0 * b;
        gradient[i] -= 2.0 * a + 2.0 * x[i] * b_bar;
        gradient[i + 1] += b_bar;
    }
    gradient
}

pub struct Rosenbrock;

impl Problem for Rosenbrock {
    const NAME: &'static str = "Rosenbrock 1000";
    const OUTPUTS: usize = 1;

    fn point(&self) -> Vec<f64> {
        Random::new(1).numbers::<N>().to_vec()
    }

    fn value<S: Real<Mask = bool>>(&self, x: &[S], outputs: &mut [S]) {
        outputs[0] = rosenbrock(x.first_chunk().expect("N numbers"));
    }

    fn generated(&self, x: &[f64], jacobian: &mut [f64]) {
        jacobian.copy_from_slice(&rosenbrock::grad(x.first_chunk().expect("N numbers")));
    }

    fn forward(&self, x: &[f64], direction: &[f64], tangents: &mut [f64]) {
        let [x, direction] = [x, direction].map(|x| x.first_chunk().expect("N numbers"));
        tangents[0] = rosenbrock::jvp(x, direction).1;
    }

    fn by_hand(&self, x: &[f64], jacobian: &mut [f64]) {
        jacobian.copy_from_slice(&adjoint(x.first_chunk().expect("N numbers")));
    }

    fn peers(&self) -> Option<&dyn Peers> {
        Some(self)
    }
}

peers!(Rosenbrock, rosenbrock_of_numbers);
