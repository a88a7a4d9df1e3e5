use ad::differentiable;

trait Fancy {
    fn sin(self) -> f64;
}

impl Fancy for f64 {
    fn sin(self) -> f64 {
        self * 3.0
    }
}

#[differentiable]
fn of_another_trait(x: f64) -> f64 {
    <f64 as Fancy>::sin(x)
}

mod real {
    pub trait Real {
        fn sin(self) -> f64;
    }

    impl Real for f64 {
        fn sin(self) -> f64 {
            self * 3.0
        }
    }
}

#[differentiable]
fn of_a_trait_of_that_name(x: f64) -> f64 {
    use real::Real;
    <f64 as Real>::sin(x)
}

fn main() {}
