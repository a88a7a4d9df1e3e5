//! Bindings, operators, assignments, calls.

use ad::{Real, differentiable};
use glam::{DVec3, Vec3};

use crate::oracle::{check, check_generic};

#[differentiable]
fn shadowing<S: Real>(x: S, y: S) -> S {
    let a = x * y + x;
    let x = a * a;
    let x = x - y;
    let y = {
        let x = x * y;
        x.sin()
    };
    x * y - a
}

#[differentiable]
fn destructuring<S: Real>(x: S, y: S) -> S {
    let (a, b) = (x * y, x - y);
    let (c, (d, _)) = (b, (a * b, x));
    let [e, f] = [c * d, d];
    let (g, ..) = (e, f, a);
    g + e * f
}

#[differentiable]
fn operators(x: f64, y: f64) -> f64 {
    let a = 2.0 * x - y / 3.0;
    let b = -(a * x) + 1.0 / y;
    let c = (x + 10.0) % (y + 1.0);
    -b * -a + c * c
}

#[differentiable]
fn compound_assignment(mut x: f64, y: f64) -> f64 {
    let mut a = x;
    a += y * a;
    a -= x * x;
    a *= a + y;
    a /= y;
    x += a;
    a %= 3.0;
    x *= 2.0;
    a * x
}

#[differentiable]
fn self_update(x: f64) -> f64 {
    let mut a = x;
    a *= a;
    a += a;
    a /= a + 1.0;
    a -= a * a;
    a
}

#[differentiable]
fn comparison_values(x: f64, y: f64) -> f64 {
    let greater = x > y;
    let mut sign = 1.0;
    let both = greater && y > 0.5 || x == 7.0;
    if both {
        sign = x;
    }
    let neither = !greater;
    if neither { sign * y } else { sign * x }
}

#[differentiable]
fn square<S: Real>(x: S) -> S {
    x * x
}

#[differentiable]
fn pair<S: Real>(x: S, y: S) -> (S, S) {
    (x * y, square(x) - y)
}

#[differentiable]
fn calls<S: Real>(x: S, y: S) -> S {
    let (a, b) = pair(square(x), y);
    let c = self::square(a);
    let (d, e) = pair::<S>(b, c * S::from_f64(0.1));
    d * e.sin() + square(S::TWO)
}

#[differentiable]
fn methods<S: Real>(x: S, y: S) -> S {
    x.sin().mul_add(y, x.max(y)).abs().sqrt() + S::atan2(x, y) + (x * S::HALF).exp()
}

#[differentiable]
fn associated_functions(x: f64, y: f64) -> f64 {
    f64::max(x, y) * f64::powi(x, 3) + 2.0_f64.powf(y) + std::f64::consts::PI * x.powf(2.5)
}

#[differentiable]
fn by_reference(x: &f64, y: &f64) -> f64 {
    *x * *y + (*x).sin()
}

#[differentiable]
fn passes_references(x: f64, y: f64) -> f64 {
    let local = x * y;
    let mut changing = local;
    let first = by_reference(&changing, &y);
    changing = first * x;
    let reference = &local;
    first * by_reference(reference, &(changing + x)) + by_reference(&2.0, &x)
}

#[differentiable]
fn annotated(x: f32, y: f64) -> f64 {
    let a: f64 = 2.0;
    let b: f32 = x * 3.0;
    let (c, k): (f64, usize) = (b as f64 * a, 2);
    c * y + k as f64 * y
}

#[differentiable]
fn integers(x: f64, n: usize) -> f64 {
    let mut k = n;
    k = k * 2 + 1;
    k -= 1;
    k /= 2;
    let mut j = -3;
    j = -j % 2;
    let half = (n << 1) >> 2;
    let scale: i32 = 3 * (n as i32);
    x * x * k as f64 + x * j as f64 + x * half as f64 * scale as f64
}

#[differentiable]
fn expression_blocks(x: f64, y: f64) -> f64 {
    let a = {
        let t = x + y;
        t * t
    };
    {
        let a = 5.0 * y;
        let _ = a;
    }
    (if x > y { a } else { -a }) * { y }
}

