//! `skip_while`, whose predicate is asked until it fails.

use ad::differentiable;

use crate::oracle::check_list;

#[differentiable]
fn in_chains(x: &[f64]) -> f64 {
    let squares: f64 = x.iter().skip_while(|x| **x < 1.0).map(|x| x * x).sum();
    let product = x.iter().skip_while(|x| **x < 0.6).skip_while(|x| **x > 1.0).product::<f64>();
    let between = x
        .iter()
        .map(|x| 2.0 * x)
        .take_while(|x| *x < 7.0)
        .skip_while(|x| *x < 1.5)
        .fold(1.0, |all, x| all * x + x);
    let cut = x.iter().skip_while(|x| **x < 0.6).take_while(|x| **x < 3.5).sum::<f64>();
    squares * product + between * cut
}

#[differentiable]
fn in_loops(x: &[f64]) -> f64 {
    let mut total = 1.0;
    for (i, x) in x.iter().skip_while(|x| **x < 1.0).enumerate() {
        if i == 3 {
            break;
        }
        total += total * x * (i + 1) as f64;
    }
    for k in 0..2 {
        let mut limit = 0.1 + k as f64;
        // The predicate changes what it reads, and is not asked once it has failed.
        for x in x.iter().skip_while(|x| {
            limit *= 1.5;
            **x < limit
        }) {
            total += x * x;
        }
        total *= limit;
    }
    total
}

/// Not asked of an element that comes later, of which it would panic.
#[differentiable]
fn asked_until_it_fails(x: &[f64]) -> f64 {
    let ranks = [1, 0];
    x.iter().enumerate().skip_while(|(i, _)| ranks[*i] > 0).map(|(_, x)| x * x).sum()
}

#[test]
fn elements_are_skipped() {
    check_list!(in_chains, in_loops, asked_until_it_fails at [0.5, 0.9, 3.0, 0.7, 4.0, 2.0]);
    check_list!(in_chains, in_loops at [0.2, 0.3, 0.4]);
    check_list!(in_chains, in_loops at [5.0, 0.3, 1.4, 0.2]);
}
