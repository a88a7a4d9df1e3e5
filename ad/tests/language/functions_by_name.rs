//! Functions that are passed by their names, and closures without types.

use ad::{Differentiable, Real, differentiable};

use crate::oracle::{check, check_generic};

#[differentiable]
fn midpoint<F: Fn(f64) -> f64>(f: F, a: f64, b: f64) -> f64 {
    let n = 6;
    let h = (b - a) / n as f64;
    (0..n).map(|i| f(a + (i as f64 + 0.5) * h)).sum::<f64>() * h
}

#[differentiable]
fn square(x: f64) -> f64 {
    x * x
}

#[differentiable]
fn norm(xs: &[f64]) -> f64 {
    xs.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[differentiable]
fn weighted(x: f64, xs: &[f64], n: usize) -> f64 {
    x * norm(xs) * n as f64
}

mod elsewhere {
    #[ad::differentiable]
    pub fn cube(x: f64) -> f64 {
        x * x * x
    }
}

#[derive(Clone, Copy, Differentiable)]
struct Disc(f64);

#[differentiable]
impl Disc {
    fn area(self) -> f64 {
        3.0 * self.0 * self.0
    }

    fn doubled(x: f64) -> f64 {
        2.0 * x
    }
}

#[differentiable]
fn of_slices(f: impl Fn(&[f64]) -> f64, g: impl Fn(f64, &[f64], usize) -> f64, x: f64) -> f64 {
    let xs = [x, 2.0, x * x];
    f(&xs) + g(x, &xs[1..], 3)
}

#[differentiable]
fn of_discs<F>(f: &F, x: f64) -> f64
where
    F: Fn(Disc) -> f64,
{
    f(Disc(x)) + f(Disc(2.0 * x))
}

#[differentiable]
fn by_name(x: f64, y: f64) -> f64 {
    let powers = midpoint(square, x, y) + midpoint(elsewhere::cube, y, 1.0);
    let areas = of_discs(&Disc::area, x) * midpoint(Disc::doubled, 0.0, y);
    powers * midpoint(f64::sin, x, 2.0) + areas + of_slices(norm, weighted, y)
}

#[differentiable]
fn by_name_in_chains(x: f64, y: f64) -> f64 {
    [x, y, x * y].iter().copied().map(square).map(f64::sqrt).sum::<f64>()
        + Some(x).map(elsewhere::cube).unwrap_or(y)
}

#[differentiable]
fn without_types(x: f64, y: f64) -> f64 {
    let scale = |t| t * y;
    let area = midpoint(|t| t.sin() * x, 0.1, y);
    let scaled = midpoint(scale, x, 2.0);
    let of_pattern = of_discs(&|Disc(r)| r * x, y);
    let nested = midpoint(|t| t * midpoint(|s| (s * t + x).cos(), 0.0, y), 0.0, x);
    area * scaled
        + of_pattern
        + nested
        + of_slices(
            |xs| xs[0] * xs[1] + norm(xs) * x,
            |a, xs, n| a * xs.iter().sum::<f64>() + y * n as f64,
            x,
        )
}

#[differentiable]
fn generic<S: Real, F: Fn(S) -> S>(f: F, x: S) -> S {
    f(f(x) * x)
}

#[differentiable]
fn squared<S: Real>(x: S) -> S {
    x * x
}

#[differentiable]
fn generic_by_name<S: Real>(x: S, y: S) -> S {
    generic(squared::<S>, x) * generic(squared, y)
}

/// Heun's method for a system.
#[differentiable]
fn heun(f: impl Fn(f64, &[f64]) -> Vec<f64>, y0: &[f64], t1: f64, n: usize) -> Vec<f64> {
    let h = t1 / n as f64;
    let mut y = y0.to_vec();
    for i in 0..n {
        let t = i as f64 * h;
        let k1 = f(t, &y);
        let predicted: Vec<f64> = y.iter().zip(&k1).map(|(y, k)| y + h * k).collect();
        let k2 = f(t + h, &predicted);
        for j in 0..y.len() {
            y[j] += 0.5 * h * (k1[j] + k2[j]);
        }
    }
    y
}

#[differentiable]
fn driven(x: f64, y: f64) -> f64 {
    let end = heun(|t, y| vec![y[1], -x * y[0] - 0.1 * y[1] + t.sin()], &[y, 0.5], 1.5, 12);
    end[0] * end[1]
}

#[test]
fn functions_by_their_names() {
    check!(by_name(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(by_name_in_chains(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check_generic!(generic_by_name(x, y) at [1.3, 0.7], [-0.4, 1.1]);
}

#[test]
fn closures_without_types() {
    check!(without_types(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(driven(x, y) at [1.3, 0.7], [0.4, 2.1]);
}

mod setting {
    #[expect(non_upper_case_globals, reason = "a name that looks like that of a function")]
    pub const factor: f64 = 1.5;
}

#[differentiable]
fn by_another_name(x: f64, y: f64) -> f64 {
    let (f, g): (f64, f64) = (x * y, y);
    let sine = f64::sin;
    let squared: fn(f64) -> f64 = square;
    let cubed = elsewhere::cube;
    let factor = setting::factor;
    let mut sum = sine(f) * squared(g) * factor;
    for _ in 0..2 {
        sum = cubed(sum).atan() + midpoint(sine, sum, y);
    }
    sum + [x, y].iter().map(|v| squared(*v)).sum::<f64>() + [x, y].map(sine)[0]
}

#[test]
fn functions_with_another_name() {
    check!(by_another_name(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}

/// What a function of functions gives may be put into a variable that begins as a constant.
#[differentiable]
fn into_constants(x: f64, y: f64) -> f64 {
    let (mut named, mut sums) = (0.5, [0.5_f64.sin(), 0.2]);
    let mean = midpoint(square, sums[0], 1.5);
    sums[1] += mean.tanh();
    named -= midpoint(|t| t * t * t, 0.25, sums[1]);
    named * x + sums[1] * y
}

#[test]
fn functions_of_constants() {
    check!(into_constants(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}
