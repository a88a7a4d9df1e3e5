impl deposit {
    pub fn vjp_onto(
        account: &mut Account,
        amounts: &[f64],
        i: usize,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
            ::ad::Tangent<Account>,
            ::ad::rt::Offered<
                (::ad::rt::NotLent, ::ad::Tangent<[f64]>, ::ad::rt::NotLent),
            >,
        ) -> (::ad::Tangent<Account>, ::ad::Tangent<[f64]>, ::ad::Tangent<usize>) + use<>,
    ) {
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
        trait lending_1_to_mut_close {
            fn lending_1_to_mut_close(&self) -> ::ad::rt::LendsNothing {
                ::ad::rt::LendsNothing
            }
            fn lent_1_to_mut_close<A0>(&mut self, _: A0) {}
        }
        impl<T: ?::core::marker::Sized> lending_1_to_mut_close for T {}
        let amounts_space = ::ad::rt::space(&amounts);
        let index = i;
        let amounts_1 = amounts[index];
        let account_1 = account.total;
        let account_1_space = ::ad::rt::space(&account_1);
        account.total += amounts_1;
        let account_1_pullback = ::ad::rt::Increase::of(&account_1, &amounts_1);
        let index_1 = i;
        ::ad::check_name!(
            never_called = fee, fee_derivative::named(), (& mut account.fees[index_1],
            amounts)
        );
        let (fee, fee_pullback) = fee_derivative::vjp_onto(
            &mut account.fees[index_1],
            amounts,
        );
        ::ad::same_result!(never_called, fee);
        let fee_space = ::ad::rt::space(&fee);
        let amounts_2 = amounts[0];
        let (close, close_pullback) = {
            let close_pullback_lends = (*account).lending_1_to_mut_close();
            let (mut close_pullback_onto, mut close_pullback_own) = (
                ::core::option::Option::None,
                ::core::option::Option::None,
            );
            if close_pullback_lends.lends(&close_pullback_onto, &close_pullback_own) {
                close_pullback_lends.lent();
                close_pullback_onto = ::core::option::Option::Some(
                    (*account).lent_1_to_mut_close(amounts_2),
                );
            } else {
                close_pullback_own = ::core::option::Option::Some(
                    (*account).close_vjp(amounts_2),
                );
            }
            close_pullback_lends.choose(close_pullback_onto, close_pullback_own)
        };
        let close_space = ::ad::rt::space(&close);
        let total = account.total;
        let index_2 = i;
        let amounts_3 = amounts_1;
        let difference_pullback = ::ad::rt::Difference::of(&total, &amounts_3);
        let difference = total - amounts_3;
        (
            difference,
            move |
                result_bar: ::ad::Tangent<f64>,
                mut account_bar: ::ad::Tangent<Account>,
                ::ad::rt::Offered(
                    (_, mut amounts_bar, _),
                ): ::ad::rt::Offered<
                    (::ad::rt::NotLent, ::ad::Tangent<[f64]>, ::ad::rt::NotLent),
                >,
            | -> (::ad::Tangent<Account>, ::ad::Tangent<[f64]>, ::ad::Tangent<usize>) {
                let mut difference_bar = result_bar;
                let (mut total_bar, mut amounts_3_bar) = difference_pullback
                    .pull_back(difference_bar);
                let mut amounts_1_bar = amounts_3_bar;
                ::ad::rt::Absorb::absorb(&mut account_bar.total, total_bar);
                let mut close_bar = close_space.zero();
                let (account_part, mut amounts_2_bar) = {
                    let offered = (
                        ::ad::rt::Take::take(&mut account_bar),
                        ::ad::rt::Lent::nothing(),
                    );
                    ::ad::rt::MethodPullbackOnto::pull_back(
                        close_pullback,
                        close_bar,
                        &mut account_bar,
                        offered,
                    )
                };
                ::ad::rt::Absorb::absorb(&mut account_bar, account_part);
                *::ad::rt::at(&mut amounts_bar, 0) += amounts_2_bar;
                let mut fee_bar = fee_space.zero();
                let (account_part_1, amounts_part) = ::ad::rt::PullbackOnto::pull_back(
                    fee_pullback,
                    fee_bar,
                    (
                        ::ad::rt::take_changed(
                            ::ad::rt::at(&mut account_bar.fees, index_1),
                        ),
                    ),
                    (::ad::rt::Lent::nothing(), ::ad::rt::Take::take(&mut amounts_bar)),
                );
                ::ad::rt::Absorb::absorb(
                    ::ad::rt::at(&mut account_bar.fees, index_1),
                    account_part_1,
                );
                ::ad::rt::Absorb::absorb(&mut amounts_bar, amounts_part);
                (*&mut account_bar.total)
                    .accepts_tangents(amounts_space.part(|tangent| &tangent[0]));
                let (account_part_2, amounts_1_part) = account_1_pullback
                    .pull_back(
                        account_1_space.enter(::ad::rt::take(&mut account_bar.total)),
                    );
                ::ad::rt::Absorb::absorb(&mut account_bar.total, account_part_2);
                ::ad::rt::Absorb::absorb(&mut amounts_1_bar, amounts_1_part);
                *::ad::rt::at(&mut amounts_bar, index) += amounts_1_bar;
                (account_bar, amounts_bar, ())
            },
        )
    }
    pub fn vjp(
        account: &mut Account,
        amounts: &[f64],
        i: usize,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
            ::ad::Tangent<Account>,
        ) -> (::ad::Tangent<Account>, ::ad::Tangent<[f64]>, ::ad::Tangent<usize>) + use<>,
    ) {
        let shape_0 = ::ad::rt::shape(&account);
        let shape_1 = ::ad::rt::shape(&amounts);
        let (value, pullback) = Self::vjp_onto(account, amounts, i);
        (
            value,
            #[inline(always)]
            move |
                result_bar: ::ad::Tangent<f64>,
                mut incoming_0: ::ad::Tangent<Account>,
            | -> (::ad::Tangent<Account>, ::ad::Tangent<[f64]>, ::ad::Tangent<usize>) {
                let (part_0, part_1, part_2) = pullback(
                    result_bar,
                    incoming_0,
                    ::ad::rt::Offered((
                        ::ad::rt::Lent::nothing(),
                        ::ad::rt::Lent::nothing(),
                        ::ad::rt::Lent::nothing(),
                    )),
                );
                (::ad::rt::fit(shape_0, part_0), ::ad::rt::fit(shape_1, part_1), part_2)
            },
        )
    }
}
