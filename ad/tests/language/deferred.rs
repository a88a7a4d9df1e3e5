//! Variables that get their value after their declaration.

use ad::differentiable;

use crate::oracle::check;

#[differentiable]
fn by_branches(x: f64, y: f64) -> f64 {
    let a;
    let (b, mut c): (f64, f64);
    let early = x * y;
    if x > y {
        a = x * x;
        b = early + a;
        c = a * b;
        c *= 2.0;
    } else if x > 0.5 {
        let t = y.sin();
        b = t * x;
        a = b.exp();
        c = t;
    } else {
        (a, b) = (y, x * y);
        c = match (a > 0.0, b > 0.0) {
            (true, _) => a,
            _ => {
                let inner;
                inner = b * b;
                inner + x
            }
        };
    }
    c += a;
    a * b + c * early
}

#[differentiable]
fn by_arms(x: f64, y: f64, n: usize) -> f64 {
    let scale: f64;
    let unused;
    match n {
        0 => scale = x,
        1 => {
            scale = x * y;
            unused = scale + 1.0;
            if unused > 100.0 {
                return unused * x;
            }
        }
        2 => return y * y,
        _ => {
            let shift = {
                let s;
                s = y.cos();
                s
            };
            scale = shift * x
        }
    }
    scale.sin() + y
}

#[differentiable]
fn by_loop(x: f64, y: f64) -> f64 {
    let mut z = x;
    let (count, root): (i32, f64);
    let mut steps = 0_i32;
    loop {
        steps += 1;
        let next = 0.5 * (z + y / z);
        if (next - z).abs() < 1e-12 {
            root = next;
            count = steps;
            break;
        }
        z = next;
    }
    let mut last;
    let mut sum = 0.0;
    for i in 0..3 {
        last = root * i as f64;
        sum += last * last;
    }
    root * x + sum * f64::from(count.min(1))
}

#[differentiable]
fn by_option(x: Option<f64>, y: f64) -> Option<f64> {
    let (lo, hi);
    if let Some(value) = x
        && value > 0.0
    {
        lo = value.min(y);
        hi = value.max(y);
    } else {
        return None;
    }
    let y = hi - lo;
    let lo;
    {
        lo = y * hi;
    }
    Some(lo * y)
}

#[differentiable]
fn of_option(x: f64, y: f64) -> f64 {
    by_option(Some(x), y).unwrap_or(y)
        + by_arms(x, y, 0)
        + by_arms(x, y, 1)
        + by_arms(x, y, 2) * by_arms(x, y, 3)
}

#[test]
fn deferred_initialisation() {
    check!(by_branches(x, y) at [1.3, 0.7], [0.6, 0.9], [0.3, 0.8], [-0.4, -0.3], [-2.0, -1.0]);
    check!(by_loop(x, y) at [1.3, 0.7], [0.6, 2.9]);
    check!(of_option(x, y) at [1.3, 0.7], [0.6, 0.9], [-0.4, 0.8]);
}
