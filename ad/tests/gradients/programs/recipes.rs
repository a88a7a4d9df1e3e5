//! Textbook algorithms: splines, linear algebra, transforms, filters.

use std::ops::{Add, Mul, Sub};

use ad::{Differentiable, differentiable};

/// A natural cubic spline through points: its second derivatives, by a tridiagonal system.
#[differentiable]
fn second_derivatives(xs: &[f64], ys: &[f64]) -> Vec<f64> {
    let n = xs.len();
    let mut a = vec![0.0; n];
    let mut b = vec![1.0; n];
    let mut c = vec![0.0; n];
    let mut d = vec![0.0; n];
    for i in 1..n - 1 {
        let h0 = xs[i] - xs[i - 1];
        let h1 = xs[i + 1] - xs[i];
        a[i] = h0;
        b[i] = 2.0 * (h0 + h1);
        c[i] = h1;
        d[i] = 6.0 * ((ys[i + 1] - ys[i]) / h1 - (ys[i] - ys[i - 1]) / h0);
    }
    for i in 1..n {
        let w = a[i] / b[i - 1];
        b[i] -= w * c[i - 1];
        d[i] -= w * d[i - 1];
    }
    let mut m = vec![0.0; n];
    m[n - 1] = d[n - 1] / b[n - 1];
    for i in (0..n - 1).rev() {
        m[i] = (d[i] - c[i] * m[i + 1]) / b[i];
    }
    m
}

#[differentiable]
fn spline(xs: &[f64], ys: &[f64], x: f64) -> f64 {
    let m = second_derivatives(xs, ys);
    let mut lo = 0;
    let mut hi = xs.len() - 1;
    while hi - lo > 1 {
        let mid = (lo + hi) / 2;
        if xs[mid] > x {
            hi = mid;
        } else {
            lo = mid;
        }
    }
    let h = xs[hi] - xs[lo];
    let (a, b) = ((xs[hi] - x) / h, (x - xs[lo]) / h);
    a * ys[lo] + b * ys[hi] + ((a.powi(3) - a) * m[lo] + (b.powi(3) - b) * m[hi]) * h * h / 6.0
}

#[differentiable]
fn splined(x: f64, y: f64) -> f64 {
    let xs = [0.0, 0.5, 1.1, 1.9, 2.6];
    let ys = [x, y, x * y, 1.0, y.sin()];
    spline(&xs, &ys, 0.8 + 0.1 * x) + spline(&xs, &ys, 2.2)
}

/// The inverse by Gauss-Jordan elimination with partial pivoting.
#[differentiable]
fn invert(matrix: &Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let n = matrix.len();
    let mut a = matrix.clone();
    let mut inv = vec![vec![0.0; n]; n];
    for i in 0..n {
        inv[i][i] = 1.0;
    }
    for col in 0..n {
        let mut pivot = col;
        for row in col + 1..n {
            if a[row][col].abs() > a[pivot][col].abs() {
                pivot = row;
            }
        }
        if a[pivot][col].abs() < 1e-12 {
            return None;
        }
        a.swap(col, pivot);
        inv.swap(col, pivot);
        let p = a[col][col];
        for j in 0..n {
            a[col][j] /= p;
            inv[col][j] /= p;
        }
        for row in 0..n {
            if row != col {
                let factor = a[row][col];
                for j in 0..n {
                    a[row][j] -= factor * a[col][j];
                    inv[row][j] -= factor * inv[col][j];
                }
            }
        }
    }
    Some(inv)
}

