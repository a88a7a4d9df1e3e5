//! Comparison of a generated gradient with finite differences, with dual numbers and with a tape.

use ad::Dual;
use ad::tape::Var;

/// The first step of the finite differences. Points of evaluation lie farther from any branch.
pub const STEP: f64 = 1e-3;

/// The largest relative error away from kinks.
pub const TOLERANCE: f64 = 1e-7;

/// Below this size the error is measured absolutely: rounding in the function value leaves no more
/// digits of a smaller derivative.
const FLOOR: f64 = 1e-2;

#[track_caller]
pub fn assert_close(what: &str, got: f64, expected: f64, tolerance: f64) {
    let error = (got - expected).abs() / expected.abs().max(FLOOR);
    assert!(error <= tolerance, "{what}: got {got:e}, expected {expected:e}, off by {error:e}");
}

/// Asserts that `gradient` holds the derivatives of `f` at `x`.
#[track_caller]
pub fn assert_gradient(what: &str, f: impl FnMut(&[f64]) -> f64, x: &[f64], gradient: &[f64]) {
    assert_eq!(x.len(), gradient.len(), "{what}: the gradient has another length");
    let estimates = ad::check::gradient(f, x, STEP);
    for (i, (&got, expected)) in gradient.iter().zip(estimates).enumerate() {
        let what = format!("{what} at {x:?}, by parameter {i}, against finite differences");
        assert_close(&what, got, expected.value, TOLERANCE);
    }
}

/// Asserts that `gradient` holds what dual numbers give for `f` at `x`.
#[track_caller]
pub fn assert_dual_gradient(
    what: &str,
    f: impl Fn(&[Dual<f64>]) -> Dual<f64>,
    x: &[f64],
    gradient: &[f64],
) {
    for (i, &got) in gradient.iter().enumerate() {
        let point: Vec<_> = x
            .iter()
            .enumerate()
            .map(|(k, &value)| Dual::new(value, if k == i { 1.0 } else { 0.0 }))
            .collect();
        let what = format!("{what} at {x:?}, by parameter {i}, against dual numbers");
        assert_close(&what, got, f(&point).derivative, 1e-12);
    }
}

/// Asserts that `gradient` holds what a tape gives for `f` at `x`.
#[track_caller]
pub fn assert_tape_gradient(what: &str, f: impl Fn(&[Var]) -> Var, x: &[f64], gradient: &[f64]) {
    let (_, taped) = ad::tape::gradient(f, x);
    for (i, (&got, taped)) in gradient.iter().zip(taped).enumerate() {
        let what = format!("{what} at {x:?}, by parameter {i}, against a tape");
        assert_close(&what, got, taped, 1e-12);
    }
}

/// Asserts that `forward`, a function of point and direction, gives the value and the products of
/// the gradient with directions: each coordinate, and one across.
#[track_caller]
pub fn assert_forward(
    what: &str,
    forward: impl Fn(&[f64], &[f64]) -> (f64, f64),
    x: &[f64],
    value: f64,
    gradient: &[f64],
) {
    let unit = |i: usize| (0..x.len()).map(|k| if k == i { 1.0 } else { 0.0 }).collect();
    let across = (0..x.len()).map(|k| 0.7 - 1.3 * (k as f64).sin()).collect();
    let directions = (0..x.len()).map(unit).chain([across]).collect::<Vec<Vec<f64>>>();
    for direction in directions {
        let (pushed_value, pushed) = forward(x, &direction);
        let what = format!("{what} at {x:?}, forward along {direction:?}");
        assert_eq!(pushed_value.to_bits(), value.to_bits(), "{what}: the value");
        let products = gradient.iter().zip(&direction).filter(|(_, d)| **d != 0.0);
        let expected = products.map(|(g, d)| g * d).sum::<f64>();
        assert_close(&what, pushed, expected, 1e-10);
    }
}

/// Checks the gradient of a function of `f64`s at each of several points: the value bit for bit,
/// each derivative against finite differences.
macro_rules! check_reverse {
    ($f:ident($($x:ident),+) at $([$($value:expr),+]),+ $(,)?) => {
        for point in [$([$($value as f64),+]),+] {
            let [$($x),+] = point;
            let (value, gradient) = $f::value_and_grad($($x),+);
            let ($($x),+) = gradient;
            let gradient = [$($x),+];
            let primal = |x: &[f64]| {
                let [$($x),+] = *x else { unreachable!() };
                $f($($x),+)
            };
            let bits = |value: f64| value.to_bits();
            assert_eq!(bits(value), bits(primal(&point)), "{} at {point:?}", stringify!($f));
            $crate::oracle::assert_gradient(stringify!($f), primal, &point, &gradient);
        }
    };
}

