//! Operators of a type that is not `Copy`, by reference and by value.

use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use ad::{Differentiable, Real, differentiable};

use crate::oracle::{check, check_generic};

#[derive(Clone, Differentiable)]
struct Matrix<S> {
    rows: usize,
    columns: usize,
    data: Vec<S>,
}

#[differentiable]
impl<S: Real> Matrix<S> {
    fn new(rows: usize, columns: usize, data: &[S]) -> Self {
        Self { rows, columns, data: data.to_vec() }
    }

    fn transposed(&self) -> Self {
        let mut data = vec![S::ZERO; self.data.len()];
        for i in 0..self.rows {
            for k in 0..self.columns {
                data[k * self.rows + i] = self.data[i * self.columns + k];
            }
        }
        Matrix { rows: self.columns, columns: self.rows, data }
    }

    fn trace(&self) -> S {
        let mut sum = S::ZERO;
        for i in 0..self.rows {
            sum = sum + self.data[i * self.columns + i];
        }
        sum
    }

    fn gram(&self) -> Self {
        &self.transposed() * self
    }

    fn cube(&self) -> Self {
        self * self * self
    }
}

#[differentiable]
impl<'a, S: Real> Mul<&'a Matrix<S>> for &Matrix<S> {
    type Output = Matrix<S>;

    fn mul(self, other: &'a Matrix<S>) -> Self::Output {
        assert_eq!(self.columns, other.rows);
        let mut data = vec![S::ZERO; self.rows * other.columns];
        for i in 0..self.rows {
            for j in 0..other.columns {
                for k in 0..self.columns {
                    data[i * other.columns + j] = data[i * other.columns + j]
                        + self.data[i * self.columns + k] * other.data[k * other.columns + j];
                }
            }
        }
        Matrix { rows: self.rows, columns: other.columns, data }
    }
}

// Has the derivative of the one above.
impl<S: Real> Mul<&Matrix<S>> for Matrix<S> {
    type Output = Matrix<S>;

    fn mul(self, other: &Matrix<S>) -> Matrix<S> {
        &self * other
    }
}

#[differentiable]
impl<S: Real> Add for Matrix<S> {
    type Output = Self;

    fn add(mut self, other: Self) -> Self {
        for (a, b) in self.data.iter_mut().zip(&other.data) {
            *a = *a + *b;
        }
        self
    }
}

#[differentiable]
impl<S: Real> Sub<&Matrix<S>> for Matrix<S> {
    type Output = Matrix<S>;

    fn sub(self, other: &Matrix<S>) -> Matrix<S> {
        let data = self.data.iter().zip(&other.data).map(|(a, b)| *a - *b).collect();
        Matrix { data, ..self }
    }
}

#[differentiable]
impl<S: Real> Mul<S> for Matrix<S> {
    type Output = Matrix<S>;

    fn mul(self, by: S) -> Matrix<S> {
        Matrix {
            rows: self.rows,
            columns: self.columns,
            data: self.data.iter().map(|x| *x * by).collect(),
        }
    }
}

#[differentiable]
impl<S: Real> Div<S> for &Matrix<S> {
    type Output = Matrix<S>;

    fn div(self, by: S) -> Matrix<S> {
        self.clone() * (S::ONE / by)
    }
}

#[differentiable]
impl<S: Real> Neg for &Matrix<S> {
    type Output = Matrix<S>;

    fn neg(self) -> Matrix<S> {
        self / -S::ONE
    }
}

/// By halves, so that a mix-up with `+` shows.
#[differentiable]
impl<S: Real> AddAssign<&Matrix<S>> for Matrix<S> {
    fn add_assign(&mut self, other: &Matrix<S>) {
        for i in 0..self.data.len() {
            self.data[i] = self.data[i] + S::HALF * other.data[i] * self.data[0];
        }
    }
}

#[differentiable]
impl<S: Real> SubAssign for Matrix<S> {
    fn sub_assign(&mut self, other: Self) {
        for (a, b) in self.data.iter_mut().zip(&other.data) {
            *a = *a - *b;
        }
    }
}

#[differentiable]
impl<S: Real> MulAssign<S> for Matrix<S> {
    fn mul_assign(&mut self, by: S) {
        for x in &mut self.data {
            *x = *x * by;
        }
    }
}

#[differentiable]
fn by_reference<S: Real>(x: S, y: S) -> S {
    let a = Matrix::new(2, 3, &[x, y, S::ONE, x * y, S::TWO, y]);
    let b = Matrix::new(3, 2, &[y, x, x, S::TWO, S::ONE, x * x]);
    let c = &a * &b;
    let d = &(&c * &c) / (S::TWO + x * x);
    let e = -&d;
    (&e * &c).trace() + d.trace() + a.gram().trace()
}

