fn valley<S: Real, const N: usize>(x: &[S; N]) -> S {
    let mut sum = S::ZERO;
    for i in 0..N - 1 {
        let a = S::ONE - x[i];
        let b = x[i + 1] - x[i] * x[i];
        sum += a * a + S::from_f64(100.0) * b * b;
    }
    sum
}
