//! Cloth as a struct of arrays, changed through `&mut self`; robust residuals; matrices of fixed size.

use ad::{Differentiable, Real, differentiable};

use crate::oracle::{check, check_generic};

#[derive(Clone, Copy, Debug, Differentiable)]
#[constant]
struct Spring {
    ends: [usize; 2],
    rest: f64,
}

#[derive(Clone, Differentiable)]
struct Cloth {
    x: Vec<[f64; 2]>,
    v: Vec<[f64; 2]>,
    stiffness: f64,
    damping: f64,
    #[constant]
    springs: Vec<Spring>,
    #[constant]
    pinned: Vec<bool>,
}

#[differentiable]
impl Cloth {
    fn accumulate(&self, forces: &mut Vec<[f64; 2]>) {
        for spring in &self.springs {
            let [a, b] = spring.ends;
            let mut delta = [0.0; 2];
            for d in 0..2 {
                delta[d] = self.x[b][d] - self.x[a][d];
            }
            let length = delta[0].hypot(delta[1]);
            if length < 1e-9 {
                continue;
            }
            let pull = self.stiffness * (length - spring.rest) / length;
            for (d, delta) in delta.iter().enumerate() {
                forces[a][d] += pull * delta;
                forces[b][d] -= pull * delta;
            }
        }
    }

    fn step(&mut self, wind: f64, dt: f64) {
        let mut forces = vec![[wind, -9.81]; self.x.len()];
        self.accumulate(&mut forces);
        for (i, force) in forces.iter().enumerate() {
            if self.pinned[i] {
                continue;
            }
            let Cloth { x, v, damping, .. } = &mut *self;
            for d in 0..2 {
                v[i][d] = (v[i][d] + dt * force[d]) * (1.0 - *damping * dt);
                x[i][d] += dt * v[i][d];
            }
        }
    }

    fn energy(&self) -> f64 {
        let kinetic: f64 = self.v.iter().map(|[vx, vy]| 0.5 * (vx * vx + vy * vy)).sum();
        let potential = self.x.iter().map(|p| 9.81 * p[1]).sum::<f64>();
        kinetic + potential
    }
}

#[differentiable]
fn simulate(stiffness: f64, damping: f64, wind: f64) -> f64 {
    let width = 3;
    let mut x = Vec::new();
    let mut springs = Vec::new();
    for row in 0..2usize {
        for column in 0..width {
            x.push([0.1 * column as f64, -0.1 * row as f64]);
            let here = row * width + column;
            if column > 0 {
                springs.push(Spring { ends: [here - 1, here], rest: 0.1 });
            }
            if row > 0 {
                springs.push(Spring { ends: [here - width, here], rest: 0.09 });
            }
        }
    }
    let count = x.len();
    let pinned = (0..count).map(|i| i == 0 || i == width - 1).collect::<Vec<bool>>();
    let mut cloth = Cloth { x, v: vec![[0.0; 2]; count], stiffness, damping, springs, pinned };
    for _ in 0..12 {
        cloth.step(wind, 0.01);
    }
    cloth.energy()
}

#[test]
fn cloth() {
    check!(simulate(stiffness, damping, wind) at [40.0, 0.3, 1.5], [10.0, 1.2, -0.5]);
}

#[derive(Clone, Copy, Differentiable)]
enum Loss {
    Square,
    Huber(f64),
    Cauchy { scale: f64 },
}

#[differentiable]
trait Robust {
    const NAME: &'static str;
    const HALF: f64 = 0.5;

    fn rho(&self, residual: f64) -> f64;

    fn weight(&self, residual: f64) -> f64 {
        self.rho(residual) / (Self::HALF * residual * residual + 1e-12)
    }
}

#[differentiable]
impl Robust for Loss {
    const NAME: &'static str = "loss";

    fn rho(&self, residual: f64) -> f64 {
        match *self {
            Loss::Square => Self::HALF * residual * residual,
            Loss::Huber(delta) if residual.abs() <= delta => Self::HALF * residual.powi(2),
            Loss::Huber(delta) => delta * (residual.abs() - Self::HALF * delta),
            Loss::Cauchy { scale } => {
                let s = scale * scale;
                Self::HALF * s * (residual * residual / s).ln_1p()
            }
        }
    }
}

/// Two steps of Levenberg and Marquardt for an exponential through noisy points.
#[differentiable]
fn fitted(start: f64, rate: f64, scale: f64) -> f64 {
    const POINTS: [(f64, f64); 5] = [(0.0, 2.1), (0.5, 1.2), (1.0, 0.9), (1.5, 4.0), (2.0, 0.2)];
    let losses = [Loss::Square, Loss::Huber(0.3 * scale), Loss::Cauchy { scale }];
    let (mut a, mut b) = (start, rate);
    let mut lambda = 0.1;
    let mut cost = f64::INFINITY;
    for (iteration, loss) in losses.iter().cycle().take(4).enumerate() {
        let mut hessian = [[0.0; 2]; 2];
        let mut gradient = [0.0; 2];
        let mut sum = 0.0;
        for &(t, y) in POINTS.iter() {
            let model = a * (-b * t).exp();
            let residual = model - y;
            let jacobian = [(-b * t).exp(), -t * model];
            let weight = loss.weight(residual);
            for (i, row) in hessian.iter_mut().enumerate() {
                for (entry, j) in row.iter_mut().zip(&jacobian) {
                    *entry += weight * jacobian[i] * j;
                }
                gradient[i] += weight * jacobian[i] * residual;
            }
            sum += loss.rho(residual);
        }
        lambda = if iteration == 0 || sum < cost { lambda * 0.5 } else { lambda * 3.0 };
        cost = sum;
        let [[p, q], [_, s]] = hessian;
        let (p, s) = (p * (1.0 + lambda), s * (1.0 + lambda));
        let determinant = p * s - q * q;
        a -= (s * gradient[0] - q * gradient[1]) / determinant;
        b -= (p * gradient[1] - q * gradient[0]) / determinant;
    }
    assert!(!<Loss as Robust>::NAME.is_empty());
    cost + a * b
}

#[test]
fn robust_residuals() {
    check!(fitted(start, rate, scale) at [2.0, 0.8, 0.5], [1.5, 1.1, 0.9]);
}

#[derive(Clone, Copy, Differentiable)]
struct Block<S, const R: usize, const C: usize>([[S; C]; R]);

#[differentiable]
impl<S: Real, const R: usize, const C: usize> Block<S, R, C> {
    fn times<const K: usize>(&self, other: &Block<S, C, K>) -> Block<S, R, K> {
        let mut product = [[S::ZERO; K]; R];
        for (row, out) in self.0.iter().zip(product.iter_mut()) {
            for (k, entry) in out.iter_mut().enumerate() {
                for (x, other) in row.iter().zip(other.0.iter()) {
                    *entry += *x * other[k];
                }
            }
        }
        Block(product)
    }

    fn transposed(&self) -> Block<S, C, R> {
        Block(std::array::from_fn(|i| std::array::from_fn(|k| self.0[k][i])))
    }
}

#[differentiable]
fn blocks<S: Real>(x: S, y: S) -> S {
    let a = Block([[x, y, S::ONE], [x * y, S::TWO, y]]);
    let gram = a.times(&a.transposed());
    let tall = a.transposed().times(&gram);
    let Block([[p, q], [r, s], [t, _]]) = tall;
    p * q - r * s + t
}

#[test]
fn matrices_of_fixed_size() {
    check_generic!(blocks(x, y) at [0.3, -0.7], [1.2, 0.4]);
}
