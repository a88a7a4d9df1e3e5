//! Shapes and lights that users add.
//!
//! They are trait objects, met one ray and one lane at a time in `f64`, so that a scene of built-in
//! shapes and lights pays nothing for them. Their parameters are lists of numbers, which optimisers
//! and gradients reach under the paths `shape.NAME.parameters` and `light.NAME.parameters`. The
//! pullbacks are best left to `#[differentiable]`: see `examples/custom_shape.rs`. Turned down: a
//! generic parameter of the scene, which every function that takes a scene would have to name, and
//! kernels that are generic over lanes, which cannot be called through a trait object.

use std::fmt::Debug;
use std::sync::Arc;

use glam::DVec3;

use crate::kernels::camera::{Ray, RayTangent};
use crate::kernels::light::{Illumination, IlluminationTangent};
use crate::kernels::surface::{SurfacePoint, SurfacePointTangent};

/// A shape that a user adds.
pub trait CustomShape: Debug + Send + Sync {
    /// The lowest and the highest corner of a box around the shape.
    fn bounds(&self, parameters: &[f64]) -> (DVec3, DVec3);

    /// The distance at which a ray meets the shape first, above 0; nothing if it does not. Not
    /// differentiated.
    fn intersect(&self, parameters: &[f64], ray: Ray<f64>) -> Option<f64>;

    /// The point where a ray meets the shape first, with the unit normal, on either side, and the unit
    /// vector towards the origin of the ray. Only rays that meet the shape come here.
    fn surface(&self, parameters: &[f64], ray: Ray<f64>) -> SurfacePoint<f64>;

    /// The pullback of [`surface`](Self::surface): adds the cotangents of the parameters to
    /// `to_parameters` and returns that of the ray.
    fn surface_pullback(
        &self,
        parameters: &[f64],
        ray: Ray<f64>,
        cotangent: SurfacePointTangent<f64>,
        to_parameters: &mut [f64],
    ) -> RayTangent<f64>;
}

/// A light that a user adds, which reaches every point from one direction.
pub trait CustomLight: Debug + Send + Sync {
    /// How far the light is from a point, which tells what may stand between them; infinite if it has
    /// no place. Not differentiated.
    fn distance(&self, parameters: &[f64], point: DVec3) -> f64;

    /// What it brings to a point.
    fn illumination(&self, parameters: &[f64], point: DVec3) -> Illumination<f64>;

    /// The pullback of [`illumination`](Self::illumination): adds the cotangents of the parameters to
    /// `to_parameters` and returns that of the point.
    fn illumination_pullback(
        &self,
        parameters: &[f64],
        point: DVec3,
        cotangent: IlluminationTangent<f64>,
        to_parameters: &mut [f64],
    ) -> DVec3;
}

/// The discrete part of a shape that a user adds.
#[derive(Clone, Debug)]
pub struct CustomShapeObject {
    /// Its name, unique among these shapes.
    pub name: String,
    /// Index of its material, which must have no textures.
    pub material: u32,
    /// What it does.
    pub shape: Arc<dyn CustomShape>,
}

/// The discrete part of a light that a user adds.
#[derive(Clone, Debug)]
pub struct CustomLightObject {
    /// Its name, unique among all lights.
    pub name: String,
    /// What it does.
    pub light: Arc<dyn CustomLight>,
}

/// Objects are equal if they are one.
impl PartialEq for CustomShapeObject {
    fn eq(&self, other: &Self) -> bool {
        (&self.name, self.material) == (&other.name, other.material)
            && Arc::ptr_eq(&self.shape, &other.shape)
    }
}

/// Objects are equal if they are one.
impl PartialEq for CustomLightObject {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && Arc::ptr_eq(&self.light, &other.light)
    }
}
