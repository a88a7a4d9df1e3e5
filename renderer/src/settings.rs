//! How a scene is rendered.

use crate::arithmetic::{Arithmetic, Precision};
pub use crate::trace::bvh::BuildQuality;
pub use crate::trace::sampling::{GradientSamples, Samples, Sampling};

/// How a scene is rendered. The default is the fastest way to one ray through the middle of each pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// What the kernels compute in.
    pub arithmetic: Arithmetic,
    /// How primary visibility is found.
    pub visibility: PrimaryVisibility,
    /// The quality of the bounding volume hierarchy.
    pub build_quality: BuildQuality,
    /// What is shown of surfaces.
    pub pass: Pass,
    /// Where within pixels rays go.
    pub sampling: Sampling,
    /// How many mirrors and transparent surfaces a path has at most, if not as many as the scene says.
    pub bounces: Option<u32>,
}

impl Settings {
    /// The same, in double precision.
    pub fn in_double_precision(self) -> Self {
        Self { arithmetic: Arithmetic::fastest(Precision::F64), ..self }
    }
}

/// How it is found which primitive a pixel shows. The images are the same, but for pixels on edges at
/// which two primitives are equally near.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum PrimaryVisibility {
    /// Rays traverse a bounding volume hierarchy.
    #[default]
    Bvh,
    /// Every ray is tested against every primitive.
    BruteForce,
    /// Primitives are rasterised into the tiles of the image that they may cover. Shadows and mirrors
    /// use the hierarchy.
    Raster,
}

/// What is shown of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Pass {
    /// The radiance that leaves it towards the camera.
    #[default]
    Radiance,
    /// Its diffuse albedo, without lights, shadows and mirrors.
    Albedo,
}
