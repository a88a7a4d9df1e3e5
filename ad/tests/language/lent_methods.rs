//! Methods that add to the cotangents of their caller in place.

use ad::{Differentiable, differentiable};

#[derive(Clone, Debug, Differentiable)]
struct Grid {
    n: usize,
    data: Vec<f64>,
}

#[differentiable]
impl Grid {
    fn get(&self, i: usize, j: usize) -> f64 {
        self.data[i * self.n + j]
    }

    fn set(&mut self, i: usize, j: usize, value: f64) {
        self.data[i * self.n + j] = value;
    }

    fn along(&self, xs: &[f64], i: usize) -> f64 {
        self.get(i, 0) * xs[i] + self.get(0, i)
    }

    fn relax(&self, at: &mut f64, weights: &[f64], i: usize) -> f64 {
        *at = 0.5 * *at + self.data[i] * weights[i];
        *at * self.data[0]
    }

    fn descending(&self, i: usize) -> f64 {
        if i == 0 { self.data[0] } else { self.data[i] * self.descending(i - 1) }
    }

    fn with<T: Differentiable + Copy>(&self, _more: T, i: usize) -> f64 {
        self.data[i]
    }

    #[differentiable(checkpoint)]
    fn recomputed(&self, xs: &[f64], i: usize) -> f64 {
        let mut sum = 0.0;
        for k in i..i + 2 {
            sum += (self.data[k] * xs[k]).sin();
        }
        sum
    }

    #[differentiable(checkpoint)]
    fn moved(&self, value: &mut f64, xs: &[f64], i: usize) {
        for k in i..i + 2 {
            *value = (*value * self.data[k] + xs[k]).cos();
        }
    }

    fn hashed(&self, seed: u64) -> f64 {
        let state = seed.wrapping_mul(6364136223846793005);
        self.data[(state >> 60) as usize % self.data.len()]
    }

    fn total(self) -> f64 {
        self.data.iter().sum()
    }
}

/// A type whose methods of these names are lent nothing.
#[derive(Clone, Copy, Differentiable)]
struct Pair(f64, f64);

#[differentiable]
impl Pair {
    fn get(self, i: usize, j: usize) -> f64 {
        if i == j { self.0 } else { self.1 * self.0 }
    }

    fn total(&mut self) -> f64 {
        self.0 *= 0.5;
        self.0 + self.1
    }
}

#[differentiable]
trait Weighted {
    fn along(&self, xs: &[f64], i: usize) -> f64;
}

#[differentiable]
impl Weighted for Pair {
    fn along(&self, xs: &[f64], i: usize) -> f64 {
        self.0 * xs[i] + self.1
    }
}

#[differentiable]
fn generic<W: Weighted + Differentiable>(weighted: &W, xs: &[f64]) -> f64 {
    weighted.along(xs, 0) * weighted.along(xs, 1)
}

#[differentiable]
fn summed(f: impl Fn(f64) -> f64) -> f64 {
    f(0.3) + f(0.6)
}

#[differentiable(checkpoint)]
fn local(xs: &[f64], y: f64, i: usize) -> f64 {
    let scaled = xs[i] * y;
    scaled.sin() * xs[i + 1]
}

/// Receivers that may change, references to them, parameters; arguments that are borrowed, changed, of
/// any type; methods of the same names that are lent nothing.
#[differentiable]
fn mixture(x: f64, y: f64) -> f64 {
    let xs = [0.3, x, 0.5, y, 0.1, x * y, 0.9, 0.25, -0.6];
    let mut grid = Grid { n: 3, data: xs.to_vec() };
    let own = xs.to_vec();
    let mut pair = Pair(x, y);
    let (mut sum, mut at) = (0.0, y);
    for i in 0..3 {
        for j in 0..3 {
            sum += grid.get(i, j) * y + grid.along(&xs, i) * grid.along(&own, j);
            sum += pair.get(i, j) * pair.along(&own, i);
            grid.set(i, j, sum * 0.1 + grid.get(j, i));
        }
        sum += grid.relax(&mut at, &own, i + 1) * local(&xs, y, i);
    }
    sum += summed(|t: f64| pair.along(&own, 1) * t + grid.get(1, 1) * grid.along(&own, 2));
    let view = &grid;
    for i in 0..4 {
        sum += view.relax(&mut at, &xs, i) + view.recomputed(&xs, i);
        view.moved(&mut at, &own, i);
    }
    sum += view.get(1, 2) * view.descending(4) + grid.with(2.0, 1) + view.with((), 2);
    sum += view.hashed(2862933555777941757);
    sum + at + generic(&pair, &xs) + pair.total() + grid.total()
}

