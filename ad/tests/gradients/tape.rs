//! The runtime tape apart from generated code: recordings, their misuse, what it leaves out.

use std::panic::catch_unwind;

use ad::tape::{self, Recording, Var};
use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3, differentiable};

use crate::oracle::{assert_close, assert_gradient};

fn kernel<S: Real>(v: &[S]) -> S {
    let (a, b): (Vec3<S>, Vec3<S>) =
        (Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5]));
    let mut sum = a.cross(b.normalize()).length() + a.dot(b) / v[0].max(S::HALF);
    for i in 0..v.len() {
        sum = sum * v[i].sin() + v[i].abs().powf(v[(i + 1) % v.len()])
            - v[i].powi(3).mul_add(v[0], sum);
    }
    sum.tanh() + sum.atan2(v[2]) + S::difference_of_products(v[0], v[1], v[2], v[3]).exp()
}

#[test]
fn gradients_are_those_of_the_function() {
    let x = [0.7, -1.2, 0.4, 1.1, 0.3, 0.9];
    let (value, gradient) = tape::gradient(kernel, &x);
    assert_eq!(value.to_bits(), kernel(&x).to_bits());
    assert_gradient("kernel", kernel::<f64>, &x, &gradient);
}

#[test]
fn a_long_recording() {
    let n = 100_000;
    let (value, gradient) =
        tape::gradient(|v| (0..n).fold(v[1], |sum, _| sum * v[0] + v[1]), &[0.5, 3.0]);
    assert_close("value", value, 6.0, 1e-12);
    assert_close("by the factor", gradient[0], 12.0, 1e-12);
    assert_close("by the summand", gradient[1], 2.0, 1e-12);
}

#[test]
fn several_results_and_numbers_that_are_not_asked_for() {
    let recording = Recording::start();
    let (x, y) = (recording.variable(2.0), recording.variable(3.0));
    let (sum, product) = (x + y, x * y);
    let later = recording.variable(1.0) * product;
    let by_product = recording.cotangents(product);
    assert_eq!((by_product.by(x), by_product.by(y)), (3.0, 2.0));
    assert_eq!((by_product.by(sum), by_product.by(later), by_product.by(product)), (0.0, 0.0, 1.0));
    let by_sum = recording.cotangents(sum);
    assert_eq!((by_sum.by(x), by_sum.by(y)), (1.0, 1.0));
    let by_constant = recording.cotangents(Var::constant(7.0));
    assert_eq!((by_constant.by(x), by_sum.by(Var::constant(7.0))), (0.0, 0.0));
}

#[test]
fn recordings_within_recordings() {
    let (value, gradient) = tape::gradient(
        |v| {
            // The slope of x^3 at 2 is a constant to the outer recording.
            let (_, slope) = tape::gradient(|w| w[0] * w[0] * w[0], &[2.0]);
            v[0] * Var::constant(slope[0])
        },
        &[5.0],
    );
    assert_eq!((value, gradient), (60.0, vec![12.0]));
}

#[test]
fn variables_of_other_recordings_are_refused() {
    let ended = Recording::start().variable(1.0);
    let panics = |f: fn(Var) -> f64| catch_unwind(|| f(ended)).is_err();
    assert!(panics(|x| (x + x).value()));
    assert!(panics(|x| tape::gradient(|v| v[0] * x, &[1.0]).0));
    assert!(panics(|x| Recording::start().cotangents(x).by(x)));
    assert!(panics(|x| std::thread::spawn(move || x * x).join().unwrap().value()));
    // After a panic the thread records as before.
    assert_eq!(tape::gradient(|v| v[0] * v[0], &[3.0]), (9.0, vec![6.0]));

    let outer = Recording::start();
    let x = outer.variable(1.0);
    let inner = Recording::start();
    assert!(catch_unwind(|| x + x).is_err());
    drop(inner);
    assert_eq!((x + x).value(), 2.0);
}

#[differentiable]
fn energy<S: Real>(x: S, y: S) -> S {
    (x * y).sin() * y + x.exp() / y
}

/// The tape records a generated adjoint: second derivatives.
#[test]
fn over_a_generated_adjoint() {
    let by_x = |x: f64, y: f64| energy::grad(x, y).0;
    let (slope, second) = tape::gradient(|v| energy::grad(v[0], v[1]).0, &[0.7, 1.3]);
    assert_close("slope", slope, by_x(0.7, 1.3), 1e-12);
    assert_gradient("slope", |v| by_x(v[0], v[1]), &[0.7, 1.3], &second);
}
