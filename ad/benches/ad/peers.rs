//! Other crates' ways to a gradient: the tape of `reverse`, the dual numbers of `num-dual`.

use std::ops::{Add, Mul, Sub};

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

/// Implements [`Peers`] by a function that is generic over [`Number`].
macro_rules! peers {
    ($problem:ty, $function:ident) => {
        impl $crate::peers::Peers for $problem {
            fn by_reverse(&self, tape: &reverse::Tape, x: &[f64]) -> Vec<f64> {
                use reverse::Gradient;
                tape.clear();
                let variables = tape.add_vars(x);
                $function(&variables).grad().wrt(&variables)
            }

            fn by_num_dual(&self, x: &[f64]) -> f64 {
                let mut x: Vec<_> = x.iter().map(|&x| num_dual::Dual64::from_re(x)).collect();
                x[0].eps = 1.0;
                $function(&x).eps
            }
        }
    };
}
pub(crate) use peers;
