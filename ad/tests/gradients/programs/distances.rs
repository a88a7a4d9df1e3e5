//! Spheres traced along distance fields, which are passed as closures.

use ad::{Differentiable, differentiable};
use glam::DVec3 as V;

#[differentiable]
trait Sdf {
    fn distance(&self, p: V) -> f64;
}

#[derive(Clone, Differentiable)]
struct Sphere {
    center: V,
    radius: f64,
}
#[derive(Clone, Differentiable)]
struct Plane {
    height: f64,
}
#[derive(Clone, Differentiable)]
struct Union<A, B> {
    a: A,
    b: B,
}

#[differentiable]
impl Sdf for Sphere {
    fn distance(&self, p: V) -> f64 {
        (p - self.center).length() - self.radius
    }
}
#[differentiable]
impl Sdf for Plane {
    fn distance(&self, p: V) -> f64 {
        p.y - self.height
    }
}
#[differentiable]
impl<A: Sdf + Differentiable, B: Sdf + Differentiable> Sdf for Union<A, B> {
    fn distance(&self, p: V) -> f64 {
        self.a.distance(p).min(self.b.distance(p))
    }
}

#[differentiable]
fn march<F>(sdf: F, origin: V, dir: V) -> Option<f64>
where
    F: Fn(V) -> f64,
{
    let mut t = 0.0;
    for _ in 0..128 {
        let p = origin + dir * t;
        let d = sdf(p);
        if d < 1e-9 {
            return Some(t);
        }
        t += d;
        if t > 100.0 {
            break;
        }
    }
    None
}

#[differentiable]
fn normal(sdf: &impl Fn(V) -> f64, p: V) -> V {
    let e = 1e-4;
    let [dx, dy, dz] = [V::X, V::Y, V::Z].map(|axis| sdf(p + axis * e) - sdf(p - axis * e));
    V::new(dx, dy, dz).normalize()
}

#[differentiable]
fn shade(radius: f64, height: f64) -> f64 {
    let scene = Union { a: Sphere { center: V::new(0.0, 0.2, 3.0), radius }, b: Plane { height } };
    let sdf = |p: V| scene.distance(p) + 0.01 * (p.x * 3.0).sin();
    let eye = V::ZERO;
    let mut image = Vec::with_capacity(4);
    for (px, py) in [(0.0, 0.0), (0.1, 0.05), (0.0, -0.4), (-0.2, 0.1)] {
        let dir = V::new(px, py, 1.0).normalize();
        let Some(t) = march(&sdf, eye, dir) else {
            image.push(0.0);
            continue;
        };
        let p = eye + t * dir;
        let n = normal(&sdf, p);
        let light = V::new(0.3, 1.0, -0.5).normalize();
        image.push(n.dot(light).max(0.0));
    }
    image.iter().sum()
}

#[test]
fn distances() {
    use crate::oracle::check;

    check!(shade(radius, height) at [0.7, -0.5], [0.5, -0.8]);
}
