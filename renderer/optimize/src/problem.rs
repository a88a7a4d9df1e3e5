//! What is minimised.

use renderer_core::Error;

use super::{Change, Topology, Variable};

/// A function to minimise, with its gradient.
pub trait Objective {
    /// Loss and gradient at `x`.
    ///
    /// A resumed run is bit for bit the uninterrupted one only if this depends on nothing but `x` and the
    /// iteration that was [begun](Self::begin).
    fn evaluate(&mut self, x: &[f64]) -> Evaluation;

    /// Told the number of each iteration before it is evaluated, also of the first after a run is resumed, and
    /// how many [levels](super::Settings::coarse_to_fine) it is away from the finest. An objective that is a
    /// sample, such as a few of many views, takes the sample from this alone, so that a resumed run is bit for
    /// bit the uninterrupted one.
    fn begin(&mut self, _iteration: u64, _level: u32) {}

    /// The loss at `x` of all that there is where iterations take samples of it: what is said of a run at its ends.
    /// Nothing if iterations take all.
    fn full_loss(&mut self, _x: &[f64]) -> Option<f64> {
        None
    }

    /// The second derivatives of the loss at `x` by all pairs of elements, row by row, as if what the loss is
    /// made of were linear in them (Gauss and Newton): for methods that solve least squares. Nothing if it is no
    /// such loss.
    fn curvature(&mut self, _x: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// Asked after each step, before `iteration` is begun, which is to be at `x`: whether something else is optimised
    /// from then on. The answer depends on nothing but these two and the changes before. Methods that find the lengths
    /// of their steps themselves are not asked.
    ///
    /// # Errors
    ///
    /// If it cannot be changed as it should be.
    fn change(&mut self, _iteration: u64, _x: &[f64]) -> Result<Option<Change>, Error> {
        Ok(None)
    }

    /// Takes up the changes of the part of a run that a checkpoint holds; the variables since then.
    ///
    /// # Errors
    ///
    /// If they are none that it makes.
    fn restore(&mut self, _topologies: &[Topology]) -> Result<Vec<Variable>, Error> {
        Err(Error::new(
            "checkpoint",
            "holds a mesh whose triangles have changed, which this problem does not do",
        ))
    }

    /// What makes loss or gradient at `x` infinite or no number, for people; asked after
    /// [`evaluate`](Self::evaluate) gave such a result.
    fn explain(&mut self, _x: &[f64]) -> Option<String> {
        None
    }
}

impl<F: FnMut(&[f64]) -> Evaluation> Objective for F {
    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        self(x)
    }
}

/// What an objective gives at one point.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// The value to minimise.
    pub loss: f64,
    /// The derivative of the loss with respect to each element of `x`.
    pub gradient: Vec<f64>,
}

impl Evaluation {
    /// Returns `true` if the loss and all entries of the gradient are finite.
    pub fn is_finite(&self) -> bool {
        self.loss.is_finite() && self.gradient.iter().all(|derivative| derivative.is_finite())
    }
}
