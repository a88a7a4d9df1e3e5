//! Values that keep what references among the parameters refer to.

use ad::{Differentiable, differentiable};

use crate::oracle::{assert_forward, assert_gradient};

#[derive(Clone, Copy, Differentiable)]
struct View<'a> {
    data: &'a [f64],
    scale: f64,
}

#[derive(Clone, Copy, Differentiable)]
struct Pair<'a>(&'a [f64], &'a [f64]);

#[differentiable]
impl<'a> View<'a> {
    fn new(data: &'a [f64], scale: f64) -> View<'a> {
        View { data, scale }
    }

    fn product(&self) -> f64 {
        self.data[0] * self.data[1] * self.scale
    }

    fn rest(&self) -> View<'a> {
        View { data: &self.data[1..], scale: self.scale }
    }
}

#[derive(Clone, Differentiable)]
struct Owner {
    data: Vec<f64>,
}

#[differentiable]
impl Owner {
    fn view(&self, scale: f64) -> View<'_> {
        View { data: &self.data, scale }
    }

    #[differentiable(borrows)]
    fn total(&self, scale: f64) -> f64 {
        let rest = View { data: &self.data[1..], scale };
        rest.product() * self.view(scale).product()
    }
}

#[differentiable]
fn written_out(xs: &[f64], scale: f64) -> f64 {
    let view = View { data: xs, scale };
    let tail = &xs[1..];
    let pair = Pair(tail, xs);
    view.product() * view.rest().product() + pair.0[0] * pair.1[0]
}

#[differentiable]
fn whole(xs: &[f64]) -> View<'_> {
    View { data: xs, scale: 2.0 }
}

#[differentiable(borrows)]
fn ends(xs: &[f64]) -> Option<(&f64, &f64)> {
    Some((xs.first()?, xs.last()?))
}

#[differentiable(borrows)]
fn of_an_option(xs: &[f64], scale: f64) -> f64 {
    let (first, last) = ends(xs).unwrap();
    *first * *last * *last * scale
}

#[differentiable(borrows)]
fn made_by_a_call(xs: &[f64], scale: f64) -> f64 {
    View::new(xs, scale).product() * whole(xs).product()
}

#[differentiable(borrows)]
fn of_an_owner(owner: &Owner, scale: f64) -> f64 {
    owner.total(scale)
}

#[differentiable(borrows)]
fn largest(xs: &[f64], scale: f64) -> f64 {
    let mut largest: Option<&f64> = None;
    for x in xs {
        if largest.is_none() || *x > *largest.unwrap() {
            largest = Some(x);
        }
    }
    *largest.unwrap() * *largest.unwrap() * scale
}

#[derive(Clone, Differentiable)]
struct Node {
    value: f64,
    children: Vec<Node>,
}

#[differentiable(borrows)]
fn weighted(tree: &Node, decay: f64) -> f64 {
    let mut sum = 0.0;
    let mut open = vec![(tree, 1.0)];
    while let Some((node, weight)) = open.pop() {
        sum += node.value * node.value * weight;
        for child in &node.children {
            open.push((child, weight * decay));
        }
    }
    sum
}

fn check_slice(
    f: fn(&[f64], f64) -> f64,
    gradient: fn(&[f64], f64) -> (f64, (Vec<f64>, f64)),
    forward: fn(&[f64], f64, &[f64], f64) -> (f64, f64),
) {
    for point in [[0.7, 1.3, -0.4, 1.1], [-1.1, 0.4, 0.9, 0.3]] {
        let [xs @ .., scale] = &point;
        let (value, (to_xs, to_scale)) = gradient(xs, *scale);
        assert_eq!(value.to_bits(), f(xs, *scale).to_bits());
        let gradient = [&to_xs[..], &[to_scale]].concat();
        assert_gradient("slice", |p| f(&p[..3], p[3]), &point, &gradient);
        let forward = |p: &[f64], d: &[f64]| forward(&p[..3], p[3], &d[..3], d[3]);
        assert_forward("slice", forward, &point, value, &gradient);
    }
}

/// A function of a slice and a number that makes something of the slice, in both modes.
macro_rules! of_slices {
    ($($f:ident($made:expr, $tangent:expr, $back:expr);)*) => {$(
        check_slice(
            |xs, scale| $f(&$made(xs), scale),
            |xs, scale| {
                let (value, (to_made, to_scale)) = $f::value_and_grad(&$made(xs), scale);
                (value, ($back(to_made), to_scale))
            },
            |xs, scale, xs_dot, scale_dot| {
                $f::jvp(&$made(xs), scale, &$tangent(xs_dot), scale_dot)
            },
        );
    )*};
}

fn tree(xs: &[f64]) -> Node {
    let leaf = |value| Node { value, children: Vec::new() };
    let inner = Node { value: xs[1], children: vec![leaf(xs[2])] };
    Node { value: xs[0], children: vec![inner] }
}

fn tree_tangent(xs: &[f64]) -> NodeTangent {
    let leaf = |value| NodeTangent { value, children: Vec::new() };
    let inner = NodeTangent { value: xs[1], children: vec![leaf(xs[2])] };
    NodeTangent { value: xs[0], children: vec![inner] }
}

fn of_tree(tangent: NodeTangent) -> Vec<f64> {
    let inner = &tangent.children[0];
    vec![tangent.value, inner.value, inner.children[0].value]
}

#[test]
fn references_are_kept() {
    of_slices! {
        written_out(<[f64]>::to_vec, <[f64]>::to_vec, |to| to);
        made_by_a_call(<[f64]>::to_vec, <[f64]>::to_vec, |to| to);
        of_an_option(<[f64]>::to_vec, <[f64]>::to_vec, |to| to);
        largest(<[f64]>::to_vec, <[f64]>::to_vec, |to| to);
        of_an_owner(
            |xs: &[f64]| Owner { data: xs.to_vec() },
            |xs: &[f64]| OwnerTangent { data: xs.to_vec() },
            |to: OwnerTangent| to.data
        );
        weighted(tree, tree_tangent, of_tree);
    }
}
