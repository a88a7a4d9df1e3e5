use ad::differentiable;

#[differentiable]
fn f(mut x: f64, y: &mut f64) -> f64 {
    while x > 10.0 {
        x /= 2.0;
    }
    std::mem::swap(&mut x, y);
    println!("{x}");
    [x].map(|t| t * t)[0]
}

fn main() {
    let mut y = 2.0;
    f(1.0, &mut y);
}
