//! Where an object is and how it is turned, from one image, with edges and without.
//!
//! `cargo run --release --example pose`
//!
//! The object is 12, 25 and 40 degrees off and a little moved; then at 20 random poses that are 10
//! to 40 degrees off. L-BFGS and Adam minimise the mean squared difference. Without edges the gradient
//! has the interior term alone. `out/pose/` gets strips of images (start, found without edges, found
//! with edges, target) and the loss curves of L-BFGS.

mod experiment;
#[path = "../shared/plot.rs"]
mod plot;
#[path = "../shared/random.rs"]
mod random;
#[path = "../shared/runs.rs"]
mod runs;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use experiment::Pose;
use glam::DVec3;
use plot::{Horizontal, save_plot};
use random::Random;
use renderer::files::save_png;
use renderer::optimize::{Lbfgs, Optimizer, Outcome};
use renderer::{Edges, Error};
use runs::{curve, named};
use strip::{brightest, strip};

/// The side of the images in pixels.
const SIZE: u32 = 96;
/// How far the starts are turned, in degrees.
const ANGLES: [f64; 3] = [12.0, 25.0, 40.0];
/// Steps of each run, if it does not stop before.
const LBFGS_STEPS: u64 = 60;
const ADAM_STEPS: u64 = 100;
/// How many random starts there are.
const STARTS: u32 = 20;

fn main() -> Result<(), Error> {
    let out = Path::new("out/pose");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let truth = Pose::truth();
    let optimizers =
        [(Optimizer::Lbfgs(Lbfgs::default()), LBFGS_STEPS), (Optimizer::default(), ADAM_STEPS)];

    let mut curves = Vec::new();
    for angle in ANGLES {
        let start =
            truth.displaced(DVec3::new(0.5, 1.0, -0.4), angle, DVec3::new(0.1, -0.06, 0.08));
        let experiment = experiment::experiment(SIZE, &start)?;
        println!("start {angle} degrees and {:.3} off", start.error(&truth).1);
        let mut images = Vec::new();
        for edges in [Edges::Off, Edges::On] {
            let recovery = experiment::recovery(&experiment, edges)?;
            for (optimizer, steps) in optimizers {
                let outcome = experiment::run(&recovery, optimizer, steps)?;
                describe(edges, optimizer, &outcome);
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

    println!("{STARTS} random starts:");
    for edges in [Edges::Off, Edges::On] {
        for (optimizer, steps) in optimizers {
            let mut random = Random(1);
            let (mut found, mut seconds) = (0, 0.0);
            for _ in 0..STARTS {
                let start = random_start(&mut random);
                let experiment = experiment::experiment(SIZE, &start)?;
                let recovery = experiment::recovery(&experiment, edges)?;
                let outcome = experiment::run(&recovery, optimizer, steps)?;
                let error = Pose::found(&outcome.best.x).error(&truth);
                found += u32::from(experiment::is_found(error));
                seconds += outcome.seconds;
            }
            println!(
                "  {}, {}: {found} of {STARTS} found within 1 degree and 0.02, {seconds:.1} s",
                named(edges),
                optimizer.name()
            );
        }
    }
    println!("pictures and curves in {}", out.display());
    Ok(())
}

/// 10 to 40 degrees off about any axis, and up to 0.15 along each axis.
fn random_start(random: &mut Random) -> Pose {
    let mut within = |size: f64| DVec3::from_array([(); 3].map(|()| random.between(-size, size)));
    // Cubes hold no direction as often as any other; balls do.
    let axis = std::iter::repeat_with(|| within(1.0))
        .find(|axis| (0.01..1.0).contains(&axis.length_squared()))
        .unwrap_or(DVec3::Y);
    let by = within(0.15);
    Pose::truth().displaced(axis, random.between(10.0, 40.0), by)
}

/// Prints what a run came to.
fn describe(edges: Edges, optimizer: Optimizer, outcome: &Outcome) {
    let (degrees, distance) = Pose::found(&outcome.best.x).error(&Pose::truth());
    println!(
        "  {:>13}, {:>5}: {degrees:.4} degrees, {distance:.5} off; loss ratio {:.1e}, {} iterations, {:.1} s",
        named(edges),
        optimizer.name(),
        outcome.best.loss / outcome.initial_loss(),
        outcome.last.iteration,
        outcome.seconds
    );
}
