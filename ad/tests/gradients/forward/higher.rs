//! Jacobians, Hessians, checks; rules by hand without a forward mode.

#![allow(clippy::needless_range_loop, clippy::type_complexity, reason = "rows and columns, rules")]

use ad::check::{assert_forward, worst_forward};
use ad::{
    Differentiable, Real, differentiable, hessian, hvp, jacobian, jacobian_forward,
    jacobian_reverse,
};
use glam::DVec3;

#[differentiable]
fn mixed<S: Real>(x: &[S], y: S) -> S {
    let mut product = y;
    for i in 0..x.len() {
        product = product * x[i].sin() + x[i] * x[i];
    }
    product
}

fn gradient<S: Real>(x: Vec<S>, y: S) -> (Vec<S>, S) {
    mixed::grad(&x, y)
}

/// What is left over of a vector is not the direction of what stands behind it.
#[test]
#[should_panic(expected = "the direction has as many coordinates as the point")]
fn directions_of_another_length() {
    hvp(gradient, (vec![0.3, -0.7], 0.4), (vec![1.0], 5.0));
}

#[test]
fn hessians() {
    let (x, y) = (vec![0.3, -0.7, 1.1], 0.4);
    let full = hessian(gradient, (x.clone(), y));
    for i in 0..4 {
        for j in 0..4 {
            assert!((full[i][j] - full[j][i]).abs() < 1e-14);
        }
    }
    let direction = (vec![0.5, 2.0, -1.0], 3.0);
    let ((by_x, by_y), (product, along_y)) = hvp(gradient, (x.clone(), y), direction);
    assert_eq!((by_x, by_y), mixed::grad(&x, y));
    let direction = [0.5, 2.0, -1.0, 3.0];
    let along = |row: &Vec<f64>| row.iter().zip(direction).map(|(h, d)| h * d).sum::<f64>();
    let expected: Vec<f64> = full.iter().map(along).collect();
    for (got, expected) in product.into_iter().chain([along_y]).zip(expected) {
        let got: f64 = got;
        assert!((got - expected).abs() < 1e-13);
    }
    for j in 0..3 {
        let slope = ad::check::derivative(
            |value| {
                let mut x = x.clone();
                x[j] = value;
                mixed::grad(&x, y).0[1]
            },
            x[j],
            1e-2,
        );
        assert!((slope.value - full[1][j]).abs() < 1e-9);
    }
}

#[differentiable]
fn curve(t: f64, scale: DVec3, n: usize) -> (DVec3, f64) {
    let mut point = DVec3::new(t.cos(), t.sin(), t);
    for _ in 0..n {
        point = point.cross(scale).normalize() * t;
    }
    (point, point.dot(scale))
}

#[test]
fn jacobians() {
    let arguments = (0.8, DVec3::new(1.0, -0.5, 2.0), 2);
    let forward = jacobian_forward(curve::jvp, arguments);
    let reverse = jacobian_reverse(curve::vjp, arguments);
    assert_eq!((forward.len(), forward[0].len()), (4, 4));
    for (forward, reverse) in forward.iter().flatten().zip(reverse.iter().flatten()) {
        assert!((forward - reverse).abs() < 1e-13, "{forward} {reverse}");
    }
    assert_forward(curve, curve::jvp, arguments);
}

/// Branches, singular points, numbers and vectors: more coordinates than are followed at once.
#[differentiable]
fn features<S: Real<Mask = bool>>(x: [S; 5], length: S, weights: Vec<S>) -> (S, Vec<S>, [S; 2]) {
    let total = if x[0].cmplt(x[1]) { x[0].atan2(x[1]) } else { x[1].powf(x[0]) };
    let mut scaled = Vec::new();
    for weight in weights {
        scaled.push(weight / length + x[4] * x[2].max(x[3]));
    }
    (total * length.sqrt(), scaled, [x[3].abs() - x[4].sin(), (x[2] * x[2] + x[3]).tanh()])
}

#[test]
fn jacobians_of_generic_functions() {
    for x in [[0.3, 0.7, -1.0, 2.0, 0.5], [0.9, 0.2, 1.0, 0.0, -0.5]] {
        let point = (x, 1.7, vec![0.4, -2.0, 0.0]);
        let generated = jacobian_forward(features::jvp, point.clone());
        let by_duals = jacobian(features, point);
        assert_eq!((by_duals.len(), by_duals[0].len()), (6, 9));
        for (generated, dual) in generated.iter().flatten().zip(by_duals.iter().flatten()) {
            assert!((generated - dual).abs() <= 1e-14 * (1.0 + dual.abs()), "{generated} {dual}");
        }
    }
}

#[test]
fn a_wrong_rule_is_found() {
    let wrong = |x: f64, x_dot: f64| (x.sin(), x.cos() * x_dot * 1.001);
    let worst = worst_forward(|x: f64| x.sin(), wrong, (0.5,), Default::default()).unwrap();
    assert!(worst.error() > 1e-4, "{worst}");
}

#[derive(Clone, Copy, Differentiable)]
struct Pair {
    a: f64,
    b: f64,
}

/// Forward mode by way of the pullback.
#[differentiable(vjp = weighted_vjp)]
fn weighted(xs: &[f64], weight: f64, at: DVec3, n: usize) -> f64 {
    weight * xs.iter().sum::<f64>() + at.dot(DVec3::new(1.0, 2.0, 3.0)) * n as f64
}

fn weighted_vjp(
    xs: &[f64],
    weight: f64,
    at: DVec3,
    n: usize,
) -> (f64, impl FnOnce(f64) -> (Vec<f64>, f64, DVec3, ()) + use<>) {
    let (value, sum, len) = (weighted(xs, weight, at, n), xs.iter().sum::<f64>(), xs.len());
    (value, move |bar| {
        (vec![weight * bar; len], sum * bar, DVec3::new(1.0, 2.0, 3.0) * (bar * n as f64), ())
    })
}

/// Has no forward mode, which nobody asks for.
#[differentiable(vjp = exchanged_vjp)]
fn exchanged(pair: Pair) -> Pair {
    Pair { a: pair.b, b: pair.a }
}

fn exchanged_vjp(pair: Pair) -> (Pair, impl FnOnce(PairTangent) -> PairTangent) {
    (exchanged(pair), |bar| PairTangent { a: bar.b, b: bar.a })
}

#[differentiable]
fn by_rules(x: f64, y: f64) -> f64 {
    let pair = exchanged(Pair { a: x, b: y });
    pair.a * pair.a + pair.b
}

#[differentiable]
fn by_pullback(x: f64, y: f64) -> f64 {
    weighted(&[x, y * y], x, DVec3::new(y, x, 1.0), 2)
}

#[test]
fn rules_by_hand() {
    crate::oracle::check!(by_pullback(x, y) at [0.7, 1.3], [2.1, -0.4]);
    assert_eq!(by_rules::grad(2.0, 3.0), (1.0, 6.0));
}
