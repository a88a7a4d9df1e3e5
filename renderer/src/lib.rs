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
// For the program `renderer` alone.
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod cli;
#[cfg(feature = "files")]
pub mod demo;
#[cfg(feature = "files")]
pub mod experiment;
pub mod extremes;
#[cfg(feature = "files")]
pub mod files;
pub mod progressive;
#[cfg(feature = "files")]
pub mod recovery;
#[cfg(feature = "cli")]
mod report;
#[cfg(feature = "cli")]
mod tradeoff;

#[doc(inline)]
pub use renderer_core::*;
#[cfg(feature = "files")]
pub use renderer_files::Warning;
#[cfg(feature = "files")]
#[doc(inline)]
pub use renderer_optimize as optimize;
// For plots of commands and of the examples of this repository.
#[cfg(feature = "cli")]
#[doc(hidden)]
pub use renderer_optimize::palette;
#[cfg(feature = "files")]
#[doc(inline)]
pub use renderer_surfaces::laplacian;
#[doc(inline)]
pub use renderer_surfaces::remesh;

/// The code of the README of the repository.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
