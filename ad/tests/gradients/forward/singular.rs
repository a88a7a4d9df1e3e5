//! The table of singular points in `ad::rules`, for tangents.

use ad::rules::forward::*;
use ad::rules::*;
use ad::{differentiable, select};
use glam::DVec3;

const INFINITE: [f64; 3] = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

#[test]
fn numbers() {
    for zero in [0.0_f64, -0.0] {
        for tangent in [
            zero.sqrt_jvp(2.0).1,
            zero.cbrt_jvp(2.0).1,
            RealForward::abs_jvp(zero, 2.0).1,
            RealForward::ln_jvp(zero, 2.0).1,
            RealForward::recip_jvp(zero, 2.0).1,
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
    assert_eq!(VectorForward::length_jvp(zero, dot).1, 0.0);
    assert_eq!(VectorForward::normalize_or_zero_jvp(zero, dot).1, zero);
    assert_eq!(VectorForward::distance_jvp(dot, dot, dot, zero).1, 0.0);
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
        assert_eq!(VectorForward::dot_jvp(vector, vector, DVec3::ZERO, DVec3::ZERO).1, 0.0);
        assert_eq!(vector.cross_jvp(vector, DVec3::ZERO, DVec3::ZERO).1, DVec3::ZERO);
        assert_eq!(vector.mul_jvp(bad, DVec3::ZERO, 0.0).1, DVec3::ZERO);
        assert_eq!(vector.lerp_jvp(vector, bad, DVec3::ZERO, DVec3::ZERO, 0.0).1, DVec3::ZERO);
        assert_eq!(vector.reflect_jvp(vector, DVec3::ZERO, DVec3::ZERO).1, DVec3::ZERO);
    }
    // The factor that moves is the one that counts.
    assert_eq!(f64::INFINITY.mul_jvp(2.0, 3.0, 0.0).1, 6.0);
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
