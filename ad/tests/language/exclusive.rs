//! `&mut`: parameters, receivers, arguments. The cotangent comes in and goes out.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn advance(x: &mut f64, v: &mut f64, dt: f64) {
    *x += *v * dt;
    *v -= *x * dt;
}

#[differentiable]
fn oscillator(x: f64, dt: f64) -> f64 {
    let mut x = x;
    let mut v = 1.0;
    let mut energy = 0.0;
    for _ in 0..4 {
        advance(&mut x, &mut v, dt);
        energy += x * v;
    }
    advance(&mut x, &mut v, energy);
    x + v * dt
}

/// Overwrites, and returns what was there.
#[differentiable]
fn shift(xs: &mut [f64], new: f64) -> f64 {
    let first = xs[0];
    for i in 1..xs.len() {
        xs[i - 1] = xs[i];
    }
    let last = xs.len() - 1;
    xs[last] = new * first;
    first
}

#[differentiable]
fn shifted(x: f64, y: f64) -> f64 {
    let mut array = [x, y, x * y];
    let mut vec = vec![y; 4];
    let a = shift(&mut array, y);
    vec[1] = a;
    let b = shift(&mut vec, x);
    let c = shift(&mut vec[1..3], b * a);
    shift(&mut array, c);
    vec[0] * array[2] + array[1] * vec[2] + c
}

#[differentiable]
fn relax(grid: &mut [f64; 4], state: &mut (f64, [f64; 2])) -> f64 {
    state.0 *= grid[1];
    state.1[0] = state.0 + grid[0];
    advance(&mut grid[2], &mut state.0, state.1[1]);
    grid[0] = 0.0;
    inner(state) * grid[2]
}

#[differentiable]
fn inner(state: &mut (f64, [f64; 2])) -> f64 {
    state.1[1] *= state.1[0];
    let before = *state;
    state.0 = before.1[1];
    before.0
}

#[differentiable]
fn relaxed(x: f64, y: f64) -> f64 {
    let mut grid = [x, y, x, 1.0];
    let mut state = (y, [x, 2.0]);
    let mut sum = 0.0;
    for _ in 0..2 {
        sum += relax(&mut grid, &mut state);
    }
    sum * state.0 + grid[2] * state.1[1] + grid[0]
}

#[differentiable]
fn names_for_places(x: f64, y: f64) -> f64 {
    let mut rows = vec![vec![x, y], vec![y; 3]];
    for i in 0..2 {
        let row = &mut rows[i];
        row[0] *= y;
        let last = &mut row[1];
        *last += x * y;
        let mut speed = y;
        advance(last, &mut speed, x);
        rows[1][2] *= speed;
        for x in rows[i].iter_mut() {
            let mut copy = *x;
            advance(&mut *x, &mut copy, y);
        }
    }
    let mut sum = 0.0;
    let total = &mut sum;
    shift(&mut rows[0], y);
    *total += rows[0][0] * rows[1][2];
    advance(total, &mut rows[0][1], y);
    sum * rows[0][1] + rows[1][0]
}

#[derive(Clone, Copy, Differentiable)]
struct Mean {
    total: f64,
    count: f64,
    #[constant]
    calls: usize,
}

#[differentiable]
impl Mean {
    fn add(&mut self, x: f64) -> f64 {
        self.total += x * self.count;
        self.count += 1.0;
        self.calls += 1;
        self.total
    }

    fn add_twice(&mut self, x: f64) {
        let first = self.add(x);
        self.add(first * self.value());
    }

    fn value(&self) -> f64 {
        self.total / self.count
    }

    fn empty() -> Self {
        Self { total: 0.0, count: 1.0, calls: 0 }
    }

    fn reset(&mut self, to: f64) {
        *self = Self { total: to, ..Self::empty() };
    }
}

#[differentiable]
fn means(x: f64, y: f64) -> f64 {
    let mut means = [Mean { total: x, count: 1.0, calls: 0 }; 2];
    for i in 0..3 {
        means[i % 2].add(y);
        means[1].add_twice(x * y);
    }
    let early = means[0].value();
    means[0].reset(y * x);
    let mean = &means[0];
    mean.value() * early + means[1].value() + means[0].add(early) * means[0].calls as f64
}

#[differentiable]
fn exchange(x: f64, y: f64) -> f64 {
    let (mut a, mut b) = (x * y, y);
    std::mem::swap(&mut a, &mut b);
    let c = std::mem::replace(&mut a, b * x);
    let mut pair = [a, c];
    pair.swap(0, 1);
    pair[0] *= x;
    std::mem::swap(&mut pair[1], &mut b);
    let d = std::mem::take(&mut b);
    a * b + c * pair[0] + pair[1] * y * d
}

