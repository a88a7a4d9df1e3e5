//! What an optimisation remembers of its course.

use serde::{Deserialize, Serialize};

/// An iteration in the history of a run. All numbers are finite.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The number of steps taken before this evaluation.
    pub iteration: u64,
    /// The loss.
    pub loss: f64,
    /// The Euclidean norm of the gradient, without what a bound holds back.
    pub gradient_norm: f64,
    /// Seconds of work up to the end of this evaluation, over all resumed parts of the run.
    pub seconds: f64,
}

/// Parameters and their loss.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// The iteration that evaluated it.
    pub iteration: u64,
    /// The loss at `x`.
    pub loss: f64,
    /// The elements of all variables, one after the other.
    pub x: Vec<f64>,
}
