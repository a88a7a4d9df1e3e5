fn size(shape: &Shape, by: f64) -> Result<f64, Failure> {
    match shape {
        Shape::Disc(radius) => Ok(radius + by),
        Shape::Box { width, height } => Ok(bounded(width + height)? - by),
        Shape::Point => Err(Failure::Empty),
    }
}
