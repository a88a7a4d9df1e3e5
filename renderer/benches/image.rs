//! The cost of a gradient at image level, and the rate of primary rays.
//!
//! `cargo bench -p renderer --bench image [-- SCENE ..]` takes scene files or OBJ files; without one
//! it uses a bumpy sphere of 78,400 triangles. It prints milliseconds and ratios to the render of
//! the same run, medians over interleaved repetitions.

use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use glam::{DVec3, dvec3};
use renderer::acceleration::{Acceleration, Shape};
use renderer::experiment::Experiment;
use renderer::integrator::{Prepared, Wanted, gradient, render};
use renderer::kernels::camera::{Camera, frame, primary_ray};
use renderer::kernels::light::PointLight;
use renderer::kernels::material::Material;
use renderer::loss::{ImageLoss, LossKind};
use renderer::scene::{Light, MeshObject, Parameters, Scene};

const REPETITIONS: usize = 15;

fn main() {
    let scenes: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    if scenes.is_empty() {
        measure("bumpy sphere", &bumpy_sphere(140));
    }
    for path in scenes {
        match Experiment::load(Path::new(&path)) {
            Ok(experiment) => measure(&path, &experiment.scene),
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

    let cases = [
        ("lights", Wanted { lights: true, ..Wanted::default() }),
        ("materials", Wanted { materials: true, ..Wanted::default() }),
        ("camera", Wanted { camera: true, ..Wanted::default() }),
        ("vertices", Wanted { vertices: true, ..Wanted::default() }),
        (
            "everything",
            Wanted { camera: true, lights: true, materials: true, spheres: true, vertices: true },
        ),
    ];
    let mut primal = Vec::new();
    let mut gradients = vec![Vec::new(); cases.len()];
    for _ in 0..REPETITIONS {
        primal.push(seconds(|| drop(black_box(render(&prepared)))));
        for ((_, wanted), samples) in cases.iter().zip(&mut gradients) {
            samples.push(seconds(|| drop(black_box(gradient(&prepared, &loss, *wanted)))));
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

fn seconds(run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64()
}

fn median(mut samples: Vec<f64>) -> f64 {
    samples.sort_by(f64::total_cmp);
    samples[samples.len() / 2]
}

/// A sphere with bumps, `rings` by `2 rings` quadrilaterals.
fn bumpy_sphere(rings: u32) -> Scene {
    let columns = 2 * rings;
    let mut vertices = Vec::new();
    for ring in 0..=rings {
        for column in 0..columns {
            let latitude = std::f64::consts::PI * f64::from(ring) / f64::from(rings);
            let longitude = std::f64::consts::TAU * f64::from(column) / f64::from(columns);
            let radius = 1.0 + 0.05 * (9.0 * latitude).sin() * (11.0 * longitude).cos();
            let ring_radius = radius * latitude.sin();
            vertices.push([
                ring_radius * longitude.cos(),
                radius * latitude.cos(),
                ring_radius * longitude.sin(),
            ]);
        }
    }
    let vertex = |ring: u32, column: u32| ring * columns + column % columns;
    let triangles: Vec<_> = (0..rings)
        .flat_map(|ring| (0..columns).map(move |column| (ring, column)))
        .flat_map(|(r, c)| {
            let (a, b) = (vertex(r, c), vertex(r, c + 1));
            let (d, e) = (vertex(r + 1, c), vertex(r + 1, c + 1));
            [[a, b, d], [b, e, d]]
        })
        .collect();
    Scene {
        width: 512,
        height: 512,
        parameters: Parameters {
            camera: Camera {
                look_from: dvec3(1.0, 1.0, 3.0),
                look_at: DVec3::ZERO,
                up: DVec3::Y,
                vfov: 45.0,
                focus: 1.0,
            },
            lights: vec![Light::Point(PointLight {
                position: dvec3(3.0, 4.0, 3.0),
                color: DVec3::ONE,
                intensity: 400.0,
            })],
            materials: vec![Material {
                ambient: DVec3::ZERO,
                diffuse: dvec3(0.7, 0.6, 0.5),
                specular: DVec3::splat(0.1),
                exponent: 20.0,
            }],
            spheres: Vec::new(),
            vertices: vec![vertices],
        },
        light_names: vec!["key".into()],
        material_names: vec!["clay".into()],
        spheres: Vec::new(),
        meshes: vec![MeshObject {
            name: "sphere".into(),
            materials: vec![0; triangles.len()],
            triangles,
        }],
    }
}
