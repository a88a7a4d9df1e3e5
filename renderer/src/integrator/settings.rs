//! What is rendered of a scene, and how it is found.

use super::sampling::Sampling;
use crate::acceleration::Effort;

/// How a scene is rendered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RenderSettings {
    /// How what pixels show is found.
    pub visibility: Visibility,
    /// How much work building the tree is.
    pub effort: Effort,
    /// What of it is shown.
    pub pass: Pass,
    /// Where within pixels rays go.
    pub sampling: Sampling,
    /// How many mirrors light meets at most, if not as many as the scene says.
    pub bounces: Option<u32>,
}

/// How it is found what a pixel shows. The images are the same, but for pixels on edges at which two
/// primitives are equally near.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Visibility {
    /// A ray goes through a tree of bounding boxes.
    #[default]
    Tree,
    /// A ray is tested against every primitive.
    List,
    /// Primitives are drawn into the tiles of the image that they may cover. Shadows and mirrors go
    /// through the tree.
    Raster,
}

/// What is shown of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Pass {
    /// What light it sends to the camera.
    #[default]
    Radiance,
    /// Its diffuse colour, without lights, shadows and mirrors.
    Albedo,
}
