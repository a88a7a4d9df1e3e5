use ad::Differentiable;

#[derive(Differentiable)]
struct Named {
    name: String,
    size: f64,
}

fn main() {}
