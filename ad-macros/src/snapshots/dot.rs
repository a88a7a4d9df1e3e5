fn dot(xs: &[f64; 8], ys: &[f64; 8]) -> f64 {
    xs.iter().zip(ys).map(|(x, y)| x * y).sum()
}
