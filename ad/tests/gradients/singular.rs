//! The table of singular points in `ad::rules`, row by row, in the rules and in dual numbers; and
//! numbers at the ends of the range.

use ad::rules::*;
use ad::vector::Xyz;
use ad::{Dual, Real, differentiable, select};
use glam::{DAffine2, DAffine3, DMat3, DQuat, DVec2, DVec3, Vec3};

/// The derivative that dual numbers give.
fn dual(f: impl Fn(Dual<f64>) -> Dual<f64>, x: f64) -> f64 {
    f(Dual::new(x, 1.0)).derivative
}

/// Asserts what the rule and the dual number say of a function of one variable at a point.
macro_rules! assert_slope {
    ($vjp:ident, $method:ident, $x:expr, $expected:expr) => {
        let (x, expected): (f64, f64) = ($x, $expected);
        assert_eq!(x.$vjp().1(1.0), expected, "{} at {x}", stringify!($vjp));
        let single = (x as f32).$vjp().1(1.0);
        assert_eq!(single, expected as f32, "{} at {x}", stringify!($vjp));
        assert_eq!(dual(Real::$method, x), expected, "dual {} at {x}", stringify!($method));
        let (_, taped) = ad::tape::gradient(|v| Real::$method(v[0]), &[x]);
        assert_eq!(taped[0], expected, "tape {} at {x}", stringify!($method));
    };
}

#[test]
fn functions_of_one_number() {
    for zero in [0.0, -0.0] {
        assert_slope!(sqrt_vjp, sqrt, zero, 0.0);
        assert_slope!(abs_vjp, abs, zero, 0.0);
        assert_slope!(ln_vjp, ln, zero, 0.0);
        assert_slope!(recip_vjp, recip, zero, 0.0);
        assert_slope!(signum_vjp, signum, zero, 0.0);
        assert_slope!(floor_vjp, floor, zero, 0.0);
    }
    for end in [-1.0, 1.0] {
        assert_slope!(asin_vjp, asin, end, 0.0);
        assert_slope!(acos_vjp, acos, end, 0.0);
        assert_slope!(floor_vjp, floor, end, 0.0);
    }
}

/// What the rules of the methods of `f64` alone say of a function of one variable at a point.
macro_rules! assert_float_slope {
    ($($vjp:ident at $x:expr;)*) => {$(
        for x in $x {
            assert_eq!(FloatRules::$vjp(x).1(1.0), 0.0, "{} at {x}", stringify!($vjp));
            assert_eq!(FloatRules::$vjp(x as f32).1(1.0), 0.0, "{} at {x}", stringify!($vjp));
        }
    )*};
}

#[test]
fn functions_of_one_float() {
    assert_float_slope! {
        cbrt_vjp at [0.0_f64, -0.0];
        log2_vjp at [0.0_f64, -0.0];
        log10_vjp at [0.0_f64, -0.0];
        ln_1p_vjp at [-1.0_f64];
        acosh_vjp at [1.0_f64];
        atanh_vjp at [-1.0_f64, 1.0];
        ceil_vjp at [0.0_f64, 1.0, 1.5];
        round_vjp at [0.5_f64, 1.0];
        round_ties_even_vjp at [0.5_f64, 1.0];
        trunc_vjp at [0.0_f64, 1.0];
    }
    assert_eq!(0.0_f64.hypot_vjp(-0.0).1(1.0), (0.0, 0.0));
    assert_eq!(1.0_f64.hypot_vjp(0.0).1(1.0), (1.0, 0.0));
    assert_eq!(0.0_f64.log_vjp(2.0).1(1.0), (0.0, 0.0));
    assert_eq!(2.0_f64.log_vjp(1.0).1(1.0), (0.0, 0.0));
    assert_eq!(2.0_f64.log_vjp(0.0).1(1.0), (0.0, 0.0));
    assert_eq!(2.0_f64.fract_vjp().1(1.0), 1.0);
    assert_eq!(4.0_f64.rem_euclid_vjp(2.0).1(1.0), (1.0, -2.0));
    assert_eq!(f64::MAX.hypot_vjp(f64::MAX).1(0.0), (0.0, 0.0));
    for bad in [f64::INFINITY, f64::NAN] {
        for pulled in [
            bad.cbrt_vjp().1(0.0),
            bad.sinh_vjp().1(0.0),
            bad.cosh_vjp().1(0.0),
            bad.asinh_vjp().1(0.0),
            bad.acosh_vjp().1(0.0),
            bad.atanh_vjp().1(0.0),
            bad.exp2_vjp().1(0.0),
            bad.exp_m1_vjp().1(0.0),
            bad.ln_1p_vjp().1(0.0),
            bad.log2_vjp().1(0.0),
            bad.log10_vjp().1(0.0),
        ] {
            assert_eq!(pulled, 0.0, "{bad}");
        }
        for pulled in
            [bad.hypot_vjp(bad).1(0.0), bad.log_vjp(bad).1(0.0), bad.rem_euclid_vjp(bad).1(0.0)]
        {
            assert_eq!(pulled, (0.0, 0.0), "{bad}");
        }
    }
}

