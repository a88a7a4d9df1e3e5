//! The table of singular points in `ad::rules`, for tangents.

use ad::rules::*;
use ad::{Dual, Mask, Real, differentiable, select};
use glam::{DMat3, DVec3};

const INFINITE: [f64; 3] = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

#[test]
fn numbers() {
    for zero in [0.0_f64, -0.0] {
        for tangent in [
            zero.sqrt_jvp(2.0).1,
            zero.cbrt_jvp(2.0).1,
            RealRules::abs_jvp(zero, 2.0).1,
            RealRules::ln_jvp(zero, 2.0).1,
            RealRules::recip_jvp(zero, 2.0).1,
            zero.log2_jvp(2.0).1,
            zero.atan2_jvp(0.0, 2.0, 3.0).1,
            zero.hypot_jvp(zero, 2.0, 3.0).1,
            1.0_f64.div_jvp(zero, 2.0, 3.0).1,
            zero.powf_jvp(0.5, 2.0, 3.0).1,
            zero.powi_jvp(-1, 2.0, ()).1,
            1.0_f64.asin_jvp(2.0).1,
            1.0_f64.acosh_jvp(2.0).1,
        ] {
            assert_eq!(tangent, 0.0);
        }
    }
    assert_eq!(2.0_f64.min_jvp(2.0, 3.0, 5.0).1, 3.0);
    assert_eq!(2.0_f64.max_jvp(2.0, 3.0, 5.0).1, 3.0);
    assert_eq!(2.0_f64.clamp_jvp(2.0, 4.0, 3.0, 5.0, 7.0).1, 3.0);
}

#[test]
fn vectors() {
    let (zero, dot) = (DVec3::ZERO, DVec3::new(1.0, -2.0, 3.0));
    assert_eq!(VectorRules::length_jvp(zero, dot).1, 0.0);
    assert_eq!(VectorRules::normalize_or_zero_jvp(zero, dot).1, zero);
    assert_eq!(VectorRules::distance_jvp(dot, dot, dot, zero).1, 0.0);
    assert_eq!(dot.project_onto_jvp(zero, dot, dot).1, zero);
    assert_eq!(DVec3::ONE.max_element_jvp(dot).1, 1.0);
}

