fn f(x: f64, y: f64) -> f64 {
    let p = x * y;
    p.sin() + p
}
