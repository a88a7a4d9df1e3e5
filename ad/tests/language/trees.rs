//! Types that hold themselves: walked by calls, and by a reference.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Differentiable)]
enum Formula {
    Number(f64),
    Variable,
    Sum(Box<Formula>, Box<Formula>),
    Product(Box<Formula>, Box<Formula>),
    Sine(Box<Formula>),
}

#[differentiable]
impl Formula {
    fn at(&self, x: f64) -> f64 {
        match self {
            Self::Number(number) => *number,
            Self::Variable => x,
            Self::Sum(a, b) => a.at(x) + b.at(x),
            Self::Product(a, b) => a.at(x) * b.at(x),
            Self::Sine(a) => a.at(x).sin(),
        }
    }

    fn stretch(&mut self, by: f64) {
        match self {
            Self::Number(number) => *number *= by,
            Self::Variable => {}
            Self::Sum(a, b) | Self::Product(a, b) => {
                a.stretch(by);
                b.stretch(by * by);
            }
            Self::Sine(a) => a.stretch(by),
        }
    }
}

#[differentiable]
fn formula(x: f64, y: f64) -> f64 {
    let sine = Formula::Sine(Box::new(Formula::Variable));
    let sum = Formula::Sum(Box::new(Formula::Number(y)), Box::new(Formula::Number(x * y)));
    let mut formula = Formula::Product(Box::new(sum), Box::new(sine));
    let before = formula.at(x);
    formula.stretch(y);
    before * formula.at(x * y)
}

#[derive(Clone, Differentiable)]
struct Body {
    mass: f64,
    parts: Vec<Body>,
    beside: Option<Box<Body>>,
}

#[differentiable]
impl Body {
    fn total(&self, weight: f64) -> f64 {
        let mut sum = self.mass * weight;
        for part in &self.parts {
            sum += part.total(weight * 0.5 + sum);
        }
        sum + self.beside.as_ref().map_or(weight, |beside| beside.total(weight * self.mass))
    }
}

#[differentiable]
fn bodies(x: f64, y: f64) -> f64 {
    let leaf = Body { mass: x, parts: vec![], beside: None };
    let middle = Body { mass: x * y, parts: vec![leaf.clone()], beside: Some(Box::new(leaf)) };
    Body { mass: y, parts: vec![middle.clone(), middle], beside: None }.total(y)
}

#[derive(Differentiable)]
struct Node {
    value: f64,
    next: Option<Box<Node>>,
}

#[derive(Differentiable)]
struct List {
    head: Option<Box<Node>>,
    decay: f64,
}

#[differentiable]
impl List {
    fn push(&mut self, value: f64) {
        let next = self.head.take();
        self.head = Some(Box::new(Node { value, next }));
    }

    fn decayed(&self) -> f64 {
        let mut sum = 0.0;
        let mut at = self.head.as_deref();
        while let Some(node) = at {
            sum = sum * self.decay + node.value * node.value;
            at = node.next.as_deref();
        }
        sum
    }
}

#[differentiable]
fn list(x: f64, y: f64) -> f64 {
    let mut list = List { head: None, decay: y };
    for i in 0..5 {
        list.push(x * i as f64 + y);
    }
    list.decayed() * x
}

#[test]
fn trees_and_lists() {
    check!(formula(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
    check!(bodies(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
    check!(list(x, y) at [0.7, 0.4], [-0.4, 0.7], [1.3, -0.2]);
}

#[derive(Clone, Differentiable)]
enum Branching {
    Leaf(f64),
    Node(Box<Branching>, f64, Box<Branching>),
}

#[differentiable]
impl Branching {
    /// Calls itself by the name of the type.
    fn grow(depth: usize, x: f64) -> Branching {
        match depth {
            0 => Branching::Leaf(x),
            _ => Branching::Node(
                Box::new(Branching::grow(depth - 1, x * 1.1)),
                x.sin(),
                Box::new(Branching::grow(depth - 1, x - 0.3)),
            ),
        }
    }

    fn sum(&self, factor: f64) -> (f64, usize) {
        match self {
            Branching::Leaf(x) => (*x * factor, 1),
            Branching::Node(left, weight, right) => {
                let (a, n) = left.sum(factor);
                let (b, m) = right.sum(factor * weight);
                (a + b * weight, n + m)
            }
        }
    }
}

#[differentiable]
fn grown(x: f64, y: f64) -> f64 {
    let (sum, count) = Branching::grow(3, x).sum(y);
    sum / count as f64
}

#[derive(Clone, Debug, Differentiable)]
struct Link {
    value: f64,
    next: Option<Box<Self>>,
}

#[differentiable]
impl Link {
    fn product(&self) -> f64 {
        let rest = match &self.next {
            Some(next) => next.product(),
            None => 1.0,
        };
        self.value * rest
    }
}

#[derive(Clone, Debug, Differentiable)]
enum Term<T: ad::Real> {
    Product(Box<Self>, Box<Self>),
    Number(T),
}

#[differentiable]
impl<T: ad::Real> Term<T> {
    fn value(&self) -> T {
        match self {
            Term::Product(a, b) => a.value() * b.value(),
            Term::Number(number) => *number * *number,
        }
    }
}

#[differentiable]
fn of_themselves(x: f64, y: f64) -> f64 {
    let links = Link { value: x, next: Some(Box::new(Link { value: y, next: None })) };
    let [a, b] = [x * y, y].map(|number| Box::new(Term::Number(number)));
    links.product() * Term::Product(a, b).value()
}

#[test]
fn types_that_say_self() {
    check!(of_themselves(x, y) at [1.3, 0.7], [0.4, 2.1]);
}

#[test]
fn recursion_by_the_name_of_the_type() {
    check!(grown(x, y) at [1.3, 0.7], [0.4, 2.1]);
}
