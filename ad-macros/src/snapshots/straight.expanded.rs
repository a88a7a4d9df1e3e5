impl f {
    pub fn vjp_onto(
        x: f64,
        y: f64,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<f64>, ::ad::Tangent<f64>) + use<>,
    ) {
        Self::vjp(x, y)
    }
    pub fn vjp(
        x: f64,
        y: f64,
    ) -> (
        f64,
        impl ::core::ops::FnOnce(
            ::ad::Tangent<f64>,
        ) -> (::ad::Tangent<f64>, ::ad::Tangent<f64>) + use<>,
    ) {
        #[allow(unused_imports)]
        use ::ad::rt::methods::*;
        let p = x * y;
        let (sin, sin_pullback) = p.sin_vjp();
        let sum = sin + p;
        (
            sum,
            move |
                result_bar: ::ad::Tangent<f64>,
            | -> (::ad::Tangent<f64>, ::ad::Tangent<f64>) {
                let mut sum_bar = result_bar;
                let mut sin_bar = sum_bar;
                let mut p_bar = sum_bar;
                let p_part = sin_pullback(sin_bar);
                ::ad::rt::Absorb::absorb(&mut p_bar, p_part);
                let mut x_bar = ::ad::rt::scale(p_bar, y);
                let mut y_bar = ::ad::rt::scale(p_bar, x);
                (x_bar, y_bar)
            },
        )
    }
}