#[test]
fn gradients_are_those_of_the_function() {
    use crate::oracle::check;

    check!(mixture(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
}

/// Both functions ask for methods of the same names, of a type of which the trait's is lent nothing.
#[differentiable]
fn with_a_function_within(x: f64, y: f64) -> f64 {
    #[differentiable]
    fn inner(pair: &Pair, xs: &[f64]) -> f64 {
        pair.along(xs, 0) * pair.along(xs, 1)
    }

    let pair = Pair(y, x);
    let xs = [x, y, x * y];
    inner(&pair, &xs) + pair.along(&xs, 2)
}

#[test]
fn functions_within_functions_ask_for_themselves() {
    crate::oracle::check!(with_a_function_within(x, y) at [0.7, -1.2], [1.5, 0.4]);
}

#[differentiable]
trait Area {
    fn area(&self, scale: f64) -> f64;
}

#[differentiable]
impl Area for Grid {
    fn area(&self, scale: f64) -> f64 {
        self.data[0] * self.data[1] * scale
    }
}

/// A method that is lent nothing is called on what may change while a part of it is borrowed, and in
/// closures that do not change it; one that changes what it is called on, through a `&mut` and in a
/// closure.
#[differentiable]
fn while_borrowed(x: f64, y: f64) -> f64 {
    let mut grid = Grid { n: 2, data: vec![x, y, x * y, 1.0] };
    grid.set(0, 1, y * y);
    let data = &grid.data;
    let mut sum = grid.area(x) * data[1] + grid.get(1, 0) * data[0];
    sum += [x, y].iter().map(|scale| grid.area(*scale) * grid.get(0, 1)).sum::<f64>();
    let twice = |scale: f64| grid.area(scale) + grid.area(2.0 * scale);
    sum += twice(y) * twice(x);
    let name = &mut grid;
    name.set(0, 0, sum * x);
    sum += name.area(y) + name.get(0, 0);
    let mut put = |value: f64| grid.set(1, 1, value * y);
    put(sum);
    sum + grid.get(1, 1)
}

#[test]
fn methods_that_are_lent_nothing_need_no_exclusive_borrow() {
    crate::oracle::check!(while_borrowed(x, y) at [0.7, -1.2], [1.5, 0.4]);
}

/// Not told to be of a fixed size by its name: callers lend its methods its cotangent.
#[derive(Clone, Copy, Debug, Differentiable)]
enum Activation {
    Scaled(f64),
    Shifted(f64),
}

#[differentiable]
impl Activation {
    fn at(self, x: f64) -> f64 {
        match self {
            Activation::Scaled(a) => a * x,
            Activation::Shifted(a) => a + x * x,
        }
    }

    fn over(self, xs: &[f64]) -> f64 {
        xs.iter().map(|x| self.at(*x)).sum()
    }
}

#[derive(Clone, Debug, Differentiable)]
struct Layers {
    last: Activation,
    all: Vec<Activation>,
}

#[differentiable]
impl Layers {
    fn of_pattern(&self, xs: &[f64]) -> f64 {
        let Layers { last, all } = self;
        let [first, ..] = all.as_slice() else { return 0.0 };
        last.over(xs) * first.at(xs[0])
    }

    fn of_items(&self, xs: &[f64]) -> f64 {
        self.all.iter().map(|layer| layer.at(xs[1]) + layer.over(xs)).sum()
    }

    fn of_options(&self, xs: &[f64]) -> f64 {
        let first = if let Some(layer) = self.all.first() { layer.at(xs[0]) } else { 0.0 };
        first * self.all.last().map_or(1.0, |layer| layer.over(xs))
    }

    fn of_reassigned(&self, xs: &[f64]) -> f64 {
        let mut best = &self.all[0];
        for layer in &self.all {
            if layer.at(1.0) > best.at(1.0) {
                best = layer;
            }
        }
        best.over(xs)
    }
}

#[differentiable]
fn taken_by_value(x: f64, y: f64) -> f64 {
    let all = vec![Activation::Shifted(y), Activation::Scaled(x), Activation::Scaled(x * y)];
    let layers = Layers { last: Activation::Scaled(y), all };
    let lends = [x, y, x + y];
    layers.of_pattern(&lends) * layers.of_items(&lends[..2])
        + layers.of_options(&lends) * layers.of_reassigned(&lends)
}

#[test]
fn receivers_that_refer_to_what_is_taken_by_value() {
    crate::oracle::check!(taken_by_value(x, y) at [0.7, -1.2], [1.5, 0.4]);
}
