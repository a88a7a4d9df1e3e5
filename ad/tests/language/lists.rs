//! Walks along linked lists: a name that goes from one reference to the next, which may be one to a box.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Differentiable)]
enum List {
    Nil,
    Cons(f64, Box<List>),
}

#[differentiable]
impl List {
    fn horner(&self, t: f64) -> f64 {
        let mut sum = 0.0;
        let mut current = self;
        while let List::Cons(x, next) = current {
            sum = sum * t + x * x;
            current = next;
        }
        sum
    }

    fn second(&self) -> f64 {
        let mut current = self;
        if let List::Cons(_, next) = current {
            current = next;
        }
        match current {
            List::Cons(x, _) => x.sin(),
            List::Nil => 0.5,
        }
    }

    fn third(&self) -> f64 {
        let mut current = self;
        for _ in 0..2 {
            match current {
                List::Cons(_, next) => current = next,
                List::Nil => {}
            }
        }
        let rest: &List = match current {
            List::Cons(_, next) => next,
            List::Nil => self,
        };
        match (current, rest) {
            (List::Cons(x, _), List::Nil) => x * x,
            _ => 0.25,
        }
    }
}

#[differentiable]
fn walked(x: f64, y: f64) -> f64 {
    let last = List::Cons(x * y, Box::new(List::Nil));
    let list = List::Cons(x, Box::new(List::Cons(y, Box::new(last))));
    list.horner(y) + list.second() * list.third()
}

#[derive(Clone, Differentiable)]
struct Node {
    value: f64,
    next: Option<Box<Node>>,
}

#[differentiable]
fn nodes(node: &Node) -> f64 {
    let mut sum = node.value;
    let mut current = node;
    while let Some(next) = &current.next {
        sum = sum * next.value + current.value;
        current = next;
    }
    sum
}

#[differentiable]
fn linked(x: f64, y: f64) -> f64 {
    let last = Node { value: x * y, next: None };
    let middle = Node { value: y, next: Some(Box::new(last)) };
    nodes(&Node { value: x, next: Some(Box::new(middle)) })
}

#[test]
fn walks() {
    check!(walked(x, y) at [0.7, 1.3], [-1.2, 0.4]);
    check!(linked(x, y) at [0.7, 1.3], [-1.2, 0.4]);
}
