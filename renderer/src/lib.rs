//! A differentiable ray tracer: recovers lights, materials, cameras and shapes from images.
//!
//! ```
//! use renderer::glam::DVec3;
//! use renderer::{Camera, Material, PointLight, Scene, Settings, SphereObject, render};
//!
//! let mut scene = Scene::new(64, 48, Camera::looking(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO));
//! let paint = scene.add_material("paint", Material::lambertian(DVec3::new(0.2, 0.5, 0.8)))?;
//! scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0).material(paint))?;
//! let position = DVec3::new(2.0, 3.0, 4.0);
//! scene.add_light("key", PointLight { position, color: DVec3::ONE, radiant_intensity: 90.0 })?;
//! let image = render(&scene, &Settings::default())?;
//! assert!(image.pixels[24 * 64 + 32][2] > 0.1);
//! # Ok::<(), renderer::Error>(())
//! ```
//!
//! Data flows one way. A [`Scene`] holds objects and numbers; [`transport`] is what light does, as
//! differentiable functions; tracing finds what rays meet; the forward pass goes from a scene to
//! radiance, the reverse pass from cotangents back to a gradient, through pullbacks that the compiler
//! wrote. [`render()`], [`render_vjp`], [`render_jvp`] and [`loss_and_gradient`] are their face. Nothing
//! below them knows which loss is minimised, and the optimiser knows nothing of images.
//!
//! Kernels run on SIMD lanes. Building with `-C target-cpu=native` lets the compiler use the widest
//! instructions of the machine; this repository does, a crate that depends on this one has to say
//! so itself.

#[cfg(feature = "files")]
pub mod accuracy;
mod adjoint;
pub mod arithmetic;
#[cfg(feature = "cli")]
pub mod cli;
pub mod counts;
pub mod custom;
#[cfg(feature = "files")]
pub mod demo;
mod diagnose;
#[cfg(feature = "files")]
mod disk;
pub mod display;
mod error;
#[cfg(feature = "files")]
pub mod experiment;
pub mod extremes;
#[cfg(feature = "files")]
pub mod files;
mod image;
pub mod loss;
mod number;
#[cfg(feature = "files")]
pub mod optimize;
#[cfg(feature = "cli")]
pub mod palette;
mod primal;
#[cfg(feature = "files")]
pub mod recovery;
pub mod render;
#[cfg(feature = "cli")]
pub mod report;
pub mod scene;
pub mod settings;
pub mod trace;
#[cfg(feature = "cli")]
pub mod tradeoff;
pub mod transport;
#[cfg(feature = "files")]
mod warning;

pub use glam;

pub use arithmetic::{Arithmetic, Precision};
pub use error::{Error, ErrorKind};
pub use image::Image;
pub use loss::{ImageLoss, LossKind, PixelLoss};
pub use render::{
    Gradient, LossAndGradient, NonFinite, Renderer, loss_and_gradient, render, render_jvp,
    render_vjp,
};
pub use scene::*;
pub use settings::{Pass, PrimaryVisibility, Samples, Sampling, Settings};
#[cfg(feature = "files")]
pub use warning::Warning;
