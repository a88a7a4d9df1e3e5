//! The differentiable core: small pure functions over a scalar `S: Real`.

pub mod camera;
pub mod light;
pub mod material;
pub mod sphere;