#[differentiable]
fn built(x: f64, y: f64) -> f64 {
    let v = ad::rules::construct::dvec3(x, y * x, 2.0).project_onto(DVec3::new(y, 1.0, x));
    v.element_product() + v.fract().x
}

#[test]
fn vectors_by_function() {
    crate::oracle::check!(built(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    let (zero, g) = (DVec3::ZERO, DVec3::new(1.0, -2.0, 3.0));
    assert_eq!(DVec3::new(2.0, 0.0, 0.0).element_product_vjp().1(1.0), zero);
    assert_eq!(DVec3::new(2.0, 0.0, 3.0).element_product_vjp().1(1.0), DVec3::new(0.0, 6.0, 0.0));
    let bad = DVec3::splat(f64::INFINITY);
    assert_eq!(bad.element_product_vjp().1(0.0), zero);
    assert_eq!(bad.mul_add_vjp(bad, bad).1(zero), (zero, zero, zero));
    assert_eq!(bad.fract_vjp().1(zero), zero);
    assert_eq!(g.signum_vjp().1(g), zero);
}

#[differentiable]
fn conversions(x: f32, n: i32) -> f64 {
    let wide = f64::from(x);
    wide.cosh() * f64::from(n) + f64::hypot(wide, 2.0)
}

#[test]
fn conversions_of_floats_and_integers() {
    let (by_x, ()) = conversions::grad(0.5, 3);
    let x = 0.5_f64;
    let expected = 3.0 * x.sinh() + x / x.hypot(2.0);
    assert!((f64::from(by_x) - expected).abs() < 1e-6, "{by_x} is not {expected}");
}

#[test]
fn quotients() {
    for numerator in [0.0, 1.0, -1e300, f64::INFINITY] {
        for zero in [0.0, -0.0] {
            assert_eq!(numerator.div_pullback(zero, 1.0), (0.0, 0.0));
            let (by_numerator, by_denominator) = (
                dual(|x| x / Dual::constant(zero), numerator),
                dual(|x| Dual::constant(numerator) / x, zero),
            );
            assert_eq!((by_numerator, by_denominator), (0.0, 0.0));
            let (_, taped) = ad::tape::gradient(|v| v[0] / v[1], &[numerator, zero]);
            assert_eq!(taped, [0.0, 0.0]);
        }
    }
    let v = DVec3::new(1.0, 0.0, -2.0);
    assert_eq!(v.div_pullback(0.0, DVec3::ONE), (DVec3::ZERO, 0.0));
    let divisor = DVec3::new(0.0, 1.0, 2.0);
    let expected = (DVec3::new(0.0, 1.0, 0.5), DVec3::new(0.0, 0.0, 0.5));
    assert_eq!(v.div_pullback(divisor, DVec3::ONE), expected);
    assert_eq!(1.0.div_pullback(divisor, DVec3::ONE), (1.5, DVec3::new(0.0, -1.0, -0.25)));
}

#[test]
fn angles_at_the_origin() {
    for (y, x) in [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (-0.0, -0.0)] {
        assert_eq!(y.atan2_vjp(x).1(1.0), (0.0, 0.0));
        assert_eq!(Dual::new(y, 1.0).atan2(Dual::new(x, 1.0)).derivative, 0.0);
        let (_, taped) = ad::tape::gradient(|v| v[0].atan2(v[1]), &[y, x]);
        assert_eq!(taped, [0.0, 0.0]);
    }
}

/// Rounding may make the quotient of two numbers a whole one that is larger by one.
#[test]
fn remainders() {
    for (x, y) in [(1.0, 0.1), (-1.0, 0.1), (1.0, -0.1), (0.3, 0.1), (7.0, 2.5), (-7.0, 2.5)] {
        let [by_rest, by_euclid] = [x % y, f64::rem_euclid(x, y)].map(|rest| (rest - x) / y);
        let (rest, along_y) = x.rem_jvp(y, 0.0, 1.0);
        assert_eq!((rest, along_y), (x % y, by_rest.round()), "{x} % {y}");
        assert_eq!(x.rem_pullback(y, 1.0), (1.0, along_y), "{x} % {y}");
        assert_eq!(x.rem_euclid_vjp(y).1(1.0), (1.0, by_euclid.round()), "{x} rem_euclid {y}");
    }
}

/// Values and derivatives that are in range although products on the way are not.
#[test]
fn ends_that_are_in_range() {
    let close = |got: f64, expected: f64| assert!((got / expected - 1.0).abs() < 1e-6, "{got}");
    close(6e12_f32.powf_vjp(3.0).1(1.0).0.into(), 1.08e26);
    close(1.2e154.powf_vjp(2.0).1(1.0).0, 2.4e154);
    close(dual(|x| x.powf(Dual::constant(2.0)), 1.2e154), 2.4e154);
    for size in [1e-200, 1e200] {
        close(size.atan2_vjp(size).1(1.0).0, 0.5 / size);
        close(dual(|y| y.atan2(Dual::constant(size)), size), 0.5 / size);
    }
}

/// Where rotations and motions have no derivative, what is pulled back is 0.
#[test]
fn singular_rotations_and_motions() {
    let turn = DQuat::from_xyzw(0.1, 0.7, -0.3, 0.5);
    // Rounded to more than 1, as normalising may.
    let turn = turn.normalize() * (1.0 + 1e-15);
    for (a, b) in [(turn, turn), (turn, -turn), (DQuat::IDENTITY, -DQuat::IDENTITY)] {
        let zero = DQuat::from_array([0.0; 4]);
        assert_eq!(a.angle_between_vjp(b).1(1.0), (zero, zero), "cosine {}", a.dot(b));
    }
    let (by_from, by_to) = DQuat::from_rotation_arc_vjp(DVec3::X, -DVec3::X).1(DQuat::IDENTITY);
    assert_eq!((by_from, by_to), (DVec3::ZERO, DVec3::ZERO));
    let (flat, flat_plane) = (DAffine3::from_scale(DVec3::X), DAffine2::from_scale(DVec2::X));
    assert_eq!(flat.inverse_vjp().1(DAffine3::IDENTITY), DAffine3::ZERO);
    assert_eq!(flat_plane.inverse_vjp().1(DAffine2::IDENTITY), DAffine2::ZERO);
    assert_eq!(flat.matrix3.inverse_vjp().1(DMat3::IDENTITY), DMat3::ZERO);
}

#[test]
fn angles_at_infinity() {
    let far = f64::INFINITY;
    for (y, x) in [(1.0, far), (1.0, -far), (far, 1.0), (-far, 0.0), (far, far), (-far, -far)] {
        assert_eq!(y.atan2_vjp(x).1(1.0), (0.0, 0.0));
        for (along_y, along_x) in [(1.0, 1.0), (far, 1.0), (1.0, far), (-far, far)] {
            assert_eq!(y.atan2_jvp(x, along_y, along_x).1, 0.0);
            assert_eq!(Dual::new(y, along_y).atan2(Dual::new(x, along_x)).derivative, 0.0);
        }
        let (_, taped) = ad::tape::gradient(|v| v[0].atan2(v[1]), &[y, x]);
        assert_eq!(taped, [0.0, 0.0]);
    }
}

#[test]
fn powers() {
    for (base, exponent, to_base, to_exponent) in [
        (0.0, 1.0, 1.0, 0.0),
        (-0.0, 1.0, 1.0, 0.0),
        (0.0, 0.5, 0.0, 0.0),
        (0.0, 2.0, 0.0, 0.0),
        (0.0, 0.0, 0.0, 0.0),
        (0.0, -1.0, 0.0, 0.0),
        (-2.0, 3.0, 12.0, 0.0),
        (-2.0, -1.0, -0.25, 0.0),
        (0.5, f64::INFINITY, 0.0, 0.0),
        (-0.5, f64::INFINITY, 0.0, 0.0),
        (0.0, f64::INFINITY, 0.0, 0.0),
        (2.0, f64::NEG_INFINITY, 0.0, 0.0),
        (f64::INFINITY, -1.0, 0.0, 0.0),
        (f64::INFINITY, f64::NEG_INFINITY, 0.0, 0.0),
    ] {
        let at = format!("{base} to the {exponent}");
        assert_eq!(base.powf_vjp(exponent).1(1.0), (to_base, to_exponent), "{at}");
        assert_eq!(dual(|x| x.powf(Dual::constant(exponent)), base), to_base, "{at}");
        assert_eq!(dual(|y| Dual::constant(base).powf(y), exponent), to_exponent, "{at}");
        let (_, taped) = ad::tape::gradient(|v| v[0].powf(v[1]), &[base, exponent]);
        assert_eq!(taped, [to_base, to_exponent], "{at}");
    }
    for (exponent, expected) in [(1, 1.0), (0, 0.0), (2, 0.0), (-1, 0.0), (i32::MIN, 0.0)] {
        assert_eq!(0.0.powi_vjp(exponent).1(1.0).0, expected, "0 to the {exponent}");
        assert_eq!(dual(|x| x.powi(exponent), 0.0), expected, "0 to the {exponent}");
        let (_, taped) = ad::tape::gradient(|v| v[0].powi(exponent), &[0.0]);
        assert_eq!(taped[0], expected, "0 to the {exponent}");
    }
}

#[test]
fn ties() {
    assert_eq!(2.0.min_vjp(2.0).1(3.0), (3.0, 0.0));
    assert_eq!(2.0.max_vjp(2.0).1(3.0), (3.0, 0.0));
    for bound in [1.0, 2.0] {
        assert_eq!(bound.clamp_vjp(1.0, 2.0).1(3.0), (3.0, 0.0, 0.0));
        let constant = Dual::constant;
        assert_eq!(dual(|x| x.clamp(constant(1.0), constant(2.0)), bound), 1.0);
    }
    // A value that is none stays none.
    let clamped = Dual::new(f64::NAN, 1.0).clamp(Dual::constant(1.0), Dual::constant(2.0));
    assert!(clamped.value.is_nan());
    let taped = |v: &[ad::tape::Var]| v[0].clamp(v[1], v[2]);
    assert!(ad::tape::gradient(taped, &[f64::NAN, 1.0, 2.0]).0.is_nan());
    let (moving, fixed) = (Dual::new(2.0, 1.0), Dual::constant(2.0));
    assert_eq!(moving.min(fixed).derivative, 1.0);
    assert_eq!(fixed.min(moving).derivative, 0.0);
    assert_eq!(moving.max(fixed).derivative, 1.0);
    assert_eq!(fixed.max(moving).derivative, 0.0);

    let (v, w) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 0.0, 4.0));
    let g = DVec3::new(5.0, 6.0, 7.0);
    assert_eq!(v.min_vjp(w).1(g), (DVec3::new(5.0, 0.0, 7.0), DVec3::new(0.0, 6.0, 0.0)));
    assert_eq!(v.max_vjp(w).1(g), (DVec3::new(5.0, 6.0, 0.0), DVec3::new(0.0, 0.0, 7.0)));
    let (low, high) = (DVec3::ONE, DVec3::new(3.0, 1.5, 3.0));
    let expected = (DVec3::new(5.0, 0.0, 7.0), DVec3::ZERO, DVec3::new(0.0, 6.0, 0.0));
    assert_eq!(v.clamp_vjp(low, high).1(g), expected);
    let (one, moving) = (DVec3::ONE, Dual::new(1.0, 1.0));
    for (x, to_low, to_high) in [(0.5, 1.0, 0.0), (1.0, 0.0, 0.0), (1.5, 0.0, 1.0)] {
        let expected = (one * (x == 1.0) as u8 as f64, one * to_low, one * to_high);
        assert_eq!((one * x).clamp_vjp(one, one).1(one), expected, "bounds that coincide, {x}");
        assert_eq!(x.clamp_vjp(1.0, 1.0).1(1.0), (expected.0.x, to_low, to_high));
        assert_eq!(dual(|x| x.clamp(moving, Dual::constant(1.0)), x).abs(), expected.0.x + to_low);
    }

    for tied in [DVec3::new(1.0, 1.0, 1.0), DVec3::new(0.0, -0.0, 0.0)] {
        assert_eq!(tied.min_element_vjp().1(2.0), DVec3::new(2.0, 0.0, 0.0));
        assert_eq!(tied.max_element_vjp().1(2.0), DVec3::new(2.0, 0.0, 0.0));
    }
    assert_eq!(DVec3::new(0.0, 4.0, 4.0).max_element_vjp().1(2.0), DVec3::new(0.0, 2.0, 0.0));
}

