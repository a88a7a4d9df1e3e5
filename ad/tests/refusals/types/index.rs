use std::ops::{Index, IndexMut};

use ad::{Differentiable, differentiable};

#[derive(Clone, Differentiable)]
struct Matrix {
    columns: usize,
    data: Vec<f64>,
}

#[differentiable]
impl Index<usize> for Matrix {
    type Output = f64;

    fn index(&self, i: usize) -> &f64 {
        &self.data[i * self.columns]
    }
}

#[differentiable]
impl Index<u8> for Matrix {
    type Output = [f64];

    fn index(&self, i: u8) -> &[f64] {
        let start = 3 * usize::from(i);
        &self.data[start..start + 3]
    }
}

#[differentiable]
impl Index<char> for Matrix {
    type Output = f64;

    fn index(&self, name: char) -> &f64 {
        match name {
            'x' => &self.data[0],
            _ if self.columns > 1 => &self.data[1],
            _ => panic!("no element {name}"),
        }
    }
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

impl IndexMut<usize> for Row {
    fn index_mut(&mut self, i: usize) -> &mut f64 {
        &mut self.data[i]
    }
}

#[differentiable]
fn doubled(row: &mut Row) {
    row[0] *= 2.0;
}

fn main() {}
