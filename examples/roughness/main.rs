//! A texture of roughness from three pictures of a glazed tile.
//!
//! `cargo run --release --example roughness`
//!
//! Highlights are sharp where the glaze is polished and wide where it is not; the guess is the same roughness
//! everywhere. `out/roughness/` gets the pictures of guess, result and target, and the textures of all three.

mod experiment;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;
use std::time::Instant;

use renderer::files::save_png;
use renderer::optimize::{Quiet, Settings as OptimizeSettings, write_report};
use renderer::recovery::Recovery;
use renderer::{Error, Settings};
use serde_json::Map;
use strip::{brightest, strip};

const STEPS: u64 = 300;

fn main() -> Result<(), Error> {
    let out = Path::new("out/roughness");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let truth = experiment::scene(96)?;
    let problem = experiment::experiment(&truth)?;
    let recovery = Recovery::new(&problem, "roughness", &Settings::default())?;
    let settings = OptimizeSettings { iterations: STEPS, ..recovery.settings() };
    let start = Instant::now();
    let outcome = recovery.run(&settings, &mut Quiet)?;
    let seconds = start.elapsed().as_secs_f64();
    let found = recovery.scene_at(&outcome.best.x);
    println!("{STEPS} steps with three views in {seconds:.1} s");
    println!("mean error of the guess {:.4}", experiment::error(&problem.scene, &truth)?);
    println!("mean error of what was found {:.4}", experiment::error(&found, &truth)?);
    write_report(out, recovery.variables(), &outcome, Map::new())?;
    let images = [&problem.scene, &found, &truth].map(|scene| recovery.render(scene));
    let exposure = 1.0 / brightest(&images[2]);
    save_png(&strip(&images, exposure), &out.join("pictures.png"))?;
    let maps = [&problem.scene, &found, &truth].map(|scene| experiment::map(scene, 12));
    let [guess, found, truth] = maps;
    save_png(&strip(&[guess?, found?, truth?], 1.0), &out.join("textures.png"))?;
    println!("pictures and curve in {}", out.display());
    Ok(())
}
