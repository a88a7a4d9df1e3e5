use ad::{Differentiable, Real, differentiable};

#[derive(Clone, Copy, Differentiable)]
struct Disc<S: Real> {
    radius: S,
}

/// The attribute on the method does not see the parameters of the block: it goes on the block.
impl<S: Real> Disc<S> {
    #[differentiable]
    fn area(&self) -> S {
        self.radius * self.radius
    }
}

fn main() {}
