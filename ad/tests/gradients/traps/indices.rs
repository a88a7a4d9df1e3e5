//! Indices that are computed by functions which give another number each time: each is evaluated once, in
//! its turn.

use std::cell::Cell;

use ad::{Differentiable, differentiable};

use crate::oracle::check;

thread_local! {
    static NEXT: Cell<usize> = const { Cell::new(0) };
}

fn start() {
    NEXT.set(0);
}

fn next() -> usize {
    let next = NEXT.get();
    NEXT.set(next + 1);
    next % 3
}

#[derive(Clone, Copy, Differentiable)]
struct Point {
    x: f64,
}

#[differentiable]
impl Point {
    fn moved(&mut self, by: f64) -> f64 {
        self.x += by;
        self.x
    }
}

#[differentiable]
impl std::ops::AddAssign for Point {
    fn add_assign(&mut self, other: Self) {
        self.x += other.x;
    }
}

#[differentiable]
fn scaled(x: &f64, y: f64) -> f64 {
    x * y
}

#[differentiable]
fn read(x: f64, y: f64) -> f64 {
    start();
    let v = [x, y, x * y];
    let (a, b) = (&v[next()], v[next()]);
    let f = |t: f64| t * v[next()];
    let mut s = a * b * scaled(&v[next()], v[next()]) * f(x) * f(y);
    for _ in 0..4 {
        s += v[next()] * v[next()];
    }
    s
}

#[differentiable]
fn changed(x: f64, y: f64) -> f64 {
    start();
    let mut v = [x, y, x * y];
    let a = v[next()].max(0.3) * v[next()].sin();
    v[next()] *= a;
    v[next()] = x * v[next()];
    let t = &mut v[next()];
    *t += y;
    let mut points = [Point { x }, Point { x: y }];
    points[next() % 2] += Point { x: v[next()] };
    points[next() % 2].moved(a) * points[next() % 2].x * v[0] * v[1] * v[2]
}

#[differentiable]
fn run_over(x: f64, y: f64) -> f64 {
    start();
    let mut v = [[x, y, 1.0], [y, x, 2.0], [x, 3.0, y]];
    let mut s = 1.0;
    for w in &v[next()..] {
        s += w[0] * w[2];
    }
    for w in v[next()] {
        s *= w;
    }
    for w in v[next()].iter_mut() {
        *w *= y;
    }
    s * v[next()].iter().sum::<f64>() * v[2][next()]
}

#[differentiable]
fn parts(x: f64, y: f64) -> f64 {
    start();
    let mut v = [vec![x, y], vec![y, 2.0, x], vec![x * y, 3.0]];
    let a = v[next()].first().unwrap() * v[next()].last().unwrap();
    *v[next()].last_mut().unwrap() *= y;
    if let Some(b) = v[next()].get_mut(1) {
        *b += x;
    }
    let (left, right) = v[next()].split_at_mut(1);
    left[0] *= right[0];
    v[next()].swap(0, 1);
    a * v[0][1] * v[1][0] * v[2][0] * v[2][1]
}

fn moved_on(k: &mut usize) -> usize {
    *k += 1;
    *k
}

#[differentiable]
fn moved_on_within(k: &mut usize, t: f64) -> Option<usize> {
    *k += 1;
    if t > 100.0 { None } else { Some(*k) }
}

#[differentiable]
fn changed_by_an_argument(x: f64, y: f64) -> f64 {
    let mut k = 0;
    let mut rows = vec![vec![x, y, 1.5], vec![y * 2.0, x * y, x], vec![x + 1.0, y, y]];
    let a = *rows[k].get(moved_on(&mut k)).unwrap();
    k = 0;
    let (left, right) = rows[k].split_at(moved_on(&mut k));
    let b = left[0] * right[1];
    k = 0;
    if let Some(t) = rows[k].get_mut(moved_on(&mut k)) {
        *t *= 3.0;
    }
    k = 0;
    let more = [x, y];
    rows[k].extend(more.iter().take(moved_on(&mut k)).map(|t| t * k as f64));
    a * b * rows[0][1] + rows[0][3] * rows[1][1]
}

