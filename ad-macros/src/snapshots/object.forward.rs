impl area {
    pub fn jvp(
        scale: f64,
        end: f64,
        scale_dot: ::ad::Tangent<f64>,
        end_dot: ::ad::Tangent<f64>,
    ) -> (f64, ::ad::Tangent<f64>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        use integrate as integrate_derivative;
        mod without_derivative {
            pub type integrate_derivative = ::ad::rt::FunctionWithoutDerivative;
        }
        use without_derivative::*;
        let function = {
            use ::std::borrow::ToOwned as _;
            let captured_1 = ((scale).to_owned(),);
            let captured_dots = (::ad::rt::read(&captured_1.0, &scale_dot),);
            ::ad::function::forward(move |
                (t,): (f64,),
                dots: ::core::option::Option<(::ad::Tangent<f64>,)>|
            {
                let (scale_1,) = &captured_1;
                let ::core::option::Option::Some((t_dot,)) = dots else {
                    let scale_1_1 = (*scale_1);
                    let receiver = t * scale_1_1;
                    let sin = receiver.sin();
                    return (sin, ::core::option::Option::None);
                };
                let (scale_1_dot,) = &captured_dots;
                let scale_1_1 = (*scale_1);
                let scale_1_1_dot = ::ad::rt::read(&scale_1_1, scale_1_dot);
                let (receiver, receiver_dot) = ::ad::rules::MulPullback::mul_jvp(
                    t,
                    scale_1_1,
                    t_dot,
                    scale_1_1_dot,
                );
                let (sin, sin_dot) = receiver.sin_jvp(::ad::rt::pass(&receiver_dot));
                let (result_1, result_dot) = (sin, sin_dot);
                (result_1, ::core::option::Option::Some(result_dot))
            })
        };
        let (integrate, integrate_dot) = integrate_derivative::jvp(
            function,
            0.0,
            end,
            (),
            ::ad::Additive::zero(),
            end_dot,
        );
        (integrate, integrate_dot)
    }
}
