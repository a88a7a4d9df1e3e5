//! Custom shapes and lights.
//!
//! Each is a struct of named numbers, generic over its scalar, and one `#[differentiable]` kernel; a
//! shape says also in which box it lies. The numbers are parameters like any others
//! (`shape.NAME.FIELD`, `light.NAME.FIELD`), shapes stand in the acceleration structure beside
//! triangles, and the kernels run on lanes. The pullbacks are those that the attribute writes.
//!
//! ```
//! use ad::vector::{Vector, Vector3};
//! use ad::{Differentiable, Fields, Real, Vec3, differentiable};
//! use glam::DVec3;
//! use renderer::custom::{Bounded, Intersection, Shape};
//! use renderer::transport::camera::Ray;
//!
//! /// A disc that faces along z.
//! #[derive(Clone, Copy, Debug, Differentiable, Fields)]
//! struct Disc<S: Real> {
//!     center: Vec3<S>,
//!     radius: S,
//! }
//!
//! #[differentiable]
//! impl<S: Real> Shape for Disc<S> {
//!     type Scalar = S;
//!
//!     fn intersect(self, ray: Ray<S>) -> Intersection<S> {
//!         let distance = (self.center.z() - ray.origin.z()) / ray.direction.z();
//!         let offset = ray.origin + ray.direction * distance - self.center;
//!         let margin = self.radius * self.radius - offset.length_squared();
//!         let normal = <Vec3<S>>::new(S::ZERO, S::ZERO, S::ONE);
//!         Intersection { distance, normal, margin }
//!     }
//! }
//!
//! impl Bounded for Disc<f64> {
//!     fn bounds(&self) -> (DVec3, DVec3) {
//!         let reach = DVec3::new(self.radius, self.radius, 0.0);
//!         (self.center - reach, self.center + reach)
//!     }
//! }
//! ```
//!
//! A scene holds the numbers; what evaluates the kernel at each scalar is made once, for a
//! [`ShapeKernel`] or an [`EmitterKernel`]. Turned down: trait objects that hold the numbers themselves (every scene that is
//! cloned would clone them through a method of their own), and a type parameter of the scene (every
//! function that takes a scene would have to name it).

mod kernel;

pub use crate::transport::light::Emitter;
pub use crate::transport::shape::{Bounded, Intersection, Shape};
pub use kernel::{EmitterFamily, EmitterKernel, ShapeFamily, ShapeKernel};
