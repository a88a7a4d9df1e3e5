fn checkpoint(rate: f64, start: f64, n: usize) -> f64 {
    let mut x = start;
    #[differentiable(checkpoint)]
    for _ in 0..n {
        x += rate * x.sin();
    }
    x
}
