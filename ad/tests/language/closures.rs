//! Closures that have a name and are called.

use ad::{Real, differentiable};

use crate::oracle::{check, check_generic};

#[differentiable]
fn called<S: Real>(x: S, y: S) -> S {
    let square = |t: S| t * t;
    let scaled = |t| {
        let u = t + y;
        u * x
    };
    square(x * y) + scaled(square(y)) - scaled(x)
}

#[differentiable]
fn exits_of_its_own(x: f64, y: f64) -> f64 {
    let clipped = |t: f64| -> f64 {
        if t < 0.0 {
            return y * 0.1;
        }
        for i in 0..5 {
            if t * i as f64 > 3.0 {
                return t * t * i as f64;
            }
        }
        t
    };
    clipped(x) + clipped(x * y) * clipped(-y)
}

#[differentiable]
fn half(x: f64) -> Option<f64> {
    if x > 1.0 { Some(x * 0.5) } else { None }
}

#[differentiable]
fn question_mark_in_closure(x: f64, y: f64) -> f64 {
    let quarter = |t| Some(half(half(t)?)? * y);
    match (quarter(x), quarter(y)) {
        (Some(a), Some(b)) => a * b,
        (Some(a), None) => a,
        _ => x * y,
    }
}

#[differentiable]
fn in_loops(x: f64, y: f64) -> f64 {
    let mut state = [x, y, 1.0];
    let step = |a: f64, b: f64, dt: f64| (a + dt * b, b - dt * (a * y).sin());
    for i in 0..6 {
        let (a, b) = step(state[0], state[1], 0.1 + 0.05 * i as f64);
        state = [a, b, state[2] + a * b];
    }
    let sum = |values: &[f64; 3]| values[0] + values[1] * values[2];
    sum(&state)
}

#[differentiable]
fn function_names(x: f64, y: f64) -> f64 {
    let twice = |t| t + t;
    let sines: f64 = [x, y, x * y].iter().copied().map(f64::sin).sum();
    let halves: f64 = [x, y].into_iter().map(twice).map(|t| t * y).sum();
    sines * halves
}

#[differentiable]
fn in_conditions(target: f64, y: f64) -> f64 {
    let f = |x: f64| x * x * y - target;
    let (mut low, mut high) = (0.0, 4.0);
    while f(high) > 0.5 && high - low > 0.3 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 {
            high = middle * y;
        } else {
            low = middle + 0.01 * target;
        }
    }
    let index = |k: usize| k % 2;
    [low, high][index(3)] + f(low) * f(high)
}

#[differentiable]
fn contents(x: f64, y: f64) -> f64 {
    let nearest = [x, y, x * y].iter().map(|t| (t - 1.0) * (t - 1.0)).min_by(|a, b| a.total_cmp(b));
    let a = half(y).unwrap_or(x * x);
    nearest.unwrap() * a + half(x + 10.0).expect("it is large") * half(-1.0).unwrap_or(y)
}

#[differentiable]
fn closures_in_closures(x: f64, y: f64) -> f64 {
    let inner = |t: f64| t * y;
    let outer = |t: f64| {
        let y = t + 1.0;
        let again = |u: f64| inner(u) + y;
        again(t) * again(x)
    };
    let x = outer(x);
    outer(x) + inner(x)
}

#[test]
fn closures() {
    check_generic!(called(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(exits_of_its_own(x, y) at [1.3, 0.7], [-0.4, 2.1], [4.0, -3.2], [0.2, 0.3]);
    check!(question_mark_in_closure(x, y) at [5.0, 6.0], [5.0, 1.1], [1.1, 5.0]);
    check!(in_conditions(x, y) at [1.3, 0.7], [2.4, 0.9], [0.2, 0.5]);
    check!(contents(x, y) at [1.3, 0.7], [-0.4, 2.1], [1.6, 2.3]);
    check!(in_loops(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(function_names(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(closures_in_closures(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
