impl checkpoint {
    pub fn vjp_onto(
        rate: f64,
        start: f64,
        n: usize,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<f64>, ::ad::Tangent<f64>, ::ad::Tangent<usize>) + use<>,
    ) {
        Self::vjp(rate, start, n)
    }
    pub fn vjp(
        rate: f64,
        start: f64,
        n: usize,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<f64>, ::ad::Tangent<f64>, ::ad::Tangent<usize>) + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let mut x = start;
        let mut items = ::core::iter::IntoIterator::into_iter(0..n);
        let mut checkpoints = ::ad::rt::Checkpoints::expecting(items.size_hint().0);
        loop {
            checkpoints
                .begin_iteration(|| (
                    ::ad::fingerprint!(x),
                    items.clone(),
                    ::core::clone::Clone::clone(&x),
                ));
            let ::core::option::Option::Some(_) = items.next() else { break };
            let receiver = x;
            let sin = receiver.sin();
            let product = rate * sin;
            let x_1 = receiver;
            x += product;
        }
        let print = ::ad::fingerprint!(x);
        let x_2 = x;
        (
            x_2,
            move |
                result_bar: ::ad::Tangent<f64>,
            | -> (::ad::Tangent<f64>, ::ad::Tangent<f64>, ::ad::Tangent<usize>) {
                let mut x_2_bar = result_bar;
                let mut x_bar = x_2_bar;
                let mut rate_bar = -0.0_f64;
                let mut after = print;
                for (count, (before, items, mut x)) in checkpoints.into_segments() {
                    let mut tape = ::std::vec::Vec::with_capacity(count);
                    for _ in items.take(count) {
                        let receiver = x;
                        let (sin, sin_pullback) = receiver.sin_vjp();
                        let product = rate * sin;
                        let x_1 = receiver;
                        x += product;
                        tape.push((sin, sin_pullback));
                    }
                    ::ad::rt::same_again(after, ::ad::fingerprint!(x));
                    after = before;
                    for (sin, sin_pullback) in tape.into_iter().rev() {
                        let mut product_bar = x_bar;
                        rate_bar += ::ad::rt::scale(product_bar, sin);
                        let mut sin_bar = ::ad::rt::scale(product_bar, rate);
                        let mut receiver_bar = sin_pullback(sin_bar);
                        x_bar += receiver_bar;
                    }
                }
                let mut start_bar = x_bar;
                (rate_bar, start_bar, ())
            },
        )
    }
}
