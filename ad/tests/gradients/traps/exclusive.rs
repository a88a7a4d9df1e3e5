//! `&mut`: what is changed, by whom, and when.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

/// Counts what carries no derivative, beside what carries one.
#[differentiable]
fn counted(n: &mut usize, x: &mut f64, sign: &mut bool) -> f64 {
    *n += 1;
    *sign = !*sign;
    *x *= if *sign { 2.0 } else { *x };
    *x * *n as f64
}

#[differentiable]
fn counts(x: f64, y: f64) -> f64 {
    let (mut n, mut sign) = (0, false);
    let mut z = x;
    let mut sum = 0.0;
    for _ in 0..3 {
        sum += counted(&mut n, &mut z, &mut sign) * y;
    }
    sum * n as f64
}

/// A stack that grows while it is worked off.
#[differentiable]
fn worked_off(x: f64, y: f64) -> f64 {
    let mut stack = vec![(x, 3), (y, 1)];
    let mut sum = 0.0;
    while let Some((value, depth)) = stack.pop() {
        if depth == 0 {
            sum += value * value;
            continue;
        }
        stack.push((value * x, depth - 1));
        if depth % 2 == 1 {
            stack.push((value + y * sum, depth - 1));
        }
    }
    sum
}

#[differentiable]
fn given_back(mut xs: Vec<f64>, by: f64) -> Vec<f64> {
    xs[0] *= by;
    xs
}

/// Moved into a call and back, overwritten after it was read, swapped with a part of itself.
#[differentiable]
fn moved(x: f64, y: f64) -> f64 {
    let mut xs = vec![x, y, x + y];
    let before = xs[0];
    xs = given_back(xs, y);
    let kept = xs.clone();
    xs[1] = xs[0] * before;
    xs.swap(0, 2);
    let mut ys = vec![1.0; 2];
    std::mem::swap(&mut xs, &mut ys);
    xs.push(ys[0] * kept[1]);
    ys[1] += xs[2];
    let last = xs.len() - 1;
    ys[1] * kept[0] + xs[last] * ys[2]
}

#[differentiable]
fn changed_on_one_way(x: f64, y: f64) -> f64 {
    let mut a = [x, y];
    for i in 0..4 {
        if i % 2 == 0 {
            let first = &mut a[0];
            double(first, y);
            if *first > 3.0 {
                break;
            }
        } else if a[1] < 10.0 {
            double(&mut a[1], x);
        }
    }
    a[0] * a[1]
}

#[differentiable]
fn double(x: &mut f64, by: f64) {
    if by < 0.0 {
        return;
    }
    *x *= 2.0 * by;
}

/// The value of a call is not used, or only that of the change.
#[differentiable]
fn unused_values(x: f64, y: f64) -> f64 {
    let mut z = x;
    let mut n = 0;
    let mut sign = true;
    counted(&mut n, &mut z, &mut sign);
    let w = z;
    let _ = counted(&mut n, &mut z, &mut sign);
    let value = counted(&mut n, &mut z, &mut sign);
    z = y;
    value * w + z
}

#[derive(Clone, Copy, Differentiable)]
struct Turtle {
    at: (f64, f64),
    step: f64,
}

#[differentiable]
impl Turtle {
    fn forward(&mut self) -> &'static str {
        self.at.0 += self.step * self.at.1;
        "moved"
    }

    fn turn(mut self, by: f64) -> Self {
        self.at = (self.at.1 * by, -self.at.0);
        self.forward();
        self
    }

    fn length(&self) -> f64 {
        self.at.0 * self.at.1
    }
}

#[differentiable]
fn turtle(x: f64, y: f64) -> f64 {
    let mut turtle = Turtle { at: (x, y), step: x * y };
    let copy = turtle;
    turtle.forward();
    let mut turned = turtle.turn(y);
    turned.forward();
    let mut add = |by: f64| turned.step += by * turtle.length();
    add(x);
    add(y);
    turned.length() * turned.step + copy.length() + turtle.at.0
}

#[test]
fn changes_are_seen_in_their_order() {
    check!(counts(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(worked_off(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(moved(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(changed_on_one_way(x, y) at [1.3, 0.7], [-0.4, 2.1], [1.3, -0.7], [0.4, 3.0]);
    check!(unused_values(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(turtle(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
