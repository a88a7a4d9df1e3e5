//! Measuring engines in turns.

use std::time::Instant;

use peakmem_alloc::{INSTRUMENTED_SYSTEM, PeakMemAllocTrait};

use super::axis::Axis;
use super::engine::Engine;
use crate::Image;
use crate::accuracy::{GradientMetric, image_error};

/// What one setting costs, and what it is worth.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// What is chosen.
    pub axis: Axis,
    /// The choice.
    pub setting: String,
    /// The step of finite differences; nothing for other methods.
    pub step: Option<f64>,
    /// Seconds from changed parameters to their gradient: the median of the runs.
    pub seconds: f64,
    /// How often it was timed.
    pub runs: usize,
    /// The most bytes on the heap during a gradient beyond those before it; nothing if the program
    /// does not count (see [`measure`](super::measure)).
    pub bytes: Option<usize>,
    /// The relative error of the image, if the choice changes it.
    pub image_error: Option<f64>,
    /// The relative error of the gradient.
    pub gradient_error: f64,
}

/// A setting to be measured.
pub(super) struct Case<'a> {
    pub axis: Axis,
    pub setting: String,
    /// The step of finite differences; nothing for other methods.
    pub step: Option<f64>,
    pub engine: Box<dyn Engine + 'a>,
    /// The numbers whose derivatives the engine gives, if not all.
    pub elements: Option<Vec<usize>>,
}

/// What cases are measured against.
pub(super) struct Reference {
    pub metric: GradientMetric,
    pub gradient: Vec<f64>,
    pub image: Image,
}

/// So many runs are enough however short they are.
const MOST_RUNS: usize = 100;
/// So many make a median, unless one alone takes longer than all should.
const LEAST_RUNS: usize = 3;

/// Measures all cases, each for about `seconds`: errors and memory first, then times, every case
/// once in each turn, so that what else the machine does meets all of them alike.
pub(super) fn measure_in_turns(
    cases: &mut [Case<'_>],
    reference: &Reference,
    seconds: f64,
) -> Vec<Measurement> {
    let mut measured: Vec<Measurement> =
        cases.iter_mut().map(|case| measure_once(case, reference)).collect();
    let mut times: Vec<Vec<f64>> = vec![Vec::new(); cases.len()];
    loop {
        let mut all_done = true;
        for (case, times) in cases.iter_mut().zip(&mut times) {
            let used: f64 = times.iter().sum();
            let enough = times.len() >= LEAST_RUNS || times.first().is_some_and(|&t| t > seconds);
            if enough && (used >= seconds || times.len() >= MOST_RUNS) {
                continue;
            }
            all_done = false;
            case.engine.leave();
            let clock = Instant::now();
            std::hint::black_box(case.engine.gradient());
            times.push(clock.elapsed().as_secs_f64());
        }
        if all_done {
            break;
        }
    }
    for ((measurement, case), mut times) in measured.iter_mut().zip(cases).zip(times) {
        times.sort_by(f64::total_cmp);
        // An engine that goes derivative by derivative was asked for some of them.
        let part = case
            .elements
            .as_ref()
            .map_or(1.0, |elements| reference.gradient.len() as f64 / elements.len() as f64);
        measurement.seconds = part * times[times.len() / 2];
        measurement.runs = times.len();
    }
    measured
}

/// Errors and memory.
fn measure_once(case: &mut Case<'_>, reference: &Reference) -> Measurement {
    case.engine.leave();
    INSTRUMENTED_SYSTEM.reset_peak_memory();
    let gradient = case.engine.gradient();
    let peak = INSTRUMENTED_SYSTEM.get_peak_memory();
    let gradient_error = match &case.elements {
        None => reference.metric.error(&gradient, &reference.gradient),
        Some(elements) => reference.metric.error_among(elements, &gradient, &reference.gradient),
    };
    Measurement {
        axis: case.axis,
        setting: case.setting.clone(),
        step: case.step,
        seconds: 0.0,
        runs: 0,
        // Every gradient is allocated, so a program that counts has counted something.
        bytes: (peak > 0).then_some(peak),
        image_error: case.engine.image().map(|image| image_error(&image, &reference.image)),
        gradient_error,
    }
}
