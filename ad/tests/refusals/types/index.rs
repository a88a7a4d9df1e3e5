use std::ops::{Index, IndexMut};

use ad::{Differentiable, differentiable};

#[derive(Clone, Differentiable)]
struct Row {
    data: Vec<f64>,
}

#[differentiable]
impl Index<usize> for Row {
    type Output = f64;

    fn index(&self, i: usize) -> &f64 {
        &self.data[i]
    }
}

#[derive(Clone, Differentiable)]
struct Matrix {
    columns: usize,
    data: Vec<f64>,
}

#[differentiable]
impl Index<(usize, usize)> for Matrix {
    type Output = f64;

    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        self.data.get(i * self.columns + j).unwrap()
    }
}

#[differentiable]
impl IndexMut<(usize, usize)> for Matrix {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        let element = &mut self.data[i * self.columns + j];
        element
    }
}

fn main() {}