#[test]
fn operators_of_references() {
    check_generic!(by_reference(x, y) at [0.7, -1.2], [1.5, 0.4], [0.0, 2.0]);
}

#[differentiable]
fn by_value<S: Real>(x: S, y: S) -> S {
    let a = Matrix::new(2, 2, &[x, y, S::ONE, x * y]);
    let b = Matrix::new(2, 2, &[y, x, x, S::TWO]);
    let scaled = b.transposed() * x;
    let c = a.clone() + scaled - &b;
    let d = c.cube() + c * y;
    (d * &a).trace()
}

#[test]
fn operators_of_values() {
    check_generic!(by_value(x, y) at [0.7, -1.2], [1.5, 0.4], [0.0, 2.0]);
}

#[differentiable]
fn in_loops<S: Real>(x: S, y: S) -> S {
    let a = Matrix::new(2, 2, &[x, y, S::HALF, x * y]);
    let mut power = Matrix::new(2, 2, &[S::ONE, S::ZERO, S::ZERO, S::ONE]);
    let mut sum = power.clone();
    for i in 0..4 {
        power = &power * &a;
        if i == 2 {
            continue;
        }
        sum = sum + &power / S::from_f64(1.0 + i as f64);
        sum += &a;
        if i % 2 == 0 {
            sum -= power.clone();
            power *= y;
        }
    }
    (&sum * &power).trace()
}

#[test]
fn operators_in_loops() {
    check_generic!(in_loops(x, y) at [0.7, -1.2], [1.5, 0.4], [0.0, 2.0]);
}

#[derive(Clone, Differentiable)]
struct Layer {
    weights: Matrix<f64>,
    bias: Matrix<f64>,
}

#[differentiable]
impl Layer {
    fn apply(&self, x: &Matrix<f64>) -> Matrix<f64> {
        let mut y = &self.weights * x;
        y += &self.bias;
        for value in &mut y.data {
            *value = value.tanh();
        }
        y
    }

    fn step(&mut self, gradient: &Matrix<f64>, rate: f64) {
        let weights: &mut Matrix<f64> = &mut self.weights;
        *weights *= 1.0 - rate;
        let mut change: Matrix<f64> = gradient.transposed();
        change *= rate;
        self.weights -= change.clone();
        self.bias += &(&self.weights * &self.bias);
    }
}

#[differentiable]
fn accumulate(total: &mut Matrix<f64>, m: &Matrix<f64>) {
    *total += m;
    *total *= 0.5;
    *total = &*total * m;
}

#[differentiable]
fn layers(x: f64, y: f64) -> f64 {
    let layer = Layer {
        weights: Matrix::new(2, 2, &[x, 0.3, y, 1.0]),
        bias: Matrix::new(2, 1, &[0.1, x * y]),
    };
    let mut layers = vec![layer.clone(), layer];
    let gradient = Matrix::new(2, 2, &[y, y, x, x * x]);
    layers[1].step(&gradient, 0.3 * x);
    let mut signal = Matrix::new(2, 1, &[x, -y]);
    for layer in &layers {
        signal = layer.apply(&signal);
    }
    let mut total = gradient.clone();
    accumulate(&mut total, &layers[1].weights);
    accumulate(&mut total, &gradient);
    (&signal * &signal.transposed()).trace() + total.trace()
}

#[test]
fn operators_of_parts_and_of_what_is_borrowed() {
    check!(layers(x, y) at [0.7, -1.2], [1.5, 0.4], [0.3, 0.2]);
}

/// Numbers are borrowed, too.
#[allow(clippy::op_ref)]
#[differentiable]
fn of_numbers(xs: &[f64], y: f64) -> f64 {
    let mut sum = 0.0;
    for pair in xs.windows(2) {
        sum += &pair[0] * &pair[1] / y - &pair[0];
    }
    let half = &sum * 0.5;
    -&half * half
}

#[differentiable]
fn of_few_numbers(x: f64, y: f64) -> f64 {
    of_numbers(&[x, y, x * y], y)
}

#[test]
fn operators_of_borrowed_numbers() {
    check!(of_few_numbers(x, y) at [0.7, -1.2], [1.5, 0.4]);
}

/// The operator is differentiated where it is written with the attribute, whatever form is used.
#[test]
fn cotangents_have_the_shape_of_the_operands() {
    #[differentiable]
    fn trace_of_product(a: &Matrix<f64>, b: &Matrix<f64>) -> f64 {
        (a * b).trace()
    }
    let a = Matrix { rows: 1, columns: 2, data: vec![2.0, 3.0] };
    let b = Matrix { rows: 2, columns: 1, data: vec![5.0, 7.0] };
    let (by_a, by_b) = trace_of_product::grad(&a, &b);
    assert_eq!((by_a.data, by_b.data), (b.data, a.data));
}
