//! From radiance to a picture to look at. Nothing that is optimised goes through here.

use crate::image::Image;
use crate::settings::Pass;
use crate::trace::sampling::hash;

/// How radiances beyond what a picture can show are brought into its range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum ToneMapping {
    /// Not at all: a PNG clips at 1, an EXR keeps everything.
    #[default]
    #[cfg_attr(feature = "clap", value(alias = "none"))]
    Clamp,
    /// Divides by 1 + luminance (Reinhard, Stark, Shirley and Ferwerda, "Photographic tone
    /// reproduction for digital images", SIGGRAPH 2002, equation 3, with luminances taken as they
    /// are). Hues stay; a colour far from grey may still have a channel above 1.
    Reinhard,
    /// A film-like curve for each channel, the fit of Narkowicz ("ACES Filmic Tone Mapping Curve", 2016) to the
    /// reference transform of the Academy: darks get darker, and what is brighter than white fades to it.
    Aces,
}

/// The part of red, green and blue in the luminance (ITU-R BT.709).
const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

impl ToneMapping {
    /// Maps every pixel. Finite radiances stay finite.
    pub fn apply(self, image: &mut Image) {
        match self {
            Self::Clamp => {}
            Self::Reinhard => {
                for pixel in &mut image.pixels {
                    // Colours are not negative, but an image from elsewhere may be.
                    let parts = pixel.iter().zip(LUMINANCE);
                    let luminance: f64 = parts.map(|(v, part)| f64::from(v.max(0.0)) * part).sum();
                    *pixel = pixel.map(|value| (f64::from(value) / (1.0 + luminance)) as f32);
                }
            }
            Self::Aces => {
                for value in image.pixels.as_flattened_mut() {
                    let x = f64::from(value.max(0.0));
                    let mapped = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
                    *value = mapped.min(1.0) as f32;
                }
            }
        }
    }
}

/// Multiplies every radiance by two to the power of `stops`. What would leave the range of `f32`
/// becomes the largest number there.
pub fn expose(image: &mut Image, stops: f64) {
    let factor = stops.exp2();
    for value in image.pixels.as_flattened_mut() {
        let exposed = f64::from(*value) * factor;
        *value = exposed.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32;
    }
}

/// Maps the smallest value of any channel to 0 and the largest to 1, linearly: `zeroonenorm` of
/// RayTracer.jl. An image of one value becomes black.
pub fn normalize(image: &mut Image) {
    let (low, high) = range(image);
    map_range(image, low, high);
}

/// The smallest and the largest value of any channel.
pub fn range(image: &Image) -> (f32, f32) {
    let values = image.pixels.as_flattened().iter().copied();
    (values.clone().fold(f32::INFINITY, f32::min), values.fold(f32::NEG_INFINITY, f32::max))
}

/// What of a [pass](Pass) that measures shapes is 0 and what is 1 in a picture: normals from -1 to 1, coverage and
/// texture coordinates from 0 to 1, places from the smallest to the largest number, depth such that what is near is dark,
/// and black where nothing is.
pub fn range_of_measure(image: &Image, pass: Pass) -> (f32, f32) {
    match pass {
        Pass::Normals => return (-1.0, 1.0),
        Pass::Coverage | Pass::Uv => return (0.0, 1.0),
        _ => {}
    }
    let (low, high) = range(image);
    if pass == Pass::Position {
        return (low, high);
    }
    let mut depths: Vec<f32> = image.pixels.iter().map(|[z, ..]| *z).filter(|z| *z > 0.0).collect();
    depths.sort_unstable_by(f32::total_cmp);
    // Pixels on silhouettes are nearer by the part of them that nothing covers.
    let near = depths.get(depths.len() / 20).copied().unwrap_or(low);
    (near - 0.3 * (high - near), high)
}

