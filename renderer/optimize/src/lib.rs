//! The optimiser: finds the parameters that minimise a loss, and leaves a record of how.
//!
//! It knows nothing of images. A caller describes its parameters as [`Variable`]s, hands over an
//! [`Objective`] that gives loss and gradient, and gets an [`Outcome`]:
//!
//! ```
//! use renderer::optimize::{Evaluation, Optimization, Quiet, Settings, Variable};
//!
//! let variables = [Variable::new("light.key.intensity", vec![1.0], 0.1)];
//! let mut objective = |x: &[f64]| Evaluation {
//!     loss: (x[0] - 3.0).powi(2),
//!     gradient: vec![2.0 * (x[0] - 3.0)],
//! };
//! let settings = Settings { tolerance: 1e-9, ..Settings::default() };
//! let outcome = Optimization::start(&variables, &settings)?.run(&mut objective, &mut Quiet)?;
//! assert!((outcome.best.x[0] - 3.0).abs() < 1e-4);
//! # Ok::<(), renderer::Error>(())
//! ```
//!
//! # Iterations
//!
//! Iteration `k` is the evaluation at the parameters that `k` steps have led to. `iterations: N`
//! is thus `N` steps, and with a first-order method `N + 1` evaluations, at the most (a step of
//! L-BFGS or Levenberg-Marquardt takes one evaluation or several). Every loss that is reported was evaluated at the
//! parameters reported with it. The parameters recovered are the best ones: those with the lowest
//! loss, not those seen last.
//!
//! # Starts
//!
//! A method that follows gradients ends in the valley that it begins in. With [`Starts`] several beginnings
//! make a few steps each, and iteration 0 is at what the best of them has come to.
//!
//! # Changes
//!
//! An objective may change what is optimised on the way ([`Objective::change`]), such as the triangles of a mesh: then
//! the method goes on with what it remembers, carried over, and the best parameters and the trajectory are those since
//! the last change.
//!
//! # Checkpoints
//!
//! With [`Checkpointing`] the whole state goes to `checkpoint.json` in the output folder, after
//! the first step, then every few seconds, and at the end. A process killed at any moment
//! continues from the latest checkpoint to the same parameters, bit for bit, as a run that nobody
//! stopped, given an objective that is a pure function of its argument. Where an [`Observer`] changes learning
//! rates on the way, the checkpoint keeps that, and is written at once; no other run repeats it.
//!
//! | folder holds      | `resume: false`                  | `resume: true`                    |
//! |-------------------|----------------------------------|-----------------------------------|
//! | no checkpoint     | starts                           | starts: a job script can always ask to resume |
//! | an unfinished run | error: hours of work may be lost | continues                         |
//! | a finished run    | starts, and replaces it          | returns its result at once        |
//! | a damaged file    | error                            | error                             |
//!
//! A resumed run must have the same problem, variables, [`Optimizer`] and [`Schedule`]. Its stopping
//! criteria may differ, so that a finished run can be given more iterations, unless a run with the
//! new criteria would have stopped before: then the error says where. A schedule that is not
//! constant spans the run, so with one the number of iterations must stay the same too.

#[cfg(feature = "argmin")]
mod argmin_problem;
mod batch;
mod checkpoint;
mod coordinates;
mod field;
mod fingerprint;
mod history;
#[cfg(feature = "reports")]
mod loss_axis;
#[cfg(feature = "reports")]
mod loss_plot;
mod observer;
mod optimizer;
mod outcome;
// For plots of `renderer` and of the examples of its repository.
#[cfg(feature = "reports")]
#[doc(hidden)]
pub mod palette;
mod preconditioner;
mod problem;
#[cfg(feature = "reports")]
mod progress;
mod random;
#[cfg(feature = "reports")]
mod report;
mod run;
mod scale;
pub mod schedule;
mod settings;
mod starts;
mod stop;
#[cfg(test)]
mod tests;
mod topology;
mod trajectory;
mod variable;

#[cfg(feature = "argmin")]
pub use argmin_problem::ArgminProblem;
pub use batch::Batch;
pub use coordinates::Coordinates;
pub use fingerprint::Fingerprint;
pub use history::{Point, Record};
#[cfg(feature = "reports")]
pub use loss_plot::loss_svg;
pub use observer::{Observer, Quiet, Step};
#[cfg(feature = "argmin")]
pub use optimizer::Lbfgs;
pub use optimizer::{Adam, AdamW, Lm, Optimizer, RmsProp, Sgd};
pub use outcome::{Outcome, Start};
pub use preconditioner::Preconditioner;
pub use problem::{Evaluation, Objective};
#[cfg(feature = "reports")]
pub use progress::{Bar, Lines, progress};
#[cfg(feature = "reports")]
pub use report::{history_csv, summary, write_report};
pub use run::Optimization;
pub use scale::Scale;
pub use schedule::Schedule;
pub use settings::{CHECKPOINT_FILE, Checkpointing, Settings};
pub use starts::Starts;
pub use stop::{Stop, StopReason};
pub use topology::{Carry, Change, Topology};
pub use variable::Variable;
