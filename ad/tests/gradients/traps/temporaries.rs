//! Values without a name that have an effect when they are dropped, at the end of their statement.

use std::cell::RefCell;
use std::sync::Mutex;

use ad::differentiable;

use super::drops::{Guard, scale};
use crate::oracle::check;

impl Guard {
    fn count(&self) -> usize {
        self.get() as usize
    }

    fn some(&self) -> Option<f64> {
        (self.get() > 1.0).then(|| self.get())
    }

    fn list(&self) -> &[f64] {
        &[1.5, 0.5]
    }
}

struct Weighted {
    _guard: Guard,
    weight: f64,
}

fn weighted() -> Weighted {
    Weighted { _guard: Guard::push(3.0), weight: 0.5 }
}

fn seen(guard: &Guard) -> f64 {
    guard.get()
}

#[differentiable]
fn operands(x: f64, y: f64) -> f64 {
    let a = x * Guard::push(3.0).get() * scale();
    let b = y * seen(&Guard::push(2.0)) * scale() + weighted().weight * scale();
    let mut c = a * b * scale();
    c += Guard::push(2.0).get() * scale() * y;
    c *= Guard::push(5.0).get();
    c * scale()
}

#[differentiable]
fn indices(x: f64, y: f64) -> f64 {
    let mut v = [x, y, x * y, x - y];
    let a = v[Guard::push(3.0).count()] * scale();
    v[Guard::push(2.0).count()] += a * scale();
    v[Guard::push(1.0).count()] = v[2] * scale();
    let mut product = v[1] * scale();
    for w in &v[..Guard::push(2.0).count()] {
        product *= w * scale();
    }
    product * scale()
}

#[differentiable]
fn matched(x: f64, y: f64) -> f64 {
    let a = match Guard::push(2.0).count() {
        2 => x * scale(),
        _ => y,
    };
    let b =
        y * (match Guard::push(3.0).some() {
            Some(s) if s > 1.0 => a * s * scale(),
            _ => y,
        }) * scale();
    let c = match (Guard::push(2.0), scale()) {
        (guard, s) => x * guard.get() * s * scale(),
    };
    let d = match Guard::push(4.0) {
        _ => c * scale(),
    };
    match weighted().weight {
        w if w > 0.6 => return x,
        w => b * d * w * scale(),
    }
}

#[differentiable]
fn after_a_match(x: f64, y: f64) -> f64 {
    match Guard::push(2.0).count() {
        3 => return x * scale(),
        _ => {}
    }
    x * y * scale()
}

#[differentiable]
fn if_let(x: f64, y: f64) -> f64 {
    let a = if let Some(s) = Guard::push(2.0).some() { x * s * scale() } else { y };
    let b = if let Some(s) = Guard::push(0.5).some() { s * x } else { y * scale() };
    let c = if let Some(s) = Guard::push(2.0).some()
        && scale() > 1.0
        && let Some(t) = Guard::push(3.0).some()
    {
        s * t * x * scale()
    } else {
        y * scale()
    };
    let d = if let Some(s) = Guard::push(2.0).some()
        && let Some(t) = Guard::push(0.5).some()
    {
        s * t * x * scale()
    } else {
        y * scale()
    };
    let mut e = x;
    if let Some(s) = Guard::push(2.0).some() {
        if y > 5.0 {
            return e * scale();
        }
        e *= s * scale();
    }
    a * b * c * d * e * scale()
}

#[differentiable]
fn let_else(x: f64, y: f64) -> f64 {
    let Some(s) = Guard::push(2.0).some() else { return x * scale() };
    let Some(t) = Some(x * Guard::push(3.0).get() * scale()) else { return y * scale() };
    let Some(u) = Guard::push(0.5).some() else { return s * t * x * y * scale() };
    s * t * u * y * scale()
}

