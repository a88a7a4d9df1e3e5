//! How the error of differences depends on their step.

use super::axis::Axis;
use super::measurement::Measurement;
use super::plot::Curve;

/// The error of differences over their steps, in single and in double precision: a V between the error
/// of the formula, which falls with the step, and that of rounding, which grows.
pub fn steps(measurements: &[Measurement]) -> Vec<Curve> {
    let of = |color, axis: Axis| {
        let points = measurements.iter().filter(|m| m.axis == axis);
        let points = points.filter_map(|m| Some((m.step?, m.gradient_error)));
        let label = axis.name().to_owned();
        Curve { label, points: points.collect(), color, is_dashed: false }
    };
    vec![of(0, Axis::SingleDifferences), of(1, Axis::DoubleDifferences)]
}

/// The step and the error at the bottom of a V.
pub fn best_step(curve: &Curve) -> Option<(f64, f64)> {
    curve.points.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1))
}
