use ad::{Differentiable, differentiable};

#[differentiable]
trait Next {
    fn next_up(self) -> f64;
    fn twice(self) -> f64;
}

#[differentiable]
impl Next for f64 {
    fn next_up(self) -> f64 {
        2.0 * self
    }

    fn twice(self) -> f64 {
        2.0 * self
    }
}

#[differentiable]
trait Insert {
    fn insert(&mut self, value: f64);
}

#[differentiable]
impl Insert for Option<f64> {
    fn insert(&mut self, value: f64) {
        *self = Some(2.0 * value);
    }
}

#[derive(Clone, Differentiable)]
struct Width {
    value: f64,
}

#[differentiable]
impl Width {
    fn of_both(&self) -> f64 {
        self.value
    }

    fn grown(&mut self) -> f64 {
        self.value *= 2.0;
        self.value
    }

    fn alike(&self, x: f64) -> f64 {
        self.value * x
    }
}

#[differentiable]
trait Measure {
    fn of_both(self) -> f64;
    fn grown(&self) -> f64;
    fn alike(&self, x: f64) -> f64;
}

#[differentiable]
impl Measure for Width {
    fn of_both(self) -> f64 {
        2.0 * self.value
    }

    fn grown(&self) -> f64 {
        3.0 * self.value
    }

    fn alike(&self, x: f64) -> f64 {
        self.value + x
    }
}

fn main() {}
