impl softened {
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
        let x_space = ::ad::rt::space(&x);
        let limit_space = ::ad::rt::space(&limit);
        let (value, path) = if x > limit {
            let receiver = x - limit;
            let receiver_pullback = ::ad::rt::linear(&x, &limit);
            let (ln_1p, ln_1p_pullback) = receiver.ln_1p_vjp();
            let sum = limit + ln_1p;
            let sum_pullback = ::ad::rt::linear(&limit, &ln_1p);
            (
                sum,
                ::ad::rt::Branch2::Arm0((
                    receiver_pullback,
                    ln_1p_pullback,
                    sum_pullback,
                )),
            )
        } else {
            (x, ::ad::rt::Branch2::Arm1(()))
        };
        (
            value,
            move |
                result_bar: ::ad::Tangent<f32>,
            | -> (::ad::Tangent<f32>, ::ad::Tangent<f32>) {
                let mut value_bar = result_bar;
                let mut x_bar = x_space.zero();
                let mut limit_bar = limit_space.zero();
                match path {
                    ::ad::rt::Branch2::Arm0(
                        (receiver_pullback, ln_1p_pullback, sum_pullback),
                    ) => {
                        let mut sum_bar = value_bar;
                        let (limit_part, mut ln_1p_bar) = sum_pullback
                            .pull_back_sum(sum_bar);
                        ::ad::rt::Absorb::absorb(&mut limit_bar, limit_part);
                        let mut receiver_bar = ln_1p_pullback(ln_1p_bar);
                        let (x_part, limit_part_1) = receiver_pullback
                            .pull_back_difference(receiver_bar);
                        ::ad::rt::Absorb::absorb(&mut x_bar, x_part);
                        ::ad::rt::Absorb::absorb(&mut limit_bar, limit_part_1);
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
