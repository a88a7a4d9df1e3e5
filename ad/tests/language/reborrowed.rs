//! Names of `&mut` that are passed where a `&` is wanted, beside others that a call changes.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Copy, Differentiable)]
struct Body {
    x: f64,
}

#[differentiable]
impl Body {
    fn add(&mut self, other: &Body) {
        self.x += other.x * other.x;
    }

    fn give(&self, other: &mut Body) {
        other.x *= self.x;
    }

    fn second_changes(&mut self, a: &Body, b: &mut Body) -> f64 {
        self.x += a.x * b.x;
        b.x *= self.x;
        a.x * 2.0
    }

    fn first_changes(&mut self, a: &mut Body, b: &Body) -> f64 {
        self.x += a.x * b.x;
        a.x *= self.x;
        b.x * 2.0
    }

    fn scale(&mut self, weights: &[f64]) {
        self.x *= weights[0];
    }
}

#[differentiable]
trait Gather {
    fn gather(&mut self, other: &Self);
}

#[differentiable]
impl Gather for Body {
    fn gather(&mut self, other: &Self) {
        self.x += other.x.sin();
    }
}

#[differentiable]
fn gathered<T: Gather + Differentiable>(a: &mut T, b: &mut T) {
    a.gather(b);
    b.gather(a);
}

#[differentiable]
fn mixed(a: &Body, b: &mut Body) {
    b.x *= a.x;
}

#[differentiable]
fn two(a: &mut Body, b: &mut Body) {
    b.add(a);
    a.give(b);
    b.give(a);
    mixed(a, b);
    mixed(b, a);
    gathered(a, b);
}

#[differentiable]
fn three(a: &mut Body, b: &mut Body, c: &mut Body) -> f64 {
    let x = a.second_changes(b, c);
    let y = a.first_changes(b, c);
    x * y + b.second_changes(a, c) + c.first_changes(a, b)
}

#[differentiable]
fn lists(u: &mut [f64], w: &mut Vec<f64>, body: &mut Body) {
    w.extend_from_slice(u);
    w[..2].copy_from_slice(u);
    body.scale(w);
    body.scale(u);
    u[0] *= w[2];
}

#[derive(Clone, Differentiable)]
struct World {
    bodies: Vec<Body>,
    whole: Body,
}

#[differentiable]
impl World {
    fn step(&mut self) {
        for body in self.bodies.iter_mut() {
            self.whole.add(body);
            body.x *= 0.5;
        }
        let World { bodies, whole } = self;
        for body in bodies.iter_mut() {
            whole.add(body);
            body.give(whole);
        }
    }

    fn absorb(&mut self, body: &mut Body) {
        self.whole.add(body);
        body.x = 0.5;
    }
}

#[differentiable]
fn by_name(x: f64, y: f64) -> f64 {
    let (mut a, mut b, mut c) = (Body { x }, Body { x: y }, Body { x: x * y });
    two(&mut a, &mut b);
    let product = three(&mut a, &mut b, &mut c);
    let (mut u, mut w) = ([x, y], vec![y, x]);
    lists(&mut u, &mut w, &mut b);
    a.x + b.x * product + c.x * u[0] + w[3]
}

#[differentiable]
fn in_loops(x: f64, y: f64) -> f64 {
    let mut bodies = vec![Body { x }, Body { x: y }];
    let mut whole = Body { x: x * y };
    for body in bodies.iter_mut() {
        whole.add(body);
        body.x = 0.0;
    }
    let mut world = World { bodies: vec![Body { x }, whole], whole: Body { x: y } };
    world.step();
    let mut last = Body { x };
    world.absorb(&mut last);
    world.whole.x + world.bodies[0].x * last.x
}

/// A `&mut` that is written out, where a `&` is wanted.
#[differentiable]
#[allow(clippy::unnecessary_mut_passed)]
fn written_out(x: f64, y: f64) -> f64 {
    let (mut a, mut b) = (Body { x }, Body { x: y });
    b.add(&mut a);
    a.first_changes(&mut b, &mut Body { x: y }) + a.x + b.x
}

#[test]
fn references_to_change_are_looked_at() {
    check!(by_name(x, y) at [0.7, 0.4], [-0.4, 0.9]);
    check!(in_loops(x, y) at [0.7, 0.4], [-0.4, 0.9]);
    check!(written_out(x, y) at [0.7, 0.4], [-0.4, 0.9]);
}
