use ad::differentiable;

mod f64 {
    #[ad::differentiable]
    pub fn sqrt(x: std::primitive::f64) -> std::primitive::f64 {
        x * x
    }
}

#[differentiable]
fn f(x: std::primitive::f64) -> std::primitive::f64 {
    f64::sqrt(x)
}

fn main() {
    f::grad(2.0);
}
