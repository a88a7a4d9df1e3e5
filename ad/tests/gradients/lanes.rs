//! Lanes against single numbers: values, derivatives, singular points.

use ad::lanes::{Lanes, f32x8, f32x16, f64x8};
use ad::rules::RealRules;
use ad::{Mask, Real, Scalar};

/// Moderate numbers of both signs, tiny and huge ones, and the singular points.
const INPUTS: [f64; 24] = [
    0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 0.999_999, 0.25, 2.0, -2.0, 3.7, 10.0, -7.25, 0.01, 1e-3,
    -1e-3, 1e-10, 1e-20, 31.0, 88.0, -80.0, 1e4, 0.7, -0.3,
];

fn assert_near<S: Scalar>(name: &str, inputs: &[S], lanes: S, single: S) {
    let (lanes, single) = (lanes.to_f64(), single.to_f64());
    let tolerance = 25.0 * S::EPSILON.to_f64() * single.abs() + 1e-36;
    let equal = lanes == single || (lanes.is_nan() && single.is_nan());
    assert!(
        equal || (lanes - single).abs() <= tolerance,
        "{name} of {inputs:?}: {lanes} in lanes, {single} alone"
    );
}

fn element<L: Lanes>(x: f64) -> L::Element {
    L::Element::from_f64(x)
}

/// Value and derivative of a function of one number, lane by lane.
macro_rules! unary {
    ($lanes:ty: $($name:ident $vjp:ident),*) => {$(
        for first in 0..INPUTS.len() {
            let input = |lane: usize| element::<$lanes>(INPUTS[(first + lane) % INPUTS.len()]);
            let x = <$lanes>::from_lanes(input);
            let (values, pullback) = x.$vjp();
            let derivatives = pullback(<$lanes as Real>::ONE);
            assert_eq!(values.lanes().as_ref().len(), <$lanes>::COUNT);
            for lane in 0..<$lanes>::COUNT {
                let (value, pullback) = RealRules::$vjp(input(lane));
                let name = stringify!($name);
                let at = [input(lane)];
                assert_near(name, &at, values.lanes().as_ref()[lane], value);
                let derivative = derivatives.lanes().as_ref()[lane];
                assert_near(&format!("derivative of {name}"), &at, derivative, pullback(1.0));
            }
        }
    )*};
}

/// The same for functions of two numbers, over all pairs.
macro_rules! binary {
    ($lanes:ty: $($name:ident $vjp:ident),*) => {$(
        for other in INPUTS.map(element::<$lanes>) {
            for first in (0..INPUTS.len()).step_by(<$lanes>::COUNT) {
                let input = |lane: usize| element::<$lanes>(INPUTS[(first + lane) % INPUTS.len()]);
                let x = <$lanes>::from_lanes(input);
                let (values, pullback) = x.$vjp(<$lanes>::from_lanes(|_| other));
                let (by_x, by_y) = pullback(<$lanes as Real>::ONE);
                for lane in 0..<$lanes>::COUNT {
                    let (value, pullback) = RealRules::$vjp(input(lane), other);
                    let expected = pullback(1.0);
                    let name = stringify!($name);
                    let at = [input(lane), other];
                    assert_near(name, &at, values.lanes().as_ref()[lane], value);
                    let of = |name: &str| format!("derivative of {name}");
                    assert_near(&of(name), &at, by_x.lanes().as_ref()[lane], expected.0);
                    assert_near(&of(name), &at, by_y.lanes().as_ref()[lane], expected.1);
                }
            }
        }
    )*};
}

macro_rules! every_rule {
    ($lanes:ty) => {
        unary!($lanes: abs abs_vjp, signum signum_vjp, floor floor_vjp, recip recip_vjp,
            sqrt sqrt_vjp, exp exp_vjp, ln ln_vjp, atan atan_vjp);
        binary!($lanes: min min_vjp, max max_vjp, copysign copysign_vjp);
    };
}

#[test]
fn lanes_compute_what_single_numbers_do() {
    every_rule!(f32x8);
    every_rule!(f32x16);
    every_rule!(f64x8);
}

/// The powers that shading needs: a base in [0, 1], an exponent of 0 or more.
#[test]
fn powers() {
    for exponent in [0.0, 0.5, 1.0, 2.0, 8.0, 96.078, 1000.0_f32] {
        for first in 0..64 {
            let base = |lane: usize| ((first * 16 + lane) % 1024) as f32 / 1023.0;
            let (values, pullback) =
                f32x16::from_lanes(base).powf_vjp(f32x16::from_lanes(|_| exponent));
            let (by_base, by_exponent) = pullback(<f32x16 as Real>::ONE);
            for lane in 0..16 {
                let (value, pullback) = RealRules::powf_vjp(base(lane), exponent);
                let (to_base, to_exponent) = pullback(1.0);
                // The relative error of a power grows with the logarithm of the result.
                let tolerance = |x: f32| 1e-5 * x.abs() * (1.0 + exponent.ln_1p()) + 1e-30;
                let pairs = [(values, value), (by_base, to_base), (by_exponent, to_exponent)];
                for (lanes, single) in pairs {
                    let lanes = lanes.lanes().as_ref()[lane];
                    assert!(
                        (lanes - single).abs() <= tolerance(single),
                        "{} ^ {exponent}: {lanes} in lanes, {single} alone",
                        base(lane)
                    );
                }
            }
        }
    }
}

#[test]
fn differences_of_products_do_not_cancel() {
    for i in 0..200 {
        let a = 1.0 + i as f32 * f32::EPSILON;
        let (b, c, d) = (1.0 - i as f32 * f32::EPSILON, 1.0 + 3.0 * f32::EPSILON, 1.0_f32);
        let exact = f64::from(a) * f64::from(b) - f64::from(c) * f64::from(d);
        let [a, b, c, d] = [a, b, c, d].map(|x| f32x8::from_lanes(|_| x));
        let lanes = f32x8::difference_of_products(a, b, c, d).lanes().as_ref()[3];
        assert!((f64::from(lanes) - exact).abs() <= 2.4e-7 * exact.abs(), "{lanes} {exact}");
    }
}

#[test]
fn masks() {
    let mask = f32x8::mask_from_bits(0b0100_1001);
    assert_eq!(f32x8::mask_bits(mask), 0b0100_1001);
    assert_eq!(f32x8::mask_bits(!mask), 0b1011_0110);
    assert!(mask.any() && !mask.all());
    assert!(<f32x8 as ad::Select>::Mask::splat(true).all());
    assert!(!<f32x8 as ad::Select>::Mask::splat(false).any());
    assert_eq!(f32::mask_bits(f32::mask_from_bits(1)), 1);
}
