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

fn main() {}
