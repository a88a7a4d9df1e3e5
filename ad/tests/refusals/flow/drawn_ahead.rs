use ad::differentiable;

#[differentiable]
fn next_behind_a_filter(x: &[f64]) -> f64 {
    let indices = [3_usize, 1, 0, 2];
    let mut left = indices.iter();
    let even = left.by_ref().skip_while(|index| **index % 2 == 1).next().unwrap();
    x[*even] * x[*left.next().unwrap()]
}

#[differentiable]
fn found(x: &[f64]) -> f64 {
    let indices = [3_usize, 1, 0, 2];
    let mut left = indices.iter();
    let mut sum = 0.0;
    for index in left.by_ref().skip(1).filter(|index| **index > 0).take(2) {
        sum += x[*index];
    }
    sum * x[*left.next().unwrap()]
}

fn main() {}
