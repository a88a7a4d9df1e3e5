//! The Utah teapot from three views, listing 1 and figure 1 of the paper on RayTracer.jl.
//!
//! `cargo run --release --example teapot [teapot.obj]`
//!
//! The first view is that of the listing. The teapot is tessellated from its 32 Bezier patches; an
//! argument names a mesh to stand for it. `out/teapot/` gets the three pictures and a strip of them.

mod experiment;
#[path = "../shared/mesh_argument.rs"]
mod mesh_argument;
mod patches;
#[path = "../shared/strip.rs"]
mod strip;

use std::path::Path;
use std::time::Instant;

use renderer::files::save_png;
use renderer::{Error, Settings, render};
use strip::{brightest, strip};

fn main() -> Result<(), Error> {
    let mut scene = experiment::scene(16, 512)?;
    mesh_argument::apply(&mut scene)?;
    println!("{} triangles", scene.meshes().iter().map(|mesh| mesh.triangles.len()).sum::<usize>());
    let out = Path::new("out/teapot");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let mut images = Vec::new();
    for (index, (look_from, look_at)) in experiment::VIEWS.into_iter().enumerate() {
        scene.camera.look_from = look_from;
        scene.camera.look_at = look_at;
        let clock = Instant::now();
        let image = render(&scene, &Settings::default())?;
        let milliseconds = 1e3 * clock.elapsed().as_secs_f64();
        println!("view from {look_from}: {milliseconds:.1} ms, hierarchy included");
        let picture = strip(std::slice::from_ref(&image), 1.0 / brightest(&image));
        save_png(&picture, &out.join(format!("view{}.png", index + 1)))?;
        images.push(picture);
    }
    save_png(&strip(&images, 1.0), &out.join("strip.png"))?;
    println!("pictures in {}", out.display());
    Ok(())
}
