//! Medians over interleaved repetitions, so that what slows the machine down for a while slows
//! every case alike and leaves the ratios alone.

use std::time::Instant;

/// The median seconds of one call of each case, over `rounds` rounds in which each is timed for
/// at least `sample` seconds.
pub fn medians(rounds: usize, sample: f64, cases: &mut [&mut dyn FnMut()]) -> Vec<f64> {
    let calls: Vec<usize> = cases.iter_mut().map(|case| calls_within(sample, case)).collect();
    let mut samples = vec![Vec::with_capacity(rounds); cases.len()];
    for _ in 0..rounds {
        for ((case, &calls), samples) in cases.iter_mut().zip(&calls).zip(&mut samples) {
            samples.push(seconds(calls, case) / calls as f64);
        }
    }
    samples.into_iter().map(median).collect()
}

/// The number of calls that take at least `sample` seconds.
fn calls_within(sample: f64, case: &mut dyn FnMut()) -> usize {
    let mut calls = 1;
    while seconds(calls, case) < sample {
        calls *= 2;
    }
    calls
}

fn seconds(calls: usize, case: &mut dyn FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..calls {
        case();
    }
    start.elapsed().as_secs_f64()
}

fn median(mut samples: Vec<f64>) -> f64 {
    samples.sort_by(f64::total_cmp);
    samples[samples.len() / 2]
}
