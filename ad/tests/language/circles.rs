//! Methods of one block that call each other in a circle.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Series(f64);

#[differentiable]
impl Series {
    fn even(&self, n: u32, x: f64) -> f64 {
        if n == 0 { x } else { self.odd(n - 1, x * x) + x }
    }

    fn odd(&self, n: u32, x: f64) -> f64 {
        if n == 0 { x.sin() * self.0 } else { self.third(n - 1, x * 0.5) * x }
    }

    fn third(&self, n: u32, x: f64) -> f64 {
        if n == 0 { x * self.0 } else { self.even(n - 1, x) + self.third(n - 1, x * x) }
    }

    fn both(&self, x: f64) -> f64 {
        self.even(4, x) + self.odd(2, x)
    }
}

#[derive(Clone, Differentiable)]
enum Tree {
    Leaf(f64),
    Node(Vec<Tree>, f64),
}

#[differentiable]
impl Tree {
    fn total(&self) -> f64 {
        match self {
            Tree::Leaf(value) => *value,
            Tree::Node(children, weight) => {
                let mut sum = 0.0;
                for child in children {
                    sum += child.volume() * weight;
                }
                sum
            }
        }
    }

    fn volume(&self) -> f64 {
        match self {
            Tree::Leaf(value) => value * value,
            Tree::Node(children, weight) => {
                let mut product = *weight;
                for child in children {
                    product *= child.total();
                }
                product
            }
        }
    }
}

/// Its methods have the names of those of collections and numbers.
#[derive(Clone, Differentiable)]
enum Sorted {
    Empty,
    Node(Box<Sorted>, f64, Box<Sorted>),
}

#[differentiable]
impl Sorted {
    fn insert(&mut self, x: f64) {
        match self {
            Sorted::Empty => {
                *self = Sorted::Node(Box::new(Sorted::Empty), x, Box::new(Sorted::Empty));
            }
            Sorted::Node(left, middle, right) => {
                if x < *middle {
                    left.insert(x * 1.5);
                } else {
                    right.insert(x + *middle);
                }
            }
        }
    }

    fn length(&self) -> f64 {
        match self {
            Sorted::Empty => 0.5,
            Sorted::Node(left, middle, right) => left.length() * middle + right.length(),
        }
    }
}

/// A list of the form that `if let` takes apart.
#[derive(Clone, Differentiable)]
struct Stack {
    top: f64,
    rest: Option<Box<Stack>>,
}

#[differentiable]
impl Stack {
    fn max(&self) -> f64 {
        if let Some(rest) = &self.rest { self.top.max(rest.max()) * 1.25 } else { self.top }
    }

    fn push(&mut self, x: f64) {
        match &mut self.rest {
            Some(rest) => rest.push(x * self.top),
            None => self.rest = Some(Box::new(Stack { top: x, rest: None })),
        }
    }
}

#[differentiable]
fn sorted(x: f64, y: f64) -> f64 {
    let mut tree = Sorted::Empty;
    for i in 0..4 {
        tree.insert(x * y + i as f64 * (x - y));
    }
    let mut stack = Stack { top: x, rest: None };
    stack.push(y * y);
    stack.push(tree.length());
    stack.max() + tree.length()
}

#[differentiable]
fn series(x: f64, y: f64) -> f64 {
    Series(y).both(x) * Series(x).third(3, y)
}

#[differentiable]
fn tree(x: f64, y: f64) -> f64 {
    let inner = Tree::Node(vec![Tree::Leaf(y), Tree::Leaf(x)], y);
    let outer = Tree::Node(vec![Tree::Node(vec![Tree::Leaf(x)], x)], y);
    let root = Tree::Node(vec![Tree::Leaf(x), inner, outer], x);
    root.total() * root.volume()
}

#[test]
fn circles() {
    check!(series(x, y) at [0.7, 1.3], [-0.4, 0.8]);
    check!(tree(x, y) at [0.7, 1.3], [-0.4, 0.8]);
    check!(sorted(x, y) at [0.7, 1.3], [1.4, 0.8]);
}