#[test]
fn signs() {
    assert_eq!(3.0.copysign_vjp(-2.0).1(1.0), (-1.0, 0.0));
    assert_eq!(0.0.copysign_vjp(-2.0).1(1.0), (0.0, 0.0));
    assert_eq!((-3.0).copysign_vjp(-0.0).1(1.0), (1.0, 0.0));
    assert_eq!(dual(|sign| Dual::constant(3.0).copysign(sign), 1.0), 0.0);
    assert_eq!(dual(|x| x.copysign(Dual::constant(-2.0)), 0.0), 0.0);
}

#[test]
fn zero_vectors() {
    let (zero, g) = (DVec3::ZERO, DVec3::new(1.0, -2.0, 3.0));
    assert_eq!(zero.length_vjp().1(1.0), zero);
    assert_eq!(zero.length_recip_vjp().1(1.0), zero);
    assert_eq!(zero.normalize_or_zero_vjp().1(g), zero);
    assert_eq!(g.distance_vjp(g).1(1.0), (zero, zero));
    assert_eq!(Vec3::ZERO.length_vjp().1(1.0), Vec3::ZERO);

    // glam refuses to normalize a zero vector in some builds; the vectors of other scalars do not.
    let moving = |x: f64| Dual::new(x, 1.0);
    let still = Xyz { x: moving(0.0), y: moving(0.0), z: moving(0.0) };
    let ones = Xyz { x: moving(1.0), y: moving(1.0), z: moving(1.0) };
    use ad::vector::Vector;
    let pulled = still.normalize_vjp().1(ones);
    assert_eq!([pulled.x, pulled.y, pulled.z].map(|s| (s.value, s.derivative)), [(0.0, 0.0); 3]);
    assert_eq!(still.length().derivative, 0.0);
    assert_eq!(still.length_recip().derivative, 0.0);
    assert_eq!(still.distance(still).derivative, 0.0);
    assert_eq!(still.normalize_or_zero(), Xyz::ZERO);
}

