use ad::{Differentiable, differentiable};

#[derive(Clone, Differentiable)]
struct Node {
    value: f64,
    next: Option<Box<Node>>,
}

#[differentiable]
impl Node {
    fn scale(&mut self, by: f64) -> &mut Self {
        self.value *= by;
        self
    }

    fn value(&self) -> f64 {
        self.value
    }

    fn next(&mut self) -> &mut Self {
        self.next.as_mut().unwrap()
    }
}

trait Show {
    fn show(&self);
}

impl Show for f64 {
    fn show(&self) {}
}

impl Show for Node {
    fn show(&self) {}
}

#[differentiable]
fn used(x: f64) -> f64 {
    let mut node = Node { value: x, next: None };
    node.scale(2.0).value()
}

#[differentiable]
fn of_a_value(x: f64) -> f64 {
    let mut node = Node { value: x, next: None };
    node.scale(2.0);
    node.value().show();
    node.value
}

fn main() {
    used::grad(1.0);
    of_a_value::grad(1.0);
}
