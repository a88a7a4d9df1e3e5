impl valley {
    pub fn jvp<Element: Real, const N: usize>(
        x: &[Element; N],
        x_dot: &::ad::Tangent<[Element; N]>,
    ) -> (Element, ::ad::Tangent<Element>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let mut sum = Element::ZERO;
        let mut sum_dot = ::ad::rt::zero_like(&sum);
        for i in 0..N - 1 {
            let index = i;
            let x_1 = x[index];
            let x_1_dot = x_dot[index];
            let constant = Element::ONE;
            let a = constant - x_1;
            let a_dot = -x_1_dot;
            let index_1 = i + 1;
            let x_2 = x[index_1];
            let x_2_dot = x_dot[index_1];
            let index_2 = i;
            let x_3 = x[index_2];
            let x_3_dot = x_dot[index_2];
            let index_3 = i;
            let x_4 = x[index_3];
            let x_4_dot = x_dot[index_3];
            let (product, product_dot) = ::ad::rules::MulPullback::mul_jvp(
                x_3,
                x_4,
                x_3_dot,
                x_4_dot,
            );
            let b = x_2 - product;
            let b_dot = x_2_dot - product_dot;
            let (product_1, product_1_dot) = ::ad::rules::MulPullback::mul_jvp(
                a,
                a,
                a_dot,
                a_dot,
            );
            let constant_1 = Element::from_f64(100.0);
            let product_2 = constant_1 * b;
            let product_2_dot = constant_1 * b_dot;
            let (product_3, product_3_dot) = ::ad::rules::MulPullback::mul_jvp(
                product_2,
                b,
                product_2_dot,
                b_dot,
            );
            let sum_1 = product_1 + product_3;
            let sum_1_dot = product_1_dot + product_3_dot;
            let sum_2 = sum;
            let sum_2_dot = sum_dot;
            sum_dot = ::ad::rules::AddAssignPullback::add_assign_jvp(
                sum_2,
                sum_1,
                sum_2_dot,
                sum_1_dot,
            );
            sum += sum_1;
        }
        let sum_3 = sum;
        let sum_3_dot = sum_dot;
        (sum_3, sum_3_dot)
    }
}
