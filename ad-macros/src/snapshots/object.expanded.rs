impl area {
    pub fn vjp_onto(
        scale: f64,
        end: f64,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<f64>, ::ad::Tangent<f64>) + use<>,
    ) {
        Self::vjp(scale, end)
    }
    pub fn vjp(
        scale: f64,
        end: f64,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<f64>, ::ad::Tangent<f64>) + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        use integrate as integrate_derivative;
        mod without_derivative {
            pub type integrate_derivative = ::ad::rt::FunctionWithoutDerivative;
        }
        use without_derivative::*;
        let function = {
            use ::std::borrow::ToOwned as _;
            let captured = ((scale).to_owned(),);
            ::ad::function::Captured::of(&captured)
                .closure(move |pulls_back: bool, (t,): (f64,)| {
                    let (scale_1,) = &captured;
                    if !pulls_back {
                        let scale_1_1 = (*scale_1);
                        let receiver = t * scale_1_1;
                        let sin = receiver.sin();
                        return (sin, ::core::option::Option::None);
                    }
                    let scale_1_space = ::ad::rt::space(&scale_1);
                    let scale_1_1 = (*scale_1);
                    let receiver = t * scale_1_1;
                    let (sin, sin_pullback) = receiver.sin_vjp();
                    let result = sin;
                    let pullback = ::ad::function::pullback(
                        &result,
                        move |result_bar_1| {
                            let (scale_1_bar_1, t_bar_1) = {
                                let mut sin_bar = result_bar_1;
                                let mut receiver_bar = sin_pullback(sin_bar);
                                let (mut t_bar, mut scale_1_1_bar) = ::ad::rules::MulPullback::mul_pullback(
                                    t,
                                    scale_1_1,
                                    receiver_bar,
                                );
                                let mut scale_1_bar = scale_1_space.enter(scale_1_1_bar);
                                (scale_1_bar, t_bar)
                            };
                            ((scale_1_bar_1,), (t_bar_1,))
                        },
                    );
                    (result, pullback)
                })
        };
        let (integrate, integrate_pullback) = integrate_derivative::vjp(
            function,
            0.0,
            end,
        );
        (
            integrate,
            move |
                result_bar: ::ad::Tangent<f64>,
            | -> (::ad::Tangent<f64>, ::ad::Tangent<f64>) {
                let mut integrate_bar = result_bar;
                let (mut function_bar, _, mut end_bar) = integrate_pullback(
                    integrate_bar,
                );
                let mut scale_bar = function_bar.0;
                (scale_bar, end_bar)
            },
        )
    }
}
