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
    /// The quality of the bounding volume hierarchy; at least medium where light takes all paths.
    pub build_quality: BuildQuality,
    /// What is shown of surfaces.
    pub pass: Pass,
    /// Where within pixels camera rays go.
    pub sampling: Sampling,
    /// How many mirrors and transparent surfaces a path has at most, if not as many as the scene says.
    pub bounces: Option<u32>,
    /// Whether images and gradients see edges.
    pub edges: Edges,
}

impl Settings {
    /// These settings with the fastest arithmetic in double precision.
    pub fn in_double_precision(self) -> Self {
        Self { arithmetic: Arithmetic::fastest(Precision::F64), ..self }
    }
}

/// Whether images and gradients see edges: silhouettes, shadows, and whatever else radiance jumps at.
///
/// Where they do, each side of an edge counts by the area that it covers of a pixel, and the gradient
/// has the boundary term: what pixels gain and lose when edges move. Rays form a regular grid then, of
/// at least as many as the [sampling](Settings::sampling) says.
///
/// Where light takes all paths, images are means of samples that lie anywhere in a pixel, with edges or without,
/// and the boundary term comes from the edges that the camera sees, of surfaces and of shadows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Edges {
    /// For gradients by parameters that move edges, and for the images and losses that come with them.
    #[default]
    Auto,
    /// Always.
    On,
    /// Never: pixels are means of samples, and gradients the interior term alone.
    Off,
}

impl Edges {
    /// What they are for gradients by parameters, one of which moves edges or none: on or off.
    pub(crate) fn given(self, moves_edges: bool) -> Self {
        match self {
            Self::Auto if moves_edges => Self::On,
            Self::Auto => Self::Off,
            chosen => chosen,
        }
    }
}

/// How it is found which primitive a pixel shows. The images are the same, but for pixels on edges at
/// which two primitives are equally near.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
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
///
/// All but radiance are images, too: with edges, each side of an edge counts by the area that it covers of a
/// pixel, and there are gradients by whatever moves what is shown. Where the camera sees nothing, they are 0.
/// They show the first surface that a ray meets, also where it is transparent or a mirror. Identifiers alone are
/// no such image: they are those at the middle of a pixel, and have no derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Pass {
    /// The radiance that leaves it towards the camera.
    #[default]
    Radiance,
    /// Its diffuse albedo, without lights, shadows and mirrors.
    Albedo,
    /// That there is one: 1. With edges, pixels show how much of them surfaces cover: silhouettes, whatever
    /// shades them.
    Coverage,
    /// How far it is along the direction in which the camera looks, in scene units, in all three channels.
    Depth,
    /// Where it is in the world, in scene units.
    Position,
    /// The unit normal that shades it, in the world and on the side of the viewer.
    Normals,
    /// Its texture coordinates u and v, then 0; 0 where it has none. Where a texture is repeated they go beyond 1. The seam
    /// of a sphere, at which u goes from 1 to 0, is no edge.
    Uv,
    /// What it is part of: an object, counted from 1 over meshes, spheres and shapes of one's own in this order; the
    /// triangle of the mesh, counted from 1, and 1 for others; the material, counted from 1. 0 where nothing is.
    Ids,
}

impl Pass {
    /// The name that files and the command line have for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Radiance => "radiance",
            Self::Albedo => "albedo",
            Self::Coverage => "coverage",
            Self::Depth => "depth",
            Self::Position => "position",
            Self::Normals => "normals",
            Self::Uv => "uv",
            Self::Ids => "ids",
        }
    }

    /// Whether what is shown may be below 0.
    #[doc(hidden)]
    pub fn is_signed(self) -> bool {
        matches!(self, Self::Position | Self::Normals | Self::Uv)
    }

    /// Whether what is shown measures shapes, and is no part or colour of light.
    #[doc(hidden)]
    pub fn is_measure(self) -> bool {
        !matches!(self, Self::Radiance | Self::Albedo)
    }
}
