impl build {
    pub fn jvp(
        xs: [f64; 3],
        y: f64,
        xs_dot: ::ad::Tangent<[f64; 3]>,
        y_dot: ::ad::Tangent<f64>,
    ) -> ([f64; 3], ::ad::Tangent<[f64; 3]>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let (value, value_dot) = ::ad::rt::record_like(
            &xs,
            |index: usize| {
                let item = xs[index];
                let item_dot = xs_dot[index];
                let (product, product_dot) = ::ad::rules::MulPullback::mul_jvp(
                    item,
                    y,
                    item_dot,
                    y_dot,
                );
                (product, product_dot)
            },
        );
        (value, value_dot)
    }
}
