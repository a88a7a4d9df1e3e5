//! The backward pass against central differences, figure 3 of the paper on RayTracer.jl
//! ("Comparison with Finite Differencing").
//!
//! `cargo run --release --example finite_differences`
//!
//! Random triangles before a fixed camera and light, 20 parameters each: 1 to 8 of them as in the
//! paper, which is 17 times as fast at 160 parameters, then up to 10,000 parameters. Five trials with
//! other triangles each; mean and standard deviation. Both ways compute in double precision, on the
//! same lanes and threads, and take in changed parameters before every image. Of more than 400
//! parameters, differences are taken for 400 evenly spaced ones, and their time is scaled up. `out/finite_differences/` gets the times and the speed-up as plots.

mod experiment;
#[path = "../shared/plot.rs"]
mod plot;
#[path = "../shared/random.rs"]
mod random;

use std::path::Path;
use std::time::Instant;

use experiment::{PER_TRIANGLE, backward, central_differences, larger, largest_error};
use plot::{Curve, Horizontal, Point, save_plot};
use random::Random;
use renderer::Error;

/// How many triangles.
const TRIANGLES: [usize; 13] = [1, 2, 3, 4, 5, 6, 7, 8, 16, 32, 64, 150, 500];
const TRIALS: u64 = 5;
/// The width and the height of the image.
const SIZE: u32 = 64;
/// The differences that are taken of one scene, at most.
const MOST_DIFFERENCES: usize = 400;
/// The backward pass is repeated for so long, for a mean that the clock resolves.
const SECONDS: f64 = 0.004;

fn main() -> Result<(), Error> {
    println!(
        "{:>10}  {:>22}  {:>22}  {:>16}  {:>9}",
        "parameters", "backward pass / ms", "differences / ms", "speed-up", "off by"
    );
    let names = ["backward pass", "central differences", "speed-up"];
    let mut curves = names.map(|label| Curve { label: label.to_owned(), points: Vec::new() });
    for triangles in TRIANGLES {
        let parameters = triangles * PER_TRIANGLE;
        let mut samples = [Vec::new(), Vec::new(), Vec::new()];
        let mut error = 0.0_f64;
        for seed in 0..TRIALS {
            let trial = measure(triangles, seed)?;
            let times =
                [1e3 * trial.backward, 1e3 * trial.differences, trial.differences / trial.backward];
            samples.iter_mut().zip(times).for_each(|(samples, time)| samples.push(time));
            error = larger(error, trial.error);
        }
        let statistics = samples.map(|samples| mean_and_deviation(&samples));
        let [backward, differences, speedup] =
            statistics.map(|(mean, deviation)| format!("{mean:.4} ± {deviation:.4}"));
        println!(
            "{parameters:>10}  {backward:>22}  {differences:>22}  {speedup:>16}  {error:>9.1e}"
        );
        for (curve, (y, deviation)) in curves.iter_mut().zip(statistics) {
            curve.points.push(Point { x: parameters as f64, y, deviation });
        }
    }

    let out = Path::new("out/finite_differences");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let parameters = || Horizontal { title: "parameters", is_logarithmic: true };
    let (times, speedup) = curves.split_at(2);
    save_plot(&out.join("time.svg"), "Time of a gradient", parameters(), "milliseconds", times)?;
    let caption = "Central differences / backward pass";
    save_plot(&out.join("speedup.svg"), caption, parameters(), "speed-up", speedup)?;
    println!("plots in {}", out.display());
    Ok(())
}

/// Seconds of both ways, and how far they are apart.
struct Trial {
    backward: f64,
    differences: f64,
    error: f64,
}

fn measure(triangles: usize, seed: u64) -> Result<Trial, Error> {
    let mut random = Random(seed);
    let scene = experiment::scene(triangles, SIZE, &mut random)?;
    let experiment = experiment::experiment(scene, &mut random);
    let recovery = experiment::recovery(&experiment)?;
    let mut objective = recovery.objective();
    let x = recovery.initial();

    // Every pass finds other parameters than the one before, as in an optimisation.
    let moved: Vec<f64> = x.iter().map(|x| x + 1e-12).collect();
    let by_backward = backward(&recovery, objective.as_mut(), &x);
    let clock = Instant::now();
    let mut repetitions = 0;
    while clock.elapsed().as_secs_f64() < SECONDS {
        backward(&recovery, objective.as_mut(), &moved);
        backward(&recovery, objective.as_mut(), &x);
        repetitions += 2;
    }
    let backward = clock.elapsed().as_secs_f64() / f64::from(repetitions);

    let stride = by_backward.len().div_ceil(MOST_DIFFERENCES);
    let clock = Instant::now();
    let by_differences = central_differences(&experiment.scene, &recovery, stride)?;
    let scale = by_backward.len() as f64 / by_differences.len() as f64;
    let differences = scale * clock.elapsed().as_secs_f64();
    Ok(Trial { backward, differences, error: largest_error(&by_backward, &by_differences) })
}

fn mean_and_deviation(samples: &[f64]) -> (f64, f64) {
    let count = samples.len() as f64;
    let mean = samples.iter().sum::<f64>() / count;
    let variance =
        samples.iter().map(|sample| (sample - mean).powi(2)).sum::<f64>() / (count - 1.0);
    (mean, variance.sqrt())
}
