//! Closures that are passed to functions.

use ad::{Differentiable, Real, differentiable};

use crate::oracle::{assert_forward, assert_gradient, check, check_generic};

/// Simpson's rule.
#[differentiable]
fn integrate<F: Fn(f64) -> f64>(f: F, a: f64, b: f64) -> f64 {
    let n = 8;
    let h = (b - a) / n as f64;
    let mut total = f(a) + f(b);
    for i in 1..n {
        let weight = if i % 2 == 1 { 4.0 } else { 2.0 };
        total += weight * f(a + i as f64 * h);
    }
    total * h / 3.0
}

#[differentiable]
fn captured_numbers(x: f64, y: f64) -> f64 {
    let f = |t: f64| (t * x).sin() + y * t;
    let area = integrate(f, 0.1 * y, x);
    let scale = 2.0 * x;
    area * integrate(|t: f64| t * scale * area, x, y) + integrate(f, 0.0, 1.0)
}

#[differentiable]
fn newton(f: impl Fn(f64) -> (f64, f64), start: f64) -> f64 {
    let mut x = start;
    while f(x).0.abs() > 1e-13 {
        let (value, slope) = f(x);
        x -= value / slope;
    }
    x
}

#[differentiable]
fn roots(x: f64, y: f64) -> f64 {
    newton(|t: f64| (t * t * t + x * t - y, 3.0 * t * t + x), 1.0)
}

/// One Runge-Kutta step of a system of any size.
#[differentiable]
fn step<F>(f: &F, t: f64, state: &[f64], dt: f64) -> Vec<f64>
where
    F: Fn(f64, &[f64]) -> Vec<f64>,
{
    let k1 = f(t, state);
    let middle: Vec<f64> = state.iter().zip(&k1).map(|(s, k)| s + 0.5 * dt * k).collect();
    let k2 = f(t + 0.5 * dt, &middle);
    state.iter().zip(&k2).map(|(s, k)| s + dt * k).collect()
}

#[differentiable]
fn solve<F: Fn(f64, &[f64]) -> Vec<f64>>(f: F, start: &[f64], dt: f64, n: usize) -> Vec<f64> {
    let mut state = start.to_vec();
    for i in 0..n {
        state = step(&f, i as f64 * dt, &state, dt);
    }
    state
}

#[differentiable]
fn oscillator(x: f64, y: f64) -> f64 {
    let forces = [x * y, 0.3];
    let end = solve(
        |t: f64, state: &[f64]| vec![state[1], -forces[0] * state[0] + forces[1] * t.cos()],
        &[x, y],
        0.1,
        12,
    );
    end[0] * end[1]
}

#[derive(Clone, Differentiable)]
struct Spline {
    knots: Vec<f64>,
    scale: f64,
}

#[differentiable]
impl Spline {
    fn apply(&self, x: f64, warp: impl Fn(f64) -> f64 + Copy) -> f64 {
        let mut sum = 0.0;
        for (i, knot) in self.knots.iter().enumerate() {
            sum += warp(*knot) * x.powi(i as i32);
        }
        sum * self.scale
    }
}

#[differentiable]
fn of_methods(spline: &Spline, weights: &[f64; 2], y: f64, n: usize) -> f64 {
    let shift = |t: f64| t - weights[1];
    let value = spline.apply(y, |t: f64| shift(t) * weights[0] + n as f64 * y);
    value * integrate(|t: f64| spline.apply(t, |u: f64| u * t), 0.0, 1.0)
}

#[differentiable]
fn passed_on<F: Fn(f64) -> f64, G: Fn(f64, f64) -> f64>(f: F, g: G, x: f64) -> f64
where
    F: Copy,
{
    if x < 0.0 {
        return g(x, f(-x));
    }
    integrate(f, 0.0, x) + integrate(|t: f64| f(t) * g(t, x), 0.0, 1.0) + twice(&f, x)
}

#[differentiable]
fn twice<F: Fn(f64) -> f64>(f: &F, x: f64) -> f64 {
    f(f(x))
}

#[differentiable]
fn outermost(x: f64, y: f64) -> f64 {
    passed_on(|t: f64| t * t * y, |a: f64, b: f64| (a - b * y).sin(), x)
}

#[differentiable]
fn generic<S: Real, F: Fn(S) -> S>(f: F, x: S) -> S {
    f(f(x) * x)
}

#[differentiable]
fn generic_call<S: Real>(x: S, y: S) -> S {
    generic(|t: S| (t * y).sin() + x, y)
}

#[differentiable]
fn within_loops(x: f64, y: f64) -> f64 {
    let mut a = x;
    let rates = [x, y, 0.5];
    for (i, rate) in rates.iter().enumerate() {
        a += integrate(|t: f64| t * *rate + a * i as f64, 0.0, y);
        let old = a;
        let change = move |t: f64| t * old;
        a *= 0.3;
        a += integrate(change, 0.0, 0.5);
    }
    a
}

#[differentiable]
fn exits_within<F: Fn(usize, f64) -> Option<f64>>(f: F, x: f64) -> Option<f64> {
    let mut total = 0.0;
    for i in 0..4 {
        total += f(i, x)?;
    }
    Some(total)
}

#[differentiable]
fn partial(x: f64, y: f64) -> f64 {
    let limit = 2.0;
    let f = |i: usize, t: f64| -> Option<f64> {
        if t * i as f64 > limit {
            return None;
        }
        Some(t * y)
    };
    exits_within(f, x).unwrap_or(y * y) + exits_within(f, y).unwrap_or(x)
}

