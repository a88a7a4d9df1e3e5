//! What a gradient costs by what is asked for, and what scenes that use nothing special take.
//!
//! `cargo bench -p renderer -- requests` prints times and bytes of gradients by request.
//! `compare.py` beside this file runs it as `-- plain` in builds with and without each feature.

mod request;
#[path = "../sphere.rs"]
mod sphere;
#[path = "../timing.rs"]
mod timing;

use std::alloc::System;
use std::hash::{DefaultHasher, Hash, Hasher};

use peakmem_alloc::{INSTRUMENTED_SYSTEM, PeakMemAlloc};
use renderer::{Error, Image, ImageLoss, LossKind, Mesh, Renderer, Scene, Settings};
use sphere::{bumpy_sphere, scene};
use timing::{median, seconds};

#[global_allocator]
static ALLOCATOR: &PeakMemAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Images and gradients of each scene in one run.
const REPETITIONS: usize = 60;

fn main() -> Result<(), Error> {
    let subject = std::env::args().skip(1).find(|argument| !argument.starts_with("--"));
    match subject.as_deref() {
        None | Some("requests") => request::run(),
        Some("plain") => {
            plain("sphere", &scene(bumpy_sphere(140), 512, 1)?)?;
            // One that fills most of the image: the only scene on which nothing casts a shadow.
            let corners = vec![[-3.0, -2.0, 0.0], [3.0, -2.0, 0.0], [0.0, 3.0, 0.0]];
            plain("triangle", &scene(Mesh::new("triangle", corners, vec![[0, 1, 2]]), 512, 1)?)
        }
        // A subject of the other benches.
        Some(_) => Ok(()),
    }
}

/// Prints the medians of an image and of a gradient by everything in milliseconds, and a hash of both.
fn plain(name: &str, scene: &Scene) -> Result<(), Error> {
    let renderer = Renderer::new(scene, &Settings::default())?;
    let mut image = Image::black(scene.width, scene.height);
    let mut target = image.clone();
    target.pixels.fill([0.5; 3]);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let ids = scene.parameters();
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..REPETITIONS {
        times[0].push(seconds(|| renderer.render_into(&mut image)));
        times[1].push(seconds(|| renderer.loss_and_gradient(scene, &loss, &ids)));
    }
    let mut hasher = DefaultHasher::new();
    image.pixels.as_flattened().iter().for_each(|value| value.to_bits().hash(&mut hasher));
    let gradient = renderer.loss_and_gradient(scene, &loss, &ids).gradient.concat();
    gradient.iter().for_each(|value| value.to_bits().hash(&mut hasher));
    let [image, gradient] = times.map(|times| 1e3 * median(times));
    println!("{name} {image:.5} {gradient:.5} {:x}", hasher.finish());
    Ok(())
}
