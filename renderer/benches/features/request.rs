//! Gradients by what is asked for.

use glam::DVec3;
use peakmem_alloc::{INSTRUMENTED_SYSTEM, PeakMemAllocTrait};
use renderer::{Error, ImageLoss, LossKind, ParameterId, Renderer, Scene, Settings};

use crate::sphere::{bumpy_sphere, scene};
use crate::timing::{median, seconds};

const REPETITIONS: usize = 40;

/// Prints a table: time of a gradient over that of an image, the bytes that the result holds in lists,
/// and the most on the heap during the gradient.
pub fn run() -> Result<(), Error> {
    let scene = scene(bumpy_sphere(140), 512, 1)?;
    let triangles = scene.meshes()[0].triangles.len();
    let [width, height] = [scene.width, scene.height];
    println!(
        "bumpy sphere: {triangles} triangles, {width} x {height} pixels, one light, {} threads",
        rayon::current_num_threads()
    );
    let renderer = Renderer::new(&scene, &Settings::default())?;
    let mut image = renderer.render();
    let mut target = image.clone();
    target.pixels.as_flattened_mut().iter_mut().for_each(|value| *value *= 0.9);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);

    let requests = requests(&scene)?;
    let mut primal = Vec::new();
    let mut times = vec![Vec::new(); requests.len()];
    for _ in 0..REPETITIONS {
        primal.push(seconds(|| renderer.render_into(&mut image)));
        for ((_, ids), times) in requests.iter().zip(&mut times) {
            times.push(seconds(|| renderer.loss_and_gradient(&scene, &loss, ids)));
        }
    }
    let primal = median(primal);
    println!("  {:<22} {:8.3} ms", "image", 1e3 * primal);
    for ((name, ids), times) in requests.iter().zip(times) {
        let time = median(times);
        INSTRUMENTED_SYSTEM.reset_peak_memory();
        let gradient = renderer.loss_and_gradient(&scene, &loss, ids).gradient;
        let peak = INSTRUMENTED_SYSTEM.get_peak_memory();
        println!(
            "  {name:<22} {:8.3} ms  {:.2} x  {:>9} bytes of gradient, {peak:>9} at most",
            1e3 * time,
            time / primal,
            size_of_val(&gradient.concat()[..])
        );
    }
    Ok(())
}

/// Requests by name.
fn requests(scene: &Scene) -> Result<Vec<(&'static str, Vec<ParameterId>)>, Error> {
    let beginning = |start: &str| -> Vec<ParameterId> {
        let ids = scene.parameters().into_iter();
        ids.filter(|&id| scene.path(id).to_string().starts_with(start)).collect()
    };
    Ok(vec![
        ("light", beginning("light.")),
        ("light: intensity", vec![scene.parameter("light.light_0.radiant_intensity")?]),
        ("camera", beginning("camera.")),
        ("materials", beginning("material.")),
        ("one vertex", vec![seen_vertex(scene)?]),
        ("vertices of a mesh", vec![scene.parameter("mesh.sphere.vertices")?]),
        ("everything", beginning("")),
    ])
}

/// The vertex closest to the camera.
fn seen_vertex(scene: &Scene) -> Result<ParameterId, Error> {
    let eye = scene.camera.look_from;
    let distances = scene.meshes()[0].vertices.iter().map(|&v| eye.distance(DVec3::from(v)));
    let nearest = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
    let vertex = nearest.map_or(0, |(vertex, _)| vertex);
    scene.parameter(&format!("mesh.sphere.vertices[{vertex}]"))
}
