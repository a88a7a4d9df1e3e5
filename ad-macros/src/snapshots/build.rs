fn build(xs: [f64; 3], y: f64) -> [f64; 3] {
    xs.map(|x| x * y)
}
