//! Edges: what they cost, and what gradients without them miss.

use std::time::Instant;

use super::engine::{Adjoint, Engine, Question};
use super::measurement::Reference;
use crate::accuracy::{Evaluator, GradientMetric, IntegralGradient, grids, image_error};
use crate::recovery::Recovery;
use crate::settings::{Edges, Settings};

/// Gradients with or without edges, from a regular grid of rays through each pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeRun {
    /// Whether edges are seen.
    pub edges: Edges,
    /// Rays for each pixel.
    pub count: u32,
    /// Seconds of a gradient: the median of the runs.
    pub seconds: f64,
    /// The relative error of the image.
    pub image_error: f64,
    /// The relative error of the gradient.
    pub gradient_error: f64,
}

/// What came out for edges.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeRuns {
    /// Those without edges first.
    pub runs: Vec<EdgeRun>,
    /// How far the gradient that they are measured against is from that of the next coarser grid.
    pub reference_error: f64,
}

/// The most rays per pixel of the reference, and of what is compared.
const MOST_OF_REFERENCE: u32 = 256;
const MOST_COMPARED: u32 = 16;
/// The reference has fewer where an image would have more rays than this.
const MOST_RAYS: u64 = 1 << 22;
/// How often each is timed.
const RUNS: usize = 3;

/// Gradients with and without edges against that of a fine grid with edges; nothing if no parameter moves
/// an edge.
pub fn measure_edges(recovery: &Recovery<'_>) -> Option<EdgeRuns> {
    if !recovery.ids().iter().any(|&id| recovery.scene().moves_edges(id)) {
        return None;
    }
    let scene = recovery.scene();
    let pixels = u64::from(scene.width) * u64::from(scene.height);
    let most = (MOST_RAYS / pixels.max(1)).clamp(1, MOST_OF_REFERENCE.into()) as u32;
    let with_edges = Settings { edges: Edges::On, ..*recovery.render_settings() };
    let recovery = &recovery.with_settings(&with_edges);
    let metric = GradientMetric::new(scene, recovery.ids());
    let evaluator = &mut Evaluator::new(recovery);
    let exact = IntegralGradient::of_grids(evaluator, &metric, scene.bounces, most, 0.0);
    let finest = grids(most).last().unwrap_or_default();
    let settings = Settings { sampling: finest, ..with_edges }.in_double_precision();
    let image = Adjoint::new(Question { recovery, settings }).image()?;
    let reference = Reference { metric, gradient: exact.gradient, image };
    let runs = [Edges::Off, Edges::On].into_iter().flat_map(|edges| {
        let reference = &reference;
        grids(MOST_COMPARED.min(most)).map(move |sampling| {
            let settings = Settings { edges, sampling, ..Settings::default() };
            run(Question { recovery, settings }, reference)
        })
    });
    Some(EdgeRuns { runs: runs.collect(), reference_error: exact.error })
}

fn run(question: Question<'_>, reference: &Reference) -> EdgeRun {
    let Settings { edges, sampling, .. } = question.settings;
    let mut engine = Adjoint::new(question);
    let mut gradient = Vec::new();
    let mut times = [(); RUNS].map(|()| {
        engine.leave();
        let clock = Instant::now();
        gradient = engine.gradient();
        clock.elapsed().as_secs_f64()
    });
    times.sort_by(f64::total_cmp);
    let image = engine.image();
    EdgeRun {
        edges,
        count: sampling.count(),
        seconds: times[RUNS / 2],
        image_error: image.map_or(f64::NAN, |image| image_error(&image, &reference.image)),
        gradient_error: reference.metric.error(&gradient, &reference.gradient),
    }
}

/// A word for whether edges are seen.
fn name(edges: Edges) -> &'static str {
    if edges == Edges::On { "on" } else { "off" }
}

/// A table for people.
pub fn edge_table(EdgeRuns { runs, reference_error }: &EdgeRuns) -> String {
    let mut lines = vec![format!(
        "{:<6} {:>5} {:>12} {:>11} {:>13}",
        "edges", "rays", "gradient, ms", "image off", "gradient off"
    )];
    lines.extend(runs.iter().map(|run| {
        let EdgeRun { edges, count, seconds, image_error, gradient_error } = run;
        format!(
            "{:<6} {count:>5} {:>12.3} {image_error:>11.1e} {gradient_error:>13.1e}",
            name(*edges),
            1e3 * seconds
        )
    }));
    lines.push(format!(
        "Against a fine grid of rays with edges, {reference_error:.0e} from the next coarser one."
    ));
    lines.join("\n")
}

/// The same as comma-separated values.
pub fn edge_csv(EdgeRuns { runs, .. }: &EdgeRuns) -> String {
    let mut text = "edges,rays,seconds,image_error,gradient_error\n".to_owned();
    for EdgeRun { edges, count, seconds, image_error, gradient_error } in runs {
        let edges = name(*edges);
        text += &format!("{edges},{count},{seconds:e},{image_error:e},{gradient_error:e}\n");
    }
    text
}
