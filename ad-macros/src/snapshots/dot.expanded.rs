impl dot {
    pub fn vjp(
        xs: &[f64; 8],
        ys: &[f64; 8],
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<[f64; 8]>, ::ad::Tangent<[f64; 8]>) + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let xs_space = ::ad::rt::space(&xs);
        let ys_space = ::ad::rt::space(&ys);
        let mut value = ::ad::rt::empty_sum();
        let mut tape = ::ad::rt::ArrayTape::<_, 8usize>::new();
        for (index, index_1) in (0..xs.len()).zip(0..ys.len()) {
            let value_1 = xs[index];
            let value_2 = ys[index_1];
            let product = value_1 * value_2;
            let partial = value;
            value += product;
            let partial_pullback = ::ad::rt::linear(&partial, &product);
            tape.push((index, index_1, value_1, value_2, partial_pullback));
        }
        let value_3 = value;
        (
            value_3,
            move |
                result_bar: ::ad::Tangent<f64>,
            | -> (::ad::Tangent<[f64; 8]>, ::ad::Tangent<[f64; 8]>) {
                let mut value_3_bar = result_bar;
                let mut value_bar = value_3_bar;
                let mut xs_bar = xs_space.zero();
                let mut ys_bar = ys_space.zero();
                for (index, index_1, value_1, value_2, partial_pullback) in tape
                    .into_iter()
                    .rev()
                {
                    let (value_part, product_part) = partial_pullback
                        .pull_back_sum(::ad::rt::take(&mut value_bar));
                    ::ad::rt::Absorb::absorb(&mut value_bar, value_part);
                    let mut product_bar = product_part;
                    let (mut value_1_bar, mut value_2_bar) = ::ad::rules::MulPullback::mul_pullback(
                        value_1,
                        value_2,
                        product_bar,
                    );
                    ::ad::rt::Absorb::absorb(&mut ys_bar[index_1], value_2_bar);
                    ::ad::rt::Absorb::absorb(&mut xs_bar[index], value_1_bar);
                }
                (xs_bar, ys_bar)
            },
        )
    }
}
