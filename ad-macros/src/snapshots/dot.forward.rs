impl dot {
    pub fn jvp(
        xs: &[f64; 8],
        ys: &[f64; 8],
        xs_dot: &::ad::Tangent<[f64; 8]>,
        ys_dot: &::ad::Tangent<[f64; 8]>,
    ) -> (f64, ::ad::Tangent<f64>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let mut total = ::ad::rt::empty_sum::<f64>();
        let mut total_dot = ::ad::rt::zero_like(&total);
        for index in 0..xs.len().min(ys.len()) {
            let x = xs[index];
            let x_dot = xs_dot[index];
            let y = ys[index];
            let y_dot = ys_dot[index];
            let (product, product_dot) = ::ad::rules::MulPullback::mul_jvp(
                x,
                y,
                x_dot,
                y_dot,
            );
            let partial = total;
            let partial_dot = total_dot;
            let (total_1, total_1_dot) = ::ad::rules::AddPullback::add_jvp(
                partial,
                product,
                partial_dot,
                product_dot,
            );
            total = total_1;
            total_dot = total_1_dot;
        }
        let total_2 = total;
        let total_2_dot = total_dot;
        (total_2, total_2_dot)
    }
}
