//! Macros of the standard library, and of others where their values are not differentiated.

#![allow(clippy::neg_cmp_op_on_partial_ord, reason = "what a macro expands to")]

use ad::differentiable;

use crate::oracle::check;

#[differentiable]
fn checked(x: f64, y: f64) -> f64 {
    assert!(x * y < 100.0);
    let limit = 50.0;
    let mut a = x * y;
    assert!(a < limit, "{a} of {x:.3} exceeds {limit:>width$}", width = 5);
    debug_assert!(!a.is_nan(), "not a number at {}, {:?}", x, y);
    a *= a;
    assert_eq!(a, a + 0.0, "a is {a}");
    std::assert_ne!(a, -1.0);
    a * y
}

#[differentiable]
fn diverging_arms(x: f64, n: usize) -> f64 {
    if n > 9 {
        panic!("{n} is too large");
    }
    let a = match n {
        0 => x,
        1..=4 => x * x,
        5 => unreachable!("five, at {x}"),
        _ => {
            if x < 0.0 {
                panic!();
            }
            x.sqrt()
        }
    };
    let Some(b) = positive(a) else { panic!("negative: {a}") };
    if b > 1e6 { panic!("{b}") } else { b * x }
}

#[differentiable]
fn positive(x: f64) -> Option<f64> {
    if x > 0.0 { Some(x * x) } else { None }
}

#[differentiable]
fn matching(x: f64, y: f64, n: usize) -> f64 {
    let mut a = x;
    if matches!(n, 1 | 3..=5) {
        a *= y;
    }
    let large = matches!(positive(x), Some(s) if s > y && n != 4);
    if large || matches!((n, x > y), (k, true) if k > 2) { a * x } else { a }
}

#[differentiable]
fn shown(x: f64, y: f64) -> f64 {
    let a = dbg!(x * y) + y;
    dbg!(a * a)
}

#[test]
fn macros() {
    check!(checked(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(shown(x, y) at [1.3, 0.7]);
    for n in 0..8 {
        for (x, y) in [(1.3, 0.7), (0.4, 2.1)] {
            let (value, (to_x, to_y, ())) = matching::value_and_grad(x, y, n);
            assert_eq!(value, matching(x, y, n));
            let primal = |p: &[f64]| matching(p[0], p[1], n);
            crate::oracle::assert_gradient("matching", primal, &[x, y], &[to_x, to_y]);
        }
        if n != 5 {
            let (value, (slope, ())) = diverging_arms::value_and_grad(0.7, n);
            assert_eq!(value, diverging_arms(0.7, n));
            let expected = ad::check::derivative(|x| diverging_arms(x, n), 0.7, 1e-3).value;
            crate::oracle::assert_close("diverging_arms", slope, expected, 1e-9);
        }
    }
}

macro_rules! near {
    ($a:expr, $b:expr $(, within = $error:expr)?) => {
        ($a - $b).abs() <= 1e-12 $(+ $error)?
    };
}

macro_rules! places {
    ($x:expr) => {
        if $x > 1.0 { 2 } else { 1 }
    };
}

/// Macros in conditions, in an index and under integers, of variables that change.
#[differentiable]
fn compared(mut x: f64, y: f64) -> f64 {
    let powers = [1.0, y, y * y];
    if near!(x, y, within = 0.01 * y) || !near!(x * y, 1.0) && x > 3.0 {
        return x * y * y;
    }
    let starts_near: bool = near!(x, 1.0, within = 0.5);
    let place: usize = places!(x * y);
    while !near!(x, 4.0, within = y.abs() * 0.25) {
        x = 0.5 * (x + 4.0);
    }
    if starts_near { x * powers[place] } else { powers[places!(x)] * x * x }
}

/// By a `&mut` that is put into the macro.
#[differentiable]
fn converges(x: &mut f64, next: f64) -> bool {
    let has_converged: bool = near!(*x, next);
    *x = next;
    has_converged
}

#[differentiable]
fn square_root(of: f64) -> f64 {
    let mut x = 1.0;
    loop {
        let next = 0.5 * (x + of / x);
        if converges(&mut x, next) {
            return x;
        }
    }
}

#[test]
fn macros_choose() {
    check!(compared(x, y) at [1.3, 0.4], [0.7, -1.1], [0.6, 1.9], [1.2, 1.2], [5.0, 0.9]);
    for of in [0.3, 2.0, 7.0] {
        let slope = square_root::grad(of);
        crate::oracle::assert_close("square_root", slope, 0.5 / f64::sqrt(of), 1e-12);
    }
}

/// What a function panics with.
fn panic_of<T: std::fmt::Debug>(f: impl FnOnce() -> T + std::panic::UnwindSafe) -> String {
    let payload = std::panic::catch_unwind(f).expect_err("it panics");
    match payload.downcast::<String>() {
        Ok(message) => *message,
        Err(payload) => payload.downcast_ref::<&str>().expect("a message").to_string(),
    }
}

#[test]
fn panics_are_those_of_the_function() {
    for (x, n) in [(0.7, 12), (0.7, 5), (-0.7, 0), (-0.5, 7), (2000.0, 1)] {
        let expected = panic_of(move || diverging_arms(x, n));
        assert_eq!(panic_of(move || diverging_arms::grad(x, n)), expected);
    }
    let expected = panic_of(|| checked(8.0, 9.0));
    assert_eq!(panic_of(|| checked::grad(8.0, 9.0)), expected);
    assert!(expected.contains("72 of 8.000 exceeds    50"));
}
