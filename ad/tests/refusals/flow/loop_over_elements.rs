use ad::differentiable;

#[differentiable]
fn f(x: [f64; 3]) -> f64 {
    let mut sum = 0.0;
    for element in x {
        sum += element;
    }
    sum
}

fn main() {
    f::grad([1.0; 3]);
}
