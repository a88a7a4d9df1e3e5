//! Newton's method with options, damping and three outcomes.

use ad::{Differentiable, differentiable};

#[derive(Debug, Clone, Copy, PartialEq, Differentiable)]
enum Outcome {
    Converged { root: f64, iterations: u32 },
    Diverged(f64),
    Stuck,
}

#[derive(Clone, Copy, Differentiable)]
struct Options {
    tol: f64,
    #[constant]
    max_iter: u32,
    damping: Option<f64>,
}

impl Default for Options {
    fn default() -> Self {
        Options { tol: 1e-12, max_iter: 50, damping: None }
    }
}

#[differentiable]
fn newton<F, D>(f: F, df: D, x0: f64, options: &Options) -> Outcome
where
    F: Fn(f64) -> f64,
    D: Fn(f64) -> f64,
{
    let mut x = x0;
    let mut iterations = 0;
    loop {
        let fx = f(x);
        if fx.abs() < options.tol {
            break Outcome::Converged { root: x, iterations };
        }
        let slope = df(x);
        if slope.abs() < 1e-14 {
            break Outcome::Stuck;
        }
        let step = fx / slope;
        x -= match options.damping {
            Some(lambda) => lambda * step,
            None => step,
        };
        iterations += 1;
        if iterations >= options.max_iter {
            return Outcome::Diverged(x);
        }
    }
}

#[differentiable]
impl Outcome {
    fn root(self) -> Option<f64> {
        match self {
            Self::Converged { root, .. } => Some(root),
            Self::Diverged(_) | Self::Stuck => None,
        }
    }
}

#[differentiable]
fn both(a: f64, b: f64) -> f64 {
    let mut options = Options::default();
    let first = newton(|x| x * x * x - a, |x| 3.0 * x * x, 1.5, &options).root();
    options.damping = Some(0.9);
    let second = newton(|x| x.exp() - b * x - 2.0, |x| x.exp() - b, 1.0, &options);
    let third = newton(f64::cos, |x| -x.sin(), 1.0, &Options { tol: 1e-10, ..options });
    let mut sum = 0.0;
    if let Some(root) = first {
        sum += root;
    }
    if let Outcome::Converged { root, iterations } = second
        && iterations > 1
    {
        sum += root * root;
    }
    sum + third.root().map_or(0.0, |r| r * a)
        + match (first, second.root()) {
            (Some(p), Some(q)) => p * q,
            _ => 0.0,
        }
}

#[test]
fn roots() {
    use crate::oracle::check;

    check!(both(a, b) at [0.7, 0.5], [1.9, 0.2]);
}
