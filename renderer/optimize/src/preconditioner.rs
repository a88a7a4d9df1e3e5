//! Changes of coordinates.

use std::fmt;
use std::sync::Arc;

/// Multiplies with a matrix, in place.
type Inverse = dyn Fn(&mut [f64]) + Send + Sync;

/// A linear change of the coordinates of a variable, in which a first-order method takes its steps: of
/// `u = M x`, where `M` is symmetric and positive definite. The gradient by `u` is `M^-1` times that by `x`, and
/// a step of `u` is `M^-1` times it for `x`. Minima stay where they are; what is easy to move changes.
#[derive(Clone)]
pub struct Preconditioner {
    name: String,
    inverse: Arc<Inverse>,
}

impl Preconditioner {
    /// The change that `inverse` inverts: it multiplies with `M^-1`, in place. Runs are told apart by the name,
    /// which therefore says all that the variable itself does not.
    pub fn new(
        name: impl Into<String>,
        inverse: impl Fn(&mut [f64]) + Send + Sync + 'static,
    ) -> Self {
        Self { name: name.into(), inverse: Arc::new(inverse) }
    }

    /// What tells it from others.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Multiplies with `M^-1`.
    pub(super) fn apply(&self, block: &mut [f64]) {
        (self.inverse)(block);
    }
}

impl fmt::Debug for Preconditioner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Preconditioner").field(&self.name).finish()
    }
}

impl PartialEq for Preconditioner {
    /// Whether the names are the same.
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}