/// Checks gradients and forward modes of functions of one slice or array.
macro_rules! check_list {
    ($($f:ident),+ at $x:expr) => {$(
        let x: &[f64] = &$x;
        let primal = |x: &[f64]| $f(x.try_into().unwrap());
        let (value, gradient) = $f::value_and_grad(x.try_into().unwrap());
        assert_eq!(value.to_bits(), primal(x).to_bits(), stringify!($f));
        $crate::oracle::assert_gradient(stringify!($f), primal, x, &gradient);
        let forward =
            |x: &[f64], d: &[f64]| $f::jvp(x.try_into().unwrap(), d.try_into().unwrap());
        $crate::oracle::assert_forward(stringify!($f), forward, x, value, &gradient);
    )+};
}

/// [`check_reverse`], and the same for forward mode.
macro_rules! check {
    ($f:ident($($x:ident),+) at $([$($value:expr),+]),+ $(,)?) => {
        $crate::oracle::check_reverse!($f($($x),+) at $([$($value),+]),+);
        for point in [$([$($value as f64),+]),+] {
            let [$($x),+] = point;
            let (value, gradient) = $f::value_and_grad($($x),+);
            let ($($x),+) = gradient;
            let gradient = [$($x),+];
            let forward = |x: &[f64], direction: &[f64]| {
                let [$($x),+] = *x else { unreachable!() };
                let mut direction = direction.iter().copied();
                $f::jvp($($x,)+ $({ let $x = direction.next().unwrap(); $x }),+)
            };
            $crate::oracle::assert_forward(stringify!($f), forward, &point, value, &gradient);
        }
    };
}

/// [`check`] of a function generic over `S: Real`, which runs on dual numbers too, and in single
/// precision.
macro_rules! check_generic_reverse {
    ($f:ident($($x:ident),+) at $([$($value:expr),+]),+ $(,)?) => {
        for point in [$([$($value as f64),+]),+] {
            let name = stringify!($f);
            let [$($x),+] = point;
            let (value, gradient) = $f::value_and_grad::<f64>($($x),+);
            let ($($x),+) = gradient;
            let gradient = [$($x),+];
            let primal = |x: &[f64]| {
                let [$($x),+] = *x else { unreachable!() };
                $f::<f64>($($x),+)
            };
            assert_eq!(value.to_bits(), primal(&point).to_bits(), "{name} at {point:?}");
            $crate::oracle::assert_gradient(name, primal, &point, &gradient);

            let dual = |x: &[ad::Dual<f64>]| {
                let [$($x),+] = *x else { unreachable!() };
                $f::<ad::Dual<f64>>($($x),+)
            };
            $crate::oracle::assert_dual_gradient(name, dual, &point, &gradient);

            let tape = |x: &[ad::tape::Var]| {
                let [$($x),+] = *x else { unreachable!() };
                $f::<ad::tape::Var>($($x),+)
            };
            $crate::oracle::assert_tape_gradient(name, tape, &point, &gradient);

            let [$($x),+] = point.map(|x| x as f32);
            let (value, single) = $f::value_and_grad::<f32>($($x),+);
            assert_eq!(value.to_bits(), $f::<f32>($($x),+).to_bits(), "{name} at {point:?}");
            let ($($x),+) = single;
            for (single, double) in [$($x),+].into_iter().zip(gradient) {
                let what = format!("{name} at {point:?} in single precision");
                $crate::oracle::assert_close(&what, f64::from(single), double, 1e-4);
            }
        }
    };
}

/// [`check_generic_reverse`], and the same for forward mode.
macro_rules! check_generic {
    ($f:ident($($x:ident),+) at $([$($value:expr),+]),+ $(,)?) => {
        $crate::oracle::check_generic_reverse!($f($($x),+) at $([$($value),+]),+);
        for point in [$([$($value as f64),+]),+] {
            let name = stringify!($f);
            let [$($x),+] = point;
            let (value, gradient) = $f::value_and_grad::<f64>($($x),+);
            let ($($x),+) = gradient;
            let gradient = [$($x),+];
            let forward = |x: &[f64], direction: &[f64]| {
                let [$($x),+] = *x else { unreachable!() };
                let mut direction = direction.iter().copied();
                $f::jvp::<f64>($($x,)+ $({ let $x = direction.next().unwrap(); $x }),+)
            };
            $crate::oracle::assert_forward(name, forward, &point, value, &gradient);
        }
    };
}

pub(crate) use {check, check_generic, check_generic_reverse, check_list, check_reverse};
