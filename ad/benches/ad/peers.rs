//! Other crates' ways to a gradient: the tape of `reverse`, the dual numbers of `num-dual`.

use std::ops::{Add, Mul, Sub};

use num_dual::Dual64;

use crate::lotka_volterra::{H, STEPS};

/// What the functions need of a number.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Add<f64, Output = Self>
    + Mul<f64, Output = Self>
{
}

impl<T> Number for T where
    T: Copy
        + Add<Output = T>
        + Sub<Output = T>
        + Mul<Output = T>
        + Add<f64, Output = T>
        + Mul<f64, Output = T>
{
}

/// The time of these is measured.
pub trait Peers {
    /// The gradient by the tape of `reverse`.
    fn by_reverse(&self, tape: &reverse::Tape, x: &[f64]) -> Vec<f64>;

    /// The derivative by the first input by `num-dual`.
    fn by_num_dual(&self, x: &[f64]) -> f64;
}

macro_rules! peers {
    ($problem:ty, $function:ident) => {
        impl Peers for $problem {
            fn by_reverse(&self, tape: &reverse::Tape, x: &[f64]) -> Vec<f64> {
                use reverse::Gradient;
                tape.clear();
                let variables = tape.add_vars(x);
                $function(&variables).grad().wrt(&variables)
            }

            fn by_num_dual(&self, x: &[f64]) -> f64 {
                let mut x: Vec<_> = x.iter().map(|&x| Dual64::from_re(x)).collect();
                x[0].eps = 1.0;
                $function(&x).eps
            }
        }
    };
}

peers!(crate::rosenbrock::Rosenbrock, rosenbrock);
peers!(crate::lotka_volterra::LotkaVolterra, simulate);

fn rosenbrock<T: Number>(x: &[T]) -> T {
    let term = |i: usize| {
        let a = x[i] * -1.0 + 1.0;
        let b = x[i + 1] - x[i] * x[i];
        a * a + b * b * 100.0
    };
    (1..x.len() - 1).fold(term(0), |sum, i| sum + term(i))
}

fn simulate<T: Number>(p: &[T]) -> T {
    let [a, b, c, d, mut x, mut y] = *p.first_chunk().expect("6 numbers");
    let slope = |x: T, y: T| (a * x - b * x * y, c * x * y - d * y);
    for _ in 0..STEPS {
        let (k1, l1) = slope(x, y);
        let (k2, l2) = slope(x + k1 * (H / 2.0), y + l1 * (H / 2.0));
        let (k3, l3) = slope(x + k2 * (H / 2.0), y + l2 * (H / 2.0));
        let (k4, l4) = slope(x + k3 * H, y + l3 * H);
        x = x + (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (H / 6.0);
        y = y + (l1 + l2 * 2.0 + l3 * 2.0 + l4) * (H / 6.0);
    }
    x
}
