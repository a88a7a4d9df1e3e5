use ad::differentiable;
use glam::DVec3;

trait Coordinates {
    fn x(&self) -> f64;
    fn y(self) -> f64;
}

impl Coordinates for DVec3 {
    fn x(&self) -> f64 {
        self.x * 100.0
    }

    fn y(self) -> f64 {
        self.y * 100.0
    }
}

#[differentiable]
fn f(v: DVec3) -> f64 {
    v.x() + v.y()
}

fn main() {
    f::grad(DVec3::ONE);
}
