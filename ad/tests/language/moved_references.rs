//! `&mut` that move from one name to another.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Differentiable)]
struct Account {
    amounts: Vec<f64>,
    rate: f64,
}

#[differentiable]
impl Account {
    /// Through names for itself and for a field.
    fn pay(&mut self, by: f64) -> f64 {
        let account = self;
        account.rate *= by;
        let field = &mut account.amounts;
        let amounts = field;
        amounts[0] += account.rate;
        amounts.push(by * by);
        account.amounts[0] * account.rate
    }

    fn length(&self) -> f64 {
        self.amounts[0] * 3.0
    }
}

#[differentiable]
fn paid(x: f64, y: f64) -> f64 {
    let mut account = Account { amounts: vec![x, y], rate: y };
    let paid = account.pay(x);
    let lent = &mut account;
    let named: &mut Account = lent;
    named.rate *= named.length();
    paid * account.rate + account.amounts[2]
}

#[differentiable]
fn doubled(xs: &mut [f64], by: f64) {
    let elements = xs;
    elements[0] *= by;
    let whole = &mut *elements;
    let rest = whole;
    rest[1] += rest[0] * by;
}

/// Parameters, items of loops, and what one of two is.
#[differentiable]
fn passed(x: f64, y: f64) -> f64 {
    let mut xs = [x, y, x * y];
    doubled(&mut xs[..2], y);
    for element in xs.iter_mut() {
        let same = element;
        *same *= x;
    }
    let one = if x > y { &mut xs[0] } else { &mut xs[1] };
    let same = one;
    *same += y;
    xs[0] * xs[1] + xs[2]
}

/// Elements that are lent, or else nothing is given.
#[differentiable]
fn lent(xs: &[f64], by: f64, at: usize) -> Option<f64> {
    let mut xs = xs.to_vec();
    let last = xs.last_mut()?;
    *last *= by;
    for index in 0..2 {
        let element = xs.get_mut(index + at)?;
        *element += by * *element;
    }
    Some(xs[0] * xs[1])
}

#[differentiable]
fn lent_or_not(x: f64, y: f64) -> f64 {
    let xs = [x, y, x + y];
    lent(&xs, y, 1).unwrap_or(x) * lent(&xs, x, 2).unwrap_or(y) + lent(&xs[..0], x, 0).unwrap_or(x)
}

#[test]
fn moved_references() {
    check!(paid(x, y) at [1.3, 0.7], [-0.6, 1.1]);
    check!(passed(x, y) at [1.3, 0.7], [-0.6, 1.1]);
    check!(lent_or_not(x, y) at [1.3, 0.7], [-0.6, 1.1]);
}
