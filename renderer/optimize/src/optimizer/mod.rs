//! The methods that turn gradients into steps.
//!
//! A first-order method is a small pure stepper: its memory of earlier gradients, and a function
//! from gradient to *direction*, the step per unit of learning rate. What all of them share
//! happens once, outside of them: the learning rate of each element, the
//! [`Schedule`](super::Schedule), and the projection onto the bounds. L-BFGS and
//! Levenberg-Marquardt are other things: they evaluate the loss several times in a step. L-BFGS lives in
//! coordinates without bounds, Levenberg-Marquardt solves for steps within them.
//!
//! The methods are a closed enum, not a trait: a checkpoint has to name the one that wrote it and
//! to read back its memory.

mod adam;
mod first_order;
#[cfg(feature = "argmin")]
mod lbfgs;
mod lm;
mod rms_prop;
mod sgd;

pub use adam::{Adam, AdamW};
#[cfg(feature = "argmin")]
pub use lbfgs::Lbfgs;
pub use lm::Lm;
pub use rms_prop::RmsProp;
pub use sgd::Sgd;

use first_order::FirstOrder;
#[cfg(feature = "argmin")]
use lbfgs::LbfgsState;
use lm::LmState;
use renderer_core::Error;

use serde::{Deserialize, Serialize};

use super::field::{Field, check_fields};
use super::variable::Flat;
use super::{Carry, Evaluation, Fingerprint, Objective, Schedule};

/// A method, with its hyper-parameters. Learning rates belong to the variables.
///
/// Serialises to a table with the name of the method as `type`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "lowercase")]
pub enum Optimizer {
    /// Steps of about the learning rate, however large the gradient is. The default.
    Adam(Adam),
    /// Adam with decoupled weight decay.
    AdamW(AdamW),
    /// The gradient times the learning rate, with momentum.
    Sgd(Sgd),
    /// The gradient over its root mean square.
    RmsProp(RmsProp),
    /// Least squares, for few numbers.
    Lm(Lm),
    /// A quasi-Newton method with a line search; with the feature `argmin`.
    #[cfg(feature = "argmin")]
    Lbfgs(Lbfgs),
}

impl Default for Optimizer {
    fn default() -> Self {
        Self::Adam(Adam::default())
    }
}

impl Optimizer {
    /// Every method with its default hyper-parameters.
    pub fn all() -> Vec<Self> {
        vec![
            Self::Adam(Adam::default()),
            Self::AdamW(AdamW::default()),
            Self::Sgd(Sgd::default()),
            Self::RmsProp(RmsProp::default()),
            Self::Lm(Lm::default()),
            #[cfg(feature = "argmin")]
            Self::Lbfgs(Lbfgs::default()),
        ]
    }

    /// The method `name`, with its default hyper-parameters.
    ///
    /// # Errors
    ///
    /// If there is none of this name; the text says which there are.
    pub fn named(name: &str) -> Result<Self, String> {
        let found = Self::all().into_iter().find(|method| method.name() == name);
        found.ok_or_else(|| {
            let names: Vec<_> = Self::all().iter().map(Self::name).collect();
            format!("no optimizer `{name}`; there is {}", names.join(", "))
        })
    }

    /// What files and the command line call it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Adam(_) => "adam",
            Self::AdamW(_) => "adamw",
            Self::Sgd(_) => "sgd",
            Self::RmsProp(_) => "rmsprop",
            Self::Lm(_) => "lm",
            #[cfg(feature = "argmin")]
            Self::Lbfgs(_) => "lbfgs",
        }
    }

    /// Whether the length of a step is that of the gradient, times the learning rate. There is no
    /// learning rate then that suits every loss. The steps of the other methods are as long as the
    /// learning rate says.
    pub fn follows_gradient_length(&self) -> bool {
        matches!(self, Self::Sgd(_))
    }

    /// Whether it finds the lengths of its steps by itself, so that a schedule has no say.
    pub fn finds_step_lengths(&self) -> bool {
        match self {
            Self::Adam(_) | Self::AdamW(_) | Self::Sgd(_) | Self::RmsProp(_) => false,
            Self::Lm(_) => true,
            #[cfg(feature = "argmin")]
            Self::Lbfgs(_) => true,
        }
    }

    /// # Errors
    ///
    /// If the method has no use for `schedule`.
    pub fn check_schedule(&self, schedule: &Schedule) -> Result<(), Error> {
        if *schedule == Schedule::Constant {
            return Ok(());
        }
        self.check_learning_rate().map_err(|problem| {
            Error::new("optimize.schedule", format!("is {}, but {problem}", schedule.name()))
        })
    }

    /// # Errors
    ///
    /// If the method has no use for a learning rate.
    pub fn check_learning_rate(&self) -> Result<(), String> {
        if !self.finds_step_lengths() {
            return Ok(());
        }
        Err(format!("{} finds the lengths of its steps itself; leave it out", self.name()))
    }

    /// # Errors
    ///
    /// If the method does not solve for as many numbers.
    pub(super) fn check_count(&self, count: usize) -> Result<(), Error> {
        if !matches!(self, Self::Lm(_)) || count <= lm::MOST_NUMBERS {
            return Ok(());
        }
        let most = lm::MOST_NUMBERS;
        let problem = format!("{} solves for up to {most} numbers; these are {count}", self.name());
        Err(Error::new("optimize.optimizer", problem))
    }

    /// # Errors
    ///
    /// If a number is out of its range; the place is its field in a scene file.
    pub fn check(&self) -> Result<(), Error> {
        check_fields("optimize.optimizer", self.fields())
    }

    /// The hyper-parameters.
    pub(super) fn fields(&self) -> Vec<Field> {
        match self {
            Self::Adam(method) => method.fields(),
            Self::AdamW(method) => method.fields(),
            Self::Sgd(method) => method.fields(),
            Self::RmsProp(method) => method.fields(),
            Self::Lm(method) => method.fields(),
            #[cfg(feature = "argmin")]
            Self::Lbfgs(method) => method.fields(),
        }
    }

    /// Adds what tells it from other methods to a fingerprint.
    pub(super) fn mark(&self, fingerprint: Fingerprint) -> Fingerprint {
        let values: Vec<f64> = self.fields().iter().map(|(_, value, ..)| *value).collect();
        fingerprint.text(self.name()).numbers(&values)
    }
}

