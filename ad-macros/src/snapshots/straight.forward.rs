impl f {
    pub fn jvp(
        x: f64,
        y: f64,
        x_dot: ::ad::Tangent<f64>,
        y_dot: ::ad::Tangent<f64>,
    ) -> (f64, ::ad::Tangent<f64>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let (p, p_dot) = ::ad::rules::MulPullback::mul_jvp(x, y, x_dot, y_dot);
        let (sin, sin_dot) = p.sin_jvp(p_dot);
        let sum = sin + p;
        let sum_dot = sin_dot + p_dot;
        (sum, sum_dot)
    }
}
