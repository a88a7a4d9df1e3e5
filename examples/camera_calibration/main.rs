//! Film scale and position of a camera from one image of a rectangle, section V-C of the paper on
//! RayTracer.jl ("Calibration of Camera Parameters").
//!
//! `cargo run --release --example camera_calibration`
//!
//! Adam with a learning rate of 0.1 as in the paper, which stops when the loss has fallen from 5705.98
//! to 100; then other learning rates and other optimisers. Before a rectangle that the camera faces, standing further away
//! and zooming in cannot be told from each other: what the image tells is film scale times distance.
//! `out/camera_calibration/` gets a strip of images (guess, result, target, difference) and the loss
//! curves.

mod experiment;
#[path = "../shared/plot.rs"]
mod plot;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use plot::{Curve, Horizontal, Point, save_plot};
use renderer::files::save_png;
use renderer::optimize::{Optimizer, Outcome, Record, Settings as OptimizeSettings, write_report};
use renderer::{Error, Image};
use serde_json::Map;
use strip::{brightest, strip};

/// The optimiser and the learning rate of the paper.
const PAPER: (&str, f64) = ("adam", 0.1);
/// The others. A step of gradient descent is as long as the gradient; L-BFGS finds the lengths of its
/// steps, and its learning rates are the scales of its coordinates.
const OTHERS: [(&str, f64); 7] = [
    ("adam", 0.02),
    ("adam", 0.5),
    ("adamw", 0.1),
    ("rmsprop", 0.1),
    ("sgd", 0.1),
    ("sgd", 0.01),
    ("lbfgs", 0.1),
];

fn main() -> Result<(), Error> {
    let experiment = experiment::experiment(400, 300)?;
    let recovery = experiment::recovery(&experiment)?;
    let out = Path::new("out/camera_calibration");
    let settings = |name| -> Result<OptimizeSettings, Error> {
        let optimizer =
            Optimizer::named(name).map_err(|problem| Error::new("optimizer", problem))?;
        Ok(OptimizeSettings { optimizer, ..recovery.settings() })
    };

    let outcome = experiment::run(&experiment, PAPER.1, &settings(PAPER.0)?)?;
    write_report(out, recovery.variables(), &outcome, Map::new())?;
    let found = recovery.scene_at(&outcome.best.x);
    let camera = &found.camera;
    println!("position {:.5}, film scale {:.5}", camera.look_from, camera.film_scale);
    println!("film scale x distance {:.6}, true 30", experiment::magnification(camera));
    let mut curves = vec![describe(PAPER, &outcome)];
    for (name, rate) in OTHERS {
        let outcome = experiment::run(&experiment, rate, &settings(name)?)?;
        curves.push(describe((name, rate), &outcome));
    }

    let guess = recovery.render(&experiment.scene);
    let image = recovery.render(&found);
    let target = recovery.target();
    let difference = recovery.targets()[0].difference(&image);
    let images: Vec<Image> = [guess, image, target.clone()].into_iter().chain(difference).collect();
    save_png(&strip(&images, 1.0 / brightest(target)), &out.join("strip.png"))?;
    let iterations = Horizontal { title: "iteration", is_logarithmic: false };
    save_plot(&out.join("losses.svg"), "Optimiser, learning rate", iterations, "loss", &curves)?;
    println!("pictures and curves in {}", out.display());
    Ok(())
}

/// Prints how a run went, and makes a curve of it.
fn describe((name, rate): (&str, f64), outcome: &Outcome) -> Curve {
    let label = format!("{name}, {rate}");
    let reached = match experiment::first_below(outcome, experiment::PAPER_RATIO) {
        Some(iteration) => format!("below the paper's tolerance after {iteration} iterations"),
        None => "above the paper's tolerance".to_owned(),
    };
    let ratio = outcome.best.loss / outcome.initial_loss;
    println!("{label:>14}: {reached}; loss ratio {ratio:.1e} after {}", outcome.best.iteration);
    let point =
        |record: &Record| Point { x: record.iteration as f64, y: record.loss, deviation: 0.0 };
    Curve { label, points: outcome.history.iter().map(point).collect() }
}