#[differentiable]
fn loops(x: f64, y: f64) -> f64 {
    let mut z = x;
    for _ in 0..Guard::push(2.0).count() {
        z *= y * scale();
    }
    for w in Guard::push(3.0).list() {
        z += y * *w * scale();
    }
    for (i, w) in Guard::push(3.0).list().iter().enumerate() {
        z += y * w * scale();
        if i > 0 && z > 100.0 {
            return z * x * scale();
        }
    }
    let mut k = 0;
    while Guard::push(2.0).count() > k {
        z += x * scale();
        k += 1;
    }
    let numbers = RefCell::new(vec![1.5, 2.5]);
    while let Some(w) = numbers.borrow_mut().pop() {
        z *= if numbers.try_borrow().is_ok() { y } else { 2.0 * w };
    }
    z * scale()
}

fn factor(n: f64) -> Option<f64> {
    Guard::push(n).some()
}

#[differentiable]
fn attempt(x: f64, y: f64) -> Option<f64> {
    let a = Guard::push(2.0).some()? * x * scale();
    let b = factor(2.0)? * a * scale();
    Some(b * y * scale())
}

#[differentiable]
fn attempted(x: f64, y: f64) -> f64 {
    attempt(x, y).unwrap_or(y) * scale()
}

#[differentiable]
fn blocks(x: f64, y: f64) -> f64 {
    let a = {
        let _outer = Guard::push(4.0);
        x * Guard::push(2.0).get() * scale()
    };
    let f = |t: f64| t * Guard::push(2.0).get() * scale();
    let b = 'part: {
        if x > 0.0 {
            break 'part y * Guard::push(3.0).get() * scale();
        }
        y
    };
    let c = if Guard::push(2.0).get() * scale() > 3.0 { x * scale() } else { y };
    let listed: Vec<f64> = vec![x * Guard::push(3.0).get(), y * scale()];
    let n: usize = Guard::push(3.0).count() * scale() as usize;
    a * f(x) * b * c * listed[0] * listed[1] * n as f64 * scale()
}

static SHARED: Mutex<(f64, usize)> = Mutex::new((1.5, 1));

/// Tells whether this thread holds the lock: there is no other.
fn locked() -> f64 {
    if SHARED.try_lock().is_ok() { 2.0 } else { 3.0 }
}

#[differentiable]
fn locks(x: f64, y: f64) -> f64 {
    let mut v = [x, y];
    let a = x * SHARED.lock().unwrap().0 * locked();
    v[SHARED.lock().unwrap().1] += a * locked();
    let b = match *SHARED.lock().unwrap() {
        (factor, 1) => x * factor * locked(),
        _ => y,
    };
    let c = if let Ok(shared) = SHARED.lock() { y * shared.0 * locked() } else { y * locked() };
    let (factor, _) = *SHARED.lock().unwrap();
    v[1] * b * c * factor * locked()
}

struct Table(Vec<usize>);

impl Table {
    fn at(&self, i: usize) -> usize {
        self.0[i]
    }
}

impl Guard {
    fn times(&self, k: usize) -> usize {
        self.count() * k
    }
}

/// Guards that something is called on, beside a variable that changes.
#[differentiable]
fn receivers(x: f64, y: f64) -> f64 {
    let table = Mutex::new(Table(vec![2, 0, 1]));
    let seen = RefCell::new(vec![1_usize]);
    let values = [x, y, x * y];
    let mut sum = 0.0;
    let mut i = 0_usize;
    while i < 3 {
        let a: usize = table.lock().unwrap().at(i);
        let b: usize = table.lock().unwrap().at(a);
        seen.borrow_mut().push(i);
        let k = seen.borrow()[i];
        sum += values[b] * values[k] * scale();
        let times: usize = Guard::push(2.0).times(i);
        sum *= times as f64 + scale();
        i += 1;
    }
    sum * scale()
}

#[test]
fn temporaries_end_with_their_statements() {
    check!(receivers(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(operands(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(indices(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(matched(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(after_a_match(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(if_let(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(let_else(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(loops(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(attempted(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(blocks(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(locks(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
