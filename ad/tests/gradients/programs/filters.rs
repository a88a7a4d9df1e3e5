//! A Kalman filter on a matrix type of its own, with errors as texts.

use ad::{Differentiable, differentiable};

#[derive(Clone, Debug, PartialEq, Differentiable)]
struct Matrix {
    rows: usize,
    cols: usize,
    data: Vec<f64>,
}

#[differentiable]
impl Matrix {
    fn zeros(rows: usize, cols: usize) -> Self {
        Matrix { rows, cols, data: vec![0.0; rows * cols] }
    }
    fn identity(n: usize) -> Self {
        let mut m = Self::zeros(n, n);
        for i in 0..n {
            m.set(i, i, 1.0);
        }
        m
    }
    fn from_rows(rows: &[Vec<f64>]) -> Matrix {
        let mut data = Vec::new();
        for row in rows {
            data.extend_from_slice(row);
        }
        Matrix { rows: rows.len(), cols: rows[0].len(), data }
    }
    fn get(&self, i: usize, j: usize) -> f64 {
        self.data[i * self.cols + j]
    }
    fn set(&mut self, i: usize, j: usize, v: f64) {
        self.data[i * self.cols + j] = v;
    }
    fn matmul(&self, other: &Matrix) -> Matrix {
        assert_eq!(self.cols, other.rows, "dimension mismatch");
        let mut out = Matrix::zeros(self.rows, other.cols);
        for i in 0..self.rows {
            for j in 0..other.cols {
                let mut acc = 0.0;
                for k in 0..self.cols {
                    acc += self.get(i, k) * other.get(k, j);
                }
                out.set(i, j, acc);
            }
        }
        out
    }
    fn transpose(&self) -> Matrix {
        let mut out = Matrix::zeros(self.cols, self.rows);
        for i in 0..self.rows {
            for j in 0..self.cols {
                out.data[j * self.rows + i] = self.data[i * self.cols + j];
            }
        }
        out
    }
    fn add(&self, other: &Matrix) -> Matrix {
        let data = self.data.iter().zip(other.data.iter()).map(|(a, b)| a + b).collect();
        Matrix { data, ..*self }
    }
    fn scale(&self, s: f64) -> Matrix {
        Matrix { data: self.data.iter().map(|x| x * s).collect(), rows: self.rows, cols: self.cols }
    }
    fn inverse(&self) -> Option<Matrix> {
        let n = self.rows;
        let mut a = self.clone();
        let mut inv = Matrix::identity(n);
        for col in 0..n {
            let mut pivot = col;
            let mut best = a.get(col, col).abs();
            for r in col + 1..n {
                let v = a.get(r, col).abs();
                if v > best {
                    best = v;
                    pivot = r;
                }
            }
            if best < 1e-12 {
                return None;
            }
            if pivot != col {
                for j in 0..n {
                    a.data.swap(col * n + j, pivot * n + j);
                    inv.data.swap(col * n + j, pivot * n + j);
                }
            }
            let p = a.get(col, col);
            for j in 0..n {
                a.data[col * n + j] /= p;
                inv.data[col * n + j] /= p;
            }
            for r in 0..n {
                if r == col {
                    continue;
                }
                let f = a.get(r, col);
                for j in 0..n {
                    let (x, y) = (a.get(col, j), inv.get(col, j));
                    a.data[r * n + j] -= f * x;
                    inv.data[r * n + j] -= f * y;
                }
            }
        }
        Some(inv)
    }
}

#[derive(Clone, Differentiable)]
struct KalmanFilter {
    x: Matrix,
    p: Matrix,
    f: Matrix,
    h: Matrix,
    q: Matrix,
    r: Matrix,
}

#[differentiable]
impl KalmanFilter {
    fn predict(&mut self) {
        self.x = self.f.matmul(&self.x);
        self.p = self.f.matmul(&self.p).matmul(&self.f.transpose()).add(&self.q);
    }
    fn update(&mut self, z: &Matrix) -> Result<f64, String> {
        let y = z.add(&self.h.matmul(&self.x).scale(-1.0));
        let ht = self.h.transpose();
        let s = self.h.matmul(&self.p).matmul(&ht).add(&self.r);
        let s_inv = s.inverse().ok_or_else(|| "singular innovation".to_string())?;
        let k = self.p.matmul(&ht).matmul(&s_inv);
        self.x = self.x.add(&k.matmul(&y));
        let i = Matrix::identity(self.x.rows);
        self.p = i.add(&k.matmul(&self.h).scale(-1.0)).matmul(&self.p);
        let m = y.transpose().matmul(&s_inv).matmul(&y);
        Ok(m.data[0])
    }
}

#[differentiable]
fn run(q: f64, r: f64) -> Result<f64, String> {
    let mut filter = KalmanFilter {
        x: Matrix { rows: 2, cols: 1, data: vec![0.0, 1.0] },
        p: Matrix::identity(2),
        f: Matrix::from_rows(&[vec![1.0, 0.1], vec![0.0, 1.0]]),
        h: Matrix { rows: 1, cols: 2, data: vec![1.0, 0.0] },
        q: Matrix::identity(2).scale(q),
        r: Matrix { rows: 1, cols: 1, data: vec![r] },
    };
    let measurements = [0.12, 0.19, 0.33, 0.37, 0.55];
    let mut total = 0.0;
    for &z in measurements.iter() {
        filter.predict();
        let m = filter.update(&Matrix { rows: 1, cols: 1, data: vec![z] })?;
        total += m;
    }
    Ok(total)
}

#[differentiable]
fn nll(q: f64, r: f64) -> f64 {
    run(q, r).unwrap_or(f64::INFINITY)
}

#[test]
fn filters() {
    use crate::oracle::check;

    check!(nll(q, r) at [0.1, 0.5], [0.7, 0.2]);
}
