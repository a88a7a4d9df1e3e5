//! The cost of a gradient at image level, and the rate of single primary rays: scene files or OBJ
//! files; without one a bumpy sphere of 78,400 triangles. Milliseconds and ratios to the render of
//! the same run, medians over interleaved repetitions.

use std::hint::black_box;
use std::path::Path;

use glam::DVec3;
use renderer::acceleration::{Acceleration, Shape};
use renderer::experiment::Experiment;
use renderer::integrator::{Prepared, Wanted, gradient, render};
use renderer::kernels::camera::{frame, primary_ray};
use renderer::loss::{ImageLoss, LossKind};
use renderer::scene::Scene;

use super::sphere::scene;
use super::timing::{median, seconds};

const REPETITIONS: usize = 15;

/// Measures scene files, OBJ files, or the sphere.
pub fn run(scenes: &[String]) {
    if scenes.is_empty() {
        measure("bumpy sphere", &scene(140, 512, 1));
    }
    for path in scenes {
        match Experiment::load(Path::new(path)) {
            Ok(experiment) => measure(path, &experiment.scene),
            Err(error) => eprintln!("error: {error}"),
        }
    }
}

fn measure(name: &str, scene: &Scene) {
    let triangles: usize = scene.meshes.iter().map(|mesh| mesh.triangles.len()).sum();
    println!(
        "{name}: {triangles} triangles, {} x {} pixels, {} threads",
        scene.width,
        scene.height,
        rayon::current_num_threads()
    );
    let prepared = Prepared::<wide::f32x16>::new(scene);
    let image = render(&prepared);
    let mut target = image.clone();
    target.pixels.iter_mut().flatten().for_each(|value| *value *= 0.9);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);

    let ids = scene.parameter_ids();
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
        primal.push(seconds(|| render(&prepared)));
        for ((_, ids), samples) in cases.iter().zip(&mut gradients) {
            samples.push(seconds(|| gradient(&prepared, &loss, Wanted::by(ids))));
        }
    }
    let primal = median(primal);
    println!("  render                  {:8.2} ms", primal * 1e3);
    for ((name, _), samples) in cases.iter().zip(gradients) {
        let time = median(samples);
        println!("  gradient by {name:11} {:8.2} ms  {:.2} x", time * 1e3, time / primal);
    }
    measure_rays(scene);
}

/// Traversal alone, on one thread.
fn measure_rays(scene: &Scene) {
    let vertex = |mesh: usize, index: u32| {
        DVec3::from(scene.parameters.vertices[mesh][index as usize]).as_vec3()
    };
    let shapes: Vec<_> = scene
        .meshes
        .iter()
        .enumerate()
        .flat_map(|(i, mesh)| {
            mesh.triangles.iter().map(move |t| Shape::Triangle(t.map(|v| vertex(i, v))))
        })
        .collect();
    let acceleration = Acceleration::new(&shapes);
    let aspect = f64::from(scene.width) / f64::from(scene.height);
    let frame = frame::<f64>(scene.parameters.camera, aspect);
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
                black_box(acceleration.nearest(origin, direction));
            }
        })
    });
    let rate = rays.len() as f64 / median(samples.collect());
    println!("  primary rays            {:8.2} Mrays/s on one thread", rate / 1e6);
}
