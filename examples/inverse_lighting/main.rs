//! Inverse lighting: position and strength of a light from one image of a tree, section V-D of the
//! paper on RayTracer.jl ("Optimizing the Light Source").
//!
//! `cargo run --release --example inverse_lighting [tree.obj]`
//!
//! The paper's repository runs 401 iterations of Adam. An argument names a mesh to stand for the
//! generated tree. `out/inverse_lighting/` gets the target, a strip of images of the run (iterations
//! 0, 10, 50, 100 and the last) and the loss curve.

mod experiment;
#[path = "../shared/mesh_argument.rs"]
mod mesh_argument;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use renderer::Error;
use renderer::arithmetic::Arithmetic;
use renderer::files::save_png;
use renderer::optimize::write_report;
use renderer::recovery::render_at;
use serde_json::Map;
use strip::{brightest, strip};

/// The iterations of the paper's repository.
const PAPER_ITERATIONS: u64 = 401;
/// The iterations that the strip shows, before the last.
const SHOWN: [u64; 4] = [0, 10, 50, 100];

fn main() -> Result<(), Error> {
    let mut experiment = experiment::experiment(128)?;
    mesh_argument::apply(&mut experiment.scene)?;
    let recovery = experiment::recovery(&experiment)?;
    let out = Path::new("out/inverse_lighting");

    let outcome = experiment::run(&recovery, PAPER_ITERATIONS)?;
    write_report(out, recovery.variables(), &outcome, Map::new())?;
    let found = recovery.scene_at(&outcome.best.x);
    let truth: Vec<f64> =
        recovery.variables().iter().flat_map(|v| v.target.clone().unwrap_or_default()).collect();
    let (degrees, irradiance) = experiment::error_at_tree(&found, &recovery.scene_at(&truth));
    println!("found {:?}, true {truth:?}", outcome.best.x);
    println!(
        "at the tree: direction {degrees:.3} degrees off, irradiance {:.3} % off",
        100.0 * irradiance
    );
    println!(
        "loss ratio {:.1e} in {:.2} s",
        outcome.best.loss / outcome.initial_loss(),
        outcome.seconds
    );
    for ratio in [1e-2, 1e-3, 1e-4] {
        match experiment::first_below(&outcome, ratio) {
            Some(iteration) => println!("loss ratio {ratio:e} after {iteration} iterations"),
            None => println!("loss ratio {ratio:e} not reached"),
        }
    }

    let mut images = Vec::new();
    for steps in SHOWN {
        let x = experiment::run(&recovery, steps)?.last.x;
        images.push(render_at(Arithmetic::default(), &recovery.scene_at(&x)));
    }
    images.push(render_at(Arithmetic::default(), &found));
    save_png(&strip(&images, 1.0 / brightest(recovery.target())), &out.join("strip.png"))?;
    save_png(recovery.target(), &out.join("target.png"))?;
    println!("pictures and curve in {}", out.display());
    Ok(())
}
