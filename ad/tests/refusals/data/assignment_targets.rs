use ad::differentiable;

#[differentiable]
fn f(x: f64, y: f64) -> f64 {
    let (mut a, mut b) = (x, y);
    (a, b) = (b, a);
    let c;
    'outer: loop {
        loop {
            c = a * b;
            break 'outer;
        }
    }
    let part = [a, b, c];
    part[1]
}

#[differentiable]
fn in_an_index(xs: &[f64]) -> f64 {
    let mut k = 0;
    xs[{
        k = 1;
        k
    }]
}

fn main() {
    f::grad(1.0, 2.0);
}
