//! Against digits from tables, and against identities that hold exactly.

use std::f64::consts::{E, LN_10, SQRT_2};

use ad::Real;

use super::{Extended, LN_2};

/// Asserts that two numbers agree to 28 digits.
fn assert_same(found: Extended, expected: Extended) {
    let error = (found - expected).abs() / expected.abs();
    assert!(error.high <= 1e-28, "{found:?} instead of {expected:?}");
}

fn x(high: f64, low: f64) -> Extended {
    Extended::sum(high, low)
}

#[test]
fn constants_have_their_digits() {
    let n = Extended::new;
    assert_same(n(1.0).exp(), x(E, 1.4456468917292502e-16));
    assert_same(n(2.0).ln(), LN_2);
    assert_same(n(2.0).sqrt(), x(SQRT_2, -9.667293313452913e-17));
    assert_same(n(1.0).atan() * n(4.0), Extended::PI);
    assert_same(n(10.0).ln(), x(LN_10, -2.1707562233822494e-16));
    assert_same((Extended::PI / n(6.0)).sin(), n(0.5));
    assert_same((Extended::PI / n(3.0)).cos(), n(0.5));
    assert_same((Extended::PI / n(4.0)).tan(), n(1.0));
    assert_same(n(0.5).asin() * n(6.0), Extended::PI);
    assert_same(n(0.5).acos() * n(3.0), Extended::PI);
    assert_same(n(3.0).powf(n(-30.0)), n(1.0) / n(205_891_132_094_649.0));
    assert_same(n(-3.0).atan2(n(-3.0)) * n(-4.0), Extended::PI * n(3.0));
}

#[test]
fn identities_hold() {
    let n = Extended::new;
    for i in 1..200 {
        let a = n(f64::from(i) * 0.37 - 20.0) + n(1e-17 * f64::from(i));
        let b = n(f64::from(i * i % 83) + 0.1);
        assert_same(a / b * b, a);
        assert_same(b.sqrt() * b.sqrt(), b);
        assert_same(b.ln().exp(), b);
        let (sin, cos) = a.sin_cos();
        assert_same(sin * sin + cos * cos, n(1.0));
        let positive = a.abs();
        let (sum, product) = (positive + b, positive * b);
        assert_same(sum * sum, a * a + b * b + product + product);
        assert_same(sin.atan2(cos).tan(), a.tan());
        assert!((a.floor() <= a) && (a - a.floor()) < n(1.0));
    }
}
