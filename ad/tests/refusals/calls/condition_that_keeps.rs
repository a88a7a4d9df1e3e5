use ad::{Differentiable, differentiable};

#[derive(Default, Differentiable)]
struct History {
    energies: Vec<f64>,
}

#[differentiable]
impl History {
    fn record(&mut self, energy: f64) -> bool {
        self.energies.push(energy);
        self.energies.len() < 100
    }
}

#[differentiable]
fn in_an_assertion(p: &[f64]) -> f64 {
    let mut history = History::default();
    for x in p {
        assert!(history.record(x * x), "full");
    }
    history.energies.iter().sum()
}

#[differentiable]
fn in_a_guard(p: &[f64]) -> f64 {
    let mut history = History::default();
    let mut count = 0;
    for x in p {
        match *x {
            y if history.record(y * y) => count += 1,
            _ => {}
        }
    }
    history.energies[0] * count as f64
}

fn normalise(v: &mut [f64], k: f64) -> bool {
    v[0] *= k;
    v[0] > 0.0
}

#[differentiable]
fn by_a_slice(x: f64) -> f64 {
    let mut v = vec![1.0, 2.0];
    if normalise(v.as_mut_slice(), x) { v[0] * v[1] } else { 0.0 }
}

struct Best {
    energy: f64,
}

impl Best {
    fn improves(&mut self, energy: f64) -> bool {
        let improves = energy < self.energy;
        self.energy = self.energy.min(energy);
        improves
    }
}

#[differentiable]
fn in_a_constant(#[constant] best: &mut Best, p: &[f64]) -> f64 {
    for x in p {
        if !best.improves(x * x) {
            break;
        }
    }
    best.energy * p[0]
}

#[differentiable]
fn in_a_constant_in_a_closure(p: &[f64]) -> f64 {
    #[constant]
    let mut best = Best { energy: 9.0 };
    if p.iter().any(|x| best.improves(*x)) { best.energy * p[0] } else { p[0] }
}

fn pushed(v: &mut Vec<f64>, x: f64) -> usize {
    v.push(x);
    v.len()
}

#[differentiable]
fn in_a_constant_by_name(#[constant] v: &mut Vec<f64>, x: f64) -> f64 {
    if pushed(v, x) > 1 { v[0] * x } else { x }
}

#[differentiable]
fn in_a_comparison(p: &[f64]) -> f64 {
    let mut sum = 0.0;
    let greatest = p.iter().copied().max_by(|a, b| {
        sum += *a;
        a.total_cmp(b)
    });
    sum * greatest.unwrap_or(0.0)
}

fn main() {}
