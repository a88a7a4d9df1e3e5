fn roughness(x: &[f64; 100]) -> f64 {
    let mut sum = 0.0;
    for i in 1..100 {
        let step = x[i] - x[i - 1];
        if step > 0.5 {
            sum += step;
        } else {
            sum += step * step;
        }
    }
    sum
}
