impl search {
    pub fn jvp(
        x: f64,
        step: f64,
        x_dot: ::ad::Tangent<f64>,
        step_dot: ::ad::Tangent<f64>,
    ) -> (f64, ::ad::Tangent<f64>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let mut a = x;
        let mut a_dot = x_dot;
        let mut i = 0;
        while i < 100 {
            i += 1;
            let a_1 = a;
            let a_1_dot = a_dot;
            let (product, product_dot) = ::ad::rules::MulPullback::mul_jvp(
                a_1,
                step,
                a_1_dot,
                step_dot,
            );
            let sum = product + x;
            let sum_dot = product_dot + x_dot;
            a = sum;
            a_dot = sum_dot;
            let value = if a > 10.0 {
                ::core::ops::ControlFlow::Break(())
            } else {
                ::core::ops::ControlFlow::Continue(())
            };
            if ::core::ops::ControlFlow::<_, ()>::is_break(&value) {
                break;
            }
        }
        let a_2 = a;
        let a_2_dot = a_dot;
        let (product_1, product_1_dot) = ::ad::rules::MulPullback::mul_jvp(
            a_2,
            step,
            a_2_dot,
            step_dot,
        );
        (product_1, product_1_dot)
    }
}
