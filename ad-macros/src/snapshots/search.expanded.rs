impl search {
    pub fn vjp_onto(
        x: f64,
        step: f64,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<f64>, ::ad::Tangent<f64>) + use<>,
    ) {
        Self::vjp(x, step)
    }
    pub fn vjp(
        x: f64,
        step: f64,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<f64>, ::ad::Tangent<f64>) + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let mut a = x;
        let mut i = 0;
        let mut tape = ::std::vec::Vec::new();
        while i < 100 {
            i += 1;
            let a_1 = a;
            let product = a_1 * step;
            let sum = product + x;
            a = sum;
            let value = if a > 10.0 {
                ::core::ops::ControlFlow::Break(())
            } else {
                ::core::ops::ControlFlow::Continue(())
            };
            tape.push((a_1,));
            if ::core::ops::ControlFlow::<_, ()>::is_break(&value) {
                break;
            }
        }
        let a_2 = a;
        let product_1 = a_2 * step;
        (
            product_1,
            move |
                result_bar: ::ad::Tangent<f64>,
            | -> (::ad::Tangent<f64>, ::ad::Tangent<f64>) {
                let irregular = ::ad::rt::vanishing(result_bar);
                ::ad::rt::with_products(
                    irregular,
                    #[inline(always)]
                    move |products: ::ad::rt::Products| {
                        let mut product_1_bar = result_bar;
                        let mut a_2_bar = products.scale(product_1_bar, step);
                        let mut step_bar = products.scale(product_1_bar, a_2);
                        let mut a_bar = a_2_bar;
                        let mut x_bar = -0.0_f64;
                        for (a_1,) in tape.into_iter().rev() {
                            let a_part = ::ad::rt::take(&mut a_bar);
                            let mut sum_bar = a_part;
                            let mut product_bar = sum_bar;
                            x_bar += sum_bar;
                            let mut a_1_bar = products.scale(product_bar, step);
                            step_bar += products.scale(product_bar, a_1);
                            a_bar += a_1_bar;
                        }
                        x_bar += a_bar;
                        (x_bar, step_bar)
                    },
                )
            },
        )
    }
}
