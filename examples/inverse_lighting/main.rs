//! Inverse lighting: position and strength of a light from one image of a tree, section V-D of the
//! paper on RayTracer.jl ("Optimizing the Light Source").
//!
//! `cargo run --release --example inverse_lighting [tree.obj]`
//!
//! The paper's repository runs 401 iterations of Adam, or 252 of L-BFGS. An argument names a mesh to stand for the
//! generated tree. `out/inverse_lighting/` gets the target, a strip of images of the run (iterations
//! 0, 10, 50, 100 and the last) and the loss curve.

mod experiment;
#[path = "../shared/mesh_argument.rs"]
mod mesh_argument;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use renderer::files::save_png;
use renderer::optimize::{Lbfgs, Optimizer, Outcome, write_report};
use renderer::recovery::Recovery;
use renderer::{Error, Scene};
use serde_json::Map;
use strip::{brightest, strip};

/// The iterations of the paper's repository.
const ADAM_ITERATIONS: u64 = 401;
const LBFGS_ITERATIONS: u64 = 252;
/// The iterations that the strip shows, before the last.
const SHOWN: [u64; 4] = [0, 10, 50, 100];

fn main() -> Result<(), Error> {
    let mut experiment = experiment::experiment(128)?;
    mesh_argument::apply(&mut experiment.scene)?;
    let recovery = experiment::recovery(&experiment)?;
    let out = Path::new("out/inverse_lighting");

    let truth: Vec<f64> =
        recovery.variables().iter().flat_map(|v| v.target.clone().unwrap_or_default()).collect();
    println!("true {truth:?}");
    let truth = recovery.scene_at(&truth);
    let lbfgs = experiment::run(&recovery, Optimizer::Lbfgs(Lbfgs::default()), LBFGS_ITERATIONS)?;
    describe("L-BFGS", &lbfgs, &recovery, &truth)?;
    let outcome = experiment::run(&recovery, Optimizer::default(), ADAM_ITERATIONS)?;
    describe("Adam", &outcome, &recovery, &truth)?;
    write_report(out, recovery.variables(), &outcome, Map::new())?;

    let mut images = Vec::new();
    for steps in SHOWN {
        let x = experiment::run(&recovery, Optimizer::default(), steps)?.last.x;
        images.push(recovery.render(&recovery.scene_at(&x)));
    }
    images.push(recovery.render(&recovery.scene_at(&outcome.best.x)));
    save_png(&strip(&images, 1.0 / brightest(recovery.target())), &out.join("strip.png"))?;
    save_png(recovery.target(), &out.join("target.png"))?;
    println!("pictures and curve in {}", out.display());
    Ok(())
}

/// Prints what a run came to.
fn describe(
    name: &str,
    outcome: &Outcome,
    recovery: &Recovery<'_>,
    truth: &Scene,
) -> Result<(), Error> {
    let Outcome { best, last, .. } = outcome;
    println!("{name}: {:?} after {} iterations, {:.2} s", best.x, last.iteration, outcome.seconds);
    let (degrees, irradiance) = experiment::error_at_tree(&recovery.scene_at(&best.x), truth)?;
    println!(
        "  at the tree: direction {degrees:.3} degrees off, irradiance {:.3} % off",
        100.0 * irradiance
    );
    println!("  loss ratio {:.1e}", best.loss / outcome.initial_loss);
    for ratio in [1e-2, 1e-3, 1e-4] {
        match experiment::first_below(outcome, ratio) {
            Some(iteration) => println!("  loss ratio {ratio:e} after {iteration} iterations"),
            None => println!("  loss ratio {ratio:e} not reached"),
        }
    }
    Ok(())
}