#[differentiable]
fn nothing_captured(x: f64, y: f64) -> f64 {
    integrate(|t: f64| t.exp(), x, y) + constant_of(|| x * y) * integrate(|_: f64| 2.0, x, y)
}

#[differentiable]
fn constant_of(f: impl Fn() -> f64) -> f64 {
    f() * f()
}

#[differentiable]
fn recursive<F: Fn(f64) -> f64 + Copy>(f: F, a: f64, b: f64, depth: usize) -> f64 {
    let middle = 0.5 * (a + b);
    if depth == 0 || (f(a) - f(b)).abs() < 1e-3 {
        return (b - a) * f(middle);
    }
    recursive(f, a, middle, depth - 1) + recursive(f, middle, b, depth - 1)
}

#[differentiable]
fn adaptive(x: f64, y: f64) -> f64 {
    recursive(|t: f64| (x * t * t).sin() * y, 0.0, y, 5)
}

/// Functions that are passed where no derivative flows back.
#[differentiable]
fn unused<F: Fn(f64) -> f64 + Copy>(f: &F, x: f64, y: f64) -> f64 {
    let g = |t: f64| t * y;
    let _ = twice(&g, x) + twice(f, y) + integrate(*f, x, y);
    let mut sum = twice(f, x);
    #[differentiable(checkpoint)]
    for i in 0..3 {
        let h = |t: f64| (t + y * i as f64).sin();
        let unread = twice(&h, sum);
        if unread > 10.0 {
            break;
        }
        sum += twice(&h, x) * integrate(h, 0.0, y);
    }
    sum
}

#[differentiable]
fn uses_unused(x: f64, y: f64) -> f64 {
    unused(&|t: f64| t * t * x, x, y)
}

/// The types of the closure's parameters tell neither `N` nor `L`.
#[differentiable]
fn column_sums<const N: usize, L, T>(rows: &[[f64; N]], _weight: L, of: &T) -> [f64; N]
where
    L: Real + Into<f64>,
    T: Fn(f64) -> f64,
{
    let mut sums = [0.0; N];
    for row in rows {
        for (sum, element) in sums.iter_mut().zip(row) {
            *sum += of(*element);
        }
    }
    sums
}

/// They tell `S`.
#[differentiable]
fn first_of<S: Real, const N: usize>(all: &[S; N], of: impl Fn(S) -> S) -> S
where
    [S; N]: Clone,
{
    of(all[0]) * all[1]
}

#[differentiable]
fn sized(x: f64, y: f64) -> f64 {
    let sums = column_sums(&[[x, y], [y, x * y]], x, &|t| t * t * x);
    sums[0] * sums[1] + first_of(&[x, y], |t| t * y)
}

#[test]
fn closures_as_arguments() {
    check!(sized(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(uses_unused(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(captured_numbers(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(roots(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(oscillator(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(outermost(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(within_loops(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(partial(x, y) at [0.3, 0.7], [0.9, 0.4], [0.4, 2.1]);
    check!(nothing_captured(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(adaptive(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check_generic!(generic_call(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// The value takes a closure that changes what it captures; its derivative takes one that does not.
#[differentiable]
fn stepped<F: FnMut(f64, usize) -> f64>(start: f64, steps: usize, mut step: F) -> f64 {
    let mut x = start;
    for i in 0..steps {
        x = step(x, i);
        if step(x, i) > 20.0 {
            break;
        }
    }
    x
}

#[differentiable]
fn once(f: impl FnOnce(f64) -> f64, x: f64) -> f64 {
    f(x) * x
}

#[differentiable]
fn twice_stepped(mut f: impl FnMut(f64) -> f64, x: f64) -> f64 {
    let first = stepped(x, 2, |x, i| f(x) + i as f64);
    first * f(x)
}

#[differentiable]
fn mutable_functions(x: f64, y: f64) -> f64 {
    let step = |t: f64| t * y + x;
    stepped(x, 3, |t, i| t * y + i as f64 * x) + once(step, y) * once(f64::sin, x)
        - twice_stepped(step, y)
}

#[test]
fn functions_by_other_bounds() {
    check!(mutable_functions(x, y) at [1.3, 0.7], [-0.4, 2.1], [4.0, 3.0]);
    let mut calls = 0;
    let counted = stepped(1.0, 3, |t, _| {
        calls += 1;
        2.0 * t
    });
    assert_eq!((counted, calls), (8.0, 6));
}

#[test]
fn captured_structs() {
    let primal = |p: &[f64]| {
        let spline = Spline { knots: p[..3].to_vec(), scale: p[3] };
        of_methods(&spline, &[p[4], p[5]], p[6], 2)
    };
    let point = [0.4, -1.2, 0.7, 1.5, 0.9, 0.3, 1.1];
    let spline = Spline { knots: point[..3].to_vec(), scale: point[3] };
    let (by_spline, by_weights, by_y, ()) = of_methods::grad(&spline, &[0.9, 0.3], 1.1, 2);
    let gradient = [&by_spline.knots[..], &[by_spline.scale], &by_weights, &[by_y]].concat();
    assert_gradient("of_methods", primal, &point, &gradient);
    let forward = |p: &[f64], d: &[f64]| {
        let spline = |p: &[f64]| Spline { knots: p[..3].to_vec(), scale: p[3] };
        let (along, [a, b, y]) = (spline(d), [d[4], d[5], d[6]]);
        let along = SplineTangent { knots: along.knots, scale: along.scale };
        of_methods::jvp(&spline(p), &[p[4], p[5]], p[6], 2, &along, &[a, b], y, ())
    };
    assert_forward("of_methods", forward, &point, primal(&point), &gradient);
}
