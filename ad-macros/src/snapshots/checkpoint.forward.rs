impl checkpoint {
    pub fn jvp(
        rate: f64,
        start: f64,
        n: usize,
        rate_dot: ::ad::Tangent<f64>,
        start_dot: ::ad::Tangent<f64>,
        n_dot: ::ad::Tangent<usize>,
    ) -> (f64, ::ad::Tangent<f64>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let mut x = start;
        let mut x_dot = start_dot;
        for _ in 0..n {
            let receiver = x;
            let receiver_dot = x_dot;
            let (sin, sin_dot) = receiver.sin_jvp(::ad::rt::pass(&receiver_dot));
            let (product, product_dot) = ::ad::rules::MulPullback::mul_jvp(
                rate,
                sin,
                rate_dot,
                sin_dot,
            );
            let x_1 = x;
            let x_1_dot = x_dot;
            x_dot = ::ad::rules::AddAssignPullback::add_assign_jvp(
                x_1,
                product,
                x_1_dot,
                product_dot,
            );
            x += product;
        }
        let x_2 = x;
        let x_2_dot = x_dot;
        (x_2, x_2_dot)
    }
}
