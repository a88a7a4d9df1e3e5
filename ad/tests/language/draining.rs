//! `drain`, `retain`, sorting by keys, `copy_within`, binary searches.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Debug, Differentiable)]
struct P {
    a: f64,
    b: f64,
}

#[differentiable]
fn drained(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y, x * x];
    let s: f64 = v.drain(1..3).sum();
    v.push(s * x);
    v[0] * s + v[1] * v[2]
}

#[differentiable]
fn drained_in_a_loop(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y, x * x];
    let mut s = 0.0;
    for (i, t) in v.drain(..2).enumerate() {
        s += t * t * (i + 1) as f64;
        if t < -1.0 {
            break;
        }
    }
    v[0] * s + v[1]
}

#[differentiable]
fn drained_and_mapped(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y, x * x];
    let w: Vec<f64> = v.drain(1..=2).map(|t| t * x).collect();
    v.drain(..1);
    v[0] * w[1] + w[0]
}

#[differentiable]
fn drained_backwards(x: f64, y: f64) -> f64 {
    let mut v = vec![P { a: x, b: y }, P { a: y, b: x * y }, P { a: 1.0, b: x }];
    let mut out = vec![];
    out.extend(v.drain(1..).rev());
    let mut s = 0.0;
    for p in &out {
        s += p.a * p.b;
        s *= x;
    }
    s + v[0].a
}

mod drained_field {
    use super::*;

    #[derive(Clone, Differentiable)]
    struct Q {
        items: Vec<f64>,
    }
    #[differentiable]
    impl Q {
        fn take(&mut self, n: usize) -> f64 {
            let n = n.min(self.items.len());
            let mut s = 0.0;
            for t in self.items.drain(..n) {
                s += t * t;
            }
            s
        }
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let mut q = Q { items: vec![x, y, x * y, 2.0] };
        let a = q.take(1);
        let b = q.take(2);
        a * b + q.items[0] * q.take(5)
    }
}

#[differentiable]
fn retained(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y, x * x, 1.0];
    v.retain(|t| *t > 0.0);
    let lim = x;
    v.retain(|&t| t < lim + 3.0);
    let mut s = 0.0;
    for (i, t) in v.iter().enumerate() {
        s += t * t * (i + 1) as f64;
    }
    s * x
}

#[differentiable]
fn retained_structs(x: f64, y: f64) -> f64 {
    let mut v = vec![P { a: x, b: y }, P { a: y, b: x * y }, P { a: 1.0, b: x }];
    let mut k = 0;
    v.retain(|p| p.a > 0.5);
    k += v.len();
    v.iter().map(|p| p.a * p.b).sum::<f64>() * k as f64
}

#[differentiable]
fn without_repetitions(x: f64, y: f64) -> f64 {
    let mut v = vec![x, x, y, x * y, x * y, x * y, x, x + y];
    v.dedup();
    let mut w = vec![(1, x), (1, y), (2, x * x), (2, y * y), (1, x * y)];
    w.dedup_by_key(|(k, _)| *k);
    let near = 0.2 * y.abs();
    let mut u = vec![x, x + 0.1 * y, x + 0.15 * y, x + y, x - y];
    u.dedup_by(|a, b| (*a - *b).abs() < near);
    let mut p = vec![P { a: x, b: y }, P { a: x, b: x * x }, P { a: y, b: x }];
    p.dedup_by(|one, other| one.a == other.a);
    let mut none: Vec<f64> = Vec::new();
    none.dedup();
    none.push(y);
    let mut total = p[1].b * p.len() as f64 + none[0];
    for (i, t) in v.iter().chain(&u).enumerate() {
        total += t * t * (i + 1) as f64;
    }
    total + w[1].1 * w[2].1 * v[4] * u[u.len() - 1]
}

#[differentiable]
fn by_key(x: f64, y: f64) -> f64 {
    let mut v = vec![(2, x), (1, y), (3, x * y)];
    v.sort_by_key(|p| p.0);
    v[0].1 * v[1].1 * x + v[2].1
}

