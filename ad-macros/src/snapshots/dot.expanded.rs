impl dot {
    pub fn vjp_onto(
        xs: &[f64; 8],
        ys: &[f64; 8],
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<[f64; 8]>, ::ad::Tangent<[f64; 8]>) + use<>,
    ) {
        Self::vjp(xs, ys)
    }
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
        let total_1_pullback = ::ad::rt::Sum::of_unknown();
        let xs_kept = *xs;
        let ys_kept = *ys;
        let range = 0..xs.len().min(ys.len());
        let xs_space = ::ad::rt::space(&xs);
        let ys_space = ::ad::rt::space(&ys);
        let mut total = ::ad::rt::empty_sum::<f64>();
        for index in range.clone() {
            let x = xs[index];
            let y = ys[index];
            let product = x * y;
            let partial = total;
            total_1_pullback.keep(&partial, &product);
            let total_1 = partial + product;
            total = total_1;
        }
        let total_2 = total;
        (
            total_2,
            move |
                result_bar: ::ad::Tangent<f64>,
            | -> (::ad::Tangent<[f64; 8]>, ::ad::Tangent<[f64; 8]>) {
                let mut total_2_bar = result_bar;
                let mut total_bar = total_2_bar;
                let mut xs_bar = xs_space.zero();
                let mut ys_bar = ys_space.zero();
                for index in range.clone().rev() {
                    let x = xs_kept[index];
                    let y = ys_kept[index];
                    let total_part = ::ad::rt::take(&mut total_bar);
                    let mut total_1_bar = total_part;
                    let (mut partial_bar, mut product_bar) = total_1_pullback
                        .pull_back(total_1_bar);
                    ::ad::rt::Absorb::absorb(&mut total_bar, partial_bar);
                    let mut x_bar = ::ad::rt::scale(product_bar, y);
                    let mut y_bar = ::ad::rt::scale(product_bar, x);
                    ys_bar[index] += y_bar;
                    xs_bar[index] += x_bar;
                }
                (xs_bar, ys_bar)
            },
        )
    }
}
