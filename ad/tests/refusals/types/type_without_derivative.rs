use ad::differentiable;

#[derive(Clone, Copy)]
struct Disc {
    radius: f64,
}

#[differentiable]
fn f(disc: Disc) -> f64 {
    disc.radius * disc.radius
}

fn main() {
    f::grad(Disc { radius: 1.0 });
}
