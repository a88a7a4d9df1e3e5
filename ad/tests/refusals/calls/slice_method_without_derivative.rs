use ad::{Differentiable, differentiable};

#[derive(Differentiable)]
struct Stack {
    values: Vec<f64>,
}

impl Stack {
    fn push(&mut self, x: f64) {
        self.values.push(x);
    }
}

#[differentiable]
fn of_a_slice(xs: &[f64]) -> f64 {
    let ends = xs.first_chunk::<2>();
    xs[0]
}

#[differentiable]
fn by_a_closure(xs: &[f64]) -> f64 {
    xs.split(|x| *x < 0.0).map(|part| part[0]).sum()
}

/// A method of the name that a method of slices has.
#[differentiable]
impl Stack {
    fn get(&self, index: usize) -> f64 {
        self.values[index]
    }
}

#[differentiable]
fn of_the_name_of_another(stacks: &[Stack]) -> f64 {
    stacks[0].get(0)
}

#[differentiable]
fn of_a_type(stack: &mut Stack, x: f64) -> f64 {
    stack.push(x);
    x
}

fn main() {
    of_a_slice::grad(&[1.0]);
}
