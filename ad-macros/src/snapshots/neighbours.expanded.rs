impl roughness {
    pub fn vjp_onto(
        x: &[f64; 100],
    ) -> (
        f64,
        impl ::core::ops::FnOnce(::ad::Tangent<f64>) -> ::ad::Tangent<[f64; 100]> + use<>,
    ) {
        Self::vjp(x)
    }
    pub fn vjp(
        x: &[f64; 100],
    ) -> (
        f64,
        impl ::core::ops::FnOnce(::ad::Tangent<f64>) -> ::ad::Tangent<[f64; 100]> + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let x_kept = *x;
        let range = 1..100;
        let x_space = ::ad::rt::space(&x);
        let mut sum: f64 = 0.0;
        for i in range.clone() {
            let index = i;
            let x_1 = x[index];
            let index_1 = i - 1;
            let x_2 = x[index_1];
            let step = x_1 - x_2;
            let (value, path) = if step > 0.5 {
                let sum_1 = sum;
                sum += step;
                ((), ::ad::rt::Branch2::Arm0(()))
            } else {
                let product = step * step;
                let sum_2 = sum;
                sum += product;
                ((), ::ad::rt::Branch2::Arm1(()))
            };
        }
        let sum_3 = sum;
        (
            sum_3,
            move |result_bar: ::ad::Tangent<f64>| -> ::ad::Tangent<[f64; 100]> {
                let irregular = ::ad::rt::vanishing(result_bar);
                ::ad::rt::with_products(
                    irregular,
                    #[inline(always)]
                    move |products: ::ad::rt::Products| {
                        let mut sum_3_bar = result_bar;
                        let mut sum_bar = sum_3_bar;
                        let mut x_bar = x_space.zero();
                        let mut x_2_carried = -0.0_f64;
                        for i in range.clone().rev() {
                            let index = i;
                            let x_1 = x_kept[index];
                            let index_1 = i - 1;
                            let x_2 = x_kept[index_1];
                            let step = x_1 - x_2;
                            let path = if step > 0.5 {
                                ::ad::rt::Branch2::Arm0(())
                            } else {
                                ::ad::rt::Branch2::Arm1(())
                            };
                            let mut step_bar = -0.0_f64;
                            match path {
                                ::ad::rt::Branch2::Arm0(()) => {
                                    step_bar += sum_bar;
                                }
                                ::ad::rt::Branch2::Arm1(()) => {
                                    let mut product_bar = sum_bar;
                                    step_bar += products.scale(product_bar, step);
                                    step_bar += products.scale(product_bar, step);
                                }
                            }
                            let mut x_1_bar = step_bar;
                            let mut x_2_bar = -step_bar;
                            x_bar[index] += x_1_bar + x_2_carried;
                            x_2_carried = x_2_bar;
                        }
                        if let Some(i) = range.clone().next() {
                            *::ad::rt::at(&mut x_bar, i - 1) += x_2_carried;
                        }
                        x_bar
                    },
                )
            },
        )
    }
}
