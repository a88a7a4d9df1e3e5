//! What a caller chooses.

use std::path::PathBuf;
use std::time::Duration;

use renderer_core::Error;

use super::field::{Field, check_fields};
use super::{Fingerprint, Optimizer, Schedule, Starts};

/// The file in the output folder that holds the state of the run.
pub const CHECKPOINT_FILE: &str = "checkpoint.json";

/// How to optimise, and when to stop.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The most steps; 0 only evaluates the initial parameters.
    pub iterations: u64,
    /// Stop when the loss is at most this. At the default 0, a loss that cannot get lower stops.
    pub tolerance: f64,
    /// Stop when the Euclidean norm of the gradient is at most this, not counting elements that a
    /// bound holds back. At the default 0, only a gradient that vanished stops.
    pub gradient_tolerance: f64,
    /// The method. Learning rates belong to the variables.
    pub optimizer: Optimizer,
    /// How the learning rates change in the course of the run.
    pub schedule: Schedule,
    /// How many coarser levels of the [objective](super::Objective::begin) come before it itself. Each level
    /// has an equal share of the iterations, and ends before that where its loss or gradient meets a
    /// tolerance, or a step of a method that finds its own lengths lowers the loss by less than a
    /// thirtieth. The parameters recovered are the best of the finest level reached; of the finest of all, the
    /// initial parameters are among them.
    pub coarse_to_fine: u32,
    /// Several beginnings, if there are to be any beside the initial parameters. Their steps are no iterations,
    /// and come before the first checkpoint: a run that was killed before takes them again.
    pub starts: Option<Starts>,
    /// Whether the loss is that of a sample which changes from iteration to iteration: the parameters
    /// recovered are then the last ones, since the lowest loss is that of the easiest sample.
    pub is_sampled: bool,
    /// How many iterations see all that there is, where each sees another part of it: tolerances are of the mean over as
    /// many. 0 counts as 1.
    pub epoch: usize,
    /// Where the run is kept safe; nothing for a run that leaves no trace.
    pub checkpointing: Option<Checkpointing>,
}

impl Default for Settings {
    /// 200 iterations, tolerances 0, Adam at constant learning rates, one level, one start, no
    /// samples, no checkpoints.
    fn default() -> Self {
        Self {
            iterations: 200,
            tolerance: 0.0,
            gradient_tolerance: 0.0,
            optimizer: Optimizer::default(),
            schedule: Schedule::default(),
            coarse_to_fine: 0,
            starts: None,
            is_sampled: false,
            epoch: 1,
            checkpointing: None,
        }
    }
}

/// Where, how often and for what problem checkpoints are written.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpointing {
    /// The output folder; it is made if it does not exist.
    pub folder: PathBuf,
    /// The time between two checkpoints. Zero writes one after every step.
    pub every: Duration,
    /// Whether to continue the run that the folder holds, if any.
    pub resume: bool,
    /// Stands for everything the objective depends on: scene, target, loss, precision.
    pub problem: Fingerprint,
}

impl Settings {
    /// The first iteration that is finer than a level, which is not the finest.
    pub(super) fn end_of(&self, level: u32) -> u64 {
        let levels = u64::from(self.coarse_to_fine) + 1;
        self.iterations * (levels - u64::from(level)) / levels
    }

    /// # Errors
    ///
    /// If a number is out of its range; the place is its field.
    pub(super) fn check(&self) -> Result<(), Error> {
        let tolerances: [Field; 2] = [
            ("tolerance", self.tolerance, !self.tolerance.is_nan(), "a number"),
            (
                "gradient_tolerance",
                self.gradient_tolerance,
                self.gradient_tolerance >= 0.0,
                "0 or more",
            ),
        ];
        check_fields("optimize", tolerances.to_vec())?;
        self.optimizer.check()?;
        self.schedule.check()?;
        self.optimizer.check_schedule(&self.schedule)
    }
}
