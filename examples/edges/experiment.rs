//! The derivative of every pixel by one number of a scene: with edges, without, and by differences of
//! finely sampled images.

use glam::DVec3;
use renderer::{
    Camera, Edges, Error, Image, Material, Mesh, ParameterId, PointLight, Sampling, Scene,
    Settings, render, render_jvp,
};

/// Parameters, which of their numbers, and how far the steps of the differences are, times the side of
/// the image in pixels: edges move by about a tenth of a pixel.
pub const NUMBERS: [(&str, usize, f64); 4] = [
    ("mesh.wedge.translation", 0, 0.35),
    ("mesh.wedge.rotation", 1, 20.0),
    ("light.lamp.position", 0, 0.7),
    ("camera.look_from", 0, 0.7),
];

/// A wedge above a floor, in an image of `size` by `size` pixels.
pub fn scene(size: u32) -> Result<Scene, Error> {
    let camera = Camera::looking(DVec3::new(0.3, 1.6, 4.0), DVec3::new(0.05, 0.5, 0.0));
    let mut scene = Scene::new(size, size, camera);
    let green = scene.add_material("green", Material::lambertian(DVec3::new(0.3, 0.7, 0.4)))?;
    let red = scene.add_material("red", Material::lambertian(DVec3::new(0.8, 0.3, 0.2)))?;
    let floor = vec![[-6.0, 0.0, -6.0], [6.0, 0.0, -6.0], [6.0, 0.0, 6.0], [-6.0, 0.0, 6.0]];
    let floor = Mesh::new("floor", floor, vec![[0, 2, 1], [0, 3, 2]]);
    scene.add_mesh(floor.material(green))?;
    // Two faces that meet in a ridge.
    let corners = vec![
        [-0.8, 0.1, 0.0],
        [0.03, 0.1, 0.6],
        [0.05, 1.3, 0.55],
        [-0.8, 1.3, 0.0],
        [0.9, 0.1, -0.1],
        [0.9, 1.3, -0.1],
    ];
    let faces = vec![[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]];
    scene.add_mesh(Mesh::new("wedge", corners, faces).material(red))?;
    let position = DVec3::new(1.1, 3.0, 2.0);
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 12.0 };
    scene.add_light("lamp", lamp)?;
    Ok(scene)
}

/// Double precision. The interior term and the differences are of means of `side` by `side` samples.
fn settings(edges: Edges, side: u32) -> Settings {
    let settings = Settings { edges, sampling: Sampling::Grid(side), ..Settings::default() };
    settings.in_double_precision()
}

/// By forward mode, with edges or the interior term alone.
pub fn by_forward_mode(
    scene: &Scene,
    (id, element): (ParameterId, usize),
    edges: Edges,
) -> Result<Image, Error> {
    let unit = |index: usize| f64::from(u8::from(index == element));
    let direction = (id, (0..scene.get(id).len()).map(unit).collect());
    Ok(render_jvp(scene, &settings(edges, 4), &[direction])?.1)
}

/// By central differences of two images without edges, of 16 by 16 samples a pixel. Long steps blur
/// edges, short ones see an edge jump from sample to sample.
pub fn by_differences(
    scene: &Scene,
    (id, element): (ParameterId, usize),
    step: f64,
) -> Result<Image, Error> {
    let step = step / f64::from(scene.width);
    let image = |offset: f64| {
        let mut moved = scene.clone();
        let mut numbers = scene.get(id).into_owned();
        numbers[element] += offset;
        moved.set(id, &numbers)?;
        render(&moved, &settings(Edges::Off, 16))
    };
    let (mut difference, below) = (image(step)?, image(-step)?);
    let pairs = difference.pixels.as_flattened_mut().iter_mut().zip(below.pixels.as_flattened());
    for (above, below) in pairs {
        *above = (f64::from(*above - below) / (2.0 * step)) as f32;
    }
    Ok(difference)
}

/// The sum of the differences between two images over that of the second, both without signs.
pub fn relative_error(image: &Image, expected: &Image) -> f64 {
    let pairs = image.pixels.as_flattened().iter().zip(expected.pixels.as_flattened());
    let (off, size) = pairs.fold((0.0, 0.0), |(off, size), (a, b)| {
        (off + f64::from((a - b).abs()), size + f64::from(b.abs()))
    });
    off / size
}
