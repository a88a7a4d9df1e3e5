use ad::differentiable;

#[differentiable]
fn f(mut x: f64, y: &mut f64) -> f64 {
    for t in [1.0].iter().cycle() {
        x /= t;
    }
    std::mem::swap(&mut x, y);
    let line = line!();
    let later = async { line };
    [x].map(|t| t * t)[0]
}

fn main() {
    let mut y = 2.0;
    f(1.0, &mut y);
}
