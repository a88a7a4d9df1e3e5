//! What inserts, removes and moves elements.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn edited(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, 2.0];
    v.insert(1, x * y);
    v.insert(4, y * y);
    let removed = v.remove(2);
    let swapped = v.swap_remove(0);
    let last = v.swap_remove(v.len() - 1);
    let unused = v.remove(0);
    v.resize(4, unused * y);
    v.rotate_left(1);
    v.rotate_right(2);
    v[0] * removed + v[1] * swapped - v[3] * last * v[2]
}

#[differentiable]
fn cut(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y, 3.0 * x, y * y];
    let mut rest = v.split_off(3);
    rest.truncate(1);
    v.append(&mut rest);
    v.resize(3, y);
    let mut array = [v[2], v[0], x];
    array.rotate_left(1);
    rest.push(array[0] * v[1]);
    rest[0] * array[2] + array[1] * v.len() as f64
}

#[derive(Clone, Differentiable)]
struct Queue {
    items: Vec<(f64, f64)>,
}

#[differentiable]
impl Queue {
    fn step(&mut self, x: f64) -> f64 {
        let (weight, value) = self.items.remove(0);
        self.items.insert(self.items.len() / 2, (value, weight * x));
        if self.items.len() > 2 {
            self.items.truncate(2);
        }
        weight * value
    }
}

#[differentiable]
fn queued(x: f64, y: f64) -> f64 {
    let mut queue = Queue { items: vec![(x, 1.0), (y, x), (2.0, y)] };
    let mut sum = 0.0;
    for _ in 0..4 {
        sum += queue.step(y);
    }
    sum
}

#[test]
fn editing() {
    check!(edited(x, y) at [1.3, 0.4], [-0.7, 1.1]);
    check!(cut(x, y) at [1.3, 0.4], [-0.7, 1.1]);
    check!(queued(x, y) at [1.3, 0.4], [-0.7, 1.1]);
}

#[differentiable]
fn lengthened(xs: &[f64], k: usize) -> Vec<f64> {
    let mut v = vec![1.0];
    let twice: Vec<f64> = xs.iter().map(|x| 2.0 * x).collect();
    v.extend(&xs[k..]);
    v.extend(&twice);
    v.extend(xs);
    v
}

#[differentiable]
fn of_lengthened(x: f64, y: f64) -> f64 {
    let v = lengthened(&[x, y, x * y], 1);
    v[1] * v[3] + v[2] * v[5] * v[8] + v[6]
}

#[test]
fn references_are_copied() {
    crate::oracle::check!(of_lengthened(x, y) at [0.7, 1.3], [-0.4, 0.9]);
}

#[derive(Clone, Differentiable)]
struct Samples {
    values: Vec<f64>,
}

#[differentiable]
fn sampled(x: f64) -> Samples {
    Samples { values: vec![x, x * x] }
}

#[differentiable]
fn of_temporaries(x: f64, y: f64) -> f64 {
    let v = vec![x, y, x * y];
    let mut sum = v.clone().pop().unwrap() * v.to_vec().swap_remove(1) + v[2];
    sum += vec![y, x].remove(1) * Samples { values: vec![x, y] }.values.pop().unwrap_or(0.0);
    for i in 0..2 {
        sum += sampled(sum).values.swap_remove(i) * 0.1;
    }
    if let Some(last) = sampled(y).values.pop() {
        sum *= last;
    }
    sum
}

#[test]
fn what_nothing_names_is_changed() {
    check!(of_temporaries(x, y) at [0.7, 1.3], [-0.4, 0.9]);
}
