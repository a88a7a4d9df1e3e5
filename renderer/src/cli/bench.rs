//! `renderer bench`

use std::hint::black_box;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use super::load;
use super::output::print;
use crate::Error;
use crate::arithmetic::Arithmetic;
use crate::counts::Counts;
use crate::loss::{ImageLoss, LossKind};
use crate::render::Renderer;
use crate::scene::{ParameterId, Scene};
use crate::settings::{Edges, Settings};

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// A scene file (TOML), or a mesh (OBJ, PLY, STL, glTF), which is framed and lit by default
    scene: PathBuf,

    /// A parameter to differentiate by (can be repeated); without any, those of the scene file, or
    /// all
    #[arg(long = "param", value_name = "PATH")]
    parameters: Vec<String>,

    /// Whether the image and the gradient see edges
    #[arg(long, value_enum, default_value_t = Edges::Auto)]
    edges: Edges,

    /// How long each row is repeated
    #[arg(long, default_value_t = 1.0, value_name = "SECONDS", value_parser = seconds)]
    seconds: f64,
}

pub(super) fn seconds(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(seconds) if (0.0..=3600.0).contains(&seconds) => Ok(seconds),
        _ => Err("has to be a number from 0 to 3600".into()),
    }
}

pub(super) fn run(arguments: &Arguments, arithmetic: Arithmetic) -> Result<(), Error> {
    let start = Instant::now();
    let experiment = load(&arguments.scene)?;
    let load = start.elapsed();
    let scene = &experiment.scene;
    let mut ids = Vec::new();
    for path in &arguments.parameters {
        let id = scene.find_parameter(path);
        ids.push(id.map_err(|problem| Error::new(format_args!("--param {path}"), problem))?);
    }
    if ids.is_empty() {
        let tuned = experiment.optimize.iter().flat_map(|section| &section.parameters);
        ids.extend(tuned.map(|tuned| tuned.id));
    }
    if ids.is_empty() {
        ids = scene.parameters();
    }

    let triangles: usize = scene.meshes.iter().map(|mesh| mesh.triangles.len()).sum();
    let [width, height] = scene.size();
    let derivatives: usize = ids.iter().map(|&id| scene.count(id)).sum();
    print(format_args!(
        "{}: {triangles} triangles, {} spheres, {} lights, {} x {} pixels, {derivatives} derivatives; {:?} on {} threads",
        arguments.scene.display(),
        scene.spheres.len(),
        scene.lights.len(),
        width,
        height,
        arithmetic,
        rayon::current_num_threads(),
    ))?;
    let limit = Duration::from_secs_f64(arguments.seconds);
    let start = Instant::now();
    let edges = scene.edges_for(arguments.edges, &ids);
    let settings = Settings { arithmetic, edges, ..Settings::default() };
    scene.check_differentiable(&settings, &ids)?;
    let renderer = Renderer::unchecked(scene, &settings);
    let build = start.elapsed();
    Bench { original: scene, scene: scene.clone(), ids, renderer, load, build, limit, moves: 0 }
        .run()
}

/// So many repetitions are enough however short they are.
const ENOUGH: usize = 10_000;

/// What is measured.
struct Bench<'a> {
    original: &'a Scene,
    /// The scene whose parameters are moved before each gradient.
    scene: Scene,
    ids: Vec<ParameterId>,
    renderer: Renderer,
    /// The time that loading took, then until the acceleration structure was built.
    load: Duration,
    build: Duration,
    limit: Duration,
    moves: u32,
}

