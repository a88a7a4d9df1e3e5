//! Where an object is and how it is turned, from one image, with edges and without.
//!
//! `cargo run --release --example pose`, or with a file of a mesh, which takes the place of the cubes
//!
//! The object is 12, 25 and 40 degrees off and a little moved; then at 20 random poses for each of these
//! angles. L-BFGS and Adam minimise the mean squared difference. Without edges the gradient
//! has the interior term alone. Levenberg-Marquardt goes from coarse images to fine ones, as L-BFGS does from one
//! start and from the best of 16. `out/pose/` gets
//! strips of images (start, found without edges, found with edges, target) and the loss curves of L-BFGS.

mod experiment;
#[path = "../shared/merged.rs"]
mod merged;
mod mesh;
#[path = "../shared/plot.rs"]
mod plot;
#[path = "../shared/random.rs"]
mod random;
#[path = "../shared/runs.rs"]
mod runs;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use experiment::{Pose, Task};
use glam::DVec3;
use plot::{Horizontal, save_plot};
use random::Random;
use renderer::files::save_png;
use renderer::optimize::{Adam, Lbfgs, Lm, Optimizer, Outcome};
use renderer::{Edges, Error};
use runs::{curve, named};
use strip::{brightest, strip};

/// The side of the images in pixels: of the cubes, and of a mesh.
const SIZES: [u32; 2] = [96, 128];
/// How far the starts are turned, in degrees, and how far random ones are moved.
const LEVELS: [(f64, f64); 3] = [(12.0, 0.18), (25.0, 0.35), (40.0, 0.5)];
/// Steps of each run, if it does not stop before.
const LBFGS_STEPS: u64 = 60;
const ADAM_STEPS: u64 = 100;
const LM_STEPS: u64 = 75;
/// How many random starts there are.
const STARTS: u32 = 20;
/// Methods, their steps, how often images are halved to begin with, and from how many starts.
type Method = (fn() -> Optimizer, u64, u32, u32);
const METHODS: [Method; 5] = [
    (|| Optimizer::Lbfgs(Lbfgs::default()), LBFGS_STEPS, 0, 1),
    (|| Optimizer::Lbfgs(Lbfgs::default()), 2 * LBFGS_STEPS, 3, 1),
    (|| Optimizer::Lbfgs(Lbfgs::default()), 2 * LBFGS_STEPS, 3, 16),
    (|| Optimizer::Adam(Adam::default()), ADAM_STEPS, 0, 1),
    (|| Optimizer::Lm(Lm::default()), LM_STEPS, 3, 1),
];

fn main() -> Result<(), Error> {
    let out = Path::new("out/pose");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let task = match std::env::args_os().nth(1) {
        Some(path) => mesh::task(Path::new(&path), SIZES[1])?,
        None => Task::cubes(SIZES[0]),
    };
    let truth = task.truth;
    let optimizers =
        [(Optimizer::Lbfgs(Lbfgs::default()), LBFGS_STEPS), (Optimizer::default(), ADAM_STEPS)];

    let mut curves = Vec::new();
    for (angle, _) in LEVELS {
        let start =
            truth.displaced(DVec3::new(0.5, 1.0, -0.4), angle, DVec3::new(0.1, -0.06, 0.08));
        let experiment = experiment::experiment(&task, &start, 0, 1)?;
        println!("start {angle} degrees and {:.3} off", start.error(&truth).1);
        let mut images = Vec::new();
        for edges in [Edges::Off, Edges::On] {
            let recovery = experiment::recovery(&experiment, edges)?;
            for (optimizer, steps) in optimizers {
                let outcome = experiment::run(&recovery, optimizer, steps)?;
                describe(&task, edges, optimizer, &outcome);
                if optimizer.finds_step_lengths() {
                    let label = format!("{angle} degrees, {}", named(edges));
                    curves.push(curve(label, &outcome));
                    images.push(recovery.render(&recovery.scene_at(&outcome.best.x)));
                }
            }
        }
        let recovery = experiment::recovery(&experiment, Edges::On)?;
        images.insert(0, recovery.render(&experiment.scene));
        images.push(recovery.target().clone());
        let picture = strip(&images, 1.0 / brightest(recovery.target()));
        save_png(&picture, &out.join(format!("start{angle}.png")))?;
    }
    let steps = Horizontal { title: "iteration", is_logarithmic: false };
    save_plot(&out.join("losses.svg"), "Start", steps, "loss over that of the start", &curves)?;

    println!("{STARTS} starts each:");
    for (angle, distance) in LEVELS {
        for (optimizer, steps, coarse_to_fine, starts) in METHODS {
            let mut random = Random(1);
            let (mut found, mut close, mut seconds, mut iterations) = (0, 0, 0.0, 0);
            for _ in 0..STARTS {
                let by = direction(&mut random) * distance;
                let start = task.truth.displaced(direction(&mut random), angle, by);
                let experiment = experiment::experiment(&task, &start, coarse_to_fine, starts)?;
                let recovery = experiment::recovery(&experiment, Edges::On)?;
                let outcome = experiment::run(&recovery, optimizer(), steps)?;
                let error = Pose::found(&outcome.best.x).error(&task.truth);
                found += u32::from(experiment::is_found(error));
                close += u32::from(error.0 < 0.05);
                seconds += outcome.seconds / f64::from(STARTS);
                iterations += outcome.last.iteration;
            }
            println!(
                "  {angle} degrees, {distance}: {:>5}, {coarse_to_fine} levels, {starts} starts: {close} within 0.05 degrees, {found} within 1 degree \
                 and 0.02; mean {seconds:.2} s, {} iterations",
                optimizer().name(),
                iterations / u64::from(STARTS)
            );
        }
    }
    println!("pictures and curves in {}", out.display());
    Ok(())
}

/// Any direction, as often as any other.
fn direction(random: &mut Random) -> DVec3 {
    let mut within = || DVec3::from_array([(); 3].map(|()| random.between(-1.0, 1.0)));
    // Cubes hold no direction as often as any other; balls do.
    let found = std::iter::repeat_with(&mut within);
    let mut found = found.filter(|v| (0.01..1.0).contains(&v.length_squared()));
    found.next().map_or(DVec3::Y, DVec3::normalize)
}

/// Prints what a run came to.
fn describe(task: &Task, edges: Edges, optimizer: Optimizer, outcome: &Outcome) {
    let (degrees, distance) = Pose::found(&outcome.best.x).error(&task.truth);
    println!(
        "  {:>13}, {:>5}: {degrees:.4} degrees, {distance:.5} off; loss ratio {:.1e}, {} iterations, {:.1} s",
        named(edges),
        optimizer.name(),
        outcome.best.loss / outcome.initial_loss,
        outcome.last.iteration,
        outcome.seconds
    );
}
