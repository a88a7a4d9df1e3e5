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

use ad::lanes::f32x16;
use peakmem_alloc::{INSTRUMENTED_SYSTEM, PeakMemAlloc};
use renderer::image::Image;
use renderer::integrator::{Prepared, Wanted, gradient, render_into};
use renderer::loss::{ImageLoss, LossKind};
use renderer::scene::Scene;
use timing::{median, seconds};

#[global_allocator]
static ALLOCATOR: &PeakMemAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Images and gradients of each scene in one run.
const REPETITIONS: usize = 60;

fn main() {
    let subject = std::env::args().skip(1).find(|argument| !argument.starts_with("--"));
    match subject.as_deref() {
        None | Some("requests") => request::run(),
        Some("plain") => {
            plain("sphere", &sphere::scene(140, 512, 1));
            plain("triangle", &single_triangle());
        }
        // A subject of the other benches.
        Some(_) => {}
    }
}

/// One triangle that fills most of the image, under one light: the only scene on which nothing casts
/// a shadow.
fn single_triangle() -> Scene {
    let mut scene = sphere::scene(2, 512, 1);
    scene.parameters.vertices = vec![vec![[-3.0, -2.0, 0.0], [3.0, -2.0, 0.0], [0.0, 3.0, 0.0]]];
    scene.meshes[0].triangles = vec![[0, 1, 2]];
    scene.meshes[0].materials = vec![0];
    scene
}

/// Prints the medians of an image and of a gradient by everything in milliseconds, and a hash of both.
fn plain(name: &str, scene: &Scene) {
    let prepared = Prepared::<f32x16>::new(scene);
    let target =
        Image { pixels: vec![[0.5; 3]; (scene.width * scene.height) as usize], ..size(scene) };
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let ids = scene.parameter_ids();
    let wanted = Wanted::by(&ids);
    let mut image = size(scene);
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..REPETITIONS {
        times[0].push(seconds(|| render_into(&prepared, &mut image)));
        times[1].push(seconds(|| gradient(&prepared, &loss, wanted)));
    }
    let mut hasher = DefaultHasher::new();
    image.pixels.as_flattened().iter().for_each(|value| value.to_bits().hash(&mut hasher));
    let result = gradient(&prepared, &loss, wanted);
    for &id in &ids {
        result.gradient.get(id).iter().for_each(|value| value.to_bits().hash(&mut hasher));
    }
    let [image, gradient] = times.map(|times| 1e3 * median(times));
    println!("{name} {image:.5} {gradient:.5} {:x}", hasher.finish());
}

/// A black image of the size of a scene's.
fn size(scene: &Scene) -> Image {
    Image::black(scene.width, scene.height)
}
