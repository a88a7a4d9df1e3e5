impl size {
    pub fn vjp_onto(
        shape: &Shape,
        by: f64,
    ) -> (
        Result<f64, Failure>,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<Result<f64, Failure>>,
            ::ad::rt::Offered<(::ad::Tangent<Shape>, ::ad::rt::NotLent)>,
        ) -> (::ad::Tangent<Shape>, ::ad::Tangent<f64>) + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        use bounded as bounded_derivative;
        mod without_derivative {
            pub type bounded_derivative = ::ad::rt::FunctionWithoutDerivative;
        }
        use without_derivative::*;
        let (value_5, path_1) = match shape {
            Shape::Disc(radius) => {
                let radius_1 = ::ad::rt::ByValue::by_value(radius);
                let sum_pullback = ::ad::rt::Sum::of(&radius_1, &by);
                let sum = radius_1 + by;
                let value = Ok(sum);
                (value, ::ad::rt::Branch3::Arm0((sum_pullback,)))
            }
            Shape::Box { width: width, height: height } => {
                let width_1 = ::ad::rt::ByValue::by_value(width);
                let height_1 = ::ad::rt::ByValue::by_value(height);
                let argument_pullback = ::ad::rt::Sum::of(&width_1, &height_1);
                let argument = width_1 + height_1;
                ::ad::check_name!(
                    never_called = bounded, bounded_derivative::named(), (argument)
                );
                let (matched, matched_pullback) = bounded_derivative::vjp(argument);
                ::ad::same_result!(never_called, matched);
                let matched_space = ::ad::rt::space(&matched);
                let (value_4, path) = match matched {
                    ::core::result::Result::Ok(value_1) => {
                        let difference_pullback = ::ad::rt::Difference::of(
                            &value_1,
                            &by,
                        );
                        let difference = value_1 - by;
                        let value_2 = Ok(difference);
                        (value_2, ::ad::rt::Branch2::Arm0((difference_pullback,)))
                    }
                    ::core::result::Result::Err(error) => {
                        let (propagate, propagate_pullback) = ::ad::rt::propagate::vjp(
                            error,
                        );
                        let value_3 = ::core::result::Result::Err(propagate);
                        (value_3, ::ad::rt::Branch2::Arm1((propagate_pullback,)))
                    }
                };
                (
                    value_4,
                    ::ad::rt::Branch3::Arm1((
                        argument_pullback,
                        matched_space,
                        matched_pullback,
                        path,
                    )),
                )
            }
            Shape::Point => (Err(Failure::Empty), ::ad::rt::Branch3::Arm2(())),
        };
        (
            value_5,
            move |
                result_bar: ::ad::Tangent<Result<f64, Failure>>,
                ::ad::rt::Offered(
                    (mut shape_bar, _),
                ): ::ad::rt::Offered<(::ad::Tangent<Shape>, ::ad::rt::NotLent)>,
            | -> (::ad::Tangent<Shape>, ::ad::Tangent<f64>) {
                let mut value_5_bar = result_bar;
                let mut by_bar = -0.0_f64;
                match path_1 {
                    ::ad::rt::Branch3::Arm0((sum_pullback,)) => {
                        let mut value_bar = value_5_bar;
                        let mut sum_bar = value_bar.0;
                        let (mut radius_1_bar, by_part) = sum_pullback
                            .pull_back(sum_bar);
                        ::ad::rt::Absorb::absorb(&mut by_bar, by_part);
                        let mut radius_bar = radius_1_bar;
                        ::ad::rt::Absorb::absorb(&mut shape_bar.Disc.0, radius_bar);
                    }
                    ::ad::rt::Branch3::Arm1(
                        (argument_pullback, matched_space, matched_pullback, path),
                    ) => {
                        let mut value_4_bar = value_5_bar;
                        let mut matched_bar = matched_space.zero();
                        match path {
                            ::ad::rt::Branch2::Arm0((difference_pullback,)) => {
                                let mut value_2_bar = value_4_bar;
                                let mut difference_bar = value_2_bar.0;
                                let (mut value_1_bar, by_part_1) = difference_pullback
                                    .pull_back(difference_bar);
                                ::ad::rt::Absorb::absorb(&mut by_bar, by_part_1);
                                ::ad::rt::Absorb::absorb(&mut matched_bar.0, value_1_bar);
                            }
                            ::ad::rt::Branch2::Arm1((propagate_pullback,)) => {
                                let mut value_3_bar = value_4_bar;
                                let mut propagate_bar = value_3_bar.1;
                                let mut error_bar = propagate_pullback(propagate_bar);
                                ::ad::rt::Absorb::absorb(&mut matched_bar.1, error_bar);
                            }
                        }
                        let mut argument_bar = matched_pullback(matched_bar);
                        let (mut width_1_bar, mut height_1_bar) = argument_pullback
                            .pull_back(argument_bar);
                        let mut height_bar = height_1_bar;
                        let mut width_bar = width_1_bar;
                        ::ad::rt::Absorb::absorb(&mut shape_bar.Box.width, width_bar);
                        ::ad::rt::Absorb::absorb(&mut shape_bar.Box.height, height_bar);
                    }
                    ::ad::rt::Branch3::Arm2(()) => {}
                }
                (shape_bar, by_bar)
            },
        )
    }
    pub fn vjp(
        shape: &Shape,
        by: f64,
    ) -> (
        Result<f64, Failure>,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<Result<f64, Failure>>,
        ) -> (::ad::Tangent<Shape>, ::ad::Tangent<f64>) + use<>,
    ) {
        let shape_0 = ::ad::rt::shape(&shape);
        let (value, pullback) = Self::vjp_onto(shape, by);
        (
            value,
            #[inline(always)]
            move |
                result_bar: ::ad::Tangent<Result<f64, Failure>>,
            | -> (::ad::Tangent<Shape>, ::ad::Tangent<f64>) {
                let (part_0, part_1) = pullback(
                    result_bar,
                    ::ad::rt::Offered((
                        ::ad::rt::Lent::nothing(),
                        ::ad::rt::Lent::nothing(),
                    )),
                );
                (::ad::rt::fit(shape_0, part_0), part_1)
            },
        )
    }
}