/// A method at work: itself, and what it remembers from step to step.
#[derive(Clone, Serialize, Deserialize)]
pub(super) enum Method {
    FirstOrder(FirstOrder),
    Lm(LmState),
    #[cfg(feature = "argmin")]
    Lbfgs(Box<LbfgsState>),
}

impl Method {
    /// `optimizer` without a memory yet, for `len` elements.
    pub fn new(optimizer: &Optimizer, len: usize) -> Self {
        Self::FirstOrder(match *optimizer {
            Optimizer::Adam(adam) => FirstOrder::adam(adam, len),
            Optimizer::AdamW(adam_w) => FirstOrder::adam_w(adam_w, len),
            Optimizer::Sgd(sgd) => FirstOrder::Sgd(sgd, vec![0.0; len]),
            Optimizer::RmsProp(rms_prop) => FirstOrder::RmsProp(rms_prop, vec![0.0; len]),
            Optimizer::Lm(lm) => return Self::Lm(LmState::new(&lm)),
            #[cfg(feature = "argmin")]
            Optimizer::Lbfgs(lbfgs) => return Self::Lbfgs(Box::new(LbfgsState::new(&lbfgs))),
        })
    }

    /// Returns `true` if the memory is that of `len` elements.
    pub fn fits(&self, len: usize) -> bool {
        match self {
            Self::FirstOrder(method) => method.fits(len),
            Self::Lm(_) => true,
            #[cfg(feature = "argmin")]
            Self::Lbfgs(method) => method.fits(len),
        }
    }

    /// What it remembers, of other elements. Methods that find the lengths of their steps remember nothing of use.
    pub fn carry(&mut self, carry: &Carry) {
        if let Self::FirstOrder(method) = self {
            method.carry(carry);
        }
    }

    /// Moves `x`, where `evaluation` took place. Returns the evaluation at the new `x` if that was
    /// needed to choose it.
    ///
    /// # Errors
    ///
    /// If a line search finds no lower loss; the text says why.
    pub fn step(
        &mut self,
        flat: &Flat,
        factor: f64,
        x: &mut [f64],
        mut evaluation: Evaluation,
        objective: &mut dyn Objective,
    ) -> Result<Option<Evaluation>, String> {
        match self {
            Self::FirstOrder(method) => {
                flat.pull_back_to_places(x, &mut evaluation.gradient);
                flat.precondition(&mut evaluation.gradient);
                method.direction(&flat.places(x), &mut evaluation.gradient, &flat.blocks);
                flat.precondition(&mut evaluation.gradient);
                flat.step(x, &evaluation.gradient, factor);
                Ok(None)
            }
            Self::Lm(method) => method.step(flat, x, &evaluation, objective).map(Some),
            #[cfg(feature = "argmin")]
            Self::Lbfgs(method) => method.step(flat, x, &evaluation, objective).map(Some),
        }
    }
}

/// A factor by which a running mean keeps its past.
fn decay(name: &'static str, value: f64) -> Field {
    (name, value, (0.0..1.0).contains(&value), "at least 0 and below 1")
}

/// What it may be where no step lowers a loss: losses of images jump at edges, and those of random paths everywhere.
const NO_LOWER_LOSS: &str =
    "this is a minimum as far as the loss can tell, or an edge or the noise of it";

/// Something to divide by.
fn divisor(name: &'static str, value: f64) -> Field {
    (name, value, value > 0.0 && value.is_finite(), "a positive number")
}

/// The square root of a running mean of squares: of what it was, and of a new value.
///
/// The root is kept because the squares of gradients below 1e-154 are zero.
fn running_rms(root: f64, decay: f64, value: f64) -> f64 {
    (decay.sqrt() * root).hypot((1.0 - decay).sqrt() * value).min(f64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_to_methods() {
        for method in Optimizer::all() {
            assert_eq!(Optimizer::named(method.name()), Ok(method));
            let table = serde_json::json!({ "type": method.name() });
            assert_eq!(serde_json::from_value::<Optimizer>(table).unwrap(), method);
            let written = serde_json::to_value(method).unwrap();
            assert_eq!(serde_json::from_value::<Optimizer>(written).unwrap(), method);
        }
        let refused = Optimizer::named("adan").unwrap_err();
        assert!(refused.starts_with("no optimizer `adan`; there is adam, adamw, sgd"), "{refused}");
    }
}
