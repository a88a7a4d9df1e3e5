use ad::differentiable;

#[differentiable]
fn outside(x: f64) -> f64 {
    x * x
}

mod plain {
    pub fn outside(x: f64) -> f64 {
        x * x * x
    }
}

#[differentiable]
fn imports(x: f64) -> f64 {
    use plain::outside;
    outside(x)
}

fn main() {
    outside(1.0);
}