#[differentiable]
fn changed_by_a_start(x: f64, y: f64) -> f64 {
    let mut k = 0;
    let rows = [vec![x, y, 1.5], vec![y * 2.0, x * y, x], vec![x + 1.0, y, y]];
    let a = rows[k].iter().fold(moved_on(&mut k) as f64, |a, b| a * b + x);
    let b = rows[k].iter().map(|t| t * y).nth(moved_on(&mut k)).unwrap();
    k = 1;
    let c = rows[0].chunks(k).map(|c| c[0]).fold(moved_on(&mut k) as f64, |a, b| a * b + y);
    a * b + c
}

#[differentiable]
fn changed_by_a_default(x: f64, y: f64) -> f64 {
    let options = [Some(x), None, Some(y)];
    let mut k = 0;
    let a = options[k].map_or(moved_on(&mut k) as f64 * x, |t| t * y);
    k = 0;
    let b = options[k].ok_or({
        k += 1;
        k
    });
    let c = (k < 2).then_some(moved_on(&mut k) as f64 * x);
    a * b.map_or_else(|e| e as f64, |t| t * x) * c.unwrap_or(y)
}

#[differentiable]
fn changed_before_an_exit(x: f64, y: f64) -> Option<f64> {
    let mut k = 0;
    let mut rows = vec![vec![x, y, 1.5], vec![y * 2.0, x * y, x], vec![x + 1.0, y, y]];
    let a = rows[k][moved_on_within(&mut k, x)?] * rows[k - 1][moved_on_within(&mut k, y)? - 1];
    k = 0;
    let b = rows[k].get(moved_on_within(&mut k, x)?).copied()?;
    k = 0;
    let c = rows[k].iter().fold(moved_on_within(&mut k, a)? as f64, |a, b| a * b + x);
    k = 0;
    let d = std::mem::replace(&mut rows[k][0], moved_on_within(&mut k, b)? as f64 * y);
    k = 0;
    rows[k].push(moved_on_within(&mut k, x)? as f64 * y);
    k = 0;
    let [p, q] = [&rows[k], &rows[moved_on_within(&mut k, x)?]];
    Some(a * b + c * d + p[3] * q[0] * rows[0][0])
}

#[differentiable]
fn exits(x: f64, y: f64) -> f64 {
    changed_before_an_exit(x, y).unwrap_or(x * y)
}

