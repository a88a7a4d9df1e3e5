//! Bodies, chains, rays.

use ad::{Differentiable, differentiable};
use glam::{DVec2, DVec3};

use crate::oracle::check;

#[derive(Clone, Copy, Debug, Differentiable)]
struct Body {
    position: DVec3,
    velocity: DVec3,
    mass: f64,
}

#[differentiable]
fn accelerations(bodies: &[Body], softening: f64) -> Vec<DVec3> {
    let mut result = vec![DVec3::ZERO; bodies.len()];
    for i in 0..bodies.len() {
        for j in (i + 1)..bodies.len() {
            let r = bodies[j].position - bodies[i].position;
            let d2 = r.length_squared() + softening * softening;
            let inv = 1.0 / (d2 * d2.sqrt());
            result[i] += r * bodies[j].mass * inv;
            result[j] -= r * bodies[i].mass * inv;
        }
    }
    result
}

#[differentiable]
fn leapfrog(bodies: &mut Vec<Body>, dt: f64) {
    let a = accelerations(bodies, 0.1);
    for (body, a) in bodies.iter_mut().zip(&a) {
        body.velocity += *a * (0.5 * dt);
        body.position += body.velocity * dt;
    }
    let a = accelerations(bodies, 0.1);
    for (body, a) in bodies.iter_mut().zip(a.iter()) {
        body.velocity += 0.5 * dt * *a;
    }
}

#[differentiable]
fn energy(bodies: &[Body]) -> f64 {
    let kinetic: f64 = bodies.iter().map(|b| 0.5 * b.mass * b.velocity.length_squared()).sum();
    let mut potential = 0.0;
    for (i, a) in bodies.iter().enumerate() {
        for b in &bodies[i + 1..] {
            potential -= a.mass * b.mass / a.position.distance(b.position);
        }
    }
    kinetic + potential
}

#[differentiable]
fn n_body(mass: f64, speed: f64) -> f64 {
    let mut bodies = vec![
        Body { position: DVec3::ZERO, velocity: DVec3::ZERO, mass },
        Body { position: DVec3::X, velocity: DVec3::new(0.0, speed, 0.1), mass: 0.1 },
        Body { position: DVec3::new(-1.5, 0.2, 0.0), velocity: DVec3::Y * -speed, mass: 0.2 },
    ];
    for _ in 0..5 {
        leapfrog(&mut bodies, 0.02);
    }
    energy(&bodies) + bodies[1].position.x
}

/// A planar arm: where its end is, and how far from a target.
#[differentiable]
fn end_of_chain(lengths: &[f64], angles: &[f64]) -> DVec2 {
    let mut position = DVec2::ZERO;
    let mut heading = 0.0;
    for (length, angle) in lengths.iter().zip(angles) {
        heading += angle;
        position += DVec2::new(heading.cos(), heading.sin()) * *length;
    }
    position
}

#[differentiable]
fn reach(x: f64, y: f64) -> f64 {
    let lengths = [1.0, 0.8, 0.5];
    let mut angles = [0.3, x, y];
    let target = DVec2::new(1.2, 0.9);
    // A few steps of coordinate descent along the way.
    for i in 0..angles.len() {
        let end = end_of_chain(&lengths, &angles);
        let error = (end - target).length();
        angles[i] -= 0.1 * error;
    }
    end_of_chain(&lengths, &angles).distance(target)
}

/// Springs between neighbours on a string with fixed ends.
#[differentiable]
fn string(stiffness: f64, damping: f64) -> f64 {
    const N: usize = 6;
    let mut y = [0.0; N];
    let mut v = [0.0; N];
    y[2] = 0.3;
    let mut heard = 0.0;
    for step in 0..20 {
        let mut force = [0.0; N];
        for i in 0..N {
            let left = if i == 0 { 0.0 } else { y[i - 1] };
            let right = if i == N - 1 { 0.0 } else { y[i + 1] };
            force[i] = stiffness * (left + right - 2.0 * y[i]) - damping * v[i];
        }
        for ((y, v), f) in y.iter_mut().zip(v.iter_mut()).zip(&force) {
            *v += 0.1 * f;
            *y += 0.1 * *v;
        }
        heard += y[4] * (step as f64 * 0.2).sin();
    }
    heard
}

#[derive(Clone, Copy, Differentiable)]
enum Solid {
    Sphere { center: DVec3, radius: f64 },
    Box { half: DVec3 },
    Plane { height: f64 },
}

#[differentiable]
impl Solid {
    fn distance(&self, p: DVec3) -> f64 {
        match *self {
            Solid::Sphere { center, radius } => (p - center).length() - radius,
            Solid::Box { half } => {
                let q = p.abs() - half;
                q.max(DVec3::ZERO).length() + q.max_element().min(0.0)
            }
            Solid::Plane { height } => p.y - height,
        }
    }
}

#[differentiable]
fn smooth_min(a: f64, b: f64, k: f64) -> f64 {
    let h = (k - (a - b).abs()).max(0.0) / k;
    a.min(b) - h * h * k * 0.25
}

#[differentiable]
fn scene(solids: &[Solid], p: DVec3) -> f64 {
    solids.iter().fold(1e3, |nearest, solid| smooth_min(nearest, solid.distance(p), 0.3))
}

#[differentiable]
fn normal(solids: &[Solid], p: DVec3) -> DVec3 {
    let h = 1e-3;
    let d = |offset: DVec3| scene(solids, p + offset) - scene(solids, p - offset);
    DVec3::new(d(DVec3::X * h), d(DVec3::Y * h), d(DVec3::Z * h)).normalize()
}

#[differentiable]
fn march(solids: &[Solid], origin: DVec3, direction: DVec3) -> Option<DVec3> {
    let mut t = 0.0;
    for _ in 0..64 {
        let p = origin + direction * t;
        let d = scene(solids, p);
        if d < 1e-9 {
            return Some(p);
        }
        t += d;
        if t > 20.0 {
            break;
        }
    }
    None
}

#[differentiable]
fn pixel(radius: f64, height: f64) -> f64 {
    let solids = [
        Solid::Sphere { center: DVec3::new(0.2, 0.1, 0.0), radius },
        Solid::Box { half: DVec3::new(0.3, 0.5, 0.3) },
        Solid::Plane { height },
    ];
    let light = DVec3::new(0.5, 1.0, -0.8).normalize();
    let mut color = 0.0;
    for i in 0..3 {
        let direction = DVec3::new(0.1 * i as f64 - 0.12, 0.05, 1.0).normalize();
        let Some(hit) = march(&solids, DVec3::new(0.0, 0.2, -3.0), direction) else {
            color += 0.1;
            continue;
        };
        let n = normal(&solids, hit);
        color += n.dot(light).max(0.0) * 0.8 + 0.2 * hit.z;
    }
    color
}

#[test]
fn geometry() {
    check!(n_body(mass, speed) at [1.3, 0.7], [0.4, 1.1]);
    check!(reach(x, y) at [0.3, 0.7], [-0.4, 1.1]);
    check!(string(k, c) at [1.3, 0.7], [0.4, 0.1]);
    check!(pixel(radius, height) at [0.6, -0.7], [0.4, -0.5]);
}
