//! Functions of scalars.

use super::symmetric;
use crate::rules::operators::product_tangent;
use crate::rules::{RealRules, ScalarRules, chain};
use crate::{Real, Scalar};

/// The `_jvp` siblings of the methods of [`Real`].
pub trait RealForward: RealRules {
    symmetric! {
        abs_jvp = abs_vjp();
        signum_jvp = signum_vjp();
        floor_jvp = floor_vjp();
        recip_jvp = recip_vjp();
        sqrt_jvp = sqrt_vjp();
        exp_jvp = exp_vjp();
        ln_jvp = ln_vjp();
        sin_jvp = sin_vjp();
        cos_jvp = cos_vjp();
        tan_jvp = tan_vjp();
        asin_jvp = asin_vjp();
        acos_jvp = acos_vjp();
        atan_jvp = atan_vjp();
        tanh_jvp = tanh_vjp();
        min_jvp = min_vjp(other other_tangent 1);
        max_jvp = max_vjp(other other_tangent 1);
        copysign_jvp = copysign_vjp(sign sign_tangent 1);
        powf_jvp = powf_vjp(exponent exponent_tangent 1);
        atan2_jvp = atan2_vjp(abscissa abscissa_tangent 1);
        clamp_jvp = clamp_vjp(low low_tangent 1, high high_tangent 2);
    }

    /// The product, and the tangent of the summand.
    #[inline(always)]
    fn mul_add_jvp(
        self,
        a: Self,
        b: Self,
        tangent: Self,
        a_tangent: Self,
        b_tangent: Self,
    ) -> (Self, Self) {
        (self.mul_add(a, b), product_tangent(self, a, tangent, a_tangent) + b_tangent)
    }

    /// From [`powi_vjp`](RealRules::powi_vjp).
    #[inline(always)]
    fn powi_jvp(self, exponent: i32, tangent: Self, (): ()) -> (Self, Self) {
        let (value, pullback) = self.powi_vjp(exponent);
        (value, pullback(tangent).0)
    }

    /// Both products.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn difference_of_products_jvp(
        a: Self,
        b: Self,
        c: Self,
        d: Self,
        a_tangent: Self,
        b_tangent: Self,
        c_tangent: Self,
        d_tangent: Self,
    ) -> (Self, Self) {
        let first = product_tangent(a, b, a_tangent, b_tangent);
        let second = product_tangent(c, d, c_tangent, d_tangent);
        (Self::difference_of_products(a, b, c, d), first - second)
    }
}

impl<S: Real> RealForward for S {}

/// The `_jvp` siblings of functions that only single numbers have.
pub trait ScalarForward: ScalarRules {
    symmetric! {
        to_radians_jvp = to_radians_vjp();
        to_degrees_jvp = to_degrees_vjp();
    }

    /// Sine and cosine together.
    #[inline(always)]
    fn sin_cos_jvp(self, tangent: Self) -> ((Self, Self), (Self, Self)) {
        let (sin, cos) = (self.sin(), self.cos());
        ((sin, cos), (chain(tangent, cos), -chain(tangent, sin)))
    }
}

impl<S: Scalar> ScalarForward for S {}
