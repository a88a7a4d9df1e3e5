//! References that become slices as parts of what is returned.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Debug, Differentiable)]
struct Factors {
    left: Vec<f64>,
    right: Vec<f64>,
    scale: f64,
}

#[differentiable]
impl Factors {
    fn both(&self) -> (&[f64], &[f64]) {
        (&self.left, &self.right)
    }

    fn nested(&self) -> (&[f64], f64, (&[f64], usize)) {
        let left = &self.left;
        (left, self.scale, (&self.right, 3))
    }

    fn in_turn(&self, is_turned: bool) -> (&[f64], &[f64]) {
        if is_turned { (&self.right[1..], &self.left) } else { (&self.left, &self.right) }
    }

    fn one_of_three(&self, which: usize) -> &[f64] {
        match which {
            0 => &self.left,
            1 => &self.right[1..],
            _ => {
                let right = &self.right;
                right
            }
        }
    }

    fn returned(&self, is_early: bool) -> &[f64] {
        if is_early {
            return &self.right[1..];
        }
        &self.left
    }

    fn optional(&self, is_there: bool) -> Option<(&[f64], f64)> {
        if !is_there {
            return None;
        }
        Some((&self.left, self.scale))
    }

    fn attempted(&self, is_there: bool) -> Result<&[f64], String> {
        if is_there { Ok(&self.right) } else { Err("nothing".to_owned()) }
    }
}

#[differentiable]
fn taken(factors: &Factors) -> f64 {
    let mut total = 0.0;
    for is_there in [true, false] {
        if let Some((left, scale)) = factors.optional(is_there) {
            total += left[0] * left[1] * scale;
        }
        total += match factors.attempted(is_there) {
            Ok(right) => right[0] * right[1],
            Err(message) => message.len() as f64,
        };
    }
    total
}

#[differentiable]
fn all(x: f64, y: f64) -> f64 {
    let factors = Factors { left: vec![x, y], right: vec![x * y, 2.0 * x], scale: y };
    let (left, right) = factors.both();
    let mut total = left[0] * right[1] * left.len() as f64;
    let (left, scale, (right, count)) = factors.nested();
    total = total * left[1] * scale + right[0] * count as f64;
    for is_turned in [false, true] {
        let (first, second) = factors.in_turn(is_turned);
        total = total * first[0] + second[1] * factors.returned(is_turned)[0];
    }
    for which in 0..3 {
        total += factors.one_of_three(which)[0] * (which + 1) as f64;
    }
    let (whole, part): (&[f64], &[f64]) = (&factors.left, &factors.right[..1]);
    let chosen: &[f64] = if x > 0.0 { &factors.left } else { &factors.right[1..] };
    total * whole[1] * part[0] + chosen[0] * taken(&factors)
}

#[test]
fn references_that_become_slices() {
    check!(all(x, y) at [0.7, 1.3], [-0.4, 0.9]);
}

#[differentiable]
fn halves(v: &[f64]) -> (&[f64], &[f64]) {
    v.split_at(v.len() / 2)
}

#[differentiable]
fn beyond<'a>(rows: &'a [Vec<f64>], i: usize) -> Option<&'a Vec<f64>> {
    if i == 0 { None } else { rows.get(i) }
}

#[differentiable]
fn smaller_first<'a>(v: &'a [f64], w: &'a [f64]) -> (&'a [f64], f64, &'a [f64]) {
    if v[0] < w[0] { (v, w[1], w) } else { (w, v[1], v) }
}

/// Functions that give several references may be called on variables of the function itself.
#[differentiable]
fn of_own_variables(x: f64, y: f64) -> f64 {
    let v = vec![x, y, x * y, x + y];
    let (left, right) = halves(&v);
    let rows = vec![v.clone(), vec![left[0] * right[1], right[0], y]];
    let mut s = left[1];
    if let Some(row) = beyond(&rows, 1) {
        s += row[0] * row[1];
    }
    let (first, between, second) = smaller_first(&v, &rows[1]);
    s * first[1] * between * second[0]
}

#[test]
fn references_to_own_variables() {
    check!(of_own_variables(x, y) at [0.7, 1.3], [-0.4, 0.9]);
}
