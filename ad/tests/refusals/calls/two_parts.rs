use ad::differentiable;

#[differentiable]
fn relax(left: &mut [f64], right: &mut [f64]) {
    left[0] += right[0];
}

#[differentiable]
fn halves(v: &mut [f64]) {
    let (left, right) = v.split_at_mut(1);
    relax(left, right);
}

#[differentiable]
fn ends(v: &mut [f64]) {
    if let [first, .., last] = v {
        std::mem::swap(first, last);
    }
}

#[differentiable]
fn of_an_element(v: &mut Vec<(f64, f64)>) {
    let (a, b) = &mut v[0];
    std::mem::swap(a, b);
}

fn main() {}
