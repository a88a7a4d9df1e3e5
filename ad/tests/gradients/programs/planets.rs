//! Bodies under gravity, by the velocity Verlet method, on glam's vectors.

use ad::{Differentiable, differentiable};
use glam::DVec3;

use crate::oracle::check;

const G: f64 = 1.0;

#[derive(Clone, Debug, Differentiable)]
struct System {
    positions: Vec<DVec3>,
    velocities: Vec<DVec3>,
    masses: Vec<f64>,
}

#[differentiable]
impl System {
    fn accelerations(&self, softening: f64) -> Vec<DVec3> {
        let n = self.positions.len();
        let mut out = vec![DVec3::ZERO; n];
        for i in 0..n {
            for j in (i + 1)..n {
                let d = self.positions[j] - self.positions[i];
                let r2 = d.length_squared() + softening * softening;
                let f = G / (r2 * r2.sqrt());
                out[i] += d * (f * self.masses[j]);
                out[j] -= d * (f * self.masses[i]);
            }
        }
        out
    }

    fn step(&mut self, dt: f64, softening: f64) {
        let before = self.accelerations(softening);
        for i in 0..self.positions.len() {
            self.positions[i] += self.velocities[i] * dt + 0.5 * before[i] * dt * dt;
        }
        let after = self.accelerations(softening);
        for ((v, a), b) in self.velocities.iter_mut().zip(&before).zip(&after) {
            *v += 0.5 * dt * (*a + *b);
        }
    }

    fn energy(&self) -> f64 {
        let kinetic: f64 = self
            .velocities
            .iter()
            .zip(self.masses.iter())
            .map(|(v, m)| 0.5 * m * v.length_squared())
            .sum();
        let mut potential = 0.0;
        for i in 0..self.positions.len() {
            for j in 0..i {
                let distance = (self.positions[i] - self.positions[j]).length();
                potential -= G * self.masses[i] * self.masses[j] / distance;
            }
        }
        kinetic + potential
    }
}

#[differentiable]
fn miss(speed: f64, mass: f64) -> f64 {
    let mut system = System {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::new(0.0, -1.5, 0.2)],
        velocities: vec![DVec3::ZERO, DVec3::Y * speed, DVec3::new(0.7, 0.0, 0.0)],
        masses: vec![mass, 1e-2, 2e-2],
    };
    let start = system.energy();
    for _ in 0..20 {
        system.step(0.02, 0.01);
    }
    let target = DVec3::new(0.9, 0.4, 0.0);
    system.positions[1].distance_squared(target) + (system.energy() - start).powi(2)
}

#[test]
fn planets() {
    check!(miss(speed, mass) at [1.0, 1.1], [0.8, 0.9]);
}
