//! Elements of one's own types, told by one index: parts of a value and of its tangent.

use std::ops::{Index, IndexMut};

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Direction {
    parts: [f64; 3],
}

#[differentiable]
impl Index<usize> for Direction {
    type Output = f64;
    fn index(&self, i: usize) -> &f64 {
        debug_assert!(i < self.parts.len());
        &self.parts[i]
    }
}

#[differentiable]
impl IndexMut<usize> for Direction {
    fn index_mut(&mut self, i: usize) -> &mut f64 {
        &mut self.parts[i]
    }
}

#[differentiable]
fn cross(a: &Direction, b: &Direction) -> Direction {
    let mut c = Direction { parts: [0.0; 3] };
    for i in 0..3 {
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3];
        c[i] -= a[(i + 2) % 3] * b[(i + 1) % 3];
    }
    c
}

#[differentiable]
fn crossed(x: f64, y: f64) -> f64 {
    let a = Direction { parts: [x, y, x * y] };
    let mut b = Direction { parts: [y * y, 1.5, x] };
    b[0] *= b[2];
    let c = cross(&a, &cross(&b, &a));
    let last = &mut b;
    last[1] = c[1] * c[2];
    c[0] * b[1] + c[2]
}

#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
}

#[derive(Clone, Copy, Differentiable)]
struct Point {
    x: f64,
    y: f64,
}

#[differentiable]
impl Index<Axis> for Point {
    type Output = f64;
    fn index(&self, axis: Axis) -> &f64 {
        match axis {
            Axis::X => &self.x,
            Axis::Y => &self.y,
        }
    }
}

#[differentiable]
impl Index<usize> for Point {
    type Output = f64;
    fn index(&self, i: usize) -> &f64 {
        if i == 0 { &self.x } else { &self.y }
    }
}

#[differentiable]
impl IndexMut<usize> for Point {
    fn index_mut(&mut self, i: usize) -> &mut f64 {
        match i {
            0 => &mut self.x,
            i if i % 2 == 1 => &mut self.y,
            _ => panic!("a point has no part {i}"),
        }
    }
}

#[differentiable]
fn pointed(x: f64, y: f64) -> f64 {
    let mut p = Point { x, y };
    for i in 0..2 {
        p[i] *= p[1 - i];
    }
    p[Axis::X] * p[0] + p[Axis::Y] / p[1].exp()
}

/// Two indices may lead to one element.
#[derive(Clone, Differentiable)]
struct Ring<T> {
    values: Vec<T>,
}

const LENGTH: isize = 4;

#[differentiable]
impl<T: ad::Real> Index<isize> for Ring<T> {
    type Output = T;
    fn index(&self, i: isize) -> &T {
        let k = i.rem_euclid(LENGTH) as usize;
        &self.values[k]
    }
}

#[differentiable]
impl<T: ad::Real> IndexMut<isize> for Ring<T> {
    fn index_mut(&mut self, i: isize) -> &mut T {
        let k = i.rem_euclid(LENGTH) as usize;
        &mut self.values[k]
    }
}

#[differentiable]
fn diffused<T: ad::Real>(ring: &Ring<T>) -> Ring<T> {
    let mut out = ring.clone();
    for i in 0..6 {
        out[i] = ring[i - 1] * ring[i + 1] - ring[i] * out[i + 1];
    }
    out
}

#[differentiable]
fn around(x: f64, y: f64) -> f64 {
    let ring = diffused(&Ring { values: vec![x, y, x * y, 1.0] });
    let twice = diffused(&ring);
    twice[0] * twice[1] + twice[2] * ring[7] + ring[-2]
}

#[derive(Clone, Differentiable)]
struct Square {
    rows: [[f64; 2]; 2],
}

#[differentiable]
impl Index<usize> for Square {
    type Output = [f64; 2];
    fn index(&self, i: usize) -> &[f64; 2] {
        &self.rows[i]
    }
}

#[differentiable]
impl IndexMut<usize> for Square {
    fn index_mut(&mut self, i: usize) -> &mut [f64; 2] {
        &mut self.rows[i]
    }
}

#[differentiable]
impl Square {
    fn squared(&self) -> Square {
        let mut square = Square { rows: [[0.0; 2]; 2] };
        for i in 0..2 {
            for j in 0..2 {
                for k in 0..2 {
                    square[i][j] += self[i][k] * self[k][j];
                }
            }
        }
        square
    }
}

#[differentiable]
fn squared_twice(x: f64, y: f64) -> f64 {
    let square = Square { rows: [[x, y], [1.0, x * y]] }.squared().squared();
    square[0][0] * square[1][1].sin() - square[0][1] * square[1][0]
}

#[test]
fn an_element_is_a_part_of_the_tangent() {
    check!(crossed(x, y) at [0.7, 0.4], [-0.4, 1.7]);
    check!(pointed(x, y) at [0.7, 0.4], [-0.4, 1.7]);
    check!(squared_twice(x, y) at [0.7, 0.4], [-0.4, 1.7]);
}

#[test]
fn indices_may_lead_to_one_element() {
    check!(around(x, y) at [0.7, 0.4], [-0.4, 1.7]);
}
