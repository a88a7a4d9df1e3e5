use ad::differentiable;
use glam::DVec3;

#[differentiable]
pub fn f(x: DVec3, y: DVec3) -> DVec3 {
    let a = x & y;
    a * x
}

fn main() {}
