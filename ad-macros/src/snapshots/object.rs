fn area(scale: f64, end: f64) -> f64 {
    integrate(|t: f64| (t * scale).sin(), 0.0, end)
}
