//! The methods that turn gradients into steps.
//!
//! A first-order method is a small pure stepper: its memory of earlier gradients, and a function
//! from gradient to *direction*, the step per unit of learning rate. What all of them share
//! happens once, outside of them: the learning rate of each element, the
//! [`Schedule`](super::Schedule), and the projection onto the bounds.
//!
//! The methods are a closed enum, not a trait: a checkpoint has to name the one that wrote it and
//! to read back its memory.

mod adam;
mod first_order;
mod rms_prop;
mod sgd;

pub use adam::{Adam, AdamW};
pub use rms_prop::RmsProp;
pub use sgd::Sgd;

pub(super) use first_order::FirstOrder;

use serde::{Deserialize, Serialize};

use super::Fingerprint;
use super::settings::check_fields;
use crate::Error;

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
}

impl Default for Optimizer {
    fn default() -> Self {
        Self::Adam(Adam::default())
    }
}

/// A hyper-parameter: its name, its value, whether that can be used, and what can.
pub(super) type Field = (&'static str, f64, bool, &'static str);

impl Optimizer {
    /// Every method with its default hyper-parameters.
    pub fn all() -> Vec<Self> {
        vec![
            Self::Adam(Adam::default()),
            Self::AdamW(AdamW::default()),
            Self::Sgd(Sgd::default()),
            Self::RmsProp(RmsProp::default()),
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
        }
    }

    /// Whether the length of a step is that of the gradient, times the learning rate. There is no
    /// learning rate then that suits every loss. The steps of the other methods are as long as the
    /// learning rate says.
    pub fn follows_gradient_length(&self) -> bool {
        matches!(self, Self::Sgd(_))
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
        }
    }

    /// Adds what tells it from other methods to a fingerprint.
    pub(super) fn mark(&self, fingerprint: Fingerprint) -> Fingerprint {
        let values: Vec<f64> = self.fields().iter().map(|(_, value, ..)| *value).collect();
        fingerprint.text(self.name()).numbers(&values)
    }
}

/// A factor by which a running mean keeps its past.
fn decay(name: &'static str, value: f64) -> Field {
    (name, value, (0.0..1.0).contains(&value), "at least 0 and below 1")
}

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
