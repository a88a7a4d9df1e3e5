impl softened {
    pub fn vjp_onto(
        x: f32,
        limit: f32,
    ) -> (
        f32,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f32>,
        ) -> (::ad::Tangent<f32>, ::ad::Tangent<f32>) + use<>,
    ) {
        Self::vjp(x, limit)
    }
    pub fn vjp(
        x: f32,
        limit: f32,
    ) -> (
        f32,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f32>,
        ) -> (::ad::Tangent<f32>, ::ad::Tangent<f32>) + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        trait ln_1p_derivatives {
            fn ln_1p_vjp(&mut self) {}
            fn ln_1p_jvp(&mut self) {}
        }
        impl<
            T: ?::core::marker::Sized + ::ad::rt::MethodWithDerivative,
        > ln_1p_derivatives for T {}
        let (value, path) = if x > limit {
            let receiver = x - limit;
            let (ln_1p, ln_1p_pullback) = receiver.ln_1p_vjp();
            let sum = limit + ln_1p;
            (sum, ::ad::rt::Branch2::Arm0((ln_1p_pullback,)))
        } else {
            (x, ::ad::rt::Branch2::Arm1(()))
        };
        (
            value,
            move |
                result_bar: ::ad::Tangent<f32>,
            | -> (::ad::Tangent<f32>, ::ad::Tangent<f32>) {
                let mut value_bar = result_bar;
                let mut x_bar = -0.0_f32;
                let mut limit_bar = -0.0_f32;
                match path {
                    ::ad::rt::Branch2::Arm0((ln_1p_pullback,)) => {
                        let mut sum_bar = value_bar;
                        limit_bar += sum_bar;
                        let mut ln_1p_bar = sum_bar;
                        let mut receiver_bar = ln_1p_pullback(ln_1p_bar);
                        x_bar += receiver_bar;
                        limit_bar -= receiver_bar;
                    }
                    ::ad::rt::Branch2::Arm1(()) => {
                        ::ad::rt::Absorb::absorb(&mut x_bar, value_bar);
                    }
                }
                (x_bar, limit_bar)
            },
        )
    }
}
