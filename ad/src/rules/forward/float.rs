//! Functions that only `f32` and `f64` have.

use super::symmetric;
use crate::rules::FloatRules;

/// The `_jvp` siblings of methods of `f32` and `f64`.
pub trait FloatForward: FloatRules + Copy + core::ops::Add<Output = Self> {
    symmetric! {
        hypot_jvp = hypot_vjp(other other_tangent 1);
        midpoint_jvp = midpoint_vjp(other other_tangent 1);
        cbrt_jvp = cbrt_vjp();
        sinh_jvp = sinh_vjp();
        cosh_jvp = cosh_vjp();
        asinh_jvp = asinh_vjp();
        acosh_jvp = acosh_vjp();
        atanh_jvp = atanh_vjp();
        exp2_jvp = exp2_vjp();
        exp_m1_jvp = exp_m1_vjp();
        ln_1p_jvp = ln_1p_vjp();
        log2_jvp = log2_vjp();
        log10_jvp = log10_vjp();
        log_jvp = log_vjp(base base_tangent 1);
        rem_euclid_jvp = rem_euclid_vjp(rhs rhs_tangent 1);
        div_euclid_jvp = div_euclid_vjp(rhs rhs_tangent 1);
        ceil_jvp = ceil_vjp();
        round_jvp = round_vjp();
        round_ties_even_jvp = round_ties_even_vjp();
        trunc_jvp = trunc_vjp();
        fract_jvp = fract_vjp();
    }
}

impl FloatForward for f32 {}
impl FloatForward for f64 {}