#[differentiable]
fn inverted(x: f64, y: f64) -> f64 {
    let matrix = vec![vec![0.1 * x, y, 1.0], vec![2.0, x * y, -y], vec![x, 0.3, y * y]];
    match invert(&matrix) {
        Some(inv) => inv.iter().map(|row| row.iter().map(|v| v.sin()).sum::<f64>()).sum(),
        None => 0.0,
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
struct Complex {
    re: f64,
    im: f64,
}

#[differentiable]
impl Complex {
    fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    fn from_polar(r: f64, theta: f64) -> Self {
        Complex::new(r * theta.cos(), r * theta.sin())
    }

    fn norm_sqr(&self) -> f64 {
        self.re * self.re + self.im * self.im
    }
}

#[differentiable]
impl Add for Complex {
    type Output = Complex;
    fn add(self, rhs: Complex) -> Complex {
        Complex::new(self.re + rhs.re, self.im + rhs.im)
    }
}

#[differentiable]
impl Sub for Complex {
    type Output = Complex;
    fn sub(self, rhs: Complex) -> Complex {
        Complex::new(self.re - rhs.re, self.im - rhs.im)
    }
}

#[differentiable]
impl Mul for Complex {
    type Output = Complex;
    fn mul(self, rhs: Complex) -> Complex {
        Complex::new(self.re * rhs.re - self.im * rhs.im, self.re * rhs.im + self.im * rhs.re)
    }
}

/// The fast Fourier transform by recursion.
#[differentiable]
fn fft(input: &[Complex]) -> Vec<Complex> {
    let n = input.len();
    if n == 1 {
        return vec![input[0]];
    }
    let even: Vec<Complex> = input.iter().step_by(2).copied().collect();
    let odd: Vec<Complex> = input.iter().skip(1).step_by(2).copied().collect();
    let even = fft(&even);
    let odd = fft(&odd);
    let mut out = vec![Complex { re: 0.0, im: 0.0 }; n];
    for k in 0..n / 2 {
        let angle = -2.0 * std::f64::consts::PI * k as f64 / n as f64;
        let t = Complex::from_polar(1.0, angle) * odd[k];
        out[k] = even[k] + t;
        out[k + n / 2] = even[k] - t;
    }
    out
}

#[differentiable]
fn spectrum(x: f64, y: f64) -> f64 {
    let signal: Vec<Complex> =
        (0..8).map(|i| Complex::new((x * i as f64).sin(), y * (i as f64 * 0.3).cos())).collect();
    let spectrum = fft(&signal);
    spectrum.iter().enumerate().map(|(k, c)| c.norm_sqr() * (k + 1) as f64).sum()
}

type Mat2 = [[f64; 2]; 2];

#[differentiable]
fn mat_mul(a: &Mat2, b: &Mat2) -> Mat2 {
    let mut out = [[0.0; 2]; 2];
    for i in 0..2 {
        for j in 0..2 {
            for k in 0..2 {
                out[i][j] += a[i][k] * b[k][j];
            }
        }
    }
    out
}

#[differentiable]
fn transpose(a: &Mat2) -> Mat2 {
    [[a[0][0], a[1][0]], [a[0][1], a[1][1]]]
}

#[derive(Clone, Debug, Differentiable)]
struct Kalman {
    state: [f64; 2],
    covariance: Mat2,
    process_noise: f64,
    measurement_noise: f64,
}

#[differentiable]
impl Kalman {
    fn predict(&mut self, dt: f64) {
        let f = [[1.0, dt], [0.0, 1.0]];
        self.state = [self.state[0] + dt * self.state[1], self.state[1]];
        self.covariance = mat_mul(&mat_mul(&f, &self.covariance), &transpose(&f));
        self.covariance[0][0] += self.process_noise * dt.powi(3) / 3.0;
        self.covariance[0][1] += self.process_noise * dt.powi(2) / 2.0;
        self.covariance[1][0] += self.process_noise * dt.powi(2) / 2.0;
        self.covariance[1][1] += self.process_noise * dt;
    }

    /// Returns the negative log-likelihood of the measurement.
    fn update(&mut self, measured: f64) -> f64 {
        let innovation = measured - self.state[0];
        let s = self.covariance[0][0] + self.measurement_noise;
        let gain = [self.covariance[0][0] / s, self.covariance[1][0] / s];
        for (value, k) in self.state.iter_mut().zip(gain) {
            *value += k * innovation;
        }
        let p = self.covariance;
        for i in 0..2 {
            for j in 0..2 {
                self.covariance[i][j] -= gain[i] * p[0][j];
            }
        }
        0.5 * (innovation * innovation / s + s.ln())
    }
}

#[differentiable]
fn likelihood(q: f64, r: f64) -> f64 {
    let mut filter = Kalman {
        state: [0.0, 1.0],
        covariance: [[1.0, 0.0], [0.0, 1.0]],
        process_noise: q.exp(),
        measurement_noise: r.exp(),
    };
    let measurements = [0.3, 0.9, 1.1, 1.8, 2.0];
    let mut total = 0.0;
    for &z in &measurements {
        filter.predict(0.4);
        total += filter.update(z);
    }
    total
}

#[test]
fn recipes() {
    use crate::oracle::check;

    check!(splined(x, y) at [1.3, 0.7], [0.4, -1.2]);
    check!(inverted(x, y) at [1.3, 0.7], [-0.4, 1.2]);
    check!(spectrum(x, y) at [1.3, 0.7], [0.4, -1.2]);
    check!(likelihood(q, r) at [0.3, -0.7], [-1.1, 0.2]);
}