#[differentiable]
fn growing(x: f64, y: f64) -> f64 {
    let mut xs = Vec::new();
    for i in 0..4 {
        xs.push(x * i as f64 + y);
        if i == 2 {
            xs[1] *= x;
        }
    }
    let last = xs.pop();
    xs.extend_from_slice(&[y, x]);
    xs.reverse();
    let mut copy = vec![0.0; xs.len()];
    copy.copy_from_slice(&xs);
    copy[1..3].fill(x * y);
    let Some(last) = last else {
        return 0.0;
    };
    xs.clear();
    xs.push(copy[0] * copy[1]);
    last * xs[0] + copy[3] * copy[2] + copy[4]
}

/// The generator is not differentiated.
fn next(seed: &mut u32) -> f64 {
    *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    f64::from(*seed >> 8) / f64::from(1 << 24)
}

#[differentiable]
fn noisy(x: f64, y: f64) -> f64 {
    let mut seed: u32 = 7;
    let mut sum = 0.0;
    for _ in 0..3 {
        let noise = next(&mut seed);
        sum += noise * x * next(&mut seed) + y * y;
    }
    sum * x
}

#[test]
fn changed_in_place() {
    check!(oscillator(x, dt) at [1.3, 0.1], [-0.4, 0.3]);
    check!(shifted(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(relaxed(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(names_for_places(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(means(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(exchange(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(growing(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(noisy(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn the_cotangent_comes_in_and_goes_out() {
    let (mut x, mut v) = (1.0, 2.0);
    let ((), pullback) = advance::vjp(&mut x, &mut v, 0.5);
    assert_eq!((x, v), (2.0, 1.0));
    // x' = x + v dt, v' = v - x' dt
    let (by_x, by_v, by_dt) = pullback((), 3.0, 4.0);
    assert_eq!((by_x, by_v, by_dt), (3.0 - 4.0 * 0.5, 4.0 + 0.5, 2.0 - 4.0 * 2.0));

    let mut xs = [1.0, 2.0, 3.0];
    let (first, pullback) = shift::vjp(&mut xs, 5.0);
    assert_eq!((first, xs), (1.0, [2.0, 3.0, 5.0]));
    assert_eq!(pullback(10.0, vec![0.5, 0.25, 2.0]), (vec![20.0, 0.5, 0.25], 2.0));

    // The gradient of the result alone: what is left behind counts for nothing.
    let mut xs = [1.0, 2.0, 3.0];
    assert_eq!(shift::grad(&mut xs, 5.0), (vec![1.0, 0.0, 0.0], 0.0));
}

#[differentiable]
fn doubled(xs: &mut [f64], n: usize) {
    for i in 0..n {
        scale_one(xs, i, 2.0);
    }
}

#[differentiable]
fn scale_one(xs: &mut [f64], i: usize, by: f64) {
    xs[i] *= by;
}

#[test]
fn passing_on_costs_nothing() {
    let n = 100_000;
    let mut xs = vec![1.0; n];
    let ((), pullback) = doubled::vjp(&mut xs, n);
    let (by_xs, ()) = pullback((), vec![1.0; n]);
    assert_eq!((by_xs[0], by_xs[n - 1], xs[n - 1]), (2.0, 2.0, 2.0));
}

#[differentiable(checkpoint)]
fn recomputed(xs: &mut [f64], state: &mut (f64, f64), y: f64) -> f64 {
    for i in 1..xs.len() {
        xs[i] *= xs[i - 1] * y;
        state.0 += xs[i] * state.1;
    }
    state.1 *= state.0;
    xs[0] * y
}

#[differentiable]
fn recomputed_steps(x: f64, y: f64) -> f64 {
    let mut xs = [x, y, x * y];
    let (mut a, mut b) = (x, y);
    let mut state = (y, 1.0);
    let mut sum = 0.0;
    #[differentiable(checkpoint)]
    for _ in 0..5 {
        sum += recomputed(&mut xs, &mut state, y);
        advance(&mut a, &mut b, 0.1 * y);
    }
    sum * a + state.1 * xs[2] + b
}

#[test]
fn changed_in_place_under_checkpoints() {
    check!(recomputed_steps(x, y) at [1.3, 0.7], [-0.4, 1.1]);
}

#[differentiable]
fn mixed(v: &mut [f64], w: &mut [f64], scale: &mut f64, counts: &mut [usize; 2]) {
    v[0] *= w[1] * *scale;
    w[0] += v[0];
    *scale += w[0];
    v[1] += w[0] * *scale;
    counts[0] += 1;
    v[1] *= counts[0] as f64;
}

/// Values without names that begin as numbers take up derivatives.
#[differentiable]
fn into_literals(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    mixed(&mut v, &mut [0.0, 1.0], &mut 1.5, &mut [1, 2]);
    for i in 0..2 {
        mixed(&mut v, &mut [0.5; 2], &mut (i as f64 + 0.5), &mut [i; 2]);
    }
    v[0] * v[1]
}

#[test]
fn literals_are_lent_exclusively() {
    check!(into_literals(x, y) at [1.3, 0.7], [-0.4, 1.1]);
}