/// A cotangent of zero stays zero, whatever it meets.
#[test]
fn zero_cotangents() {
    let (zero, bad_numbers) = (DVec3::ZERO, [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 0.0]);
    for bad in bad_numbers {
        for g in [0.0, -0.0] {
            for pulled in [
                bad.abs_vjp().1(g),
                bad.signum_vjp().1(g),
                bad.floor_vjp().1(g),
                bad.recip_vjp().1(g),
                bad.sqrt_vjp().1(g),
                bad.exp_vjp().1(g),
                bad.ln_vjp().1(g),
                bad.powi_vjp(-3).1(g).0,
                bad.powi_vjp(0).1(g).0,
                bad.sin_vjp().1(g),
                bad.cos_vjp().1(g),
                bad.tan_vjp().1(g),
                bad.asin_vjp().1(g),
                bad.acos_vjp().1(g),
                bad.atan_vjp().1(g),
                bad.tanh_vjp().1(g),
                bad.sin_cos_vjp().1((g, g)),
                bad.to_degrees_vjp().1(g),
            ] {
                assert_eq!(pulled, 0.0, "{bad}");
            }
            for pulled in [
                bad.mul_pullback(bad, g),
                bad.div_pullback(bad, g),
                bad.rem_pullback(bad, g),
                bad.min_vjp(1.0).1(g),
                bad.max_vjp(bad).1(g),
                bad.copysign_vjp(bad).1(g),
                bad.powf_vjp(bad).1(g),
                bad.powf_vjp(0.5).1(g),
                bad.atan2_vjp(bad).1(g),
            ] {
                assert_eq!(pulled, (0.0, 0.0), "{bad}");
            }
            assert_eq!(bad.mul_add_vjp(bad, bad).1(g), (0.0, 0.0, 0.0));
            let pulled = f64::difference_of_products_vjp(bad, bad, bad, bad).1(g);
            assert_eq!(pulled, (0.0, 0.0, 0.0, 0.0));

            let v = DVec3::new(bad, 1.0, bad);
            for pulled in [
                v.length_vjp().1(g),
                v.length_squared_vjp().1(g),
                v.length_recip_vjp().1(g),
                v.min_element_vjp().1(g),
                v.max_element_vjp().1(g),
                v.abs_vjp().1(zero),
                v.recip_vjp().1(zero),
                v.exp_vjp().1(zero),
                v.sqrt_vjp().1(zero),
                v.powf_vjp(bad).1(zero).0,
                v.normalize_or_zero_vjp().1(zero),
                v.dot_vjp(v).1(g).0,
                v.dot_vjp(v).1(g).1,
                v.distance_vjp(v).1(g).0,
                v.distance_squared_vjp(-v).1(g).1,
                v.cross_vjp(v).1(zero).0,
                v.cross_vjp(v).1(zero).1,
                v.min_vjp(v).1(zero).0,
                v.lerp_vjp(-v, bad).1(zero).0,
                v.mul_pullback(v, zero).0,
                v.mul_pullback(bad, zero).0,
                v.div_pullback(v, zero).1,
                v.div_pullback(bad, zero).0,
            ] {
                assert_eq!(pulled, zero, "{bad}");
            }
            assert_eq!(v.powf_vjp(bad).1(zero).1, 0.0);
            assert_eq!(v.lerp_vjp(-v, bad).1(zero).2, 0.0);
            assert_eq!(v.mul_pullback(bad, zero).1, 0.0);
            assert_eq!(v.div_pullback(bad, zero).1, 0.0);
        }
    }
}

