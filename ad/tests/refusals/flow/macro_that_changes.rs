use ad::differentiable;

macro_rules! grown {
    ($x:expr) => {{
        $x += 1.0;
        $x > 2.0
    }};
}

#[differentiable]
fn f(mut x: f64) -> f64 {
    if grown!(x) { x * x } else { x }
}

fn main() {
    f::grad(1.0);
}
