//! The derivatives of an image with edges, beside differences of finely sampled images and the interior
//! term alone.
//!
//! `cargo run --release --example edges`
//!
//! Red is brighter as the number grows, blue darker, white the same. `out/edges/` gets the image and,
//! for some numbers of the scene, a strip of the three: interior term, with edges, differences.

mod experiment;
#[path = "../shared/false_colors.rs"]
mod false_colors;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use false_colors::false_colors;
use renderer::files::save_png;
use renderer::{Edges, Error, Settings, render};
use strip::{brightest, strip};

/// The side of the images in pixels.
const SIZE: u32 = 192;

fn main() -> Result<(), Error> {
    let out = Path::new("out/edges");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let scene = experiment::scene(SIZE)?;
    let image = render(&scene, &Settings { edges: Edges::On, ..Settings::default() })?;
    let picture = strip(std::slice::from_ref(&image), 1.0 / brightest(&image));
    save_png(&picture, &out.join("image.png"))?;
    println!("L1 error over that of the differences:");
    for (path, element, step) in experiment::NUMBERS {
        let number = (scene.parameter(path)?, element);
        let interior = experiment::by_forward_mode(&scene, number, Edges::Off)?;
        let edges = experiment::by_forward_mode(&scene, number, Edges::On)?;
        let differences = experiment::by_differences(&scene, number, step)?;
        println!(
            "{path}[{element}]: with edges {:.4}, interior term alone {:.4}",
            experiment::relative_error(&edges, &differences),
            experiment::relative_error(&interior, &differences)
        );
        // Edges are thin, and far above all else.
        let largest = 0.5 * brightest(&differences);
        let pictures = [interior, edges, differences].map(|image| false_colors(&image, largest));
        let name = format!("{path}.{element}.png");
        save_png(&strip(&pictures, 1.0), &out.join(name))?;
    }
    println!("pictures in {}", out.display());
    Ok(())
}