/// A reflection asserts a normal of length 1 in some builds of glam, so the vectors of other
/// scalars stand in.
#[test]
fn zero_cotangent_of_a_reflection() {
    for bad in [f64::INFINITY, f64::NAN] {
        let v = Xyz { x: bad, y: bad, z: bad };
        let zero = Xyz { x: 0.0, y: 0.0, z: 0.0 };
        assert_eq!(v.reflect_vjp(v).1(zero), (zero, zero));
    }
}

/// No rule makes a NaN of finite numbers where the function itself is not NaN.
#[test]
fn ends_of_the_range() {
    let tiny = f64::from_bits(1);
    let magnitudes = [0.0, tiny, 1e-310, 1e-200, 1e-30, 1.0, 1e30, 1e200, f64::MAX];
    let numbers: Vec<_> = magnitudes.into_iter().flat_map(|x| [x, -x]).collect();
    let check = |name: &str, value: f64, pulled: &[f64], at: &[f64]| {
        let silent = value.is_nan() || pulled.iter().all(|p| !p.is_nan());
        assert!(silent, "{name} at {at:?} pulls back {pulled:?}");
    };
    macro_rules! unary {
        ($x:expr, $($vjp:ident)*) => {$(
            let (value, pullback) = $x.$vjp();
            check(stringify!($vjp), value, &[pullback(1.0)], &[$x]);
            let x = Dual::new($x, 1.0);
            let (value, pullback) = x.$vjp();
            let pulled = pullback(Dual::constant(1.0));
            check(stringify!($vjp), value.value, &[pulled.value], &[$x]);
        )*};
    }
    for &x in &numbers {
        unary!(x, abs_vjp signum_vjp floor_vjp recip_vjp sqrt_vjp exp_vjp ln_vjp sin_vjp cos_vjp
            tan_vjp asin_vjp acos_vjp atan_vjp tanh_vjp);
        for n in [i32::MIN, -2, -1, 0, 1, 2, 3, i32::MAX] {
            let (value, pullback) = x.powi_vjp(n);
            check("powi", value, &[pullback(1.0).0], &[x, n.into()]);
        }
        for &y in &numbers {
            macro_rules! binary {
                ($($name:literal $call:expr;)*) => {$(
                    let (value, pullback) = $call;
                    let (a, b) = pullback(1.0);
                    check($name, value, &[a, b], &[x, y]);
                )*};
            }
            binary! {
                "powf" x.powf_vjp(y);
                "atan2" x.atan2_vjp(y);
                "min" x.min_vjp(y);
                "max" x.max_vjp(y);
                "copysign" x.copysign_vjp(y);
                "mul" (x * y, |g| x.mul_pullback(y, g));
                "div" (x / y, |g| x.div_pullback(y, g));
            }
            for &z in &numbers {
                let v = DVec3::new(x, y, z);
                check("length", v.length(), &v.length_vjp().1(1.0).to_array(), &[x, y, z]);
                let (value, pullback) = v.length_recip_vjp();
                check("length_recip", value, &pullback(1.0).to_array(), &[x, y, z]);
                let (value, pullback) = v.normalize_or_zero_vjp();
                let pulled = pullback(DVec3::ONE).to_array();
                check("normalize_or_zero", value.element_sum(), &pulled, &[x, y, z]);
            }
        }
    }
}

