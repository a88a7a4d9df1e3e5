//! The inherent methods of `f32` and `f64`, and those of `Real`, which take their receiver by value.

use crate::names::is_in;

/// Those that return a number of the same type.
const TO_NUMBER: &str = "\
    abs acos acosh asin asinh atan atan2 atanh cbrt ceil clamp copysign cos cosh div_euclid exp \
    exp2 exp_m1 floor fract hypot ln ln_1p log log10 log2 max midpoint min mul_add powf powi recip \
    rem_euclid round round_ties_even signum sin sinh sqrt tan tanh to_degrees to_radians trunc";

/// Those that `Real` has, too.
const OF_REAL: &str = "\
    abs acos asin atan atan2 clamp copysign cos exp floor ln max min mul_add powf powi recip \
    signum sin sqrt tan tanh";

/// Whether a method of `Real` of this name returns a number of the same type.
pub fn real_returns_number(method: &str) -> bool {
    is_in(OF_REAL, method)
}

/// Whether a method of numbers of this name returns a number of the same type.
pub fn returns_number(method: &str) -> bool {
    is_in(TO_NUMBER, method)
}

/// Whether a method of this name takes a number by value.
pub fn takes_number(method: &str) -> bool {
    returns_number(method) || method == "sin_cos"
}
