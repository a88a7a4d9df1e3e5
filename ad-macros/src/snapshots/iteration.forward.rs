impl newton {
    pub fn jvp(a: f64, a_dot: ::ad::Tangent<f64>) -> (f64, ::ad::Tangent<f64>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let mut x = a;
        let mut x_dot = a_dot;
        for _ in 0..5 {
            let x_1 = x;
            let x_1_dot = x_dot;
            let x_2 = x;
            let x_2_dot = x_dot;
            let (quotient, quotient_dot) = ::ad::rules::DivPullback::div_jvp(
                a,
                x_2,
                a_dot,
                x_2_dot,
            );
            let sum = x_1 + quotient;
            let sum_dot = x_1_dot + quotient_dot;
            let constant = 0.5;
            let product = constant * sum;
            let product_dot = constant * sum_dot;
            x = product;
            x_dot = product_dot;
        }
        let x_3 = x;
        let x_3_dot = x_dot;
        (x_3, x_3_dot)
    }
}