#[differentiable]
fn by_name(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y];
    v.sort_by(f64::total_cmp);
    let mut w = [y, x, 1.0];
    w.sort_unstable_by(|a, b| b.total_cmp(a));
    let mut places = [3, 1, 2];
    places.sort_unstable_by_key(|place| -place);
    v[0] * v[1] + v[2] * v[2] * w[0] + w[2] * f64::from(places[0])
}

#[differentiable]
fn by_keys(x: f64, y: f64) -> f64 {
    let mut v = vec![(2, x), (1, y), (3, x * y)];
    v.sort_by_key(|&(k, _)| std::cmp::Reverse(k));
    fn key(p: &(i32, f64)) -> i32 {
        -p.0
    }
    let s = v[0].1;
    v.sort_by_key(key);
    v[0].1 * v[1].1 + v[2].1 * s
}

#[differentiable]
fn listed(x: f64, y: f64) -> Vec<f64> {
    vec![x, y, x * y]
}

/// Drains what a call, a macro and a method give, with and without a derivative.
#[differentiable]
fn drained_without_a_name(x: f64, y: f64) -> f64 {
    let mut sum = 0.0;
    for z in listed(x, y).drain(1..) {
        sum += z * x;
    }
    for z in vec![x, y].drain(..) {
        sum += z * z;
    }
    let weights = vec![0.5, 2.0];
    for weight in weights.clone().drain(1..) {
        sum += weight * listed(y, x).drain(..2).map(|z| z * z).sum::<f64>();
    }
    let last: Vec<f64> = listed(x, sum).drain(2..).collect();
    last[0] * weights[0]
}

#[differentiable]
fn copied_within(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y, 2.0];
    v.copy_within(0..2, 1);
    let mut w = [x, y, y, x * x, 1.0];
    w.copy_within(2.., 0);
    w[1..].copy_within(..=1, 2);
    v[1] * v[2] + v[3] * v[0] + w[0] * w[1] + w[3] * w[4] * w[2]
}

#[differentiable]
fn searched(x: f64, y: f64) -> f64 {
    let v = [0.0, 0.5, 1.0, 2.0];
    let i = match v.binary_search_by(|t: &f64| t.total_cmp(&x)) {
        Ok(i) => i,
        Err(i) => i,
    };
    let k = v.partition_point(|t| *t < y);
    i as f64 * x + k as f64 * y
}

#[differentiable]
fn searched_active(x: f64, y: f64) -> f64 {
    let v = [x - 1.0, x, x + 1.0];
    let k = v.partition_point(|t| *t < y);
    let k = k.min(2);
    let i = v.binary_search_by(|t| t.partial_cmp(&0.45).unwrap()).unwrap_or_else(|i| i);
    v[k] * y + v[i.min(2)] * if v.contains(&y) { x } else { y }
}

#[differentiable]
fn in_conditions(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y];
    if v.remove(0) > 0.0 {
        v[0] *= x;
    }
    while v.swap_remove(0) < 0.5 && v.len() > 1 {
        v.push(y);
        if v.len() > 5 {
            break;
        }
    }
    v[0] * y
}

#[test]
fn elements_are_moved_with_their_derivatives() {
    check!(drained(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(drained_in_a_loop(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(drained_and_mapped(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(drained_without_a_name(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(drained_backwards(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    {
        use drained_field::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
    check!(retained(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(retained_structs(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(without_repetitions(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(by_key(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(by_name(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(by_keys(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(copied_within(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(searched(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(searched_active(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(in_conditions(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
}

#[differentiable]
fn take_some(list: &mut Vec<f64>, k: f64) -> f64 {
    list.copy_within(0..2, 1);
    let mut sum = 0.0;
    for x in list.drain(1..3) {
        sum += x * k;
    }
    let rest: Vec<f64> = list.drain(..1).collect();
    list.push(sum * rest[0]);
    sum
}

#[differentiable]
fn drained_behind_a_reference(x: f64, y: f64) -> f64 {
    let mut list = vec![x, y, x * y, x * x];
    let sum = take_some(&mut list, y);
    list[0] * sum + list[1] * x
}

#[test]
fn ranges_of_what_is_behind_a_reference() {
    check!(drained_behind_a_reference(x, y) at [0.7, -1.2], [1.5, 0.4]);
}
