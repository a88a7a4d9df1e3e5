//! References to one element of a slice, and to one of several places.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Debug, Differentiable)]
struct P {
    a: f64,
    b: f64,
}

#[differentiable]
impl P {
    fn bounce(&mut self, k: f64) -> f64 {
        self.a *= k;
        self.a + self.b
    }
}

#[differentiable]
fn bump(a: &mut f64, k: f64) -> f64 {
    *a *= k;
    *a + k
}

#[differentiable]
fn chosen(x: f64, y: f64) -> f64 {
    let mut a = x * y;
    let mut b = y;
    let r = if x > y { &mut a } else { &mut b };
    *r *= x;
    let t = *r;
    bump(r, t);
    a * b
}

#[differentiable]
fn chosen_in_a_loop(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y, x * y];
    for i in 0..3 {
        let r: &mut f64 = match i {
            0 => &mut v[2],
            1 => &mut v[0],
            _ => &mut v[1],
        };
        *r += y;
        if *r > 10.0 {
            continue;
        }
        *r *= x;
    }
    v[0] * v[1] + v[2]
}

#[differentiable]
fn chosen_twice(x: f64, y: f64) -> f64 {
    let (mut a, mut b) = (P { a: x, b: y }, P { a: y, b: x });
    let p = if x > 0.0 { &mut a } else { &mut b };
    p.a *= y;
    let s = p.bounce(x);
    let q = if y > 0.0 { &mut a } else { &mut b };
    q.b += s;
    if s > 100.0 {
        return x;
    }
    a.a * b.b + a.b * b.a
}

#[differentiable]
fn assigned(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    *v.last_mut().unwrap() = x * y;
    *v.first_mut().unwrap() *= y;
    *v.get_mut(1).expect("one") += x;
    v[0] * v[1]
}

#[differentiable]
fn if_there_is_one(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    if let Some(l) = v.last_mut() {
        *l *= x;
        *l += y;
    }
    if let Some(l) = v.get_mut(7) {
        *l = 0.0;
    } else {
        v[0] *= y;
    }
    v[0] * v[1]
}

#[differentiable]
fn named(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    let l = v.last_mut().unwrap();
    *l *= x;
    *l += *l * y;
    v.push(x);
    let m = v.last_mut().unwrap();
    bump(m, y);
    v[0] * v[1] + v[2]
}

#[differentiable]
fn methods(x: f64, y: f64) -> f64 {
    let mut v = vec![P { a: x, b: y }, P { a: y, b: x * y }];
    v.last_mut().unwrap().a *= x;
    let s = v.last_mut().unwrap().bounce(y) + v.first_mut().unwrap().bounce(x);
    let t = bump(&mut v.last_mut().unwrap().b, x);
    if let Some(P { a, b }) = v.last_mut() {
        *a *= *b;
    }
    v[1].a * v[0].b + s * t
}

#[differentiable]
fn let_else(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    let Some(l) = v.last_mut() else { return x };
    *l *= x;
    match v.first_mut() {
        None => return y,
        Some(f) => *f *= 2.0,
    }
    bump(v.last_mut().unwrap(), x) * v[0]
}

#[differentiable]
fn stack(x: f64, y: f64) -> f64 {
    let mut stack = vec![x];
    for t in [y, x, 2.0] {
        if let Some(top) = stack.last_mut() {
            *top *= t;
        }
        stack.push(t * y);
    }
    stack.iter().sum::<f64>() * stack.pop().unwrap()
}

mod of_a_parameter {
    use super::*;

    #[differentiable]
    fn g(v: &mut Vec<f64>, k: f64) {
        if let Some(t) = v.last_mut() {
            *t *= k;
        }
        *v.first_mut().unwrap() -= k;
    }
    #[differentiable]
    pub fn value(x: f64, y: f64) -> f64 {
        let mut v = vec![x, y];
        g(&mut v, x);
        g(&mut v, y);
        v[0] * v[1]
    }
}

#[test]
fn what_is_lent_is_changed() {
    check!(chosen(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(chosen_in_a_loop(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(chosen_twice(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(assigned(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(if_there_is_one(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(named(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(methods(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(let_else(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(stack(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    {
        use of_a_parameter::value;
        check!(value(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    }
}

#[differentiable]
fn squared_at(row: &[f64], i: usize) -> f64 {
    row[i] * row[i]
}

#[differentiable]
fn read(x: f64, y: f64) -> f64 {
    let mut rows = vec![vec![x, y, x * y], vec![y, 2.0, x]];
    let option = Some(vec![x, x * x]);
    let (mut sum, mut calls) = (0.0, 0_usize);
    for i in 0..3 {
        // The position is evaluated once.
        let row = rows
            .get({
                calls += 1;
                calls % 2
            })
            .unwrap();
        sum += row[i] * rows.last().unwrap()[0] * calls as f64;
        if let Some(row) = rows.get(i) {
            sum += squared_at(row, i) * squared_at(rows.first().unwrap(), 2);
        } else {
            sum *= y;
        }
        sum += match rows[0].get(i + 1) {
            None => x * x,
            Some(z) => z * *rows[1].first().unwrap(),
        };
        if let Some(row) = option.as_ref() {
            sum += row[1] * row.len() as f64;
        }
        let last = rows.last().unwrap()[2];
        rows[0][i] += last * last;
    }
    sum
}

#[test]
fn what_is_lent_is_read() {
    check!(read(x, y) at [0.7, 0.4], [-0.4, 1.7]);
}
