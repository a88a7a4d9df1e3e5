//! What changes and never carries a derivative: generators of random numbers, counters, containers of
//! integers.

use std::collections::HashMap;

use ad::{Differentiable, differentiable};

use crate::oracle::check;

/// Knows nothing of derivatives.
#[derive(Clone)]
struct Generator(u64);

impl Generator {
    fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    fn is_heads(&mut self) -> bool {
        self.uniform() < 0.5
    }

    fn accepts(&mut self, probability: f64) -> bool {
        self.uniform() < probability
    }

    fn below(&mut self, count: usize) -> usize {
        self.uniform().mul_add(count as f64, 0.0) as usize
    }

    fn is_far_from(&self, x: f64) -> bool {
        x < self.0 as f64
    }
}

trait Draw {
    fn draw(&mut self) -> f64;
}

impl Draw for Generator {
    fn draw(&mut self) -> f64 {
        self.uniform()
    }
}

#[differentiable]
fn path(x: f64, y: f64, #[constant] generator: &mut Generator) -> f64 {
    let mut s = x;
    for _ in 0..4 {
        let step = generator.between(-1.0, 1.0);
        s *= (0.1 * y * step).exp();
        if generator.is_heads() {
            s += generator.uniform() * y;
        }
    }
    s
}

#[differentiable]
fn generic<G: Draw>(x: f64, y: f64, #[constant] generator: &mut G) -> f64 {
    let first = generator.draw();
    first * x + generator.draw() * (generator.draw() - y)
}

#[differentiable]
fn hidden(x: f64, y: f64, #[constant] generator: &mut impl Draw) -> f64 {
    generator.draw() * x * (y - generator.draw())
}

#[differentiable]
fn prices(x: f64, y: f64) -> f64 {
    #[constant]
    let mut generator = Generator::new(11);
    let mut sum = 0.0;
    for _ in 0..5 {
        let paid = path(x, y, &mut generator) - generator.uniform();
        sum += paid.max(0.0);
    }
    let rest = generic(x, y, &mut generator) * hidden(x, y, &mut generator);
    sum / 5.0 + rest * generator.uniform()
}

/// Without a mark: nothing but the generator itself can change it.
#[differentiable]
fn drawn(x: f64, y: f64) -> f64 {
    let mut generator = Generator::new(5);
    let mut sum = generator.uniform() - x * generator.uniform();
    while generator.uniform() < 0.7 {
        sum += generator.between(0.0, 1.0) * y;
    }
    sum * [generator.uniform(), generator.uniform() * x][1]
}

#[differentiable]
fn passed_on(x: f64, y: f64) -> f64 {
    inner(x, y, &mut Generator::new(3).clone())
}

#[differentiable]
fn inner(x: f64, y: f64, #[constant] generator: &mut Generator) -> f64 {
    path(x, y, generator) * path(y, generator.uniform(), generator) + path(x, x, generator)
}

/// Calls in conditions, indices and closures: those that are given nothing with a derivative change the generator, those
/// that are given some only look at it.
#[differentiable]
fn chosen(x: f64, y: f64) -> f64 {
    #[constant]
    let mut generator = Generator::new(7);
    let pair = [x, y];
    let mut sum = 0.0;
    for i in 0..6 {
        if generator.accepts(ad::stop_gradient(0.5 * x)) && generator.is_far_from(x * y) {
            sum += pair[generator.below(pair.len())] * pair[i % 2];
        }
        if pair.get(generator.below(4)).is_some() && i >= generator.below(3) {
            sum *=
                pair.iter().filter(|number| **number > 0.0 && generator.is_heads()).count() as f64;
        }
        sum += y;
    }
    sum
}

/// A generator within a struct, advanced by the struct's own methods.
struct Sampler {
    generator: Generator,
    drawn: usize,
}

#[differentiable]
impl Sampler {
    fn shifted(#[constant] &mut self, x: f64) -> f64 {
        self.drawn += 1;
        x * self.generator.uniform() + self.drawn as f64
    }
}

