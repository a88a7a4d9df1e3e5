//! Runs with edges and without, side by side.

use renderer::Edges;
use renderer::optimize::{Outcome, Record};

use crate::plot::{Curve, Point};

/// How a run is told from the other.
pub fn named(edges: Edges) -> &'static str {
    if edges == Edges::Off { "without edges" } else { "with edges" }
}

/// The losses of a run over that of its start.
pub fn curve(label: String, outcome: &Outcome) -> Curve {
    let point = |record: &Record| Point {
        x: record.iteration as f64,
        y: record.loss / outcome.initial_loss,
        deviation: 0.0,
    };
    Curve { label, points: outcome.history.iter().map(point).collect() }
}
