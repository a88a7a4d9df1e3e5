//! The light from everywhere, recovered from one picture of a ball that reflects it blurred.
//!
//! `cargo run --release --example environment`
//!
//! The picture shows the ball before a black background, not the map. The target is rendered with other random
//! numbers, and more of them. `out/environment/` gets the target, the guess and what was found; the true map
//! beside the one that was found; and something else lit by both, which says what the map is good for.

mod experiment;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;
use std::time::Instant;

use renderer::files::{save_exr, save_png, save_scene};
use renderer::optimize::{Quiet, Settings as OptimizeSettings, write_report};
use renderer::recovery::Recovery;
use renderer::scene::PathTracing;
use renderer::{Error, Image, Settings, render};
use serde_json::Map;
use strip::{brightest, strip};

const STEPS: u64 = 200;

fn main() -> Result<(), Error> {
    let out = Path::new("out/environment");
    let truth = experiment::map();
    let paths = PathTracing { max_depth: 2, samples: 32, seed: 0 };
    let scene = experiment::scene(64, &truth, paths)?;
    let target = PathTracing { samples: 1024, seed: 1, ..paths };
    let problem = experiment::experiment(&scene, target, out)?;
    let recovery = Recovery::new(&problem, "environment", &Settings::default())?;
    let settings = OptimizeSettings { iterations: STEPS, ..recovery.settings() };
    let start = Instant::now();
    let outcome = recovery.run(&settings, &mut Quiet)?;
    println!("{STEPS} steps of 32 samples in {:.1} s", start.elapsed().as_secs_f64());
    let found = recovery.scene_at(&outcome.best.x);
    let texels = experiment::texels(&scene)?;
    for (name, of) in [("guess", &problem.scene), ("found", &found)] {
        let [off, size] = experiment::difference(&scene.get(texels), &of.get(texels));
        println!("{name}: the map is off by {off:.3}, root mean square, of {size:.3}");
    }
    write_report(out, recovery.variables(), &outcome, Map::new())?;
    let guess = recovery.render(&problem.scene);
    let images = [guess, recovery.render(&found), recovery.target().clone()];
    save_png(&strip(&images, 1.0 / brightest(recovery.target())), &out.join("strip.png"))?;
    let map = found.textures()[0].image();
    save_png(
        &strip(&[truth.clone(), map.clone()].map(|map| enlarged(&map, 12)), 0.3),
        &out.join("maps.png"),
    )?;
    save_exr(&map, &out.join("found.exr"))?;

    let paths = PathTracing { max_depth: 4, samples: 256, seed: 0 };
    let lit_by = |map: &Image| render(&experiment::relit(192, map, paths)?, &Settings::default());
    let grey = Image { pixels: vec![[0.5; 3]; truth.pixels.len()], ..truth.clone() };
    let [true_light, found_light, grey_light] = [lit_by(&truth)?, lit_by(&map)?, lit_by(&grey)?];
    let off = |image: &Image| {
        let pairs = image.pixels.as_flattened().iter().zip(true_light.pixels.as_flattened());
        let squares = pairs.map(|(a, b)| f64::from(a - b).powi(2));
        (squares.sum::<f64>() / (3 * image.pixels.len()) as f64).sqrt()
    };
    println!(
        "something else lit by it is off by {:.4}, root mean square; by the guess {:.4}",
        off(&found_light),
        off(&grey_light)
    );
    save_png(&strip(&[true_light, found_light], 0.6), &out.join("relit.png"))?;
    save_scene(&found, &out.join("scene"))?;
    println!("pictures and curve in {}", out.display());
    Ok(())
}

/// Every pixel as a square of so many.
fn enlarged(image: &Image, factor: u32) -> Image {
    let (width, height) = (image.width * factor, image.height * factor);
    let pixel = |index: u32| {
        let (x, y) = (index % width / factor, index / width / factor);
        image.pixels[(y * image.width + x) as usize]
    };
    Image { width, height, pixels: (0..width * height).map(pixel).collect() }
}
