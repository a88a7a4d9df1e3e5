use ad::differentiable;

/// What has a derivative is stored in a constant parameter.
#[differentiable]
fn stored(x: f64, #[constant] scratch: &mut f64) -> f64 {
    *scratch = x;
    *scratch * x
}

struct Counter {
    calls: f64,
}

#[differentiable]
impl Counter {
    fn next(#[constant] &mut self, x: f64) -> f64 {
        self.calls += x;
        x * self.calls
    }
}

#[differentiable]
fn set(place: &mut f64, x: f64) {
    *place = x;
}

/// A function stores it there.
#[differentiable]
fn passed_on(x: f64, #[constant] scratch: &mut f64) -> f64 {
    set(scratch, x);
    *scratch * x
}

/// A method does.
#[differentiable]
fn pushed(x: f64) -> f64 {
    #[constant]
    let mut numbers = vec![1.0];
    numbers.push(x);
    numbers[1] * x
}

/// Behind a name of its own.
#[differentiable]
fn named(x: f64) -> f64 {
    let mut numbers = vec![1.0];
    let slice = numbers.as_mut_slice();
    slice.fill(x);
    numbers[0] * x
}

/// What has a derivative is taken for a constant.
#[differentiable]
fn marked(x: f64) -> f64 {
    let mut numbers = [x; 2];
    #[constant]
    let lent = &mut numbers;
    lent[0] = 1.0;
    numbers[1] * x
}

fn main() {}
