//! Methods of one field that are given another, and methods by value that are called on references.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Number {
    x: f64,
}

#[derive(Clone, Differentiable)]
struct Log {
    values: Vec<f64>,
}

#[differentiable]
impl Number {
    fn add(&mut self, other: &Number) {
        self.x += other.x * other.x;
    }

    fn step(&mut self, log: &mut Log, by: f64) {
        self.x += by * log.values[0];
        log.values.push(self.x);
    }

    fn emit(&self, log: &mut Log) {
        log.values.push(self.x * self.x);
    }

    fn both(&mut self, other: &mut Number) {
        self.x *= other.x;
        other.x += self.x;
    }

    fn square(self) -> f64 {
        self.x * self.x
    }

    fn plus(self, other: Number) -> Number {
        Number { x: self.x + other.x.sin() }
    }

    fn squares(&self, other: &Number) -> f64 {
        self.square() * other.plus(*self).square() + self.plus(*other).x
    }
}

#[differentiable]
impl Log {
    fn gather(&mut self, numbers: &[Number]) -> f64 {
        let mut sum = 0.0;
        for number in numbers {
            sum += number.x;
            self.values.push(number.x * sum);
        }
        sum
    }
}

#[derive(Clone, Differentiable)]
struct State {
    a: Number,
    b: Number,
    log: Log,
    numbers: Vec<Number>,
    pair: (Number, Number),
}

#[differentiable]
impl State {
    fn run(&mut self) {
        self.a.add(&self.b);
        self.a.step(&mut self.log, 0.3);
        self.b.emit(&mut self.log);
        for i in 0..self.numbers.len() {
            self.a.add(&self.numbers[i]);
            self.numbers[i].add(&self.b);
        }
        self.a.both(&mut self.b);
        let sum = self.log.gather(&self.numbers);
        self.a.x *= sum;
        self.pair.0.both(&mut self.pair.1);
        self.pair.0.add(&self.pair.1);
    }
}

#[differentiable]
fn fields_of_one_value(x: f64, y: f64) -> f64 {
    let (a, b) = (Number { x }, Number { x: y });
    let log = Log { values: vec![x] };
    let mut state = State { a, b, log, numbers: vec![a, b], pair: (a, b) };
    state.a.add(&state.b);
    state.run();
    state.a.step(&mut state.log, y);
    state.log.gather(&state.numbers);
    let logged = state.log.values.iter().sum::<f64>();
    state.a.x + state.b.x + logged * state.pair.0.x + state.numbers[1].x
}

#[differentiable]
fn squared(number: &Number, numbers: &[Number]) -> f64 {
    let mut sum = number.square() + number.squares(number);
    for other in numbers {
        sum += other.square() * other.squares(number);
    }
    let first = numbers.first().unwrap();
    sum + first.square()
}

#[differentiable]
#[allow(clippy::needless_borrow)]
fn by_value(x: f64, y: f64) -> f64 {
    let (a, b) = (Number { x }, Number { x: y });
    squared(&a, &[a, b]) + (&a).plus(b).square()
}

#[test]
fn parts_are_changed_together() {
    check!(fields_of_one_value(x, y) at [0.7, 0.4], [-0.4, 0.9]);
    check!(by_value(x, y) at [0.7, 0.4], [-0.4, 0.9]);
}
