impl size {
    pub fn jvp(
        shape: &Shape,
        by: f64,
        shape_dot: &::ad::Tangent<Shape>,
        by_dot: ::ad::Tangent<f64>,
    ) -> (Result<f64, Failure>, ::ad::Tangent<Result<f64, Failure>>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        use bounded as bounded_derivative;
        mod without_derivative {
            pub type bounded_derivative = ::ad::rt::FunctionWithoutDerivative;
        }
        use without_derivative::*;
        let (value_5, value_5_dot) = match shape {
            Shape::Disc(radius) => {
                let radius_dot = &shape_dot.Disc.0;
                let radius_1 = ::ad::rt::ByValue::by_value(radius);
                let radius_1_dot = ::ad::rt::read(&radius_1, radius_dot);
                let (sum, sum_dot) = ::ad::rules::AddPullback::add_jvp(
                    radius_1,
                    by,
                    radius_1_dot,
                    by_dot,
                );
                let value = Ok(sum);
                let value_dot = ::ad::rt::tangent_of(
                    &value,
                    (sum_dot, ::ad::Additive::zero()),
                );
                (value, value_dot)
            }
            Shape::Box { width: width, height: height } => {
                let width_dot = &shape_dot.Box.width;
                let height_dot = &shape_dot.Box.height;
                let width_1 = ::ad::rt::ByValue::by_value(width);
                let width_1_dot = ::ad::rt::read(&width_1, width_dot);
                let height_1 = ::ad::rt::ByValue::by_value(height);
                let height_1_dot = ::ad::rt::read(&height_1, height_dot);
                let (argument, argument_dot) = ::ad::rules::AddPullback::add_jvp(
                    width_1,
                    height_1,
                    width_1_dot,
                    height_1_dot,
                );
                ::ad::check_name!(
                    never_called = bounded, bounded_derivative::named(), (argument)
                );
                let (matched, matched_dot) = bounded_derivative::jvp(
                    argument,
                    argument_dot,
                );
                ::ad::same_result!(never_called, matched);
                let (value_4, value_4_dot) = match matched {
                    ::core::result::Result::Ok(value_1) => {
                        let value_1_dot = ::ad::rt::read(&value_1, matched_dot.0);
                        let (difference, difference_dot) = ::ad::rules::SubPullback::sub_jvp(
                            value_1,
                            by,
                            value_1_dot,
                            by_dot,
                        );
                        let value_2 = Ok(difference);
                        let value_2_dot = ::ad::rt::tangent_of(
                            &value_2,
                            (difference_dot, ::ad::Additive::zero()),
                        );
                        (value_2, value_2_dot)
                    }
                    ::core::result::Result::Err(error) => {
                        let error_dot = ::ad::rt::read(&error, matched_dot.1);
                        let mut last = error_dot;
                        let (propagate, propagate_dot) = ::ad::rt::propagate::jvp(
                            error,
                            ::ad::rt::pass(::ad::rt::Last(&mut last)),
                        );
                        let value_3 = ::core::result::Result::Err(propagate);
                        let value_3_dot = ::ad::rt::tangent_of(
                            &value_3,
                            (::ad::Additive::zero(), propagate_dot),
                        );
                        (value_3, value_3_dot)
                    }
                };
                (value_4, value_4_dot)
            }
            Shape::Point => ::ad::rt::with_zero(Err(Failure::Empty)),
        };
        (value_5, value_5_dot)
    }
}
