//! Macros of the standard library.

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
