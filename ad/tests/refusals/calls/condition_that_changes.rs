use ad::{Differentiable, differentiable};

#[derive(Clone, Differentiable)]
struct Ball {
    height: f64,
    speed: f64,
}

#[differentiable]
impl Ball {
    fn bounce(&mut self) -> bool {
        self.height *= self.speed;
        self.height > 1.0
    }
}

#[differentiable]
fn of_an_element(balls: &mut [Ball]) -> f64 {
    let mut hits = 0;
    for i in 0..balls.len() {
        if balls[i].bounce() {
            hits += 1;
        }
    }
    balls[0].height * hits as f64
}

#[differentiable]
fn of_a_variable(x: f64) -> f64 {
    let mut ball = Ball { height: x, speed: x };
    let up: bool = ball.bounce();
    while ball.bounce() {}
    if up { ball.height } else { x }
}

fn bump(v: &mut [f64]) -> bool {
    v[0] += 1.0;
    true
}

#[differentiable]
fn under_a_condition(v: &mut [f64], x: f64) -> f64 {
    match Some(x) {
        Some(y) if bump(v) => y * v[0],
        _ => v[0],
    }
}

#[differentiable]
fn in_a_closure(v: &mut [f64], x: f64) -> f64 {
    if [1, 2].iter().any(|_| bump(v)) { v[0] * x } else { x }
}

fn main() {}
