//! Lifetimes that a head or a signature leaves out.

use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct View<'a, T> {
    values: &'a [f64],
    by: T,
}

#[differentiable]
trait Weigh {
    fn weigh(&self, by: f64) -> f64;
}

#[differentiable]
impl View<'_, f64> {
    fn head(&self) -> &f64 {
        &self.values[0]
    }

    fn dot(&self, other: &View<'_, f64>) -> f64 {
        let mut sum = self.by * other.by;
        for (a, b) in self.values.iter().zip(other.values) {
            sum += a * b;
        }
        sum
    }
}

#[differentiable]
impl<T: Copy + Differentiable> Weigh for View<'_, T> {
    fn weigh(&self, by: f64) -> f64 {
        let mut sum = by;
        for value in self.values {
            sum += value * value * by;
        }
        sum
    }
}

#[differentiable]
fn both(view: View<'_, f64>, other: &View<'_, f64>) -> f64 {
    view.dot(other) * view.weigh(*other.head())
}

/// By all numbers of both views.
fn gradient(x: &[f64]) -> Vec<f64> {
    let (left, right) = views(x);
    let (by_left, by_right) = both::grad(left, &right);
    [by_left.values, vec![by_left.by], by_right.values, vec![by_right.by]].concat()
}

fn views(x: &[f64]) -> (View<'_, f64>, View<'_, f64>) {
    (View { values: &x[..2], by: x[2] }, View { values: &x[3..5], by: x[5] })
}

#[test]
fn left_out() {
    let value = |x: &[f64]| {
        let (left, right) = views(x);
        both(left, &right)
    };
    let x = [0.7, -0.4, 1.3, 0.2, 0.9, -0.3];
    crate::oracle::assert_gradient("both", value, &x, &gradient(&x));

    let direction = [0.3, 1.0, -0.2, 0.5, -0.7, 0.1];
    let ((left, right), (left_dot, right_dot)) = (views(&x), views(&direction));
    let of = |view: View<'_, f64>| ViewTangent { values: view.values.to_vec(), by: view.by };
    let (_, along) = both::jvp(left, &right, of(left_dot), &of(right_dot));
    let expected = gradient(&x).iter().zip(direction).map(|(g, d)| g * d).sum();
    crate::oracle::assert_close("both along a direction", along, expected, 1e-12);
}
