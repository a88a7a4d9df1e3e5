//! Iterators of the standard library that change a state, hold one item or end in two vectors, and sums
//! within `collect`.

use crate::oracle::check;
use ad::differentiable;
/// The type of the inner sums stands in the signature, at a `let` or at `collect`.
#[differentiable]
fn product(m: &[Vec<f64>], v: &[f64]) -> Vec<f64> {
    m.iter().map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum()).collect()
}

#[differentiable]
fn sums_of_rows(x: f64, y: f64) -> f64 {
    let m = vec![vec![x, y], vec![x * y, 2.0]];
    let v = product(&m, &[y, x]);
    let rows: Vec<f64> = m
        .iter()
        .map(|row| {
            let scale = v[0];
            row.iter().map(|a| a * scale).sum()
        })
        .collect();
    let columns = (0..2).map(|j| m.iter().map(|row| row[j]).product()).collect::<Vec<f64>>();
    let tables: Vec<Vec<f64>> =
        (0..2).map(|i| (0..2).map(|j| m[i].iter().map(|a| a * v[j]).sum()).collect()).collect();
    v[1] * rows[0] + rows[1] * columns[0] - columns[1] + tables[0][1] * tables[1][0]
}

#[differentiable]
fn scans(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y, 0.7];
    let running: Vec<f64> = xs
        .iter()
        .scan(0.0, |sum, a| {
            *sum += a * x;
            Some(*sum * a)
        })
        .collect();
    let mut total = 0.0;
    for (i, p) in xs
        .into_iter()
        .scan(y, |p, a| {
            *p *= a;
            (*p < 2.0).then_some(*p)
        })
        .enumerate()
    {
        total += p * i as f64;
    }
    let weights = xs
        .iter()
        .scan((1.0, 0), |(w, n), a| {
            *w *= 0.5 * y;
            *n += 1;
            Some(*w * a * *n as f64)
        })
        .sum::<f64>();
    let counted = xs
        .iter()
        .scan(0, |n, a| {
            *n += 1;
            if *n > 3 {
                return None;
            }
            Some(a * *n as f64)
        })
        .fold(0.0, |s, t| s + t * t);
    running.iter().sum::<f64>() * total + weights * counted
}

#[differentiable]
fn of_one(x: f64, y: f64) -> f64 {
    let padded: Vec<f64> =
        std::iter::once(x).chain([y, x * y]).chain(std::iter::once(2.0)).collect();
    let scaled = padded.iter().zip(std::iter::repeat(y)).map(|(a, b)| a * b * b).sum::<f64>();
    let three: f64 = core::iter::repeat_n(x * y, 3).product();
    scaled + three + padded[1]
}
/// Into two vectors.
#[differentiable]
fn in_two(x: f64, y: f64) -> f64 {
    let (angles, radii): (Vec<f64>, Vec<f64>) =
        (0..4).map(|i| (x * i as f64, y + i as f64 * x)).unzip();
    let (large, small): (Vec<f64>, Vec<f64>) =
        angles.iter().zip(&radii).map(|(a, r)| a * r).partition(|p| *p > 1.0);
    let (even, odd): (Vec<usize>, Vec<usize>) = (0..5).partition(|i| i % 2 == 0);
    let (near, _) = radii.iter().copied().partition::<Vec<f64>, _>(|r| *r < 2.0);
    let (ids, squares): (Vec<usize>, Vec<f64>) =
        radii.iter().enumerate().filter(|(i, _)| i % 2 == 1).map(|(i, r)| (i, r * r)).unzip();
    large.iter().sum::<f64>() * (small.len() + even.len() + odd[1]) as f64
        + small.iter().map(|s| s * s).sum::<f64>()
        + near.iter().product::<f64>()
        + squares[1] * ids[1] as f64
}

#[test]
fn scans_and_sums() {
    check!(sums_of_rows(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(scans(x, y) at [1.3, 0.7], [0.4, 2.1], [3.0, 0.2]);
    check!(of_one(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(in_two(x, y) at [1.25, 0.6], [0.4, 1.75]);
}
