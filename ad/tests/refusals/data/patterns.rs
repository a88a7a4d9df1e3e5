use ad::differentiable;

#[differentiable]
fn f(x: (f64, f64, f64), mut y: Option<f64>) -> f64 {
    let (.., c) = x;
    let ([a, _] | [_, a]) = [c, c];
    let (d, [[e, .., g], _]) = (c, [[c; 3]; 2]);
    match y {
        Some(ref mut b) => *b * c * a * d * e * g,
        _ => 0.0,
    }
}

fn main() {
    f::grad((1.0, 2.0, 3.0), None);
}
