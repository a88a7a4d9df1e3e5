use ad::differentiable;

const N: usize = 2;

#[differentiable]
fn f(x: f64) -> f64 {
    let outer = [x; N];
    {
        const N: usize = 3;
        let inner = [x; N];
        outer[1] * inner[2]
    }
}

fn main() {}
