//! Gradients by what is asked for.

use ad::lanes::f32x16;
use glam::DVec3;
use peakmem_alloc::{INSTRUMENTED_SYSTEM, PeakMemAllocTrait};
use renderer::integrator::{Gradient, Prepared, Wanted, gradient, render, render_into};
use renderer::loss::{ImageLoss, LossKind};
use renderer::scene::{ParameterId, Scene};

use crate::sphere::scene;
use crate::timing::{median, seconds};

const REPETITIONS: usize = 40;

/// Prints a table: time of a gradient over that of an image, the bytes that the result holds in lists,
/// and the most on the heap during the gradient.
pub fn run() {
    let scene = scene(140, 512, 1);
    let triangles = scene.meshes[0].triangles.len();
    let [width, height] = [scene.width, scene.height];
    println!(
        "bumpy sphere: {triangles} triangles, {width} x {height} pixels, one light, {} threads",
        rayon::current_num_threads()
    );
    let prepared = Prepared::<f32x16>::new(&scene);
    let mut image = render(&prepared);
    let mut target = image.clone();
    target.pixels.as_flattened_mut().iter_mut().for_each(|value| *value *= 0.9);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);

    let requests = requests(&scene);
    let mut primal = Vec::new();
    let mut times = vec![Vec::new(); requests.len()];
    for _ in 0..REPETITIONS {
        primal.push(seconds(|| render_into(&prepared, &mut image)));
        for ((_, ids), times) in requests.iter().zip(&mut times) {
            times.push(seconds(|| gradient(&prepared, &loss, Wanted::by(ids))));
        }
    }
    let primal = median(primal);
    println!("  {:<22} {:8.3} ms", "image", 1e3 * primal);
    for ((name, ids), times) in requests.iter().zip(times) {
        let time = median(times);
        INSTRUMENTED_SYSTEM.reset_peak_memory();
        let result = gradient(&prepared, &loss, Wanted::by(ids));
        let peak = INSTRUMENTED_SYSTEM.get_peak_memory();
        println!(
            "  {name:<22} {:8.3} ms  {:.2} x  {:>9} bytes of gradient, {peak:>9} at most",
            1e3 * time,
            time / primal,
            bytes(&scene, ids, &result.gradient)
        );
    }
}

/// Requests by name.
fn requests(scene: &Scene) -> Vec<(&'static str, Vec<ParameterId>)> {
    let beginning = |start: &str| -> Vec<ParameterId> {
        let ids = scene.parameter_ids().into_iter();
        ids.filter(|&id| scene.path(id).to_string().starts_with(start)).collect()
    };
    vec![
        ("light", beginning("light.")),
        ("light: intensity", vec![ParameterId::LightIntensity(0)]),
        ("camera", beginning("camera.")),
        ("materials", beginning("material.")),
        ("one vertex", vec![seen_vertex(scene)]),
        ("vertices of a mesh", beginning("mesh.")),
        ("everything", beginning("")),
    ]
}

/// The vertex closest to the camera.
fn seen_vertex(scene: &Scene) -> ParameterId {
    let eye = scene.parameters.camera.look_from;
    let distances = scene.parameters.vertices[0].iter().map(|&v| eye.distance(DVec3::from(v)));
    let nearest = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
    ParameterId::Vertex { mesh: 0, vertex: nearest.map_or(0, |(vertex, _)| vertex) }
}

/// The bytes of the numbers in a gradient by the parameters `ids`.
fn bytes(scene: &Scene, ids: &[ParameterId], gradient: &Gradient) -> usize {
    let all = scene.parameter_ids();
    let parts = ids.iter().filter(|id| !all.contains(id));
    all.iter().chain(parts).map(|&id| size_of_val(gradient.get(id))).sum()
}
