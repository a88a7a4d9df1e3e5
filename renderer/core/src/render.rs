//! Images and their derivatives.
//!
//! The functions here follow the convention of [`ad`]: [`render`] gives the value, [`render_vjp`] the
//! value and a pullback, [`render_jvp`] the value and its derivative along a direction. So any loss,
//! network or outer program can stand behind the image. [`loss_and_gradient`] is the faster way for
//! losses that are sums over pixels: value, cotangent and pullback follow each other pixel by pixel, in
//! one pass. Who evaluates a scene again and again keeps a [`Renderer`], which keeps the acceleration
//! structure.
//!
//! ```
//! use renderer::glam::DVec3;
//! use renderer::{Camera, Image, Material, Mesh, PointLight, Scene, Settings, render_vjp};
//!
//! let mut scene = Scene::new(32, 24, Camera::looking(DVec3::new(0.0, 1.0, 4.0), DVec3::ZERO));
//! let paint = scene.add_material("paint", Material::lambertian(DVec3::new(0.8, 0.3, 0.2)))?;
//! let corners = vec![[-1.0, 0.0, -1.0], [1.0, 0.0, -1.0], [1.0, 0.0, 1.0], [-1.0, 0.0, 1.0]];
//! scene.add_mesh(Mesh::new("floor", corners, vec![[0, 2, 1], [0, 3, 2]]).material(paint))?;
//! let position = DVec3::new(1.0, 2.0, 1.0);
//! scene.add_light("key", PointLight { position, color: DVec3::ONE, radiant_intensity: 5.0 })?;
//!
//! let vertices = scene.parameter("mesh.floor.vertices")?;
//! let (image, pullback) = render_vjp(&scene, &Settings::default(), &[vertices])?;
//! // The gradient of the mean of the image.
//! let weight = 1.0 / (3 * image.pixels.len()) as f32;
//! let cotangent = Image { pixels: vec![[weight; 3]; image.pixels.len()], ..image };
//! let gradient = pullback(&cotangent);
//! assert_eq!(gradient.get(vertices).len(), 12);
//! # Ok::<(), renderer::Error>(())
//! ```
//!
//! Scenes are checked before they are rendered. What is not finite in an image or a gradient stays so,
//! and [`Renderer::find_non_finite`] says where it comes from.

mod engine;

use glam::DVec3;

pub use crate::adjoint::{Gradient, LossAndGradient};
pub use crate::diagnose::NonFinite;
pub use engine::Renderer;

use crate::Error;
use crate::image::Image;
use crate::loss::PixelLoss;
use crate::scene::{ParameterId, Scene};
use crate::settings::Settings;

/// Renders a scene: linear RGB radiance, black where the camera sees nothing.
///
/// # Errors
///
/// If the scene is not [valid](Scene::check).
pub fn render(scene: &Scene, settings: &Settings) -> Result<Image, Error> {
    Ok(Renderer::new(scene, settings)?.render())
}

/// Renders a scene; the second result is the pullback, from a cotangent of the image (the derivatives of
/// some loss by each channel of each pixel) to the gradient by the requested parameters.
///
/// The pullback traces the scene again. If any of the parameters moves edges, both see edges, unless the
/// [settings](Settings::edges) say otherwise.
///
/// # Errors
///
/// If the scene is not [valid](Scene::check), or there is [no derivative](Scene::check_differentiable) by
/// one of the parameters.
///
/// # Panics
///
/// The pullback panics if the cotangent has another size than the image.
pub fn render_vjp(
    scene: &Scene,
    settings: &Settings,
    requested: &[ParameterId],
) -> Result<(Image, impl Fn(&Image) -> Gradient + use<>), Error> {
    scene.check_differentiable(settings, requested)?;
    let settings = Settings { edges: scene.edges_for(settings.edges, requested), ..*settings };
    let renderer = Renderer::new(scene, &settings)?;
    let (image, scene, requested) = (renderer.render(), scene.clone(), requested.to_vec());
    Ok((image, move |cotangent: &Image| renderer.pullback(&scene, cotangent, &requested)))
}

/// Renders a scene and the derivative of the image along a direction: for some parameters, how fast
/// their numbers move.
///
/// # Errors
///
/// If the scene is not [valid](Scene::check), a direction has another number of numbers than its
/// parameter, two have numbers in common, or there is [no derivative](Scene::check_differentiable) by one.
pub fn render_jvp(
    scene: &Scene,
    settings: &Settings,
    direction: &[(ParameterId, Vec<f64>)],
) -> Result<(Image, Image), Error> {
    Renderer::new(scene, settings)?.jvp(scene, direction)
}

/// A loss of the image of a scene that is a sum over pixels, and its gradient by the requested
/// parameters, in one pass.
///
/// # Errors
///
/// If the scene is not [valid](Scene::check), or there is [no derivative](Scene::check_differentiable) by
/// one of the parameters.
pub fn loss_and_gradient(
    scene: &Scene,
    settings: &Settings,
    loss: &dyn PixelLoss,
    requested: &[ParameterId],
) -> Result<LossAndGradient, Error> {
    scene.check_differentiable(settings, requested)?;
    Ok(Renderer::new(scene, settings)?.loss_and_gradient(scene, loss, requested))
}

/// The linear loss whose cotangents are those of an image.
struct Linear<'a>(&'a Image);

impl PixelLoss for Linear<'_> {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let cotangent = self.0.pixels[y as usize * self.0.width as usize + x as usize];
        let cotangent = DVec3::from_array(cotangent.map(f64::from));
        (radiance.dot(cotangent), cotangent)
    }
}
