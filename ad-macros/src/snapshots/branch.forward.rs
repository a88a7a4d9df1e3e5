impl softened {
    pub fn jvp(
        x: f32,
        limit: f32,
        x_dot: ::ad::Tangent<f32>,
        limit_dot: ::ad::Tangent<f32>,
    ) -> (f32, ::ad::Tangent<f32>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        trait ln_1p_derivatives {
            fn ln_1p_vjp(&mut self) {}
            fn ln_1p_jvp(&mut self) {}
        }
        impl<
            T: ?::core::marker::Sized + ::ad::rt::MethodWithDerivative,
        > ln_1p_derivatives for T {}
        let (value, value_dot) = if x > limit {
            let receiver = x - limit;
            let receiver_dot = x_dot - limit_dot;
            let (ln_1p, ln_1p_dot) = receiver.ln_1p_jvp(::ad::rt::pass(&receiver_dot));
            let sum = limit + ln_1p;
            let sum_dot = limit_dot + ln_1p_dot;
            (sum, sum_dot)
        } else {
            (x, x_dot)
        };
        (value, value_dot)
    }
}