#[differentiable]
fn guarded(x: f64) -> f64 {
    let root = (-x).sqrt().abs().copysign(x);
    select(x < 0.0, root.ln() * root.powf(0.5), x.acos().abs() / x)
}

/// The arm that `select` did not take computes infinities and NaNs; the gradient is that of the
/// other one.
#[test]
fn select_keeps_the_other_arm_out() {
    for x in [0.0, -0.0, 0.5, 2.0, 1e30, 1e-310] {
        let expected = ad::check::derivative(|x: f64| x.acos().abs() / x, 0.5, 0.01).value;
        let slope = guarded::grad(x);
        match x {
            0.5 => crate::oracle::assert_close("guarded", slope, expected, 1e-7),
            2.0 | 1e30 => assert!(slope.is_nan(), "acos has no value there"),
            _ => assert!(!slope.is_nan(), "at {x}: {slope}"),
        }
    }
}

/// Enough products that the reverse sweep is written for finite factors too.
#[differentiable]
fn overflowing(x: f64, y: f64) -> f64 {
    // Infinite at x = 0, and for large x; neither reaches the value.
    let quotient = y / x;
    let scaled = quotient * y * x + quotient * quotient * y;
    let grown = x * x * x * x * y * y;
    let squashed = 1.0 / (1.0 + grown * grown);
    let mut sum = select(x == 0.0, y * y, scaled * x * y);
    for i in 0..3 {
        let unused = grown * grown * y * i as f64;
        if x < 1.0 && x > -1.0 {
            sum += unused * x * y;
        }
    }
    sum + squashed * y
}

