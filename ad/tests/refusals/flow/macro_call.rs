use ad::differentiable;

macro_rules! square {
    ($x:expr) => {
        $x * $x
    };
}

#[differentiable]
fn f(x: f64) -> f64 {
    println!("{x}");
    let y = square!(x);
    if matches!(y as i32, 3) { x } else { todo!() }
}

fn main() {
    f::grad(1.0);
}
