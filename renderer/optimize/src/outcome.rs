//! What an optimisation found.

use super::{Point, Record, Stop, Topology};

/// What an optimisation came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The parameters recovered: the lowest loss seen, the earliest if there are several; the last ones of
    /// a [sampled](super::Settings::is_sampled) loss. The initial parameters count as iteration 0, which
    /// with [levels](super::Settings::coarse_to_fine) or [starts](super::Settings::starts) was another evaluation.
    pub best: Point,
    /// The meshes whose triangles have [changed](super::Objective::change) in the course of the run, as the parameters
    /// have them. Most runs have none.
    pub topologies: Vec<Topology>,
    /// The latest parameters with a finite loss and gradient.
    pub last: Point,
    /// The history of the run, one entry for each iteration from 0 on; never empty.
    pub history: Vec<Record>,
    /// Some of the points it went through, from the first to the last, evenly spaced; empty if they
    /// have too many numbers to be kept.
    pub trajectory: Vec<Point>,
    /// The loss at the initial parameters; with [levels](super::Settings::coarse_to_fine) that of the finest. Like that
    /// of the best, it is the [full](super::Objective::full_loss) one where iterations take samples.
    pub initial_loss: f64,
    /// Why it stopped.
    pub stop: Stop,
    /// How often the objective was evaluated, over all resumed parts of the run.
    pub evaluations: u64,
    /// Seconds of work, over all resumed parts of the run.
    pub seconds: f64,
    /// How this part of the run began.
    pub start: Start,
}

/// How an optimisation begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// From the initial parameters.
    Fresh,
    /// From a checkpoint.
    Resumed {
        /// The number of steps already taken.
        iteration: u64,
    },
    /// With a checkpoint of a run that needs no further iteration.
    Finished {
        /// The number of steps it took.
        iteration: u64,
    },
}
