use ad::differentiable;

#[differentiable]
fn f(x: glam::DVec3, y: glam::DVec3) -> glam::DVec3 {
    let a = x & y;
    a * x
}

fn main() {
    f::grad(1.0, 2.0);
}
