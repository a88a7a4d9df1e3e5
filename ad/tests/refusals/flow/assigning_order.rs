use ad::{Real, differentiable};
use glam::DVec3;

fn pick(n: usize) -> usize {
    n / 2
}

fn noise() -> f64 {
    0.5
}

#[differentiable]
fn of_vectors(x: DVec3) -> f64 {
    let mut sums = [x, x];
    sums[pick(2)] *= noise();
    sums[0].x
}

#[differentiable]
fn of_scalars<S: Real>(x: S) -> S {
    let mut sums = [x, x];
    sums[pick(2)] += x * S::from_f64(noise());
    sums[0]
}

#[differentiable]
fn of_an_index(x: DVec3) -> f64 {
    let mut sums = [x, x];
    let mut k = 0;
    sums[k] *= {
        k += 1;
        x.y
    };
    sums[k].x
}

#[differentiable]
fn takes_out_on_both_sides(x: f64, v: &[DVec3; 3]) -> f64 {
    let (mut whole, mut left) = (*v, vec![2_usize, 1, 0]);
    whole[left.pop().unwrap()] += whole[left.pop().unwrap()] * x;
    whole[0].x
}

#[differentiable]
fn of_references(v: &[f64]) -> f64 {
    let (mut whole, mut left) = (v.to_vec(), vec![2_usize, 1, 0]);
    whole[left.pop().unwrap()] += v.get(left.pop().unwrap()).unwrap();
    whole[0]
}

fn main() {}
