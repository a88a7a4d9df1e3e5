impl area {
    pub fn jvp(
        scale: f64,
        end: f64,
        scale_dot: ::ad::Tangent<f64>,
        end_dot: ::ad::Tangent<f64>,
    ) -> (f64, ::ad::Tangent<f64>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        ::ad::rt::without_forward_mode()
    }
}
