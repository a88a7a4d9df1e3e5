use ad::differentiable;

trait Potential {
    fn energy(&self, x: f64) -> f64;
}

#[differentiable]
fn doubled(xs: &[f64]) -> Box<dyn Iterator<Item = f64> + '_> {
    Box::new(xs.iter().map(|x| 2.0 * x))
}

#[differentiable]
fn total(potentials: &[Box<dyn Potential>], x: f64) -> f64 {
    potentials.iter().map(|potential| potential.energy(x)).sum()
}

#[differentiable]
fn chosen<'a>(xs: &'a [f64], fs: Vec<fn(f64) -> f64>) -> Option<impl Iterator<Item = f64> + use<'a>> {
    fs.first().copied().map(|f| xs.iter().map(move |x| f(*x)))
}

fn main() {
    total(&[], doubled(&[1.0]).sum());
    let _ = chosen(&[], Vec::new());
}
