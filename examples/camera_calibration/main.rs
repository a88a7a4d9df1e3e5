//! Focus and position of a camera from one image of a rectangle, section V-C of the paper on
//! RayTracer.jl ("Calibration of Camera Parameters").
//!
//! `cargo run --release --example camera_calibration`
//!
//! Adam with a learning rate of 0.1 as in the paper, which stops when the loss has fallen from 5705.98
//! to 100; then other learning rates. Before a rectangle that the camera faces, standing further away
//! and zooming in cannot be told from each other: what the image tells is focus times distance.
//! `out/camera_calibration/` gets a strip of images (guess, result, target, difference) and the loss
//! curves.

mod experiment;
#[path = "../shared/plot.rs"]
mod plot;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use plot::{Curve, Horizontal, Point, save_plot};
use renderer::Error;
use renderer::arithmetic::Arithmetic;
use renderer::files::save_png;
use renderer::image::Image;
use renderer::optimize::{Outcome, Record, write_report};
use renderer::recovery::render_at;
use serde_json::Map;
use strip::{brightest, strip};

/// The learning rate of the paper.
const LEARNING_RATE: f64 = 0.1;
/// The others.
const RATES: [f64; 4] = [0.02, 0.05, 0.2, 0.5];

fn main() -> Result<(), Error> {
    let experiment = experiment::experiment(400, 300)?;
    let recovery = experiment::recovery(&experiment)?;
    let out = Path::new("out/camera_calibration");
    let settings = recovery.settings();

    let outcome = experiment::run(&experiment, LEARNING_RATE, &settings)?;
    write_report(out, recovery.variables(), &outcome, Map::new())?;
    let found = recovery.scene_at(&outcome.best.x);
    let camera = &found.parameters.camera;
    println!("position {:.5}, focus {:.5}", camera.look_from, camera.focus);
    println!("focus x distance {:.6}, true 30", experiment::magnification(camera));
    let mut curves = vec![describe("Adam, 0.1", &outcome)];
    for rate in RATES {
        let outcome = experiment::run(&experiment, rate, &settings)?;
        curves.push(describe(&format!("Adam, {rate}"), &outcome));
    }

    let guess = render_at(Arithmetic::default(), &experiment.scene);
    let image = render_at(Arithmetic::default(), &found);
    let target = recovery.target();
    let difference = recovery.difference(&image);
    let images: Vec<Image> = [guess, image, target.clone()].into_iter().chain(difference).collect();
    save_png(&strip(&images, 1.0 / brightest(target)), &out.join("strip.png"))?;
    let iterations = Horizontal { title: "iteration", is_logarithmic: false };
    save_plot(&out.join("losses.svg"), "Optimiser, learning rate", iterations, "loss", &curves)?;
    println!("pictures and curves in {}", out.display());
    Ok(())
}

/// Prints how a run went, and makes a curve of it.
fn describe(label: &str, outcome: &Outcome) -> Curve {
    let reached = match experiment::first_below(outcome, experiment::PAPER_RATIO) {
        Some(iteration) => format!("below the paper's tolerance after {iteration} iterations"),
        None => "above the paper's tolerance".to_owned(),
    };
    let ratio = outcome.best.loss / outcome.initial_loss();
    println!("{label:>14}: {reached}; loss ratio {ratio:.1e} after {}", outcome.best.iteration);
    let point =
        |record: &Record| Point { x: record.iteration as f64, y: record.loss, deviation: 0.0 };
    Curve { label: label.to_owned(), points: outcome.history.iter().map(point).collect() }
}
