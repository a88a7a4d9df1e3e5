//! From a sphere to a shape, by images of eight sides of it.

use std::f64::consts::PI;
use std::path::{Path, PathBuf};

use glam::DVec3;
use renderer::experiment::{
    Experiment, MatchedPass, OptimizeSection, Remeshing, TunedParameter, ViewTarget,
};
use renderer::files::save_exr;
use renderer::optimize::{Adam, Batch, Optimizer, Schedule, schedule};
use renderer::{
    Camera, DistantLight, Edges, Error, LossKind, Material, Mesh, Normals, Pass, Renderer, Scene,
    Settings, View,
};

use crate::merged::{merged, normalize};
use crate::sphere::icosphere;

/// The side of the images in pixels, and their number.
pub const SIZE: u32 = 256;
pub const VIEWS: usize = 8;
/// How far the shape reaches from the middle of its bounding box.
pub const RADIUS: f64 = 1.48571;
/// How far away the cameras are.
const DISTANCE: f64 = 5.0;
/// The length of the first steps, and what becomes of it: steps that stay long turn triangles over.
const RATE: f64 = 0.04;
const END: f64 = 0.2;
/// How the triangles change: into about as many as the sphere has.
pub const REMESHING: Remeshing = Remeshing { edge_length: 0.034, every: 100 };
/// The coordinates of the steps. Triangles that never change need stiffer ones, or more of them turn over.
const LAMBDA: f64 = 5.0;
const LAMBDA_FIXED: f64 = 25.0;
/// How often the icosahedron is cut.
const LEVEL: u32 = 5;

/// A file of a mesh, all objects of it in one, or a shape with horns, which is shaded with these normals.
pub fn target(path: Option<&Path>, normals: Normals) -> Result<Mesh, Error> {
    let (mut vertices, triangles) = path.map_or_else(|| Ok(horns()), merged)?;
    normalize(&mut vertices, |_, reach| RADIUS / reach);
    Ok(Mesh { normals, ..Mesh::new("target", vertices, triangles) })
}

/// A ball with six horns of different lengths and a dent.
fn horns() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let (mut vertices, triangles) = icosphere(LEVEL);
    let horns = [
        (DVec3::X, 0.9),
        (DVec3::NEG_X, 0.5),
        (DVec3::Y, 0.7),
        (DVec3::new(0.3, -1.0, 0.2), 0.4),
        (DVec3::new(0.2, 0.4, 1.0), 0.6),
        (DVec3::new(-0.5, 0.6, -1.0), 0.8),
        (DVec3::new(0.8, -0.5, 0.8), -0.35),
    ];
    for vertex in &mut vertices {
        let direction = DVec3::from(*vertex);
        let height = |(axis, height): (DVec3, f64)| {
            height * (-6.0 * (1.0 - direction.dot(axis.normalize()))).exp()
        };
        *vertex = (direction * (0.8 + horns.map(height).iter().sum::<f64>())).to_array();
    }
    (vertices, triangles)
}

/// A mesh under four lights of different colours, from eight sides: the directions of a Fibonacci lattice.
fn scene(mesh: Mesh) -> Result<Scene, Error> {
    let mut scene = Scene::new(SIZE, SIZE, Camera::looking(DVec3::Z * DISTANCE, DVec3::ZERO));
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    for index in 0..VIEWS {
        let around = 2.0 * PI * index as f64 / golden;
        let down = (1.0 - 2.0 * (index as f64 + 0.5) / VIEWS as f64).acos();
        let direction =
            DVec3::new(around.cos() * down.sin(), around.sin() * down.sin(), down.cos());
        let camera = Camera::looking(direction * DISTANCE, DVec3::ZERO);
        let name = format!("side{index}");
        scene.add_view(View { name, width: SIZE, height: SIZE, camera })?;
    }
    let paint = scene.add_material("paint", Material::lambertian(DVec3::splat(0.5)))?;
    scene.add_mesh(mesh.material(paint))?;
    let lights = [
        ([1.0, 1.0, 1.0], [1.0, 0.9, 0.7]),
        ([-1.0, -1.0, 1.0], [0.6, 0.8, 1.0]),
        ([-1.0, 1.0, -1.0], [0.9, 0.6, 0.8]),
        ([1.0, -1.0, -1.0], [0.7, 1.0, 0.6]),
    ];
    for (index, (direction, color)) in lights.into_iter().enumerate() {
        let (direction, color) = (DVec3::from(direction), DVec3::from(color));
        scene.add_light(
            format!("light{index}"),
            DistantLight { direction, color, irradiance: 2.5 },
        )?;
    }
    Ok(scene)
}

/// How images are rendered: edges are what moves a shape.
pub fn settings() -> Settings {
    Settings { edges: Edges::On, ..Settings::default() }
}

/// The problem: from a sphere to `target`, of which `passes` are rendered into `folder`. Each step looks at
/// `batch` views, and triangles change by `remesh`, if they do.
pub fn experiment(
    target: &Mesh,
    folder: &Path,
    batch: usize,
    passes: &[Pass],
    remesh: Option<Remeshing>,
) -> Result<Experiment, Error> {
    let mut truth = scene(target.clone())?;
    let mut renderer = Renderer::new(&truth, &settings())?;
    let mut views = Vec::new();
    for view in 0..VIEWS {
        truth.look_through(view);
        renderer.look(&truth);
        let mut matched = ViewTarget::default();
        for &pass in passes {
            let file: PathBuf = folder.join(format!("target{view}-{}.exr", pass.name()));
            renderer.show(&truth, pass);
            save_exr(&renderer.render(), &file)?;
            match pass {
                Pass::Radiance => matched.image = Some(file),
                _ => matched.passes.push(MatchedPass { pass, file, weight: 1.0 }),
            }
        }
        views.push(matched);
    }
    let (vertices, triangles) = icosphere(LEVEL);
    let scene = scene(Mesh::new("shape", vertices, triangles).smooth())?;
    let vertices = TunedParameter {
        learning_rate: Some(RATE),
        large_steps: Some(if remesh.is_some() { LAMBDA } else { LAMBDA_FIXED }),
        remesh,
        ..TunedParameter::new(scene.parameter("mesh.shape.vertices")?)
    };
    let section = OptimizeSection {
        views,
        parameters: vec![vertices],
        batch: (batch < VIEWS).then_some(Batch { size: batch, seed: 1 }),
        loss: Some(LossKind::L1),
        schedule: Some(Schedule::Exponential(schedule::Exponential { end: END })),
        optimizer: Some(Optimizer::Adam(Adam { uniform: true, ..Adam::default() })),
        ..OptimizeSection::default()
    };
    Ok(Experiment::new(scene, Some(section)))
}
