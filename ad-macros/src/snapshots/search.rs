fn search(x: f64, step: f64) -> f64 {
    let mut a = x;
    let mut i = 0;
    while i < 100 {
        i += 1;
        a = a * step + x;
        if a > 10.0 {
            break;
        }
    }
    a * step
}
