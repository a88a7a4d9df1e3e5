fn softened(x: f32, limit: f32) -> f32 {
    if x > limit {
        return limit + (x - limit).ln_1p();
    }
    x
}