#[differentiable]
fn sampled(x: f64, y: f64) -> f64 {
    #[constant]
    let mut sampler = Sampler { generator: Generator::new(8), drawn: 0 };
    let a = sampler.shifted(x);
    let b = sampler.shifted(y * a);
    a * b + sampler.generator.uniform() * sampler.drawn as f64 * x
}

/// Its type says that it carries no derivative.
#[derive(Clone, Differentiable)]
#[constant]
struct Counter(usize);

#[differentiable]
impl Counter {
    fn times(&mut self, x: f64) -> f64 {
        self.0 += 1;
        x * self.0 as f64
    }
}

#[differentiable]
fn counted(x: f64, y: f64) -> f64 {
    #[constant]
    let mut counter = Counter(0);
    counter.times(x) * counter.times(y) + counter.times(x * y) * counter.0 as f64
}

#[differentiable]
fn tables(x: f64, y: f64) -> f64 {
    let mut bins = vec![0_usize; 3];
    let mut names = HashMap::new();
    let mut last = 0;
    for i in 0..4 {
        bins[i % 3] += i;
        names.insert(i, bins[i % 3]);
        last = i;
    }
    bins.push(last);
    bins.swap(0, 3);
    let mut factor = 1.0;
    factor *= bins[0] as f64;
    x * factor + y * names.len() as f64 * bins.len() as f64
}

#[differentiable]
fn of_seed(x: f64, y: f64) -> f64 {
    let mut seed = 17_u64;
    let mut sum = 0.0;
    for _ in 0..3 {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1);
        let u = (seed >> 40) as f64 / (1 << 24) as f64;
        sum += u * x * y;
    }
    sum
}

/// What begins as a constant, and does not stay one.
#[differentiable]
fn given_one(x: f64, y: f64) -> f64 {
    let mut first = 0.0;
    let mut second = first;
    let mut third = [0.0; 2];
    let mut fourth = None;
    for _ in 0..3 {
        first = second;
        second = x;
        third[1] += first;
        fourth = Some(third);
    }
    let mut fifth = 1.0;
    {
        let second = 3.0;
        fifth *= second;
    }
    let mut set = |value: f64| fifth += value;
    set(y);
    first * second + third[1] * y + fourth.map_or(0.0, |pair| pair[1]) * fifth
}

#[test]
fn generators() {
    check!(prices(x, y) at [1.1, 0.3], [0.4, 1.2]);
    check!(drawn(x, y) at [1.1, 0.3], [-0.4, 1.2]);
    check!(passed_on(x, y) at [1.1, 0.3], [0.4, 1.2]);
    check!(chosen(x, y) at [1.1, 0.3], [0.4, 1.2]);
    check!(sampled(x, y) at [1.1, 0.3], [-0.4, 1.2]);
    check!(counted(x, y) at [1.1, 0.3], [-0.4, 1.2]);
}

#[test]
fn generators_advance_as_the_function_advances_them() {
    let (mut plain, mut reverse, mut forward) =
        (Generator::new(1), Generator::new(1), Generator::new(1));
    for x in [0.5, 1.5] {
        let value = path(x, 0.7, &mut plain);
        let (differentiated, (by_x, _, ())) = path::value_and_grad(x, 0.7, &mut reverse);
        let (pushed, along_x) = path::jvp(x, 0.7, &mut forward, 1.0, 0.0, Default::default());
        assert_eq!([differentiated, pushed], [value; 2]);
        assert!((along_x - by_x).abs() < 1e-12);
        assert_eq!([reverse.0, forward.0], [plain.0; 2]);
    }
}

#[test]
fn what_is_counted_and_what_is_given_a_derivative() {
    check!(tables(x, y) at [1.1, 0.3], [-0.4, 1.2]);
    check!(of_seed(x, y) at [1.1, 0.3], [-0.4, 1.2]);
    check!(given_one(x, y) at [1.1, 0.3], [-0.4, 1.2]);
}
