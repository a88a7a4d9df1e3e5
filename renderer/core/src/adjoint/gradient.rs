//! Gradients.

use crate::scene::ParameterId;

/// Derivatives by parameters of a scene, each in the shape of its parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient {
    blocks: Vec<(ParameterId, Vec<f64>)>,
}

impl Gradient {
    pub(super) fn new(blocks: Vec<(ParameterId, Vec<f64>)>) -> Self {
        Self { blocks }
    }

    /// The derivatives by one of the parameters that were asked for; nothing by others.
    pub fn get(&self, id: ParameterId) -> &[f64] {
        self.blocks.iter().find(|(of, _)| *of == id).map_or(&[], |(_, block)| block)
    }

    /// The derivatives by all parameters, one after the other in the order in which they were asked for.
    pub fn concat(&self) -> Vec<f64> {
        self.blocks.iter().flat_map(|(_, block)| block).copied().collect()
    }

    /// The parameters that were asked for, with the derivatives.
    pub fn iter(&self) -> impl Iterator<Item = (ParameterId, &[f64])> {
        self.blocks.iter().map(|(id, block)| (*id, &block[..]))
    }

    /// Multiplies all derivatives.
    pub(super) fn scale(&mut self, factor: f64) {
        let numbers = self.blocks.iter_mut().flat_map(|(_, block)| block);
        numbers.for_each(|value| *value *= factor);
    }
}

/// A loss and its gradient.
#[derive(Clone, Debug, PartialEq)]
pub struct LossAndGradient {
    /// The loss.
    pub loss: f64,
    /// The derivatives by the parameters that were asked for.
    pub gradient: Gradient,
}
