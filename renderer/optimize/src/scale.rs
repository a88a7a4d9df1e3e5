//! What the numbers of a parameter are steps of.

use serde::{Deserialize, Serialize};

/// The scale on which a variable is optimised.
///
/// On a logarithmic scale every method takes its steps in `u = ln x`: the gradient by `u` is `x` times that by `x`, a
/// step of `u` multiplies `x`, and `x` stays above 0 without a bound. Numbers that are off by a factor of a hundred are
/// as far away there as those that are off by a hundredth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Scale {
    /// The numbers themselves.
    #[default]
    Linear,
    /// Their natural logarithms.
    Log,
}

impl Scale {
    /// The learning rate of a variable on a logarithmic scale that names none: a step of a tenth.
    pub const LOG_RATE: f64 = 0.1;

    /// The place of a number on the scale. What is not above 0 is infinitely far down a logarithmic one.
    pub fn place(self, x: f64) -> f64 {
        match self {
            Self::Linear => x,
            Self::Log => x.max(0.0).ln(),
        }
    }

    /// The number at a place on the scale.
    pub(super) fn number(self, place: f64) -> f64 {
        match self {
            Self::Linear => place,
            Self::Log => place.exp(),
        }
    }

    /// The derivative of a number by its place on the scale.
    pub(super) fn slope(self, x: f64) -> f64 {
        match self {
            Self::Linear => 1.0,
            Self::Log => x,
        }
    }

    /// The number that is `by` farther up the scale than `x`.
    pub(super) fn moved(self, x: f64, by: f64) -> f64 {
        match self {
            Self::Linear => x + by,
            Self::Log => x * by.exp(),
        }
    }

    /// The least finite number of the scale.
    pub(super) fn least(self) -> f64 {
        match self {
            Self::Linear => f64::MIN,
            Self::Log => f64::MIN_POSITIVE,
        }
    }
}
