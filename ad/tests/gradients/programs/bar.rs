//! A bar of finite elements, solved by conjugate gradients.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

/// Geometry alone.
#[derive(Clone, Debug)]
struct Element {
    nodes: [usize; 2],
    length: f64,
}

#[derive(Clone, Debug, Differentiable)]
struct Material {
    young: f64,
    area: f64,
}

#[differentiable]
fn stiffness(element: &Material, length: f64) -> f64 {
    element.young * element.area / length
}

#[differentiable]
fn apply(#[constant] elements: &[Element], materials: &[Material], u: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; u.len()];
    for (element, material) in elements.iter().zip(materials) {
        let k = stiffness(material, element.length);
        let [i, j] = element.nodes;
        let force = k * (u[j] - u[i]);
        out[i] -= force;
        out[j] += force;
    }
    // The first node is held.
    out[0] = u[0];
    out
}

#[differentiable]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[differentiable]
fn solve(
    #[constant] elements: &[Element],
    materials: &[Material],
    load: &[f64],
    tolerance: f64,
) -> Result<Vec<f64>, String> {
    let mut u = vec![0.0; load.len()];
    let mut r = load.to_vec();
    let mut p = r.clone();
    let mut rr = dot(&r, &r);
    for _ in 0..4 * load.len() {
        if rr < tolerance {
            break;
        }
        let ap = apply(elements, materials, &p);
        let alpha = rr / dot(&p, &ap);
        for i in 0..u.len() {
            u[i] += alpha * p[i];
            r[i] -= alpha * ap[i];
        }
        let next = dot(&r, &r);
        let beta = next / rr;
        rr = next;
        for (pi, ri) in p.iter_mut().zip(&r) {
            *pi = *ri + beta * *pi;
        }
    }
    if rr >= tolerance {
        return Err(format!("no convergence after {} iterations", 4 * load.len()));
    }
    Ok(u)
}

#[differentiable]
fn compliance(young: f64, force: f64) -> f64 {
    let elements: Vec<Element> =
        (0..4).map(|i| Element { nodes: [i, i + 1], length: 0.5 + 0.1 * i as f64 }).collect();
    let mut materials = Vec::new();
    for i in 0..4 {
        materials
            .push(Material { young: young * (1.0 + 0.1 * i as f64), area: 1.0 + 0.05 * force });
    }
    let load = vec![0.0, 0.2, 0.0, 0.1, force];
    match solve(&elements, &materials, &load, 1e-24) {
        Ok(u) => dot(&u, &load),
        Err(_) => f64::NAN,
    }
}

#[test]
fn a_bar() {
    check!(compliance(young, force) at [2.0, 0.7], [1.2, -0.4]);
}
