//! A glazed tile with a pattern of roughness under a grid of lamps, from three views.

use glam::{DVec3, dvec3};
use renderer::experiment::{Experiment, OptimizeSection, Target, TunedParameter};
use renderer::scene::{MaterialObject, Slot, View, Wrap};
use renderer::{Camera, Error, Image, Mesh, ParameterId, PointLight, Scene, Texture};

/// Texels along each side.
pub const SIDE: u32 = 16;
/// The roughness of the guess, everywhere.
pub const GUESS: f64 = 0.5;

/// The roughness at a texel: a ring and a bar, polished, on a brushed ground.
fn roughness(column: u32, row: u32) -> f64 {
    let at = |index: u32| (f64::from(index) + 0.5) / f64::from(SIDE) - 0.5;
    let (x, y) = (at(column), at(row));
    let is_ring = (0.24..0.38).contains(&x.hypot(y));
    let is_bar = x.abs() < 0.07 && y.abs() < 0.2;
    if is_ring || is_bar { 0.22 } else { 0.62 + 0.2 * (x + y) }
}

/// The scene with the true texture.
pub fn scene(size: u32) -> Result<Scene, Error> {
    let mut scene = Scene::new(1, 1, Camera::looking(dvec3(0.0, 0.0, 4.0), DVec3::ZERO));
    for (name, from) in [
        ("front", dvec3(0.0, -1.4, 2.6)),
        ("left", dvec3(-1.9, 0.7, 2.2)),
        ("right", dvec3(1.6, 1.1, 2.3)),
    ] {
        let camera = Camera { vfov: 32.0, ..Camera::looking(from, DVec3::ZERO) };
        scene.add_view(View { name: name.into(), width: size, height: size, camera })?;
    }
    let texel = |i: u32| [1.0, roughness(i % SIDE, i / SIDE), 1.0];
    let texels: Vec<[f64; 3]> = (0..SIDE * SIDE).map(texel).collect();
    let finish = scene.add_texture(Texture {
        name: "finish".into(),
        width: SIDE,
        height: SIDE,
        wrap: Wrap::Clamp,
        texels: texels.into(),
    })?;
    let mut glaze = MaterialObject::metallic_roughness(dvec3(0.05, 0.12, 0.2), 0.0, 1.0);
    glaze.values.ior = 1.8;
    let glaze = glaze.with_texture(Slot::MetallicRoughness, finish);
    let glaze = scene.add_material("glaze", glaze)?;
    let corners = vec![[-0.7, -0.7, 0.0], [0.7, -0.7, 0.0], [0.7, 0.7, 0.0], [-0.7, 0.7, 0.0]];
    let places = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    let tile = Mesh::new("tile", corners, triangles.clone()).material(glaze);
    scene.add_mesh(tile.texture_coordinates(places, triangles))?;
    for index in 0..16 {
        let at = |index: u32| f64::from(index) - 1.5;
        let light = PointLight {
            position: dvec3(at(index % 4), at(index / 4), 1.6),
            color: DVec3::ONE,
            radiant_intensity: 1.0,
        };
        scene.add_light(format!("lamp {index}"), light)?;
    }
    Ok(scene)
}

/// The texels of the texture.
pub fn texels(scene: &Scene) -> Result<ParameterId, Error> {
    scene.parameter("texture.finish.texels")
}

/// The problem: the texels from one roughness everywhere, and the three images of the truth.
pub fn experiment(truth: &Scene) -> Result<Experiment, Error> {
    let texels = texels(truth)?;
    let true_texels = truth.get(texels).into_owned();
    let mut guess = truth.clone();
    guess.set(texels, &[1.0, GUESS, 1.0].repeat((SIDE * SIDE) as usize))?;
    let tuned = TunedParameter {
        min: Some(vec![0.05; true_texels.len()]),
        max: Some(vec![1.0; true_texels.len()]),
        ..TunedParameter::new(texels)
    };
    let optimize = OptimizeSection {
        target: Some(Target::Values(vec![(texels, true_texels)])),
        parameters: vec![tuned],
        learning_rate: Some(0.02),
        ..OptimizeSection::default()
    };
    Ok(Experiment::new(guess, Some(optimize)))
}

/// The mean distance between the roughness of two scenes, over all texels.
pub fn error(a: &Scene, b: &Scene) -> Result<f64, Error> {
    let (a, b) = (a.get(texels(a)?), b.get(texels(b)?));
    let green = a.iter().zip(b.iter()).skip(1).step_by(3);
    Ok(green.map(|(a, b)| (a - b).abs()).sum::<f64>() / f64::from(SIDE * SIDE))
}

/// The roughness of a scene as a grey image, each texel `scale` pixels wide.
#[allow(dead_code, reason = "the test of the experiment shows no pictures")]
pub fn map(scene: &Scene, scale: u32) -> Result<Image, Error> {
    let texels = scene.get(texels(scene)?);
    let mut image = Image::black(SIDE * scale, SIDE * scale);
    let width = image.width as usize;
    for (index, pixel) in image.pixels.iter_mut().enumerate() {
        let scale = scale as usize;
        let texel = index / width / scale * SIDE as usize + index % width / scale;
        *pixel = [texels[3 * texel + 1] as f32; 3];
    }
    Ok(image)
}
