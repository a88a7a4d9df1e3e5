use ad::differentiable;

#[differentiable]
fn f(x: f64) -> f64 {
    let powers = vec![x, {
        #[cfg(all())]
        {
            x * x
        }
        #[cfg(not(all()))]
        {
            x
        }
    }];
    powers[0]
}

fn main() {
    f::grad(1.0);
}
