use ad::differentiable;

#[differentiable]
fn f(xs: [f64; 3]) -> f64 {
    let mut total = 0.0;
    for x in xs.iter().chain(&[1.0]) {
        total += x;
    }
    for (x, _) in xs.iter().filter(|x| **x > 0.0).zip(0..) {
        total += x;
    }
    let mut count = 0.0;
    let scaled = xs.iter().map(|x| x * 2.0);
    for x in scaled {
        count += x;
    }
    total += xs
        .iter()
        .map(|x| {
            count += x;
            x * count
        })
        .rev()
        .sum::<f64>();
    total + xs.iter().map(|x| x * 2.0).reduce(f64::max).unwrap()
}

#[differentiable]
fn greatest(xs: [f64; 3]) -> f64 {
    *xs.iter().max_by(|a, b| a.total_cmp(b)).unwrap()
}

fn main() {
    f::grad([1.0; 3]);
    greatest::grad([1.0; 3]);
}
