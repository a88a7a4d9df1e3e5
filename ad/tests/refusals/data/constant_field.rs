use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Hit {
    #[constant]
    time: f64,
    depth: f64,
}

#[derive(Clone, Copy, Differentiable)]
enum Shape {
    Disc {
        #[constant]
        radius: f64,
        height: f64,
    },
    Point,
}

#[differentiable]
fn made(x: f64) -> f64 {
    let hit = Hit { time: x * x, depth: x };
    hit.time * hit.depth
}

#[differentiable]
fn updated(x: f64, hit: Hit) -> f64 {
    let hit = Hit { time: x, ..hit };
    hit.time * hit.depth
}

#[differentiable]
fn assigned(x: f64, hit: Hit) -> f64 {
    let mut later = hit;
    later.time = x;
    later.time * later.depth
}

#[differentiable]
fn increased(x: f64, hit: Hit) -> f64 {
    let mut later = hit;
    later.time += x;
    later.time * later.depth
}

#[differentiable]
fn double(x: &mut f64) {
    *x *= 2.0;
}

#[differentiable]
fn lent(hit: Hit) -> f64 {
    let mut later = hit;
    double(&mut later.time);
    later.time * later.depth
}

#[differentiable]
fn of_a_variant(x: f64) -> f64 {
    match (Shape::Disc { radius: x, height: 2.0 * x }) {
        Shape::Disc { radius, height } => radius * height,
        Shape::Point => 0.0,
    }
}

#[differentiable]
fn computed(hit: Hit) -> f64 {
    let later = Hit { time: 2.0 * hit.time, ..hit };
    later.time * later.depth
}

fn main() {}