/// A tangent of zero annihilates a partial derivative that is infinite or NaN.
#[test]
fn nothing_moves() {
    for bad in INFINITE {
        for tangent in [
            bad.mul_jvp(bad, 0.0, 0.0).1,
            bad.div_jvp(bad, 0.0, 0.0).1,
            bad.rem_jvp(bad, 0.0, 0.0).1,
            bad.powf_jvp(bad, 0.0, 0.0).1,
            bad.hypot_jvp(bad, 0.0, 0.0).1,
            bad.exp_jvp(0.0).1,
            bad.mul_add_jvp(bad, bad, 0.0, 0.0, 0.0).1,
        ] {
            assert_eq!(tangent, 0.0, "{bad}");
        }
        let vector = DVec3::splat(bad);
        assert_eq!(VectorRules::dot_jvp(vector, vector, DVec3::ZERO, DVec3::ZERO).1, 0.0);
        assert_eq!(vector.cross_jvp(vector, DVec3::ZERO, DVec3::ZERO).1, DVec3::ZERO);
        assert_eq!(vector.mul_jvp(bad, DVec3::ZERO, 0.0).1, DVec3::ZERO);
        assert_eq!(vector.lerp_jvp(vector, bad, DVec3::ZERO, DVec3::ZERO, 0.0).1, DVec3::ZERO);
        assert_eq!(vector.reflect_jvp(vector, DVec3::ZERO, DVec3::ZERO).1, DVec3::ZERO);
        let matrix = DMat3::from_cols_array(&[bad, 0.0, 0.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
        assert_eq!(matrix.mul_jvp(matrix, DMat3::ZERO, DMat3::ZERO).1, DMat3::ZERO);
        let along = matrix.mul_jvp(DVec3::ONE, DMat3::IDENTITY, DVec3::Y).1;
        assert_eq!(along, DVec3::new(3.0, 4.0, 5.0));
    }
    // The factor that moves is the one that counts.
    assert_eq!(f64::INFINITY.mul_jvp(2.0, 3.0, 0.0).1, 6.0);
}

/// Asserts that nothing moves where functions of an infinite number are finite, along any tangent.
macro_rules! assert_flat {
    ($rules:ident of $type:ty: $($jvp:ident)*) => {$(
        for x in [f64::INFINITY, f64::NEG_INFINITY] {
            for along in [1.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
                let [x, along] = [x, along].map(<$type as Real>::from_f64);
                let (value, tangent) = $rules::$jvp(x, along);
                let is_flat = tangent.cmpeq(Real::ZERO) | !Real::is_finite(value);
                assert!(is_flat.all(), "{} at {x:?} along {along:?}: {tangent:?}", stringify!($jvp));
            }
        }
    )*};
    ($($type:ty),*) => {$(
        assert_flat!(RealRules of $type: abs_jvp signum_jvp floor_jvp recip_jvp sqrt_jvp exp_jvp
            ln_jvp sin_jvp cos_jvp tan_jvp asin_jvp acos_jvp atan_jvp tanh_jvp);
    )*};
}

#[test]
fn infinite_numbers() {
    assert_flat!(f64, f32, Dual<f64>);
    #[cfg(feature = "lanes")]
    assert_flat!(ad::lanes::f32x8, ad::lanes::f64x8);
    assert_flat!(FloatRules of f64: cbrt_jvp sinh_jvp cosh_jvp asinh_jvp acosh_jvp atanh_jvp
        exp2_jvp exp_m1_jvp ln_1p_jvp log2_jvp log10_jvp);
    assert_flat!(FloatRules of f32: exp2_jvp exp_m1_jvp);
    for bad in INFINITE {
        let (far, zero) = (f64::INFINITY, DVec3::ZERO);
        for tangent in [
            far.powi_jvp(-2, bad, ()).1,
            far.powf_jvp(-2.0, bad, bad).1,
            0.5.powf_jvp(far, bad, bad).1,
            1.0.div_jvp(far, bad, bad).1,
            bad.mul_jvp(0.0, bad, 0.0).1,
            1.0.rem_jvp(far, 0.0, bad).1,
            bad.mul_add_jvp(0.0, 1.0, bad, 0.0, 0.0).1,
            f64::difference_of_products_jvp(bad, 0.0, 0.0, bad, bad, 0.0, 0.0, bad).1,
            0.0.sin_cos_jvp(bad).1.1,
            1.0.max_jvp(0.5, 0.0, bad).1,
            VectorRules::dot_jvp(DVec3::ONE, zero, DVec3::splat(bad), zero).1,
        ] {
            assert_eq!(tangent, 0.0, "{bad}");
        }
        let (vector, along) = (DVec3::splat(f64::NEG_INFINITY), DVec3::splat(bad));
        assert_eq!(VectorRules::exp_jvp(vector, along).1, zero);
        assert_eq!(VectorRules::recip_jvp(vector, along).1, zero);
        assert_eq!(VectorRules::powf_jvp(-vector, -1.0, along, bad).1, zero);
        assert_eq!(DVec3::ONE.mul_jvp(0.0, along, 0.0).1, zero);
        assert_eq!(DVec3::ONE.mul_jvp(zero, along, zero).1, zero);
        assert_eq!(DVec3::ONE.div_jvp(vector, along, along).1, zero);
    }
}

/// The survivors of a hazard that overflows.
fn survival<S: Real>(x: S) -> S {
    (-x.exp()).exp()
}

#[differentiable]
fn overflown(x: f64) -> f64 {
    let flat = (-x.exp()).exp() + x.cosh().recip() + x.exp().powi(3).recip() + x.cosh().powi(-2);
    let bounded = x.exp().tanh() + x.exp().atan() + x.exp().atan2(1.0) + 0.5.powf(x.exp());
    let weibull = (-(10.0 * x).powf(400.0)).exp();
    flat + bounded + weibull + (x * f64::NEG_INFINITY).exp() + x
}

/// What overflows on the way to a finite value does not move it, in any mode.
#[test]
fn overflow_on_the_way() {
    assert_eq!(overflown::grad(800.0), 1.0);
    assert_eq!(overflown::jvp(800.0, 2.0).1, 2.0);
    assert_eq!(survival(Dual::new(800.0, 1.0)).derivative, 0.0);
    assert_eq!(ad::tape::gradient(|v| survival(v[0]), &[800.0]).1, [0.0]);
}

#[differentiable]
fn entropy(p: f64) -> f64 {
    select(p > 0.0, -p * p.ln(), 0.0)
}

/// The smaller one, beside an infinite slope.
#[differentiable]
fn smaller(x: f64) -> f64 {
    (x * 0.5).min((x * 1e300) * (x * 1e300))
}

/// What is not chosen does not count.
#[test]
fn choices() {
    assert_eq!(entropy::jvp(0.0, 1.0), (0.0, 0.0));
    assert_eq!(entropy::jvp(1.0, 2.0).1, -2.0);
    assert_eq!(smaller::jvp(1e10, 2.0), (5e9, 1.0));
}
