//! A network that learns to find the light of an image, trained through the renderer: what section V
//! of the paper on RayTracer.jl joins to Flux, joined to candle.
//!
//! `cargo run --release -p network`
//!
//! A network sees images of a tree and two balls and answers where the lamp is and how strong. It is
//! never told: the scene is rendered with the lamp that it answers, the loss is how far that image is
//! from the one that it saw, and the gradient goes back through the renderer into the network.
//! `out/network/` gets held-back images above those with the lamps that the network finds in them,
//! before and after training, and the errors of training as curves.
//!
//! Of the maintained libraries that train, candle 0.11 was chosen over burn 0.22. An operation with a
//! backward pass of its own is one trait with two methods; in burn it is a trait that every back-end
//! implements, and another for its derivative. And it takes 4.3 minutes of processor time to build,
//! where burn takes 7.0 (its features `std`, `flex` and `autodiff`). Even so this is a package outside
//! of the default members of the workspace: `cargo build` and `cargo test` leave it alone unless asked.

mod layer;
mod network;
#[path = "../../shared/plot.rs"]
mod plot;
#[path = "../../shared/random.rs"]
mod random;
mod scene;
#[path = "../../shared/strip.rs"]
mod strip;
mod training;

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use layer::RenderLayer;
use network::{Network, SIZE};
use plot::{Curve, Horizontal, Point, save_plot};
use random::Random;
use renderer::files::save_png;
use renderer::{Image, Settings, render};
use scene::{Lamp, PATHS};
use strip::{brightest, strip};
use training::{Accuracy, Schedule, Views, find, train};

/// Images to train with, and images held back.
const IMAGES: [usize; 2] = [2000, 200];
const SCHEDULE: Schedule = Schedule { batch: 32, steps: 1500, learning_rate: 3e-3 };
/// The steps from one look at the held-back images to the next.
const INTERVAL: usize = 50;
/// How many of the held-back images the picture shows, and how large.
const SHOWN: usize = 6;
const SHOWN_SIZE: u32 = 160;
/// The black pixels between images one above the other.
const GAP: u32 = 4;

fn main() -> Result<(), Box<dyn Error>> {
    let out = Path::new("out/network");
    std::fs::create_dir_all(out).map_err(|error| renderer::Error::new(out.display(), error))?;
    let random = &mut Random(1);
    let layer = RenderLayer::new(scene::scene(SIZE as u32)?, &PATHS)?;
    let views = Views::random(&layer, IMAGES[0], random)?;
    let held_back = Views::random(&layer, IMAGES[1], random)?;
    let network = Network::new(random)?;
    let evaluate = |found: &[Lamp]| Accuracy::of(found, &layer, &held_back);

    println!("{} images of {SIZE} x {SIZE} to train with, {} held back", IMAGES[0], IMAGES[1]);
    let before = find(&network, &held_back.images)?;
    describe("before training", evaluate(&before)?);
    let curve = |label: &str| Curve { label: label.to_owned(), points: Vec::new() };
    let mut training = curve("images of the step");
    let mut held = curve("images held back");
    let clock = Instant::now();
    train(&network, &layer, &views.images, SCHEDULE, random, |step, loss| {
        let point = |error| Point { x: step as f64, y: error, deviation: 0.0 };
        training.points.push(point(f64::from(loss).sqrt()));
        if step % INTERVAL == 0 {
            held.points.push(point(evaluate(&find(&network, &held_back.images)?)?.image));
        }
        Ok(())
    })?;
    println!(
        "{} steps of {} images: {:.1} s",
        SCHEDULE.steps,
        SCHEDULE.batch,
        clock.elapsed().as_secs_f64()
    );
    let after = find(&network, &held_back.images)?;
    describe("after training", evaluate(&after)?);

    let steps = Horizontal { title: "step", is_logarithmic: false };
    let caption = "Relative error of images with the lamp that the network finds";
    save_plot(&out.join("error.svg"), caption, steps, "relative error", &[training, held])?;
    let lamps = held_back.lamps.iter().zip(&before).zip(&after).take(SHOWN);
    let columns = lamps.map(|((&truth, &before), &after)| column([truth, before, after]));
    save_png(&strip(&columns.collect::<Result<Vec<_>, _>>()?, 1.0), &out.join("held_back.png"))?;
    println!("pictures in {}", out.display());
    Ok(())
}

/// Prints how far the lamps found in the held-back images are from the true ones.
fn describe(when: &str, accuracy: Accuracy) {
    let Accuracy { image, distance, degrees, intensity } = accuracy;
    println!(
        "{when}: images off by {:.1} %, lamps by {distance:.2} units ({degrees:.1} degrees), \
         intensities by {:.0} %",
        100.0 * image,
        100.0 * intensity
    );
}

/// The scene with each of some lamps, one above the other, as bright as the first needs.
fn column(lamps: [Lamp; 3]) -> Result<Image, renderer::Error> {
    let layer = RenderLayer::new(scene::scene(SHOWN_SIZE)?, &PATHS)?;
    let scenes = lamps.map(|lamp| layer.scene_at(&lamp.numbers()));
    let mut images = Vec::new();
    for scene in scenes {
        images.push(render(&scene?, &Settings::default())?);
    }
    let exposure = 1.0 / brightest(&images[0]);
    let gap = vec![[0.0; 3]; (GAP * SHOWN_SIZE) as usize];
    let images: Vec<_> = images.into_iter().map(|image| strip(&[image], exposure).pixels).collect();
    let height = lamps.len() as u32 * (SHOWN_SIZE + GAP) - GAP;
    Ok(Image { width: SHOWN_SIZE, height, pixels: images.join(&gap[..]) })
}
