use ad::Differentiable;

#[derive(Differentiable)]
enum Shape {
    Disc(f64),
    Square(f64),
}

fn main() {}
