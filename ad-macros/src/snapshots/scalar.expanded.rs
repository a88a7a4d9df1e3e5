impl valley {
    pub fn vjp_onto<Element: Real, const N: usize>(
        x: &[Element; N],
    ) -> (
        Element,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<Element>,
        ) -> ::ad::Tangent<[Element; N]> + use<Element, N>,
    ) {
        Self::vjp::<Element, N>(x)
    }
    pub fn vjp<Element: Real, const N: usize>(
        x: &[Element; N],
    ) -> (
        Element,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<Element>,
        ) -> ::ad::Tangent<[Element; N]> + use<Element, N>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let constant = Element::ONE;
        let x_kept = *x;
        let x_space = ::ad::rt::space(&x);
        let mut sum = Element::ZERO;
        let range = 0..N - 1;
        for i in range.clone() {
            let index = i;
            let x_1 = x[index];
            let a = constant - x_1;
            let index_1 = i + 1;
            let x_2 = x[index_1];
            let index_2 = i;
            let x_3 = x_1;
            let index_3 = i;
            let x_4 = x_1;
            let product = x_3 * x_4;
            let b = x_2 - product;
            let product_1 = a * a;
            let constant_1 = Element::from_f64(100.0);
            let product_2 = constant_1 * b;
            let product_3 = product_2 * b;
            let sum_1 = product_1 + product_3;
            let sum_2 = sum;
            sum += sum_1;
        }
        let sum_3 = sum;
        (
            sum_3,
            move |result_bar: ::ad::Tangent<Element>| -> ::ad::Tangent<[Element; N]> {
                let irregular = ::ad::rt::vanishing(result_bar);
                ::ad::rt::with_products(
                    irregular,
                    #[inline(always)]
                    move |products: ::ad::rt::Products| {
                        let mut sum_3_bar = result_bar;
                        let mut sum_bar = sum_3_bar;
                        let mut x_bar = x_space.zero();
                        let mut x_1_carried = <Element as ::ad::Additive>::zero();
                        for i in range.clone().rev() {
                            let index = i;
                            let x_1 = x_kept[index];
                            let a = constant - x_1;
                            let index_1 = i + 1;
                            let x_2 = x_kept[index_1];
                            let x_3 = x_1;
                            let x_4 = x_1;
                            let product = x_3 * x_4;
                            let b = x_2 - product;
                            let constant_1 = Element::from_f64(100.0);
                            let product_2 = constant_1 * b;
                            let mut sum_1_bar = sum_bar;
                            let mut product_1_bar = sum_1_bar;
                            let mut product_3_bar = sum_1_bar;
                            let mut product_2_bar = products.scale(product_3_bar, b);
                            let mut b_bar = products.scale(product_3_bar, product_2);
                            b_bar += product_2_bar * constant_1;
                            let mut a_bar = products.scale(product_1_bar, a);
                            a_bar += products.scale(product_1_bar, a);
                            let mut x_2_bar = b_bar;
                            let mut product_bar = -b_bar;
                            let mut x_3_bar = products.scale(product_bar, x_4);
                            let mut x_4_bar = products.scale(product_bar, x_3);
                            let mut x_1_bar = x_4_bar;
                            x_1_bar += x_3_bar;
                            x_1_bar -= a_bar;
                            x_bar[index_1] += x_2_bar + x_1_carried;
                            x_1_carried = x_1_bar;
                        }
                        if let Some(i) = range.clone().next() {
                            x_bar[i] += x_1_carried;
                        }
                        x_bar
                    },
                )
            },
        )
    }
}
