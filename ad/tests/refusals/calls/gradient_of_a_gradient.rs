use ad::differentiable;

#[differentiable]
fn square(x: f64) -> f64 {
    x * x
}

#[differentiable]
fn of_grad(x: f64) -> f64 {
    square::grad(x) * x
}

#[differentiable]
fn of_value_and_grad(x: f64) -> f64 {
    square::value_and_grad(x).1
}

#[differentiable]
fn of_vjp(x: f64) -> f64 {
    let (value, _) = square::vjp(x);
    value
}

#[differentiable]
fn of_jvp(x: f64) -> f64 {
    square::jvp(x, 1.0).1
}

#[derive(ad::Differentiable)]
#[constant]
struct Unit;

#[differentiable]
impl Unit {
    fn of_method(&self, x: f64) -> f64 {
        self.cube_value_and_grad(x).0
    }

    fn cube(&self, x: f64) -> f64 {
        x * x * x
    }
}

fn main() {}
