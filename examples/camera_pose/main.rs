//! Where a camera stands and where it looks, from one image, with edges and without.
//!
//! `cargo run --release --example camera_pose`
//!
//! The picture shows matt objects under a distant light: without edges the gradient by the camera is zero,
//! or almost. 20 cameras are up to 40 % of the distance off along each axis. `out/camera_pose/` gets a
//! strip of images (start, found without edges, found with edges, target) of the first three, and the loss
//! curves of L-BFGS. With edges it also goes from coarse images to fine ones, from one start and from the best
//! of 16.

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
const STEPS: u64 = 80;
/// How many random starts there are, how many of them are shown, and how far they are off along each axis
/// at most, in distances from the camera to where it looks.
const STARTS: usize = 20;
const SHOWN: usize = 3;
const SPREAD: f64 = 0.4;
/// With or without edges, how often images are halved to begin with, and from how many starts.
const RUNS: [(Edges, u32, u32); 4] =
    [(Edges::Off, 0, 1), (Edges::On, 0, 1), (Edges::On, 3, 1), (Edges::On, 3, 16)];
/// How far from the truth a find may be, in place and in direction.
const NEAR: f64 = 0.02;

fn main() -> Result<(), Error> {
    let out = Path::new("out/camera_pose");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let [look_from, look_at] = experiment::TRUTH;
    let spread = SPREAD * look_from.distance(look_at);
    let mut random = Random(1);
    let mut starts = Vec::new();
    while starts.len() < STARTS {
        let mut within =
            |size: f64| DVec3::from_array([(); 3].map(|()| random.between(-size, size)));
        let start = [look_from + within(spread), look_at + within(0.1 * spread)];
        // Not below the floor.
        if start[0].y > 0.3 {
            starts.push(start);
        }
    }
    let mut curves = Vec::new();
    let mut images = vec![Vec::new(); SHOWN];
    for (edges, coarse_to_fine, count) in RUNS {
        let (mut found, mut seconds) = (0, 0.0);
        for (index, &start) in starts.iter().enumerate() {
            let experiment = experiment::experiment(SIZE, start, coarse_to_fine, count)?;
            let recovery = experiment::recovery(&experiment, edges)?;
            let outcome = experiment::run(&recovery, STEPS)?;
            let (distance, angle) = experiment::error(&outcome);
            found += usize::from(distance < NEAR && angle < NEAR);
            seconds += outcome.seconds;
            if let (0, Some(images)) = (coarse_to_fine, images.get_mut(index)) {
                println!(
                    "start {}, {:.2} off, {}: {distance:.5} off, {angle:.5} in direction; loss ratio {:.1e}, {} iterations",
                    index + 1,
                    start[0].distance(look_from),
                    named(edges),
                    outcome.best.loss / outcome.initial_loss,
                    outcome.last.iteration
                );
                let shown = experiment::recovery(&experiment, Edges::On)?;
                if images.is_empty() {
                    images.push(shown.render(&experiment.scene));
                }
                images.push(shown.render(&shown.scene_at(&outcome.best.x)));
                if edges == Edges::On {
                    images.push(shown.target().clone());
                    curves.push(curve(format!("start {}", index + 1), &outcome));
                }
            }
        }
        println!(
            "{}, {coarse_to_fine} levels, {count} starts: {found} of {STARTS} found within {NEAR}, {seconds:.1} s",
            named(edges)
        );
    }
    for (index, images) in images.iter().enumerate() {
        let scale = images.last().map_or(1.0, |target| 1.0 / brightest(target));
        save_png(&strip(images, scale), &out.join(format!("start{}.png", index + 1)))?;
    }
    let steps = Horizontal { title: "iteration", is_logarithmic: false };
    save_plot(&out.join("losses.svg"), "L-BFGS", steps, "loss over that of the start", &curves)?;
    println!("pictures and curves in {}", out.display());
    Ok(())
}
