// Where there are no files beside the text, its links lead to the plots below.
#![doc = "[front]: #plots\n[steps]: #plots\n[rays]: #plots\n[schedules]: #plots\n"]
#![doc = include_str!("../../docs/tradeoff.md")]
#![doc = "\n# Plots\n"]
#![doc = include_str!("../../docs/tradeoff/glossy.svg")]
#![doc = include_str!("../../docs/tradeoff/glossy-steps.svg")]
#![doc = include_str!("../../docs/tradeoff/glossy-rays.svg")]
#![doc = include_str!("../../docs/tradeoff/glossy-schedules.svg")]

mod axis;
mod cases;
mod edges;
mod engine;
mod measurement;
mod plot;
mod sampling;
mod schedules;
mod steps;
mod table;
#[cfg(test)]
mod tests;

use cases::cases;
use engine::{Adjoint, Engine, Question};
use measurement::{Reference, measure_in_turns};

pub use edges::{EdgeRuns, edge_csv, edge_table, measure_edges};
pub use measurement::Measurement;
pub use plot::{Curve, Titles, curves_svg, tradeoff_svg};
pub use sampling::{SamplingRuns, measure_sampling, sampling_csv, sampling_curves, sampling_table};
pub use schedules::{ScheduleRun, measure_schedules};
pub use steps::{best_step, steps};
pub use table::{csv, table};
#[cfg(test)]
pub(crate) use tests::{gradient_on_tapes, random_experiment};

use crate::accuracy::GradientMetric;
use crate::recovery::Recovery;
use crate::settings::{Edges, Settings};

/// What was measured on a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Tradeoff {
    /// The measurements, by axis.
    pub measurements: Vec<Measurement>,
    /// What was not measured, and why; what to know of what was.
    pub remarks: Vec<String>,
}

/// Measures what the choices of a recovery cost and what they are worth, each setting for about
/// `seconds`.
///
/// Errors are those against the gradient in double precision through a tree, without edges: what
/// [they](measure_edges) are worth is measured apart, because tapes and brute force do not have them.
///
/// Memory is counted if the program's allocator is `peakmem_alloc::INSTRUMENTED_SYSTEM`, as in the
/// command line.
pub fn measure(recovery: &Recovery<'_>, seconds: f64) -> Tradeoff {
    let scene = recovery.scene();
    let metric = GradientMetric::new(scene, recovery.ids());
    let settings = without_edges().in_double_precision();
    let mut exact = Adjoint::new(Question { recovery, settings });
    let gradient = exact.gradient();
    let image = exact.image().expect("the adjoint has an image");
    let (mut cases, remarks) = cases(recovery, &metric);
    let reference = Reference { metric, gradient, image };
    let measurements = measure_in_turns(&mut cases, &reference, seconds);
    Tradeoff { measurements, remarks }
}

/// What all ways to a gradient have in common is its interior term.
pub(crate) fn without_edges() -> Settings {
    Settings { edges: Edges::Off, ..Settings::default() }
}
