//! The shape of an object, from images of eight sides of it: 10,242 vertices of a sphere find their places.
//!
//! `cargo run --release --example shape -- suzanne.obj`, or without a file, which takes a ball with horns;
//! with `--scanned` before it, the images are of depth and normals, as scanners give them; with `--fixed`, the
//! triangles of the sphere stay; with `--facets`, images show the object as flat as its triangles are, not smooth
//!
//! Steps are those of Large Steps (Nicolet et al. 2021): uniform Adam in coordinates in which neighbours move
//! together, one view a step, so that eight steps see all of them, on triangles that change every 100 steps. Prints distances between surfaces, in
//! radii of the object. `out/shape/` gets images of the start, the target and what was found, and the mesh.

mod distance;
mod experiment;
#[path = "../shared/merged.rs"]
mod merged;
#[path = "../shared/random.rs"]
mod random;
mod sphere;
#[path = "../shared/strip.rs"]
mod strip;

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

use distance::{Distance, Surface};
use experiment::{RADIUS, VIEWS};
use renderer::files::{save_obj, save_png};
use renderer::optimize::{Observer, Settings, Step, Topology};
use renderer::recovery::Recovery;
use renderer::remesh::{self_intersecting, turned_over};
use renderer::{Error, Image, Mesh, Normals, Pass, Scene};
use strip::{brightest, strip};

/// Steps, each of one view, and how many of them lie between two reports.
const STEPS: u64 = 150 * VIEWS as u64;
const REPORTED: u64 = 25 * VIEWS as u64;
/// How many of the views are saved as pictures.
const SHOWN: usize = 4;

fn main() -> Result<(), Error> {
    let mut arguments = std::env::args_os().skip(1).peekable();
    let scanned = arguments.next_if(|argument| argument == "--scanned").is_some();
    let fixed = arguments.next_if(|argument| argument == "--fixed").is_some();
    let facets = arguments.next_if(|argument| argument == "--facets").is_some();
    let remesh = (!fixed).then_some(experiment::REMESHING);
    let passes: &[Pass] = if scanned { &[Pass::Depth, Pass::Normals] } else { &[Pass::Radiance] };
    let argument = arguments.next();
    let file = argument.as_deref().map(Path::new);
    let name = file.and_then(Path::file_stem).map_or("horns".into(), |stem| stem.to_string_lossy());
    let out = Path::new("out/shape").join(&*name);
    std::fs::create_dir_all(&out).map_err(|error| Error::new(out.display(), error))?;

    let normals = if facets { Normals::Flat } else { Normals::Smooth };
    let target = experiment::target(file, normals)?;
    let experiment = experiment::experiment(&target, &out, 1, passes, remesh)?;
    let recovery = Recovery::new(&experiment, "shape", &experiment::settings())?;
    let settings = Settings { iterations: STEPS, ..recovery.settings() };
    let mut watched = Watched::default();
    let clock = Instant::now();
    let outcome = recovery.run(&settings, &mut watched)?;
    let seconds = clock.elapsed().as_secs_f64();

    println!("views seen  Chamfer  Hausdorff  triangles  of them turned over, intersecting others");
    for (iteration, topologies, x) in &watched.seen {
        describe(*iteration, &recovery.with_topologies(topologies)?.scene_at(x), &target);
    }
    println!(
        "{:.3} s for {VIEWS} views, on {} threads",
        seconds / (STEPS / VIEWS as u64) as f64,
        rayon::current_num_threads()
    );
    let found = recovery.with_topologies(&outcome.topologies)?.scene_at(&outcome.best.x);
    let qualities = recovery.qualities(&found);
    let psnr = qualities.iter().map(|quality| quality.psnr).sum::<f64>() / qualities.len() as f64;
    println!("mean PSNR of the views {psnr:.1} dB");
    let exposure = 1.0 / brightest(&recovery.targets()[0].picture(recovery.target()));
    let sides = || recovery.targets().iter().step_by(passes.len()).take(SHOWN);
    let shown = |scene: &Scene| -> Vec<Image> {
        sides().map(|of| of.picture(&recovery.render_target(of, scene))).collect()
    };
    let targets: Vec<Image> = sides().map(|of| of.picture(&of.image)).collect();
    for (name, images) in
        [("start", shown(&experiment.scene)), ("found", shown(&found)), ("target", targets)]
    {
        save_png(&strip(&images, exposure), &out.join(name).with_extension("png"))?;
    }
    save_obj(&found.meshes()[0], found.materials(), &out.join("found.obj"))?;
    println!("pictures and the mesh in {}", out.display());
    Ok(())
}

/// How far a shape is from its target.
fn describe(iteration: u64, scene: &Scene, target: &Mesh) {
    let unit = |mesh: &Mesh| -> Vec<[f64; 3]> {
        mesh.vertices.iter().map(|vertex| vertex.map(|value| value / RADIUS)).collect()
    };
    let mesh = &scene.meshes()[0];
    let (own, other) = (unit(mesh), unit(target));
    let own = Surface { vertices: &own, triangles: &mesh.triangles };
    let Distance { chamfer, hausdorff } =
        own.distance(&Surface { vertices: &other, triangles: &target.triangles });
    let (triangles, turned) = (mesh.triangles.len(), turned_over(mesh));
    let crossed = self_intersecting(mesh);
    println!(
        "{iteration:>10}  {chamfer:>7.4}  {hausdorff:>9.4}  {triangles:>9}  {turned:>7}  {crossed:>7}"
    );
}

/// Where a run was now and then, with the triangles that it had there.
#[derive(Default)]
struct Watched {
    topologies: Vec<Topology>,
    x: Vec<f64>,
    seen: Vec<(u64, Vec<Topology>, Vec<f64>)>,
}

impl Observer for Watched {
    fn changed(&mut self, topologies: &[Topology]) {
        self.topologies = topologies.to_vec();
    }

    fn parameters(&mut self, x: &[f64]) {
        self.x = x.to_vec();
    }

    fn step(&mut self, step: &Step) -> ControlFlow<()> {
        let iteration = step.record.iteration;
        if iteration.is_multiple_of(REPORTED) {
            self.seen.push((iteration, self.topologies.clone(), self.x.clone()));
        }
        ControlFlow::Continue(())
    }
}
