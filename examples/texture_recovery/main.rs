//! A texture of 64 x 64 texels on a wavy sheet, recovered from three images of it by its gradient:
//! beyond the paper on RayTracer.jl, whose textures have none.
//!
//! `cargo run --release --example texture_recovery`
//!
//! Three cameras see the sheet; the losses of their images are added up, and Adam finds the 12,288
//! numbers of the texture that all of them share. `out/texture_recovery/` gets a strip of the texture
//! (at first, after 5, 20 and all steps, and the true one), the views, and the loss curve.

mod experiment;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;

use renderer::files::save_png;
use renderer::optimize::write_report;
use renderer::recovery::Recovery;
use renderer::{Error, Image};
use serde_json::Map;
use strip::{brightest, strip};

const TEXELS: u32 = 64;
const STEPS: [u64; 4] = [0, 5, 20, 100];
/// The pixels of a texel in the pictures of the texture.
const ENLARGED: u32 = 4;

fn main() -> Result<(), Error> {
    let views = experiment::views(TEXELS, 256)?;
    let recoveries = experiment::recoveries(&views)?;
    let out = Path::new("out/texture_recovery");
    let mut textures = Vec::new();
    for steps in STEPS {
        let outcome = experiment::run(&recoveries, steps)?;
        println!(
            "{steps:>3} steps: loss ratio {:.1e}, texels off by {:.5} (root mean square), {:.2} s",
            outcome.last.loss / outcome.initial_loss,
            experiment::error(&recoveries[0], &outcome.last.x),
            outcome.seconds
        );
        textures.push(enlarged(&outcome.last.x));
        write_report(out, recoveries[0].variables(), &outcome, Map::new())?;
        if steps == STEPS[STEPS.len() - 1] {
            let image =
                |recovery: &Recovery<'_>| recovery.render(&recovery.scene_at(&outcome.last.x));
            let images: Vec<Image> = recoveries.iter().map(image).collect();
            save_png(&strip(&images, 1.0 / brightest(&images[0])), &out.join("views.png"))?;
        }
    }
    textures.extend(recoveries[0].variables()[0].target.as_deref().map(enlarged));
    save_png(&strip(&textures, 1.0), &out.join("texture.png"))?;
    println!("pictures and curve in {}", out.display());
    Ok(())
}

/// A texture as an image, every texel a square of pixels.
fn enlarged(texels: &[f64]) -> Image {
    let size = TEXELS * ENLARGED;
    let mut image = Image::black(size, size);
    for (index, pixel) in (0..).zip(&mut image.pixels) {
        let (column, row) = (index % size / ENLARGED, index / size / ENLARGED);
        let first = 3 * (row * TEXELS + column) as usize;
        *pixel = [0, 1, 2].map(|channel| texels[first + channel] as f32);
    }
    image
}
