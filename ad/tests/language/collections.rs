//! Loops over slices, and `Vec`s that are collected and pushed to.

use ad::differentiable;

use crate::oracle::assert_gradient;

const VALUES: [f64; 6] = [0.7, 1.63, 2.56, 1.32, 2.25, 1.01];

/// Checks the gradient of a function of a slice and a number.
macro_rules! check_slice {
    ($f:ident) => {{
        let point = [&VALUES[..], &[1.3]].concat();
        let primal = |p: &[f64]| $f(&p[..6], p[6]);
        let (value, (xs, y)) = $f::value_and_grad(&VALUES, 1.3);
        assert_eq!(value, primal(&point), stringify!($f));
        assert_gradient(stringify!($f), primal, &point, &[xs, vec![y]].concat());
    }};
}

#[differentiable]
fn over_slices(xs: &[f64], ys: Vec<f64>, y: f64) -> f64 {
    let mut total = y;
    for (x, y) in xs.iter().zip(&ys) {
        total += x * y;
    }
    for (i, w) in xs.windows(2).enumerate() {
        total += w[0] / w[1] * i as f64;
    }
    for part in xs.chunks(4) {
        total += part.iter().map(|x| x.sin()).sum::<f64>() * part[0];
    }
    for x in xs {
        total = total * 0.9 + x * y;
    }
    for y in ys {
        total *= y;
    }
    total
}

#[differentiable]
fn collected(xs: &[f64], y: f64) -> f64 {
    let scaled: Vec<f64> = xs.iter().map(|x| x * y).collect();
    let pairs = scaled.iter().zip(xs).map(|(a, b)| (a * b, *a)).collect::<Vec<_>>();
    let large = xs.iter().copied().filter(|x| *x > 1.0).collect::<Vec<f64>>();
    let mut running = 0.0;
    let sums: Vec<f64> = xs
        .iter()
        .enumerate()
        .map(|(i, x)| {
            running += x * i as f64;
            running
        })
        .collect();
    let nothing: Vec<f64> = large.iter().map(|x| x * y).filter(|x| *x > 1e9).collect();
    let indices: Vec<usize> = (0..xs.len()).rev().collect();
    let mut total: f64 = pairs.iter().map(|(a, b)| a - b).sum();
    for (i, k) in indices.iter().enumerate() {
        total += sums[*k] * scaled[i];
    }
    total * large.iter().product::<f64>() + large[0] * scaled[1] + nothing.iter().sum::<f64>()
}

#[differentiable]
fn pushed(xs: &[f64], y: f64) -> f64 {
    let mut out = Vec::new();
    for x in xs {
        if *x > 1.0 {
            out.push(x * y);
        }
    }
    let mut matrix = vec![vec![1.0; 2]; 3];
    for (i, row) in matrix.iter_mut().enumerate() {
        for (entry, x) in row.iter_mut().zip(xs) {
            *entry *= x * (i as f64 + y);
        }
    }
    out.iter().sum::<f64>() * matrix.iter().map(|row| row[0] * row[1]).sum::<f64>()
}

#[differentiable]
fn relax(xs: &mut [f64], y: f64) {
    for x in xs.iter_mut() {
        *x = *x * y + 0.1;
    }
    for (i, x) in xs.iter_mut().enumerate().rev().step_by(2) {
        *x *= x.sin() * i as f64;
    }
}

#[differentiable]
fn relaxed(xs: &[f64], y: f64) -> f64 {
    let mut state = xs.to_vec();
    relax(&mut state, y);
    relax(&mut state[1..4], y * y);
    state.iter().zip(xs).map(|(a, b)| a * b).sum()
}

#[test]
fn slices() {
    let point = [&VALUES[..], &[0.8, -0.4, 1.3, 0.2, 0.9, 1.1, 1.3]].concat();
    let primal = |p: &[f64]| over_slices(&p[..6], p[6..12].to_vec(), p[12]);
    let (value, (xs, ys, y)) = over_slices::value_and_grad(&point[..6], point[6..12].to_vec(), 1.3);
    assert_eq!(value, primal(&point));
    assert_gradient("over_slices", primal, &point, &[xs, ys, vec![y]].concat());

    check_slice!(collected);
    check_slice!(pushed);
    check_slice!(relaxed);
}

/// The gradient of loops over elements costs a constant time for each.
#[test]
fn work_is_linear() {
    let seconds = |n: usize| {
        let xs = vec![1.001; n];
        let runs = 200_000 / n;
        let start = std::time::Instant::now();
        for _ in 0..runs {
            std::hint::black_box(collected::grad(std::hint::black_box(&xs), 1.0));
        }
        start.elapsed().as_secs_f64() / (runs * n) as f64
    };
    let best = |n| (0..5).map(|_| seconds(n)).fold(f64::MAX, f64::min);
    let (thousand, many) = (best(1000), best(100_000));
    assert!(many < 20.0 * thousand, "{many:e} s an element against {thousand:e} s");
}
