//! Calls that change something where their value has no derivative: in conditions, bounds, indices,
//! declarations with a type, macros.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn pivot(v: &mut [f64]) -> usize {
    v[0] *= v[0];
    v[1] *= 3.0;
    1
}

#[differentiable]
fn sweep(v: &mut [f64]) -> bool {
    v[0] *= 0.5;
    v[0] > 0.1
}

#[differentiable]
fn factor(v: &mut [f64]) -> Result<(), String> {
    v[0] *= 0.5;
    if v[0] > 0.1 { Ok(()) } else { Err("too small".to_owned()) }
}

#[differentiable]
fn declared(v: &mut [f64], y: f64) -> f64 {
    let k: usize = pivot(v);
    let sum: usize = pivot(v) + 2 * pivot(v);
    v[k] * v[0] * y * sum as f64
}

#[differentiable]
fn in_while(v: &mut [f64], y: f64) -> f64 {
    while sweep(v) {}
    v[0] * y
}

#[differentiable]
fn in_condition(v: &mut [f64], y: f64) -> Option<f64> {
    if factor(v).is_err() {
        return None;
    }
    let name = &mut *v;
    if sweep(name) && !sweep(&mut name[1..]) {
        name[0] *= y;
    }
    Some(v[0] * y + v[1])
}

#[differentiable]
fn in_assertion(v: &mut [f64], y: f64) -> f64 {
    assert!(sweep(v) || v[0] < 5.0);
    debug_assert!(v[0] < 5.0);
    v[0] * y
}

#[differentiable]
fn in_bounds(v: &mut [f64], y: f64) -> f64 {
    let mut s = 0.0;
    for i in 0..pivot(v) {
        s += v[i] * y;
    }
    for i in v.len() - pivot(v)..2 {
        s += v[i] * s;
    }
    s
}

#[differentiable]
fn in_indices(v: &mut [f64], y: f64) -> f64 {
    let w = [y, y * y, 3.0];
    w[pivot(v)] * v[0] + v[1] * w[pivot(v) + 1] * v[pivot(v)]
}

/// What stands left of the call is read before it, what stands behind `&&` perhaps not at all.
#[differentiable]
fn in_turn(v: &mut [f64], y: f64) -> f64 {
    if v[0] > 1.0 && v[0] > 0.6 * pivot(v) as f64 || sweep(v) && v[0] > 0.1 {
        v[0] * y
    } else {
        v[1] * y
    }
}

#[differentiable]
fn compared(v: &mut [f64], y: f64) -> f64 {
    let is_one = pivot(v) == 1 && !sweep(v);
    match sweep(v) {
        true if is_one => v[0] * y,
        true => v[0],
        false => v[1] * y,
    }
}

#[differentiable]
fn closures_that_change(v: &mut [f64], y: f64) -> f64 {
    let mut total = y;
    let mut add = |x: f64| {
        total *= x;
        total > 1.0
    };
    if add(v[0]) || add(v[1]) {
        v[0] *= 2.0;
    }
    let again: bool = add(v[1]);
    if again { total * v[0] } else { total }
}

macro_rules! of_slices {
    ($($name:ident by $function:ident),*) => {$(
        #[differentiable]
        fn $name(x: f64, y: f64) -> f64 {
            let mut v = [x, y];
            $function(&mut v, y) + v[0] * v[1]
        }
    )*};
}

of_slices!(
    a by declared, b by in_while, d by in_assertion, e by in_bounds, f by in_indices, g by in_turn,
    h by compared, i by closures_that_change
);

#[differentiable]
fn c(x: f64, y: f64) -> f64 {
    let mut v = [x, y];
    let found = in_condition(&mut v, y);
    found.unwrap_or(x) + v[0] * v[1]
}

#[test]
fn what_conditions_change_is_differentiated() {
    check!(a(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(b(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(c(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(d(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(e(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(f(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(g(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.3, 1.7]);
    check!(h(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(i(x, y) at [1.3, 0.7], [-0.4, 2.1], [1.6, 2.1]);
}

#[derive(Clone, Differentiable)]
struct Ball {
    height: f64,
    speed: f64,
    heights: Vec<f64>,
}

#[differentiable]
fn tick(ball: &mut Ball) -> bool {
    ball.height *= ball.speed;
    ball.height > 0.0
}

#[differentiable]
impl Ball {
    fn bounce(&mut self) -> bool {
        self.height += 0.5 * self.speed;
        if self.height > 1.0 {
            self.speed = -0.9 * self.speed;
            true
        } else {
            false
        }
    }

    fn run(&mut self, steps: usize) -> f64 {
        let mut hits = 0;
        for _ in 0..steps {
            if self.bounce() {
                hits += 1;
            }
        }
        let bounces: bool = self.bounce();
        while self.bounce() && hits < 5 {
            hits += 1;
        }
        if bounces {
            self.height *= self.speed;
        }
        if self.heights.pop().is_some() {
            self.height *= 2.0 * self.speed;
        }
        self.heights.push(self.height * self.height);
        if tick(self) { self.height * hits as f64 } else { self.heights[0] }
    }
}

#[differentiable]
fn of_methods(x: f64, y: f64) -> f64 {
    let mut balls = vec![
        Ball { height: x, speed: y, heights: vec![x] },
        Ball { height: y, speed: x, heights: Vec::new() },
    ];
    let mut total = 0.0;
    for i in 0..balls.len() {
        let bounces = balls[i].bounce();
        total += if bounces { balls[i].run(4) } else { balls[i].height };
    }
    total * balls[0].height * balls[1].speed
}

#[test]
fn what_methods_change_is_differentiated() {
    check!(of_methods(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.2, 0.3]);
}