impl Bench<'_> {
    fn run(mut self) -> Result<(), Error> {
        // The target is the image itself, a little darker: every pixel has a cotangent.
        let start = Instant::now();
        let mut target = self.renderer.render();
        let first_image = start.elapsed();
        target.pixels.as_flattened_mut().iter_mut().for_each(|value| *value *= 0.9);
        let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
        let start = Instant::now();
        black_box(self.gradient(&loss));
        let first_gradient = start.elapsed();

        print(format_args!("{:<36} {:>10} {:>10}", "milliseconds", "median", "least"))?;
        let once = |name: &str, time: Duration| {
            print(format_args!("{name:<36} {:>10} {:>10.3}", "", time.as_secs_f64() * 1e3))
        };
        once("load", self.load)?;
        once("preparation, with the hierarchy", self.build)?;
        once("first image", first_image)?;
        once("first gradient", first_gradient)?;

        let mut image = self.renderer.render();
        let before = Counts::total();
        self.renderer.trace_only(true);
        let after = Counts::total();
        let primary = self.repeat(|bench| timed(|| bench.renderer.trace_only(false)));
        let all_rays = self.repeat(|bench| timed(|| bench.renderer.trace_only(true)));
        let primal = self.repeat(|bench| timed(|| bench.renderer.render_into(&mut image)));
        let gradient = self.repeat(|bench| timed(|| bench.gradient(&loss)));
        let update = self.repeat(|bench| bench.update());
        let iteration = self.repeat(|bench| bench.update() + timed(|| bench.gradient(&loss)));

        primal.print("image")?;
        primary.print("  of it primary rays")?;
        all_rays.minus(&primary).print("  of it shadow rays")?;
        primal.minus(&all_rays).print("  of it shading")?;
        iteration.print("iteration: parameters to gradient")?;
        update.print("  of it parameters and hierarchy")?;
        gradient.print("  of it rays, shading, pullbacks")?;
        print(format_args!("iteration / image {:>29.2}", iteration.median / primal.median))?;
        let rate = |rays: u64, samples: &Samples| rays as f64 / samples.median / 1e6;
        print(format_args!(
            "{:<36} {:>10.1}",
            "primary rays, millions per second",
            rate(after.primary_rays - before.primary_rays, &primary)
        ))?;
        let shadow_rays = after.shadow_rays - before.shadow_rays;
        if shadow_rays > 0 {
            let shadow = all_rays.minus(&primary);
            print(format_args!(
                "{:<36} {:>10.1}",
                "shadow rays, millions per second",
                rate(shadow_rays, &shadow)
            ))?;
        }
        match peak_memory() {
            Some(megabytes) => {
                print(format_args!("{:<36} {megabytes:>10.1}", "peak memory, megabytes"))
            }
            None => Ok(()),
        }
    }

    fn gradient(&self, loss: &ImageLoss<'_>) -> Vec<f64> {
        self.renderer.loss_and_gradient(&self.scene, loss, &self.ids).gradient.concat()
    }

    /// Moves every parameter by a hair, so that what depends on it is computed anew; the time it
    /// takes.
    fn update(&mut self) -> Duration {
        self.moves += 1;
        let factor = 1.0 + 1e-9 * f64::from(self.moves % 16);
        timed(|| {
            for &id in &self.ids {
                let moved: Vec<f64> =
                    self.original.get(id).iter().map(|value| value * factor).collect();
                self.scene.assign(id, &moved);
            }
            self.renderer.update(&self.scene);
        })
    }

    /// Repeats a measurement, three times at least.
    fn repeat(&mut self, mut measure: impl FnMut(&mut Self) -> Duration) -> Samples {
        measure(self);
        let start = Instant::now();
        let mut times = Vec::new();
        while times.len() < 3 || (times.len() < ENOUGH && start.elapsed() < self.limit) {
            times.push(measure(self).as_secs_f64());
        }
        times.sort_by(f64::total_cmp);
        Samples { median: times[times.len() / 2], least: times[0] }
    }
}

/// The time that something takes.
fn timed<T>(run: impl FnOnce() -> T) -> Duration {
    let start = Instant::now();
    black_box(run());
    start.elapsed()
}

/// What repetitions of a measurement gave, in seconds.
struct Samples {
    median: f64,
    least: f64,
}

impl Samples {
    /// What is left without a part that was measured by itself.
    fn minus(&self, part: &Self) -> Self {
        Self { median: self.median - part.median, least: self.least - part.least }
    }

    fn print(&self, name: &str) -> Result<(), Error> {
        print(format_args!("{name:<36} {:>10.3} {:>10.3}", self.median * 1e3, self.least * 1e3))
    }
}

/// The most memory that the process ever held, where the system tells (Linux).
fn peak_memory() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kilobytes / 1024.0)
}
