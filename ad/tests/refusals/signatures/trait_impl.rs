use ad::{Differentiable, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Disc {
    radius: f64,
}

#[differentiable]
trait Area {
    fn area(&self) -> f64 {
        1.0
    }
}

impl Area for Disc {
    fn area(&self) -> f64 {
        self.radius * self.radius
    }
}

#[differentiable]
impl std::ops::Neg for Disc {
    type Output = Disc;

    fn neg(self) -> Disc {
        Disc { radius: -self.radius }
    }
}

#[differentiable]
impl Area for [f64] {
    fn area(&self) -> f64 {
        self[0] * self[1]
    }
}

fn main() {}