#[differentiable]
fn glam_vectors(x: f64, y: f64) -> f64 {
    let v = DVec3::new(x, y, x * y);
    let mut w = 2.0 * v + DVec3::splat(y);
    w.x *= x;
    w += v.cross(w);
    w[1] = w[2] * y;
    w /= x;
    let u = (w - v).normalize();
    u.dot(v) + w.length() + u.reflect(v.normalize()).x
}

#[differentiable]
fn single_precision(v: Vec3, s: f32) -> f32 {
    let c = 0.5;
    let w = v * s + Vec3::new(1.0, s, c);
    w.normalize().dot(v) * c
}

#[test]
fn bindings() {
    check_generic!(shadowing(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check_generic!(destructuring(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(expression_blocks(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn arithmetic() {
    check!(operators(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(compound_assignment(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(comparison_values(x, y) at [1.3, 0.7], [1.3, 0.4], [-0.4, 2.1]);
    for x in [0.3, -1.7] {
        let slope = ad::check::derivative(self_update, x, 1e-3).value;
        crate::oracle::assert_close("self_update", self_update::grad(x), slope, 1e-9);
    }
}

#[test]
fn integers_carry_no_derivative() {
    for n in [0, 3, 6] {
        let (value, (slope, ())) = integers::value_and_grad(0.7, n);
        assert_eq!(value, integers(0.7, n));
        let expected = ad::check::derivative(|x| integers(x, n), 0.7, 1e-3).value;
        crate::oracle::assert_close("integers", slope, expected, 1e-9);
    }
}

#[test]
fn function_calls() {
    check_generic!(calls(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check_generic!(methods(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(associated_functions(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(passes_references(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn mixed_types() {
    let (value, (to_x, to_y)) = annotated::value_and_grad(1.5, 0.7);
    assert_eq!((value, to_x, to_y), (annotated(1.5, 0.7), 4.2, 11.0));
    check!(glam_vectors(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn single_precision_vectors() {
    let (v, s) = (Vec3::new(0.3, -0.8, 1.1), 0.7_f32);
    let (value, (to_v, to_s)) = single_precision::value_and_grad(v, s);
    assert_eq!(value.to_bits(), single_precision(v, s).to_bits());
    let reference = |x: &[f64]| {
        let v = DVec3::new(x[0], x[1], x[2]);
        let w = v * x[3] + DVec3::new(1.0, x[3], 0.5);
        w.normalize().dot(v) * 0.5
    };
    let point = [v.x, v.y, v.z, s].map(f64::from);
    let expected = ad::check::gradient(reference, &point, 1e-3);
    for (got, expected) in [to_v.x, to_v.y, to_v.z, to_s].into_iter().zip(expected) {
        crate::oracle::assert_close("single_precision", got.into(), expected.value, 1e-5);
    }
}

#[derive(Clone, Copy, ad::Differentiable)]
struct Pair {
    left: f64,
    right: f64,
}

#[differentiable]
fn several_places(x: f64, y: f64) -> f64 {
    const STEPS: usize = 4;
    let (mut a, mut b) = (x, y);
    let mut state = [x, 0.0];
    for _ in 0..STEPS {
        (a, b) = (b, a * 0.5 + b);
        [state[1], state[0]] = state;
    }
    let mut rest = 0.0;
    (_, (rest, state[0])) = (a, (rest + b, a * state[1]));
    Pair { left: a, right: state[1] } = Pair { left: rest, right: state[0] * y };
    fn unrelated() -> [f64; STEPS] {
        [2.0; STEPS]
    }
    a * b + state[0] * state[1] + rest * unrelated()[0]
}

/// What is printed carries no derivative.
#[differentiable]
fn reporting(x: f64) -> Result<f64, String> {
    if x < -100.0 {
        println!("{x} is very small");
        let what = "very small";
        eprintln!("{} is {what} {count}", x, count = 2.0 * x);
    }
    if x < 0.0 { Err(format!("{x:.1} is negative")) } else { Ok(x.sqrt()) }
}

#[test]
fn assignments_and_items() {
    check!(several_places(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    let (value, pullback) = reporting::vjp(4.0);
    assert_eq!((value, pullback((1.0, ()))), (Ok(2.0), 0.25));
    let (value, pullback) = reporting::vjp(-4.0);
    assert_eq!((value, pullback((1.0, ()))), (Err("-4.0 is negative".to_owned()), 0.0));
}
