impl deposit {
    pub fn jvp(
        account: &mut Account,
        amounts: &[f64],
        i: usize,
        account_dot: &mut ::ad::Tangent<Account>,
        amounts_dot: &[::ad::Tangent<f64>],
        i_dot: ::ad::Tangent<usize>,
    ) -> (f64, ::ad::Tangent<f64>) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        trait close_derivatives {
            fn close_vjp(&mut self) {}
            fn close_jvp(&mut self) {}
        }
        impl<
            T: ?::core::marker::Sized + ::ad::rt::MethodWithDerivative,
        > close_derivatives for T {}
        use fee as fee_derivative;
        mod without_derivative {
            pub type fee_derivative = ::ad::rt::FunctionWithoutDerivative;
        }
        use without_derivative::*;
        ::ad::rt::same_length(amounts.len(), amounts_dot.len());
        let index = i;
        let amounts_1 = amounts[index];
        let amounts_1_dot = amounts_dot[index];
        let account_1 = account.total;
        let account_1_dot = ::ad::rt::read(&account_1, &account_dot.total);
        let tangent = ::ad::rules::AddAssignPullback::add_assign_jvp(
            account_1,
            amounts_1,
            account_1_dot,
            amounts_1_dot,
        );
        account.total += amounts_1;
        account_dot.total = ::ad::rt::pass(tangent);
        let index_1 = i;
        ::ad::check_name!(
            never_called = fee, fee_derivative::named(), (& mut account.fees[index_1],
            amounts)
        );
        let mut slot = ::ad::rt::Slot::new();
        let argument_dot = ::ad::rt::pass_part(
            &account.fees[index_1],
            &mut account_dot.fees[index_1],
            &mut slot,
        );
        let (fee, fee_dot) = fee_derivative::jvp(
            &mut account.fees[index_1],
            amounts,
            argument_dot,
            ::ad::rt::pass(amounts_dot),
        );
        ::ad::same_result!(never_called, fee);
        let amounts_2 = amounts[0];
        let amounts_2_dot = amounts_dot[0];
        let (close, close_dot) = account
            .close_jvp(amounts_2, ::ad::rt::pass(&mut *account_dot), amounts_2_dot);
        let total = account.total;
        let total_dot = ::ad::rt::read(&total, &account_dot.total);
        let index_2 = i;
        let amounts_3 = amounts[index_2];
        let amounts_3_dot = amounts_dot[index_2];
        let (difference, difference_dot) = ::ad::rules::SubPullback::sub_jvp(
            total,
            amounts_3,
            total_dot,
            amounts_3_dot,
        );
        (difference, difference_dot)
    }
}
