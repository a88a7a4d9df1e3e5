//! Elements of one's own types, told by tuples of indices.

use ad::{Differentiable, differentiable};
use std::ops::{Index, IndexMut};
#[derive(Clone, Debug, Differentiable)]
struct Matrix {
    rows: usize,
    cols: usize,
    data: Vec<f64>,
}
#[differentiable]
impl Index<(usize, usize)> for Matrix {
    type Output = f64;
    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        assert!(i < self.rows && j < self.cols);
        &self.data[i * self.cols + j]
    }
}
#[differentiable]
impl IndexMut<(usize, usize)> for Matrix {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        let at = i * self.cols + j;
        &mut self.data[at]
    }
}
#[differentiable]
impl Matrix {
    fn zeros(rows: usize, cols: usize) -> Self {
        Self { rows, cols, data: vec![0.0; rows * cols] }
    }
    fn matmul(&self, other: &Matrix) -> Matrix {
        let mut out = Matrix::zeros(self.rows, other.cols);
        for i in 0..self.rows {
            for j in 0..other.cols {
                for k in 0..self.cols {
                    out[(i, j)] += self[(i, k)] * other[(k, j)];
                }
            }
        }
        out
    }
    fn cholesky(&self) -> Option<Matrix> {
        let n = self.rows;
        let mut l = Matrix::zeros(n, n);
        for i in 0..n {
            for j in 0..=i {
                let mut sum = self[(i, j)];
                for k in 0..j {
                    sum -= l[(i, k)] * l[(j, k)];
                }
                if i == j {
                    if sum <= 0.0 {
                        return None;
                    }
                    l[(i, j)] = sum.sqrt();
                } else {
                    l[(i, j)] = sum / l[(j, j)];
                }
            }
        }
        Some(l)
    }
}
#[differentiable]
fn factored(x: f64, y: f64) -> f64 {
    let mut a = Matrix { rows: 2, cols: 2, data: vec![x, y, 0.5, x * y] };
    a[(0, 1)] *= a[(1, 1)] + 2.0;
    a[(1, 0)] -= x;
    let b = a.matmul(&a);
    let mut spd = b.clone();
    spd[(0, 0)] = 4.0 + b[(0, 0)].abs();
    spd[(1, 1)] = 4.0 + b[(1, 1)] * b[(1, 1)];
    spd[(1, 0)] = 0.3 * b[(0, 1)];
    let mut det = 0.0;
    if let Some(l) = spd.cholesky() {
        for i in 0..l.rows {
            det += l[(i, i)].ln();
        }
    }
    if b[(0, 0)] > 0.0 {
        det += b[(1, 0)].sin();
    }
    det + (b[(0, 1)] - b[(1, 0)]).powi(2)
}

#[test]
fn elements() {
    use crate::oracle::check;

    check!(factored(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
}
