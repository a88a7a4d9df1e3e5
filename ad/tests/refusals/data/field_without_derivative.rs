use ad::Differentiable;

#[derive(Differentiable)]
struct Aged {
    age: std::time::Duration,
    size: f64,
}

fn main() {}