#[test]
fn indices_come_before_what_changes_them() {
    check!(changed_by_an_argument(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(changed_by_a_start(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(changed_by_a_default(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(exits(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn indices_are_evaluated_once() {
    check!(read(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(changed(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(run_over(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(parts(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// Numbers that are handed out, by methods whose names types of the standard library have too.
struct Pool;

static POOL: Pool = Pool;

impl Pool {
    fn pop(&self) -> usize {
        next()
    }

    fn len(&self) -> usize {
        next() + 1
    }

    fn min(&self, most: usize) -> usize {
        next().min(most)
    }

    fn draw(&self) -> f64 {
        next() as f64
    }
}

/// The order in which numbers are handed out shows in the value.
#[differentiable]
fn handed_out_in_order(x: f64, y: f64) -> f64 {
    start();
    let k = POOL.pop();
    let a = POOL.pop() as f64 * x - POOL.draw() * y;
    let b = POOL.draw() * y * x - POOL.min(9) as f64 * x;
    let c = scaled(&(POOL.pop() as f64 * x), POOL.draw() + y);
    let [d, e] = [POOL.len() as f64, POOL.draw() * x];
    let (f, g) = (POOL.min(9) as f64 - POOL.draw(), x.powf(POOL.pop() as f64 - POOL.draw()));
    let h = Some(POOL.pop() as f64).map(|t| t * POOL.draw() * y).unwrap_or(POOL.draw());
    a + 2.0 * b + 3.0 * c + 5.0 * d * x + 7.0 * e + (11.0 * f * y + 13.0 * g) + 17.0 * h + k as f64
}

/// So does the order in which places and what is written there are evaluated.
#[differentiable]
fn handed_out_for_places(x: f64, y: f64) -> f64 {
    start();
    let mut k: Vec<usize> = vec![2, 1, 0, 4, 3, 2, 1];
    let mut v = [x, y, x * y, x + y, x - y];
    v[POOL.pop()] += v[POOL.pop()] * y;
    v[POOL.min(9)] = v[POOL.pop()] * y;
    v[k.pop().unwrap()] += v[k.pop().unwrap()] * x;
    v[k.pop().unwrap()] = v[k.pop().unwrap()] * x;
    let s: f64 = v.iter().skip(POOL.min(1)).take(POOL.len()).map(|t| t * POOL.draw()).sum();
    let t: f64 = v
        .iter()
        .take(k.pop().unwrap())
        .zip(v.iter().skip(k.pop().unwrap()))
        .map(|(a, b)| a * b)
        .sum();
    let u: f64 = v.iter().map(|t| t * POOL.pop() as f64).skip(1).step_by(2).sum();
    v[0] + 2.0 * v[1] + 3.0 * v[2] + 5.0 * v[3] * v[4] + s * t * u
}

#[differentiable]
fn handed_out_by(v: &[f64], #[constant] pool: &Pool) -> f64 {
    let last = v.len() - 1;
    let mut s = v[pool.pop()] * v[pool.pop()] + v[pool.len()] * v[last.min(3)] * v[pool.len()];
    for i in 0..pool.len() {
        s *= v[i] + v[pool.min(9)] * v[last.min(3)] * v[pool.min(9)];
        for k in 0..pool.len() {
            s += v[k] * v[i];
        }
    }
    s
}

#[differentiable]
fn handed_out(x: f64, y: f64) -> f64 {
    start();
    let v = [x, y, x * y, x + y, x - y];
    let mut s = handed_out_by(&v, &POOL);
    for i in 0..POOL.len() {
        s += v[POOL.min(9)] * v[i] * v[POOL.min(9)];
        for k in 0..POOL.len() {
            s *= v[POOL.len()] + v[k] * v[POOL.len()];
        }
    }
    s
}

#[test]
fn own_methods_with_names_of_rules_are_evaluated_once() {
    check!(handed_out_in_order(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(handed_out_for_places(x, y) at [1.3, 0.7], [0.4, 2.1]);
    check!(handed_out(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// What is computed of constants may fail where the function does not come to it.
#[differentiable]
fn horner<const N: usize>(c: &[f64; N], x: f64) -> f64 {
    if N == 0 {
        return x;
    }
    let mut s = c[N - 1];
    for i in (0..N - 1).rev() {
        let share = 12 / N;
        s = s * x + c[i] * share as f64;
        if N > 3 {
            for k in 0..N - 3 {
                s += c[k] * x;
            }
        }
    }
    s
}

#[differentiable]
fn of_all_lengths(x: f64, y: f64) -> f64 {
    horner(&[], y) * horner(&[x], y) * horner(&[y, x], y) + horner(&[x, y, x, y, x], x)
}

/// Arrays whose elements are not `Copy`, of whose lengths a loop is made.
#[differentiable]
fn layers(rows: &[Vec<f64>; 2], owned: [Vec<f64>; 2], names: &[String; 2], k: usize) -> f64 {
    let mut s = 1.0;
    for i in 0..rows[k].len() {
        for j in 0..owned[1].len() {
            s += rows[k][i] * owned[1][j] * s;
        }
    }
    for i in 0..names[1].len() {
        s *= rows[0][i];
    }
    s
}

#[differentiable]
fn of_layers(x: f64, y: f64) -> f64 {
    let rows = [vec![x, y], vec![x * y]];
    let names = ["a".to_owned(), "bc".to_owned()];
    layers(&rows, [vec![y], vec![x, 0.5]], &names, 0) * layers(&rows, rows.clone(), &names, 1)
}

#[test]
fn ranges_of_what_is_not_reached_or_not_copied() {
    check!(of_all_lengths(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(of_layers(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
