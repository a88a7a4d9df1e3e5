fn valley<Element: Real, const N: usize>(x: &[Element; N]) -> Element {
    let mut sum = Element::ZERO;
    for i in 0..N - 1 {
        let a = Element::ONE - x[i];
        let b = x[i + 1] - x[i] * x[i];
        sum += a * a + Element::from_f64(100.0) * b * b;
    }
    sum
}
