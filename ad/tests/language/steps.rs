//! Iterators that have a name, and are asked for one item after the other.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn item_by_item(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y, 3.0, x + y, 0.5 * y];
    let mut items = xs.iter();
    let mut sum = y * *items.next().unwrap();
    if let Some(second) = items.next() {
        sum *= second;
    }
    while let Some(item) = items.next() {
        if *item > 2.5 {
            continue;
        }
        sum = sum * 0.5 + item * item;
        if sum > 20.0 {
            break;
        }
    }
    for item in items {
        sum = sum * x + item;
    }
    sum
}

#[differentiable]
fn in_pairs(x: f64, y: f64) -> f64 {
    let xs = vec![x, y, x * y, y * y, x];
    let mut copies = xs[1..].iter().copied();
    let first = copies.next().unwrap_or(y);
    let mut sum = first;
    while let (Some(a), Some(b)) = (copies.next(), copies.next()) {
        sum += a * b;
    }
    // Behind the end it stays there.
    let none = copies.next().map_or(x, |z| 100.0 * z);
    sum * none + copies.sum::<f64>()
}

#[differentiable]
fn leaving(xs: &[f64]) -> Option<f64> {
    let mut items = xs.iter();
    let a = items.next()?;
    let b = items.next()?;
    let rest = items.map(|item| item * a).sum::<f64>();
    Some(a * b * rest)
}

#[differentiable]
fn left(x: f64, y: f64) -> f64 {
    let all = [x, y, x * x, 2.0];
    leaving(&all).unwrap_or(x) + leaving(&all[..1]).unwrap_or(y)
}

#[differentiable]
fn merged(x: f64, y: f64) -> f64 {
    let (xs, ys) = ([x, x + y, 5.0], vec![0.5 * y, y]);
    let mut left = xs.iter();
    let mut right = ys.iter();
    let (mut a, mut b) = (left.next(), right.next());
    let (mut sum, mut weight) = (0.0, 1.0);
    loop {
        match (a, b) {
            (Some(p), Some(q)) if p < q => {
                sum += weight * *p;
                a = left.next();
            }
            (_, Some(q)) => {
                sum += weight * *q;
                b = right.next();
            }
            (Some(p), None) => {
                sum += weight * *p;
                a = left.next();
            }
            (None, None) => break,
        }
        weight *= 0.7 * x;
    }
    sum
}

#[derive(Clone, Copy, Debug, Differentiable)]
struct P {
    a: f64,
    b: f64,
}

#[differentiable]
fn changed(x: f64, y: f64) -> f64 {
    let mut rows = vec![vec![P { a: x, b: y }; 4], vec![P { a: y, b: x }; 2]];
    let mut k = 0;
    let mut items = rows[k].iter_mut();
    k += 1;
    *items.next().unwrap() = P { a: x * y, b: x };
    if let Some(item) = items.next() {
        item.a *= y;
    }
    let third = items.next().unwrap();
    third.b += third.a * x;
    for item in items {
        item.b *= x;
    }
    let Some(last) = rows[k].iter_mut().last() else { return x };
    last.a *= 3.0;
    if let Some(first) = rows[k].iter_mut().next() {
        first.b = first.a * y;
    }
    rows[0].iter_mut().nth(1).unwrap().b *= y;
    rows.iter().flatten().map(|p| p.a * p.a + p.b).sum()
}

#[differentiable]
fn asked_in_a_condition(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y];
    let mut items = xs.iter();
    if items.next().is_none() || items.next().is_none() {
        return 0.0;
    }
    let mut count = 0;
    while items.next().is_some() {
        count += 1;
    }
    let mut again = xs.iter();
    for i in 0..5 {
        if let Some(item) = again.next()
            && *item > 0.0
        {
            count += i;
        }
    }
    x * count as f64
}

#[differentiable]
fn lent_to_loops(x: f64, y: f64) -> f64 {
    let mut xs = vec![x, y, x * y, 0.5, x + y, y];
    let mut items = xs.iter_mut();
    'first: for item in items.by_ref() {
        *item *= x;
        for _ in 0..2 {
            if *item > 0.6 {
                break 'first;
            }
            *item += 0.1;
        }
    }
    for (i, item) in items.enumerate() {
        *item *= y * i as f64;
    }
    let mut copies = xs.iter().copied();
    let mut sum = 0.0;
    for item in &mut copies {
        sum = sum * y + item;
        if item < 0.3 {
            break;
        }
    }
    copies.fold(sum, |sum, item| sum * item + x)
}

#[differentiable]
fn asked_by_a_closure(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y];
    let mut items = xs.iter();
    // The name of what it runs over may get another meaning.
    let xs = 3.0 * y;
    let mut next = || items.next().copied().unwrap_or(y);
    let first = next() * 2.0;
    let second = next() * xs;
    first + second + next() * next() * next()
}

#[differentiable]
fn one_within_another(x: f64, y: f64) -> f64 {
    let mut rows = vec![vec![x, y, 0.5], vec![y; 4]];
    let (mut k, mut sum) = (0, x);
    while k < 2 {
        let mut items = rows[k].iter();
        k += 1;
        #[differentiable(checkpoint)]
        while let Some(item) = items.next() {
            sum = (sum * x).sin() + item;
        }
    }
    rows[1][2] *= sum;
    let mut outer = rows.iter();
    while let Some(row) = outer.next() {
        let mut inner = row.iter();
        let _ = inner.next();
        while let Some(item) = inner.next() {
            sum += item * y;
        }
        if let Some(greatest) = row.iter().max_by(|a, b| a.total_cmp(b)) {
            sum *= greatest;
        }
    }
    sum
}

#[test]
fn one_after_the_other() {
    check!(item_by_item(x, y) at [1.3, 0.4], [-0.7, 1.1], [2.6, 1.9]);
    check!(in_pairs(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(left(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(merged(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, 1.9]);
    check!(changed(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(lent_to_loops(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(asked_by_a_closure(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(one_within_another(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(asked_in_a_condition(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
}