/// The product of no iteration but the last overflows, and nothing reads it.
#[differentiable]
fn overflowing_at_the_end(x: f64, y: f64) -> f64 {
    let mut states = [x; 6];
    let mut read = 0.0;
    for i in 0..5 {
        read += states[i] * y * x + x * x * y;
        states[i + 1] = states[i] * states[i] * y * x;
    }
    read
}

/// A variable is read, overwritten, and assigned what was read before.
#[differentiable]
#[allow(unused_assignments)]
fn stale_sum(x: f64, y: f64) -> f64 {
    let mut sum = y;
    for i in 0..3 {
        let before = sum;
        sum = before + x * x * x * y * y * i as f64;
        sum = before + x * y * 0.5 + y * y * x * 0.25 + x * x * y * 0.125;
    }
    sum
}

/// The only infinity is a quotient in a block.
#[differentiable]
fn divided(x: f64, y: f64) -> f64 {
    let many = x * y * y * x + y * y * y * x + x * x * x * y + x * x * y * y;
    let quotient = y / x;
    select(x == 0.0, many, quotient + y)
}

/// The only infinity is a term of a sum.
#[differentiable]
fn divided_in_a_sum(x: f64, y: f64) -> f64 {
    let many = x * y * y * x + y * y * y * x + x * x * x * y + x * x * y * y;
    let mut sum = 0.0;
    for _ in 0..3 {
        sum += y / x;
    }
    select(x == 0.0, many, sum)
}

/// The only infinity is what a loop goes on with.
#[differentiable]
fn divided_in_a_loop(x: f64, y: f64) -> f64 {
    let many = x * y * y * x + y * y * y * x + x * x * x * y + x * x * y * y;
    let mut state = y;
    for _ in 0..3 {
        state = state / x - state;
    }
    select(x == 0.0, many, state)
}

/// A mere sum, of which a caller asks nothing where it is not finite.
#[differentiable]
fn sum_of_squares(xs: &[f64], y: f64) -> f64 {
    let mut sum = 0.0;
    for x in xs {
        sum += x * x * y;
    }
    sum
}

