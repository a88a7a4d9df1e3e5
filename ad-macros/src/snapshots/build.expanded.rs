impl build {
    pub fn vjp_onto(
        xs: [f64; 3],
        y: f64,
    ) -> (
        [f64; 3],
        impl ::core::ops::FnOnce(
            ::ad::Tangent<[f64; 3]>,
        ) -> (::ad::Tangent<[f64; 3]>, ::ad::Tangent<f64>) + use<>,
    ) {
        Self::vjp(xs, y)
    }
    pub fn vjp(
        xs: [f64; 3],
        y: f64,
    ) -> (
        [f64; 3],
        impl ::core::ops::FnOnce(
            ::ad::Tangent<[f64; 3]>,
        ) -> (::ad::Tangent<[f64; 3]>, ::ad::Tangent<f64>) + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let xs_space = ::ad::rt::space(&xs);
        let (value, tape) = ::ad::rt::record_like(
            &xs,
            |index: usize| {
                let item = xs[index];
                let product = item * y;
                (product, (index, item))
            },
        );
        (
            value,
            move |
                result_bar: ::ad::Tangent<[f64; 3]>,
            | -> (::ad::Tangent<[f64; 3]>, ::ad::Tangent<f64>) {
                let mut value_bar = result_bar;
                let mut xs_bar = xs_space.zero();
                let mut y_bar = -0.0_f64;
                for ((index, item), element_bar) in tape.into_iter().zip(value_bar).rev()
                {
                    let mut product_bar = element_bar;
                    let mut item_bar = ::ad::rt::scale(product_bar, y);
                    y_bar += ::ad::rt::scale(product_bar, item);
                    xs_bar[index] += item_bar;
                }
                (xs_bar, y_bar)
            },
        )
    }
}
