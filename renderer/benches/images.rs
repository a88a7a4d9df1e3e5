//! The cost of a gradient at image level, and the rate of single primary rays: scene files or OBJ
//! files; without one a bumpy sphere of 78,400 triangles. Milliseconds and ratios to the render of
//! the same run, medians over interleaved repetitions.

use std::hint::black_box;
use std::path::Path;

use glam::DVec3;
use renderer::experiment::Experiment;
use renderer::trace::bvh::{Bvh, Shape};
use renderer::transport::camera::{camera_frame, primary_ray};
use renderer::{Error, ImageLoss, LossKind, Renderer, Scene, Settings};

use super::sphere::{bumpy_sphere, scene};
use super::timing::{median, seconds};

const REPETITIONS: usize = 15;

/// Measures scene files, OBJ files, or the sphere.
pub fn run(scenes: &[String]) {
    let load = |path: &String| measure(path, &Experiment::load(Path::new(path))?.scene);
    let measured = match scenes {
        [] => scene(bumpy_sphere(140), 512, 1).and_then(|scene| measure("bumpy sphere", &scene)),
        paths => paths.iter().try_for_each(load),
    };
    if let Err(error) = measured {
        eprintln!("error: {error}");
    }
}

fn measure(name: &str, scene: &Scene) -> Result<(), Error> {
    let triangles: usize = scene.meshes().iter().map(|mesh| mesh.triangles.len()).sum();
    println!(
        "{name}: {triangles} triangles, {} x {} pixels, {} threads",
        scene.width,
        scene.height,
        rayon::current_num_threads()
    );
    let renderer = Renderer::new(scene, &Settings::default())?;
    let mut target = renderer.render();
    target.pixels.iter_mut().flatten().for_each(|value| *value *= 0.9);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);

    let ids = scene.parameters();
    let beginning = |start: &str| {
        let ids = ids.iter().filter(|&&id| scene.path(id).to_string().starts_with(start));
        ids.copied().collect::<Vec<_>>()
    };
    let cases = [
        ("lights", beginning("light.")),
        ("materials", beginning("material.")),
        ("camera", beginning("camera.")),
        ("vertices", beginning("mesh.")),
        ("everything", beginning("")),
    ];
    let mut primal = Vec::new();
    let mut gradients = vec![Vec::new(); cases.len()];
    for _ in 0..REPETITIONS {
        primal.push(seconds(|| renderer.render()));
        for ((_, ids), samples) in cases.iter().zip(&mut gradients) {
            samples.push(seconds(|| renderer.loss_and_gradient(scene, &loss, ids)));
        }
    }
    let primal = median(primal);
    println!("  render                  {:8.2} ms", primal * 1e3);
    for ((name, _), samples) in cases.iter().zip(gradients) {
        let time = median(samples);
        println!("  gradient by {name:11} {:8.2} ms  {:.2} x", time * 1e3, time / primal);
    }
    measure_rays(scene);
    Ok(())
}

/// Traversal alone, on one thread.
fn measure_rays(scene: &Scene) {
    let shapes = scene.meshes().iter().flat_map(|mesh| {
        let vertices: Vec<DVec3> = mesh.world_vertices().collect();
        let corners = |t: &[u32; 3]| t.map(|v| vertices[v as usize].as_vec3());
        mesh.triangles.iter().map(corners).map(Shape::Triangle).collect::<Vec<_>>()
    });
    let bvh = Bvh::new(&shapes.collect::<Vec<_>>());
    let frame = camera_frame::<f64>(scene.camera, scene.aspect());
    let rays: Vec<_> = (0..512 * 512)
        .map(|i| {
            let film = |i: i32| (f64::from(i) + 0.5) / 256.0 - 1.0;
            let ray = primary_ray::<f64>(frame, film(i % 512), -film(i / 512));
            (ray.origin.as_vec3(), ray.direction.as_vec3())
        })
        .collect();
    let samples = (0..REPETITIONS).map(|_| {
        seconds(|| {
            for &(origin, direction) in &rays {
                black_box(bvh.nearest(origin, direction));
            }
        })
    });
    let rate = rays.len() as f64 / median(samples.collect());
    println!("  primary rays            {:8.2} Mrays/s on one thread", rate / 1e6);
}
