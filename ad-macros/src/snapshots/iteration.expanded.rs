impl newton {
    pub fn vjp_onto(
        a: f64,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(::ad::Tangent<f64>) -> ::ad::Tangent<f64> + use<>,
    ) {
        Self::vjp(a)
    }
    pub fn vjp(
        a: f64,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(::ad::Tangent<f64>) -> ::ad::Tangent<f64> + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let constant = 0.5;
        let mut x = a;
        let mut tape = ::ad::rt::ArrayTape::<_, 5usize>::new();
        for _ in 0..5 {
            let x_1 = x;
            let x_2 = x_1;
            let quotient = a / x_2;
            let sum = x_1 + quotient;
            let product = constant * sum;
            x = product;
            tape.push((x_2,));
        }
        let x_3 = x;
        (
            x_3,
            move |result_bar: ::ad::Tangent<f64>| -> ::ad::Tangent<f64> {
                let mut x_3_bar = result_bar;
                let mut x_bar = x_3_bar;
                let mut a_bar = -0.0_f64;
                for (x_2,) in tape.into_iter().rev() {
                    let x_part = ::ad::rt::take(&mut x_bar);
                    let mut product_bar = x_part;
                    let mut sum_bar = product_bar * constant;
                    let mut x_1_bar = sum_bar;
                    let mut quotient_bar = sum_bar;
                    let (a_part, mut x_2_bar) = ::ad::rules::DivPullback::div_pullback(
                        a,
                        x_2,
                        quotient_bar,
                    );
                    ::ad::rt::Absorb::absorb(&mut a_bar, a_part);
                    x_1_bar += x_2_bar;
                    x_bar += x_1_bar;
                }
                a_bar += x_bar;
                a_bar
            },
        )
    }
}