#[differentiable]
fn unasked(x: f64, y: f64) -> f64 {
    let sum = sum_of_squares(&[y / x, y], y / x);
    select(x == 0.0, x * y, sum)
}

/// What is read before the loop enters the value; what the loop makes of it does not always.
#[differentiable]
fn read_before(x: f64, y: f64) -> f64 {
    let mut state = y;
    let before = state;
    for _ in 0..3 {
        state = state * state * (1.0 / x);
    }
    let after = if x == 0.0 { y } else { state };
    before * x + after
}

/// The value tells of factors in loops only where they enter it, and only to who asks for it.
#[test]
fn sums_that_are_not_finite() {
    assert_eq!(unasked::grad(0.0, 3.0), (3.0, 0.0));
    assert_eq!(read_before::grad(0.0, 3.0), (3.0, 1.0));
    let grown = sum_of_squares::vjp(&[f64::INFINITY, 2.0], 3.0).1;
    assert_eq!(grown(0.0), (vec![0.0, 0.0], 0.0));
}

/// Zero cotangents annihilate what denominators of zero make.
#[test]
fn quotients_that_are_not_finite() {
    for (f, grad) in [
        (divided as fn(f64, f64) -> f64, divided::grad as fn(f64, f64) -> (f64, f64)),
        (divided_in_a_sum, divided_in_a_sum::grad),
        (divided_in_a_loop, divided_in_a_loop::grad),
    ] {
        assert_eq!(grad(0.0, 3.0), (27.0, 0.0));
        assert_eq!(grad(-0.0, 3.0), (27.0, 0.0));
        for (x, y) in [(0.5, 0.7), (-2.0, 1.5)] {
            let (by_x, by_y) = grad(x, y);
            let along_x = ad::check::derivative(|x| f(x, y), x, 1e-3);
            let along_y = ad::check::derivative(|y| f(x, y), y, 1e-3);
            crate::oracle::assert_close("divided", by_x, along_x.value, 1e-7);
            crate::oracle::assert_close("divided", by_y, along_y.value, 1e-7);
        }
    }
    // The cotangent of the numerator overflows, the quotient is zero.
    for grad in [divided::grad, divided_in_a_sum::grad] {
        assert_eq!(grad(1e-310, 0.0), (0.0, f64::INFINITY));
    }
}

/// Zero cotangents annihilate infinite factors of inlined products.
#[test]
fn products_that_are_not_finite() {
    let slope = |f: fn(f64, f64) -> f64, x: f64, y: f64| {
        let along_x = ad::check::derivative(|x| f(x, y), x, 1e-3 * x.abs());
        let along_y = ad::check::derivative(|y| f(x, y), y, 1e-3 * y.abs());
        [along_x.value, along_y.value]
    };
    for (x, y) in [(0.5, 0.7), (-2.0, 1.5), (3.0, -0.5)] {
        let (by_x, by_y) = overflowing::grad(x, y);
        let expected = slope(overflowing, x, y);
        crate::oracle::assert_close("overflowing", by_x, expected[0], 1e-7);
        crate::oracle::assert_close("overflowing", by_y, expected[1], 1e-7);
    }
    assert_eq!(overflowing::grad(0.0, 3.0), (0.0, 7.0));
    for x in [1e80, -1e100] {
        let (by_x, by_y) = overflowing::grad(x, 1.0);
        assert!(by_x.is_finite() && by_y.is_finite(), "{by_x} {by_y}");
    }

    // The last state would be 1e378.
    let (by_x, by_y) = overflowing_at_the_end::grad(1e6, 1.0);
    assert!(by_x.is_finite() && by_y.is_finite(), "{by_x} {by_y}");

    let (x, y) = (1e70, 1e60);
    let (by_x, by_y) = stale_sum::grad(x, y);
    let (small_x, small_y) = stale_sum::grad(1e10, 1e-3);
    assert!(by_x.is_finite() && by_y.is_finite(), "{by_x} {by_y}");
    let expected = slope(stale_sum, 1e10, 1e-3);
    assert!((small_x / expected[0] - 1.0).abs() < 1e-6, "{small_x} is not {}", expected[0]);
    assert!((small_y / expected[1] - 1.0).abs() < 1e-6, "{small_y} is not {}", expected[1]);
}
