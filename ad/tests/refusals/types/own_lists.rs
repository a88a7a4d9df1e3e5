use std::iter::Rev;
use std::ops::{Deref, Index};
use std::slice::Iter;

use ad::differentiable;

struct Ring {
    items: [usize; 4],
    first: usize,
}

impl Ring {
    fn len(&self) -> usize {
        self.items.len()
    }

    fn iter(&self) -> impl Iterator<Item = &usize> + '_ {
        (0..4).map(move |k| &self.items[(self.first + k) % 4])
    }
}

impl Index<usize> for Ring {
    type Output = usize;

    fn index(&self, i: usize) -> &usize {
        &self.items[i]
    }
}

struct Backwards(Vec<usize>);

impl Deref for Backwards {
    type Target = Vec<usize>;

    fn deref(&self) -> &Vec<usize> {
        &self.0
    }
}

impl<'a> IntoIterator for &'a Backwards {
    type Item = &'a usize;
    type IntoIter = Rev<Iter<'a, usize>>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter().rev()
    }
}

struct Both {
    ring: Ring,
}

#[differentiable(reverse)]
fn in_its_own_order(#[constant] ring: &Ring, xs: &[f64]) -> f64 {
    let mut sum = 1.0;
    for i in ring.iter() {
        sum = 0.5 * sum + xs[*i];
    }
    sum
}

#[differentiable(reverse)]
fn behind_another_list(#[constant] backwards: &Backwards, xs: &[f64]) -> f64 {
    let mut sum = 1.0;
    for i in backwards {
        sum = 0.5 * sum + xs[*i];
    }
    for pair in backwards.windows(2) {
        sum = 0.5 * sum + xs[pair[0]];
    }
    sum
}

#[differentiable(reverse)]
fn in_a_field(#[constant] both: &Both, xs: &[f64]) -> f64 {
    xs.iter().zip(both.ring.iter()).map(|(x, i)| x * xs[*i]).fold(1.0, |sum, x| 0.5 * sum + x)
}

#[differentiable(reverse)]
fn as_a_list(#[constant] ring: &Ring, xs: &[f64]) -> f64 {
    let mut sum = 1.0;
    let items = ad::no_diff(|| ring.iter().copied().collect::<Vec<_>>());
    for i in items.iter() {
        sum = 0.5 * sum + xs[*i];
    }
    sum
}

fn main() {
    let ring = Ring { items: [0, 1, 2, 3], first: 2 };
    as_a_list::grad(&ring, &[1.0, 2.0, 3.0, 4.0]);
}
