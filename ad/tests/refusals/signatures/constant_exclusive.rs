use ad::differentiable;

#[differentiable]
fn f(x: f64, #[constant] scratch: &mut f64) -> f64 {
    *scratch = x;
    *scratch * x
}

struct Counter {
    calls: f64,
}

#[differentiable]
impl Counter {
    fn next(#[constant] &mut self, x: f64) -> f64 {
        self.calls += 1.0;
        x * self.calls
    }
}

fn main() {}
