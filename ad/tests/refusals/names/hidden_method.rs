use ad::{Differentiable, differentiable};

#[differentiable]
trait Potential {
    fn energy(&self, x: f64) -> f64;
    fn of(stiffness: f64) -> Self;
    fn force(&self, x: f64) -> f64 {
        x
    }
}

#[derive(Clone, Copy, Differentiable)]
struct Spring {
    stiffness: f64,
}

#[differentiable]
impl Potential for Spring {
    fn energy(&self, x: f64) -> f64 {
        self.stiffness * x * x
    }

    fn of(stiffness: f64) -> Self {
        Self { stiffness }
    }
}

impl Spring {
    fn energy(&self, x: f64) -> f64 {
        self.stiffness * x
    }

    fn of(stiffness: f64) -> Self {
        Self { stiffness: 2.0 * stiffness }
    }
}

#[differentiable]
fn f(spring: Spring, x: f64) -> f64 {
    spring.energy(x) + Spring::of(x).stiffness
}

fn main() {
    f::grad(Spring { stiffness: 1.0 }, 1.0);
}
