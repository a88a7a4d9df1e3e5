//! Bodies that attract each other, on a vector type of its own.

use ad::{Differentiable, differentiable};
use std::ops::{Add, AddAssign, Mul, Sub};

#[derive(Clone, Copy, Debug, Default, PartialEq, Differentiable)]
struct Vec2(f64, f64);

#[differentiable]
impl Add for Vec2 {
    type Output = Vec2;
    fn add(self, o: Vec2) -> Vec2 {
        Vec2(self.0 + o.0, self.1 + o.1)
    }
}
#[differentiable]
impl Sub for Vec2 {
    type Output = Vec2;
    fn sub(self, o: Vec2) -> Vec2 {
        Vec2(self.0 - o.0, self.1 - o.1)
    }
}
#[differentiable]
impl Mul<f64> for Vec2 {
    type Output = Vec2;
    fn mul(self, s: f64) -> Vec2 {
        Vec2(self.0 * s, self.1 * s)
    }
}
#[differentiable]
impl Mul<Vec2> for f64 {
    type Output = Vec2;
    fn mul(self, v: Vec2) -> Vec2 {
        v * self
    }
}
#[differentiable]
impl AddAssign for Vec2 {
    fn add_assign(&mut self, o: Vec2) {
        *self = *self + o;
    }
}

#[differentiable]
impl Vec2 {
    fn norm2(self) -> f64 {
        let Vec2(x, y) = self;
        x * x + y * y
    }
}

#[derive(Clone, Debug, Differentiable)]
struct Body {
    mass: f64,
    pos: Vec2,
    vel: Vec2,
    #[constant]
    name: String,
}

const G: f64 = 1.0;

#[differentiable]
fn step(bodies: &mut [Body], dt: f64) {
    let n = bodies.len();
    let mut acc = vec![Vec2::default(); n];
    for i in 0..n {
        for j in (i + 1)..n {
            let d = bodies[j].pos - bodies[i].pos;
            let r2 = d.norm2() + 1e-3;
            let inv = G / (r2 * r2.sqrt());
            acc[i] += d * (bodies[j].mass * inv);
            acc[j] += d * (-bodies[i].mass * inv);
        }
    }
    for (body, a) in bodies.iter_mut().zip(acc) {
        body.vel += dt * a;
        body.pos += body.vel * dt;
    }
}

#[differentiable]
fn step_split(bodies: &mut [Body], dt: f64) {
    for i in 0..bodies.len() {
        let (left, right) = bodies.split_at_mut(i);
        let (me, right) = right.split_first_mut().unwrap();
        for other in left.iter().chain(right.iter()) {
            let d = other.pos - me.pos;
            let r2 = d.norm2() + 1e-3;
            me.vel += d * (dt * G * other.mass / r2.powf(1.5));
        }
    }
    for b in bodies {
        b.pos += b.vel * dt;
    }
}

#[differentiable]
fn energy(bodies: &[Body]) -> f64 {
    let mut e = 0.0;
    for (i, b) in bodies.iter().enumerate() {
        e += 0.5 * b.mass * b.vel.norm2();
        for other in &bodies[i + 1..] {
            e -= G * b.mass * other.mass / (b.pos - other.pos).norm2().sqrt();
        }
    }
    e
}

#[differentiable]
fn simulate(mass: f64, speed: f64) -> f64 {
    let mut bodies = vec![
        Body { mass: 1.0, pos: Vec2(0.0, 0.0), vel: Vec2::default(), name: "sun".into() },
        Body { mass, pos: Vec2(1.0, 0.0), vel: Vec2(0.0, speed), name: String::from("a") },
        Body {
            mass: 0.5 * mass,
            pos: Vec2(-1.5, 0.2),
            vel: Vec2(0.1, -speed),
            name: "b".to_string(),
        },
    ];
    for k in 0..20 {
        if k % 2 == 0 {
            step(&mut bodies, 0.01);
        } else {
            step_split(&mut bodies, 0.01);
        }
    }
    assert_eq!(bodies[0].name, "sun");
    energy(&bodies) + bodies[1].pos.0
}

#[test]
fn bodies() {
    use crate::oracle::check;

    check!(simulate(mass, speed) at [0.7, 0.5], [0.2, 0.9]);
}
