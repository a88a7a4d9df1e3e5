//! The position of a light, from the shadow of an object that the picture does not show, with edges and
//! without.
//!
//! `cargo run --release --example shadow`
//!
//! The picture shows a floor. The light and an arrow are above the camera, which looks down. Without edges
//! the gradient knows how bright the floor is, but not that the shadow moves. `out/shadow/` gets strips
//! of images (start, found without edges, found with edges, target) and the loss curves of L-BFGS.

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

use glam::DVec3;
use plot::{Horizontal, save_plot};
use random::Random;
use renderer::files::save_png;
use renderer::{Edges, Error};
use runs::{curve, named};
use strip::{brightest, strip};

/// The side of the images in pixels.
const SIZE: u32 = 96;
/// Steps of each run, if it does not stop before.
const STEPS: u64 = 60;
/// Where the light is to begin with.
const STARTS: [DVec3; 2] = [DVec3::new(-0.4, 4.2, -0.6), DVec3::new(1.0, 3.2, 0.2)];
/// How many random starts there are, and how far they are off along each axis at most.
const RANDOM_STARTS: u32 = 20;
const SPREAD: f64 = 1.5;
/// How far from the light a find may be.
const NEAR: f64 = 0.02;

fn main() -> Result<(), Error> {
    let out = Path::new("out/shadow");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let mut curves = Vec::new();
    for (index, start) in STARTS.into_iter().enumerate() {
        let experiment = experiment::experiment(SIZE, start)?;
        println!("start {start:.2}, {:.3} off", start.distance(experiment::TRUTH));
        let mut images = Vec::new();
        for edges in [Edges::Off, Edges::On] {
            let recovery = experiment::recovery(&experiment, edges)?;
            let outcome = experiment::run(&recovery, STEPS)?;
            println!(
                "  {:>13}: {:.6} off; loss ratio {:.1e}, {} iterations, {:.1} s",
                named(edges),
                experiment::error(&outcome),
                outcome.best.loss / outcome.initial_loss,
                outcome.last.iteration,
                outcome.seconds
            );
            curves.push(curve(format!("start {}, {}", index + 1, named(edges)), &outcome));
            images.push(recovery.render(&recovery.scene_at(&outcome.best.x)));
        }
        let recovery = experiment::recovery(&experiment, Edges::On)?;
        images.insert(0, recovery.render(&experiment.scene));
        images.push(recovery.target().clone());
        let picture = strip(&images, 1.0 / brightest(recovery.target()));
        save_png(&picture, &out.join(format!("start{}.png", index + 1)))?;
    }
    let steps = Horizontal { title: "iteration", is_logarithmic: false };
    save_plot(&out.join("losses.svg"), "L-BFGS", steps, "loss over that of the start", &curves)?;

    println!("{RANDOM_STARTS} random starts, up to {SPREAD} off along each axis:");
    for edges in [Edges::Off, Edges::On] {
        let mut random = Random(1);
        let (mut found, mut seconds) = (0, 0.0);
        for _ in 0..RANDOM_STARTS {
            let by = DVec3::from_array([(); 3].map(|()| random.between(-SPREAD, SPREAD)));
            let experiment = experiment::experiment(SIZE, experiment::TRUTH + by)?;
            let recovery = experiment::recovery(&experiment, edges)?;
            let outcome = experiment::run(&recovery, STEPS)?;
            found += u32::from(experiment::error(&outcome) < NEAR);
            seconds += outcome.seconds;
        }
        let edges = named(edges);
        println!("  {edges}: {found} of {RANDOM_STARTS} found within {NEAR}, {seconds:.1} s");
    }
    println!("pictures and curves in {}", out.display());
    Ok(())
}
