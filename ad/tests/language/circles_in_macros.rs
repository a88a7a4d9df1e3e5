//! Functions that call themselves within macros.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn in_a_list(x: f64, depth: usize) -> f64 {
    if depth == 0 {
        return x;
    }
    let values = vec![vec![in_a_list(x * 0.5, depth - 1)], vec![x; 2]];
    values[0][0] * values[1][1]
}

#[differentiable]
fn repeated(x: f64, depth: usize) -> f64 {
    if depth == 0 {
        return x;
    }
    let values = vec![repeated(x * 0.5, depth - 1) + x; 2];
    values[0] * values[1]
}

#[differentiable]
fn compared(x: f64, depth: usize) -> f64 {
    assert!(depth == 0 || compared(x, depth - 1) > -100.0);
    if depth > 0 && matches!(compared(x, depth - 1), y if y > 0.0) { x * x } else { x }
}

#[derive(Clone, Differentiable)]
enum Tree {
    Leaf(f64),
    Node(Box<Tree>, Box<Tree>),
}

#[differentiable]
impl Tree {
    fn product(&self) -> f64 {
        match self {
            Tree::Leaf(x) => *x,
            Tree::Node(left, right) => {
                let products = vec![left.product(), right.product()];
                products[0] * products[1]
            }
        }
    }
}

#[differentiable]
fn all(x: f64, y: f64) -> f64 {
    let leaves = Tree::Node(Box::new(Tree::Leaf(x)), Box::new(Tree::Leaf(y)));
    let tree = Tree::Node(Box::new(leaves), Box::new(Tree::Leaf(x)));
    in_a_list(x, 3) + repeated(y, 2) * compared(x, 2) + tree.product()
}

#[test]
fn lists_and_tests() {
    check!(all(x, y) at [0.7, 1.3], [-1.1, 0.4]);
}
