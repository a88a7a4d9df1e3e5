//! The colours of two walls of a Cornell box from one picture, one of which the picture does not show.
//!
//! `cargo run --release --example cornell`
//!
//! The left wall stands beside the image: its colour is known by the light alone that it sends to what the
//! camera sees. The target is rendered with other random numbers, and more of them. `out/cornell/` gets the
//! target, the guess, what was found, the curve of the loss, and the box as Mitsuba has it, as a scene file.

mod experiment;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;
use std::time::Instant;

use renderer::files::{save_png, save_scene};
use renderer::optimize::{Quiet, Settings as OptimizeSettings, write_report};
use renderer::recovery::Recovery;
use renderer::scene::{Integrator, PathTracing};
use renderer::{Error, Renderer, Scene, Settings, render};
use serde_json::Map;
use strip::{brightest, strip};

const STEPS: u64 = 100;
/// How many paths go through a pixel in each of them.
const SAMPLES: u32 = 8;

fn main() -> Result<(), Error> {
    let out = Path::new("out/cornell");
    let paths = PathTracing { max_depth: 6, samples: SAMPLES, seed: 0 };
    let scene = experiment::scene(96, paths)?;
    for wall in experiment::WALLS {
        let is_seen = if experiment::is_seen(&scene, wall)? { "seen" } else { "not seen" };
        println!("the {wall} wall is {is_seen}");
    }
    let target = PathTracing { samples: 1024, seed: 1, ..paths };
    let problem = experiment::experiment(&scene, target, out)?;
    let recovery = Recovery::new(&problem, "cornell", &Settings::default())?;
    let settings = OptimizeSettings { iterations: STEPS, ..recovery.settings() };
    let start = Instant::now();
    let outcome = recovery.run(&settings, &mut Quiet)?;
    let seconds = start.elapsed().as_secs_f64();
    println!("{STEPS} steps of {SAMPLES} samples in {seconds:.1} s");
    let found = recovery.scene_at(&outcome.best.x);
    for id in experiment::walls(&scene)? {
        println!("{} {:.4?}, true {:.4?}", scene.path(id), found.get(id), scene.get(id));
    }
    write_report(out, recovery.variables(), &outcome, Map::new())?;
    // With as many paths as the target has.
    let shown = |scene: &Scene| {
        let scene = Scene { integrator: Integrator::Path(target), ..scene.clone() };
        render(&scene, &Settings::default())
    };
    let images = [shown(&problem.scene)?, shown(&found)?, recovery.target().clone()];
    // The lamp is not in the picture.
    let exposure = 1.0 / brightest(recovery.target());
    save_png(&strip(&images, exposure), &out.join("strip.png"))?;

    let whole = experiment::cornell(256, PathTracing { samples: 64, ..paths })?;
    save_scene(&whole, &out.join("scene"))?;
    let image = Renderer::new(&whole, &Settings::default())?.render();
    save_png(&image, &out.join("cornell.png"))?;
    println!("pictures and curve in {}", out.display());
    Ok(())
}
