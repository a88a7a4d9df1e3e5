//! The first-order methods at work.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::adam::Moments;
use super::{Adam, AdamW, RmsProp, Sgd};
use crate::Carry;

/// A method and what it remembers from step to step, one number or more for each element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) enum FirstOrder {
    Adam(Adam, Moments),
    AdamW(AdamW, Moments),
    /// The velocity.
    Sgd(Sgd, Vec<f64>),
    /// The root mean square of the gradient.
    RmsProp(RmsProp, Vec<f64>),
}

impl FirstOrder {
    pub fn adam(adam: Adam, len: usize) -> Self {
        Self::Adam(adam, Moments::new(len))
    }

    pub fn adam_w(adam_w: AdamW, len: usize) -> Self {
        Self::AdamW(adam_w, Moments::new(len))
    }

    /// Returns `true` if the memory is that of `len` elements.
    pub fn fits(&self, len: usize) -> bool {
        match self {
            Self::Adam(_, moments) | Self::AdamW(_, moments) => moments.fits(len),
            Self::Sgd(_, memory) | Self::RmsProp(_, memory) => memory.len() == len,
        }
    }

    /// What it remembers, of other elements.
    pub fn carry(&mut self, carry: &Carry) {
        match self {
            Self::Adam(_, moments) | Self::AdamW(_, moments) => moments.carry(carry),
            Self::Sgd(_, memory) | Self::RmsProp(_, memory) => *memory = carry(memory),
        }
    }

    /// Takes in the gradient at `x`, and turns it into the direction against which to move: the
    /// step for the learning rate 1. What is finite stays finite. `blocks` are the elements of each variable.
    pub fn direction(&mut self, x: &[f64], gradient: &mut [f64], blocks: &[Range<usize>]) {
        match self {
            Self::Adam(adam, moments) => adam.direction(moments, gradient, blocks),
            Self::AdamW(adam_w, moments) => adam_w.direction(moments, x, gradient, blocks),
            Self::Sgd(sgd, velocity) => sgd.direction(velocity, gradient),
            Self::RmsProp(rms_prop, rms) => rms_prop.direction(rms, gradient),
        }
    }
}
