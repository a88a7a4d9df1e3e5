//! The attribute on single methods, in a block that does not carry it.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[derive(Clone, Differentiable)]
struct Ball {
    height: f64,
    speed: f64,
}

impl Ball {
    #[differentiable]
    fn thrown(height: f64, speed: f64) -> Self {
        Self { height, speed }
    }

    #[differentiable]
    fn energy(&self, mass: f64) -> f64 {
        mass * (0.5 * self.speed * self.speed + 9.81 * self.height)
    }

    #[differentiable]
    fn step(&mut self, dt: f64) -> bool {
        self.height += self.speed * dt;
        self.accelerate(dt);
        self.height > 0.0
    }

    #[differentiable]
    fn accelerate(&mut self, dt: f64) {
        self.speed -= 9.81 * dt;
    }

    /// Nothing is to be differentiated here.
    fn is_falling(&self) -> bool {
        self.speed < 0.0
    }
}

#[differentiable]
fn flight(x: f64, y: f64) -> f64 {
    let mut ball = Ball::thrown(x, y);
    for _ in 0..4 {
        let is_above = ball.step(0.1);
        if is_above && ball.is_falling() {
            ball.accelerate(0.05 * x);
        }
    }
    ball.energy(y)
}

#[test]
fn single_methods() {
    check!(flight(x, y) at [3.0, 1.2], [0.1, -2.0]);
}
