//! Textures as image files.

use image::ExtendedColorType;
use renderer_core::Error;
use renderer_core::scene::{Scene, Texture};

use crate::images::png::encode as encode_png;
use crate::images::srgb_encode;
use crate::warning::Warnings;

/// What an image file shows of the textures of a scene, by their indices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Picture {
    /// Colours, as sRGB.
    Color(u32),
    /// Numbers as they are.
    Data(u32),
    /// Colours, or white, with an alpha channel: the mean of the channels of a texture of the same size.
    #[cfg_attr(
        not(feature = "gltf"),
        allow(dead_code, reason = "other formats have files of opacity")
    )]
    Covered { color: Option<u32>, opacity: u32 },
}

impl Picture {
    /// The texture that it has its name, its size and its edges from.
    pub fn texture(self, scene: &Scene) -> &Texture {
        let (Self::Color(index)
        | Self::Data(index)
        | Self::Covered { color: Some(index), .. }
        | Self::Covered { color: None, opacity: index }) = self;
        &scene.textures[index as usize]
    }

    /// The bytes of a PNG file of 8 bits. Of what is above 1 is warned.
    pub fn png(self, scene: &Scene, warnings: &mut Warnings) -> Result<Vec<u8>, Error> {
        let texture = self.texture(scene);
        let place = format!("texture.{}", texture.name);
        let encode = |value: f64| match self {
            Self::Data(_) => value.clamp(0.0, 1.0),
            _ => srgb_encode(value as f32),
        };
        let level = |value: f64| (255.0 * value).round() as u8;
        let colors: Vec<[u8; 3]> = match self {
            Self::Covered { color: None, .. } => vec![[255; 3]; texture.texels.len()],
            _ => {
                if texture.texels.iter().flatten().any(|value| value > 1.0) {
                    let problem = "texels above 1 are written as 1: the image has 8 bits";
                    warnings.add("clipped texels", &place, problem);
                }
                texture.texels.iter().map(|texel| texel.map(|value| level(encode(value)))).collect()
            }
        };
        let (levels, kind) = match self {
            Self::Covered { opacity, .. } => {
                let coverage = scene.textures[opacity as usize].texels.iter();
                let mean = |[r, g, b]: [f64; 3]| level((r + g + b) / 3.0);
                let texels = colors.iter().zip(coverage);
                let texel = |(&[r, g, b], coverage): (&[u8; 3], _)| [r, g, b, mean(coverage)];
                (texels.flat_map(texel).collect(), ExtendedColorType::Rgba8)
            }
            _ => (colors.into_flattened(), ExtendedColorType::Rgb8),
        };
        encode_png(&levels, [texture.width, texture.height], kind, &place)
    }
}
