//! Calls that add to the cotangents of their caller in place.

use ad::{Differentiable, differentiable};

use crate::oracle::assert_gradient;

#[derive(Clone, Differentiable)]
struct Model {
    weights: Vec<Vec<f64>>,
    bias: f64,
}

#[differentiable]
fn product(a: &[f64], b: &[f64], i: usize) -> f64 {
    a[i] * b[(i + 1) % b.len()] + a[0]
}

#[differentiable]
fn predict(model: &Model, xs: &Vec<f64>, row: usize) -> f64 {
    let mut sum = model.bias;
    for (w, x) in model.weights[row].iter().zip(xs) {
        sum += w * x;
    }
    sum.tanh()
}

#[differentiable]
fn shift(state: &mut f64, by: &[f64], i: usize) {
    *state = *state * by[i] + 1.0;
}

#[differentiable(boxed)]
fn halves(xs: &[f64]) -> f64 {
    match xs.len() {
        0 => 1.0,
        1 => xs[0] * xs[0],
        n => halves(&xs[..n / 2]) * 0.5 + halves(&xs[n / 2..]).sin(),
    }
}

#[differentiable]
fn whole<T: Differentiable + Clone, const N: usize>(xs: &[f64; N], _more: &T) -> f64 {
    xs[N - 1] * xs[0]
}

/// A crate that knows nothing of derivatives.
mod foreign {
    pub fn sum_of_squares(xs: &[f64], factor: f64) -> f64 {
        xs.iter().map(|x| x * x).sum::<f64>() * factor
    }
}

#[differentiable(vjp = squares_vjp, jvp = squares_jvp)]
use foreign::sum_of_squares;

fn squares_vjp(xs: &[f64], factor: f64) -> (f64, impl FnOnce(f64) -> (Vec<f64>, f64) + use<>) {
    let (sum, xs) = (foreign::sum_of_squares(xs, 1.0), xs.to_vec());
    (sum * factor, move |bar| (xs.iter().map(|x| 2.0 * bar * factor * x).collect(), bar * sum))
}

fn squares_jvp(xs: &[f64], factor: f64, xs_dot: &[f64], factor_dot: f64) -> (f64, f64) {
    let along: f64 = xs.iter().zip(xs_dot).map(|(x, x_dot)| 2.0 * x * x_dot).sum();
    let sum = foreign::sum_of_squares(xs, 1.0);
    (sum * factor, along * factor + sum * factor_dot)
}

/// The same variable twice, parts of it, an array as a slice, a variable that is overwritten
/// between calls, calls in arms, beside `&mut`, of imported functions, of functions of a struct.
#[differentiable]
fn mixture(xs: &[f64], model: &Model, array: [f64; 3]) -> f64 {
    let mut own = xs.to_vec();
    let mut state = xs[0];
    let mut sum = 0.0;
    for i in 0..3 {
        sum += product(xs, xs, i) * product(&own, &array, i);
        own[i] = sum * 0.25;
        if sum > 1.0 {
            sum += product(&xs[1..], &own[..3], i);
        } else {
            shift(&mut state, &own, i);
            sum += sum_of_squares(&xs[i..], state) * 0.125;
        }
        for row in 0..2 {
            sum += predict(model, &own, row) * xs[row];
        }
        let view = &own;
        sum -= product(view, view, 2) * state;
    }
    sum + halves(xs) + halves(&own) * whole(&array, model)
}

#[test]
fn gradients_are_those_of_the_function() {
    let split = |x: &[f64]| {
        let weights = vec![x[4..8].to_vec(), x[8..12].to_vec()];
        (x[..4].to_vec(), Model { weights, bias: x[12] }, [x[13], x[14], x[15]])
    };
    let points = [
        [0.3, -0.4, 0.5, 0.2, 0.1, 0.7, -0.3, 0.4, 0.6, -0.2, 0.3, 0.5, 0.1, 0.4, -0.6, 0.8],
        [1.3, 0.9, 1.5, 1.2, 0.1, -0.7, 0.3, 0.4, -0.6, 0.2, 0.3, 0.5, 0.2, 1.4, 0.6, 0.8],
    ];
    for x in points {
        let (xs, model, array) = split(&x);
        let (by_xs, by_model, by_array) = mixture::grad(&xs, &model, array);
        let rows = by_model.weights.concat();
        let gradient = [&by_xs[..], &rows, &[by_model.bias], &by_array].concat();
        let value = |x: &[f64]| {
            let (xs, model, array) = split(x);
            mixture(&xs, &model, array)
        };
        assert_gradient("mixture", value, &x, &gradient);
    }
}

/// The pullback of a function that is lent nothing returns cotangents of the size of its parameters.
#[test]
fn sizes_are_those_of_the_parameters() {
    let (_, pullback) = product::vjp(&[1.0, 2.0, 3.0, 4.0], &[5.0, 6.0], 1);
    assert_eq!(pullback(1.0), (vec![1.0, 5.0, 0.0, 0.0], vec![2.0, 0.0], ()));
    let model = Model { weights: vec![vec![1.0, 2.0], vec![3.0, 4.0]], bias: 0.5 };
    let (by_model, by_xs, ()) = predict::grad(&model, &vec![0.0, 0.0], 0);
    assert_eq!(by_model.weights, [[0.0, 0.0], [0.0, 0.0]]);
    assert_eq!(by_xs.len(), 2);
}
