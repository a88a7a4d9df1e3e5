impl roughness {
    pub fn jvp(
        x: &[f64; 100],
        x_dot: &::ad::Tangent<[f64; 100]>,
    ) -> (f64, ::ad::Tangent<f64>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let mut sum: f64 = 0.0;
        let mut sum_dot = ::ad::rt::zero_like(&sum);
        for i in 1..100 {
            let index = i;
            let x_1 = x[index];
            let x_1_dot = x_dot[index];
            let index_1 = i - 1;
            let x_2 = x[index_1];
            let x_2_dot = x_dot[index_1];
            let step = x_1 - x_2;
            let step_dot = x_1_dot - x_2_dot;
            let value = if step > 0.5 {
                let sum_1 = sum;
                let sum_1_dot = sum_dot;
                sum_dot = ::ad::rules::AddAssignPullback::add_assign_jvp(
                    sum_1,
                    step,
                    sum_1_dot,
                    step_dot,
                );
                sum += step;
                ()
            } else {
                let (product, product_dot) = ::ad::rules::MulPullback::mul_jvp(
                    step,
                    step,
                    step_dot,
                    step_dot,
                );
                let sum_2 = sum;
                let sum_2_dot = sum_dot;
                sum_dot = ::ad::rules::AddAssignPullback::add_assign_jvp(
                    sum_2,
                    product,
                    sum_2_dot,
                    product_dot,
                );
                sum += product;
                ()
            };
        }
        let sum_3 = sum;
        let sum_3_dot = sum_dot;
        (sum_3, sum_3_dot)
    }
}
