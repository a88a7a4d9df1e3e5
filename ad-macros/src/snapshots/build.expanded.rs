impl build {
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
        let y_space = ::ad::rt::space(&y);
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
                let mut y_bar = y_space.zero();
                for ((index, item), element_bar) in tape.into_iter().zip(value_bar).rev()
                {
                    let mut product_bar = element_bar;
                    let (mut item_bar, y_part) = ::ad::rules::MulPullback::mul_pullback(
                        item,
                        y,
                        product_bar,
                    );
                    ::ad::rt::Absorb::absorb(&mut y_bar, y_part);
                    ::ad::rt::Absorb::absorb(::ad::rt::at(&mut xs_bar, index), item_bar);
                }
                (xs_bar, y_bar)
            },
        )
    }
}
