//! The differentiable core: small pure functions over a scalar `S: Real`.
//!
//! The way of the light, against its direction: a [`camera`] sends a ray through a pixel, the ray
//! meets a [`triangle`] or a [`sphere`] at a [`surface`] point, the point is lit by a [`light`] and
//! reflects by its [`material`], whose colours a [`texture`] may vary. Every function is `#[differentiable]`, and chooses with `select`,
//! `max` and `min` instead of `if`, so that the scalar may be anything that implements
//! [`Real`](ad::Real). Which primitive a ray meets is decided elsewhere and not differentiated; a
//! kernel recomputes the meeting from the primitive's own parameters.

pub mod camera;
pub mod light;
pub mod material;
pub mod sphere;
pub mod surface;
pub mod texture;
pub mod triangle;
