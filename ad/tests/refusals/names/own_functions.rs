use ad::differentiable;

mod own {
    pub fn stop_gradient(x: f64) -> f64 {
        x * x
    }

    pub fn no_diff<F: Fn() -> f64>(f: F) -> f64 {
        f() + 1.0
    }

    pub mod mem {
        pub fn replace(a: &mut f64, b: f64) -> f64 {
            *a += b;
            b
        }
    }

    pub mod iter {
        pub fn once<T>(x: T) -> Vec<T> {
            vec![x]
        }
    }

    pub mod array {
        pub fn from_fn<F: Fn(usize) -> f64>(f: F) -> [f64; 2] {
            [f(1), f(0)]
        }
    }
}

#[differentiable]
fn repeats(x: f64) -> f64 {
    let mut sum = 0.0;
    for y in own::iter::once(x) {
        sum += y;
    }
    sum
}

#[differentiable]
fn stops(x: f64) -> f64 {
    own::stop_gradient(x) * x
}

#[differentiable]
fn stops_in_a_cast(x: f64) -> f64 {
    let k = own::stop_gradient(x) as usize;
    x * k as f64
}

#[differentiable]
fn excludes(x: f64) -> f64 {
    own::no_diff(|| 2.0) * x
}

#[differentiable]
fn replaces(x: f64) -> f64 {
    let mut a = x;
    own::mem::replace(&mut a, x * x) * a
}

#[differentiable]
fn builds(x: f64) -> f64 {
    let a = own::array::from_fn(|i| x * i as f64);
    a[0]
}

#[differentiable]
fn outside(x: f64) -> f64 {
    x * x
}

#[differentiable]
fn declares(x: f64) -> f64 {
    fn outside(x: f64) -> f64 {
        x * x * x
    }
    outside(x)
}

fn main() {}
