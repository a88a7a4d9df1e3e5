use ad::{Differentiable, differentiable};

#[derive(Clone, Default)]
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
fn in_retain(x: &[f64]) -> f64 {
    #[constant]
    let mut best = Best::default();
    let mut v = x.to_vec();
    v.retain(|e| best.improves(*e));
    v[0] * best.energy
}

#[differentiable]
fn in_a_key(#[constant] best: &mut Best, x: &[f64]) -> f64 {
    let mut v = x.to_vec();
    v.sort_by_key(|e| best.improves(*e));
    v[0] * best.energy
}

#[differentiable]
fn of_a_reference(x: &[f64]) -> f64 {
    #[constant]
    let mut best = Best::default();
    let least = x.iter().min_by_key(|e| best.improves(**e)).unwrap();
    least * best.energy
}

#[differentiable]
fn of_a_value(x: &[f64]) -> f64 {
    #[constant]
    let mut least = 0.0;
    let found = x.iter().copied().min_by(|a, b| {
        least = *a;
        a.total_cmp(b)
    });
    least * found.unwrap_or(0.0)
}

#[differentiable]
fn by_a_closure(x: &[f64]) -> f64 {
    #[constant]
    let mut best = Best::default();
    let compare = |a: &f64, b: &f64| {
        best.improves(*a);
        a.total_cmp(b)
    };
    x.iter().copied().max_by(compare).unwrap_or(0.0) * x[0]
}

fn any(x: &[f64], mut f: impl FnMut(f64) -> bool) -> bool {
    x.iter().any(|x| f(*x))
}

#[differentiable]
fn given_to_a_function(x: &[f64]) -> f64 {
    #[constant]
    let mut best = Best::default();
    if any(x, |e| best.improves(e)) { x[0] * best.energy } else { x[0] }
}

#[derive(Clone, Copy, PartialEq, PartialOrd, Differentiable)]
struct Cell {
    x: f64,
    #[constant]
    index: usize,
}

#[differentiable]
fn unstable_by_a_key(cells: &[Cell]) -> f64 {
    let mut cells = cells.to_vec();
    cells.sort_unstable_by_key(|cell| cell.index);
    cells[0].x
}

#[differentiable]
fn unstable_by_a_part(x: &[f64]) -> f64 {
    let mut v = x.to_vec();
    v.sort_unstable_by(|a, b| a.abs().total_cmp(&b.abs()));
    v[0]
}

#[differentiable]
fn unstable_of_what_is_no_number(cells: &[Cell]) -> f64 {
    let mut cells = cells.to_vec();
    cells.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap());
    cells[0].x
}

fn main() {}
