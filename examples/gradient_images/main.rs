//! The derivative of an image by one number of its scene, in false colours: forward mode beside finite
//! differences.
//!
//! `cargo run --release --example gradient_images [camera.look_at [0]]`
//!
//! Arguments name another parameter and which of its numbers. Forward mode is `render_jvp`; both see
//! silhouettes and shadow edges move. Red is brighter as the number grows, blue darker, white the same.
//! `out/gradient_images/` gets the image, both derivatives, and a strip of the three.

mod experiment;
#[path = "../shared/false_colors.rs"]
mod false_colors;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use false_colors::false_colors;
use renderer::files::save_png;
use renderer::{Error, Settings, render};
use strip::{brightest, strip};

fn main() -> Result<(), Error> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let path = arguments.first().map_or("camera.look_at", String::as_str);
    let scene = experiment::scene(256)?;
    let id = scene.parameter(path)?;
    let count = scene.get(id).len();
    let element = match arguments.get(1) {
        None => 0,
        Some(text) => text.parse().ok().filter(|&element| element < count).ok_or_else(|| {
            Error::new(path, format_args!("has {count} numbers; `{text}` is the index of none"))
        })?,
    };

    let forward = experiment::by_forward_mode(&scene, id, element)?;
    let differences = experiment::by_differences(&scene, id, element)?;
    println!("largest derivative by {path}[{element}]: {:.3e}", experiment::largest(&forward));
    for tolerance in [1e-1, 1e-2, 1e-3] {
        println!(
            "differences off by more than {tolerance} of that at {:.2} % of the pixels",
            100.0 * experiment::different(&forward, &differences, tolerance)
        );
    }

    let out = Path::new("out/gradient_images");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let image = render(&scene, &Settings::default())?;
    let picture = strip(std::slice::from_ref(&image), 1.0 / brightest(&image));
    let scale = experiment::largest(&forward);
    let [forward, differences] =
        [forward, differences].map(|derivatives| false_colors(&derivatives, scale));
    save_png(&picture, &out.join("image.png"))?;
    save_png(&forward, &out.join("forward.png"))?;
    save_png(&differences, &out.join("differences.png"))?;
    save_png(&strip(&[picture, forward, differences], 1.0), &out.join("strip.png"))?;
    println!("pictures in {}", out.display());
    Ok(())
}
