//! A Kalman filter with a matrix of its own, whose failures are results.

use std::ops::{Add, Mul, Sub};

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Debug, Differentiable)]
struct Matrix {
    #[constant]
    rows: usize,
    #[constant]
    columns: usize,
    data: Vec<f64>,
}

#[derive(Clone, Debug, PartialEq, Differentiable)]
enum FilterError {
    Singular,
    Shape,
}

type Result<T> = std::result::Result<T, FilterError>;

#[differentiable]
impl Matrix {
    fn zeros(rows: usize, columns: usize) -> Self {
        Self { rows, columns, data: vec![0.0; rows * columns] }
    }

    fn from_rows(rows: usize, columns: usize, data: &[f64]) -> Self {
        Self { rows, columns, data: data.to_vec() }
    }

    fn transpose(&self) -> Self {
        let mut out = Matrix::zeros(self.columns, self.rows);
        for i in 0..self.rows {
            for j in 0..self.columns {
                out.data[j * self.rows + i] = self.data[i * self.columns + j];
            }
        }
        out
    }

    /// By Gauss and Jordan, with pivots.
    fn inverse(&self) -> Result<Self> {
        if self.rows != self.columns {
            return Err(FilterError::Shape);
        }
        let n = self.rows;
        let mut a = self.data.clone();
        let mut b = vec![0.0; n * n];
        for i in 0..n {
            b[i * n + i] = 1.0;
        }
        for column in 0..n {
            let mut pivot = column;
            for row in column + 1..n {
                if a[row * n + column].abs() > a[pivot * n + column].abs() {
                    pivot = row;
                }
            }
            if a[pivot * n + column].abs() < 1e-12 {
                return Err(FilterError::Singular);
            }
            for k in 0..n {
                a.swap(column * n + k, pivot * n + k);
                b.swap(column * n + k, pivot * n + k);
            }
            let scale = a[column * n + column];
            for k in 0..n {
                a[column * n + k] /= scale;
                b[column * n + k] /= scale;
            }
            for row in 0..n {
                if row != column {
                    let factor = a[row * n + column];
                    for k in 0..n {
                        a[row * n + k] -= factor * a[column * n + k];
                        b[row * n + k] -= factor * b[column * n + k];
                    }
                }
            }
        }
        Ok(Matrix { rows: n, columns: n, data: b })
    }
}

#[differentiable]
impl Mul<&Matrix> for &Matrix {
    type Output = Matrix;

    fn mul(self, other: &Matrix) -> Matrix {
        let mut out = Matrix::zeros(self.rows, other.columns);
        for i in 0..self.rows {
            for j in 0..other.columns {
                let mut sum = 0.0;
                for k in 0..self.columns {
                    sum += self.data[i * self.columns + k] * other.data[k * other.columns + j];
                }
                out.data[i * other.columns + j] = sum;
            }
        }
        out
    }
}

#[differentiable]
impl Add<&Matrix> for &Matrix {
    type Output = Matrix;

    fn add(self, other: &Matrix) -> Matrix {
        let data = self.data.iter().zip(other.data.iter()).map(|(a, b)| a + b).collect();
        Matrix { rows: self.rows, columns: self.columns, data }
    }
}

#[differentiable]
impl Sub<&Matrix> for &Matrix {
    type Output = Matrix;

    fn sub(self, other: &Matrix) -> Matrix {
        let data = self.data.iter().zip(other.data.iter()).map(|(a, b)| a - b).collect();
        Matrix { rows: self.rows, columns: self.columns, data }
    }
}

#[derive(Clone, Differentiable)]
struct State {
    x: Matrix,
    p: Matrix,
}

#[differentiable]
fn step(state: &State, measured: f64, q: f64, r: f64) -> Result<(State, f64)> {
    let f = Matrix::from_rows(2, 2, &[1.0, 0.1, 0.0, 1.0]);
    let h = Matrix::from_rows(1, 2, &[1.0, 0.0]);
    let noise = Matrix::from_rows(2, 2, &[q, 0.0, 0.0, q]);
    let x = &f * &state.x;
    let fp = &f * &state.p;
    let p = &(&fp * &f.transpose()) + &noise;
    let hp = &h * &p;
    let s = &(&hp * &h.transpose()) + &Matrix::from_rows(1, 1, &[r]);
    let s_inverse = s.inverse()?;
    let pht = &p * &h.transpose();
    let gain = &pht * &s_inverse;
    let hx = &h * &x;
    let innovation = measured - hx.data[0];
    let correction = &gain * &Matrix::from_rows(1, 1, &[innovation]);
    let kh = &gain * &h;
    let khp = &kh * &p;
    let next = State { x: &x + &correction, p: &p - &khp };
    let likelihood = -0.5 * (innovation * innovation / s.data[0] + s.data[0].ln());
    Ok((next, likelihood))
}

#[differentiable]
fn filter(q: f64, r: f64, #[constant] measurements: &[f64]) -> Result<f64> {
    let mut state = State {
        x: Matrix::from_rows(2, 1, &[0.0, 0.0]),
        p: Matrix::from_rows(2, 2, &[1.0, 0.0, 0.0, 1.0]),
    };
    let mut total = 0.0;
    for &measured in measurements {
        let (next, likelihood) = step(&state, measured, q, r)?;
        state = next;
        total += likelihood;
    }
    Ok(total)
}

#[differentiable]
fn likelihood(q: f64, r: f64) -> f64 {
    filter(q, r, &[0.1, 0.25, 0.2, 0.5, 0.55]).unwrap_or(0.0)
}

#[test]
fn a_kalman_filter() {
    check!(likelihood(q, r) at [0.1, 0.3], [0.02, 1.5]);
    assert_eq!(filter(0.0, -1.01, &[0.1]).unwrap_err(), FilterError::Singular);
}