/// Gives every combination of [identifiers](Pass::Ids) a colour of its own, as a hash has it; nothing stays black.
pub fn color_ids(image: &mut Image) {
    const LEVELS: u32 = 1 << 10;
    for pixel in image.pixels.iter_mut().filter(|pixel| **pixel != [0.0; 3]) {
        let mixed = pixel.iter().fold(0, |mixed, id| hash(mixed ^ *id as u32));
        *pixel = [0, 10, 20]
            .map(|shift| 0.15 + 0.85 * (mixed >> shift & (LEVELS - 1)) as f32 / LEVELS as f32);
    }
}

/// Maps `low` to 0 and `high` to 1, linearly; everything to 0 if they are equal.
pub fn map_range(image: &mut Image, low: f32, high: f32) {
    // In double precision the difference of two f32 is never infinite.
    let (low, range) = (f64::from(low), f64::from(high) - f64::from(low));
    for value in image.pixels.as_flattened_mut() {
        let part = (f64::from(*value) - low) / range;
        *value = if range > 0.0 { part as f32 } else { 0.0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(values: &[f32]) -> Image {
        let pixels = values.iter().map(|&value| [value; 3]).collect();
        Image { width: values.len() as u32, height: 1, pixels }
    }

    fn mapped(values: &[f32], map: impl Fn(&mut Image)) -> Vec<f32> {
        let mut image = image(values);
        map(&mut image);
        image.pixels.iter().map(|pixel| pixel[0]).collect()
    }

    #[test]
    fn a_stop_is_a_factor_of_two() {
        assert_eq!(mapped(&[0.0, 0.25, 3.0], |i| expose(i, 2.0)), [0.0, 1.0, 12.0]);
        assert_eq!(mapped(&[1.0], |i| expose(i, -1.0)), [0.5]);
        assert_eq!(mapped(&[0.0, 1e30], |i| expose(i, 100.0)), [0.0, f32::MAX]);
    }

    #[test]
    fn normalized_images_span_zero_to_one() {
        assert_eq!(mapped(&[3.0, 1.0, 2.0], normalize), [1.0, 0.0, 0.5]);
        assert_eq!(mapped(&[7.0, 7.0], normalize), [0.0, 0.0]);
        assert_eq!(mapped(&[f32::MIN, f32::MAX], normalize), [0.0, 1.0]);
    }

    #[test]
    fn aces_rises_from_black_to_white() {
        let aces = |image: &mut Image| ToneMapping::Aces.apply(image);
        let greys = mapped(&[-1.0, 0.0, 0.01, 0.18, 1.0, 4.0, 1e30, f32::MAX], aces);
        assert!(greys.is_sorted() && greys[1] == 0.0 && greys[7] == 1.0, "{greys:?}");
        // Middle grey, and white, by the fit worked out by hand.
        assert!(
            (greys[3] - 0.266_9).abs() < 1e-3 && (greys[4] - 0.803_8).abs() < 1e-3,
            "{greys:?}"
        );
    }

    #[test]
    fn reinhard_compresses_and_keeps_hues() {
        let reinhard = |image: &mut Image| ToneMapping::Reinhard.apply(image);
        let greys = mapped(&[0.0, 1.0, 9.0, 1e30], reinhard);
        for (grey, expected) in greys.iter().zip([0.0, 0.5, 0.9, 1.0]) {
            assert!((grey - expected).abs() < 1e-6, "{greys:?}");
        }
        let mut image = Image { width: 1, height: 1, pixels: vec![[4.0, 2.0, 1.0]] };
        reinhard(&mut image);
        let [r, g, b] = image.pixels[0];
        assert!((r / g - 2.0).abs() < 1e-6 && (g / b - 2.0).abs() < 1e-6);
        let mut image = Image { width: 1, height: 1, pixels: vec![[f32::MAX; 3]] };
        reinhard(&mut image);
        assert!(image.pixels[0].iter().all(|value| (value - 1.0).abs() < 1e-6));
    }
}
