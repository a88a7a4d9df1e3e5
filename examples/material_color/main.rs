//! The diffuse colours of a tree from one image of it, section V-E of the paper on RayTracer.jl
//! ("Retrieving Color of Materials").
//!
//! `cargo run --release --example material_color [tree.obj]`
//!
//! Adam with a learning rate of 0.05, every step projected onto [0, 1], as in the paper, which finds
//! "a good approximation" after a single step and shows the image after 35. An argument names a mesh
//! to stand for the generated tree. `out/material_color/` gets a strip of images (the guess, 1 step,
//! 35 steps, the end, the target) and the loss curve.

mod experiment;
#[path = "../shared/mesh_argument.rs"]
mod mesh_argument;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use renderer::Error;
use renderer::files::save_png;
use renderer::optimize::{Lbfgs, Optimizer, write_report};
use serde_json::Map;
use strip::{brightest, strip};

/// The iterations that the paper shows: the guess, one step, 35; then what follows.
const STEPS: [u64; 4] = [0, 1, 35, 200];

fn main() -> Result<(), Error> {
    let mut scene = experiment::scene(400, 300)?;
    mesh_argument::apply(&mut scene)?;
    let experiment = experiment::experiment(scene)?;
    let recovery = experiment::recovery(&experiment)?;
    let out = Path::new("out/material_color");

    let mut images = Vec::new();
    for steps in STEPS {
        let outcome = experiment::run(&recovery, Optimizer::default(), steps)?;
        let mut x = &outcome.last.x[..];
        println!("{steps} steps: loss ratio {:.1e}", outcome.last.loss / outcome.initial_loss);
        for variable in recovery.variables() {
            let (found, rest) = x.split_at(variable.initial.len());
            x = rest;
            println!(
                "  {} {found:.4?}, true {:.4?}",
                variable.path,
                variable.target.as_deref().unwrap_or_default()
            );
        }
        images.push(recovery.render(&recovery.scene_at(&outcome.last.x)));
        write_report(out, recovery.variables(), &outcome, Map::new())?;
    }
    // The loss is quadratic in the colours: made for a method that learns the curvature.
    let outcome = experiment::run(&recovery, Optimizer::Lbfgs(Lbfgs::default()), 50)?;
    for record in outcome.history.iter().skip(1).take(5) {
        let ratio = record.loss / outcome.initial_loss;
        println!("L-BFGS, {} steps: loss ratio {ratio:.1e}", record.iteration);
    }
    images.push(recovery.target().clone());
    // The light is so strong that pictures have to be darkened.
    save_png(&strip(&images, 1.0 / brightest(recovery.target())), &out.join("strip.png"))?;
    println!("pictures and curve in {}", out.display());
    Ok(())
}
