//! How alike two pictures are.
//!
//! Both are taken as they are shown: clipped to 0..1 and encoded as sRGB, since that is what figures of other
//! programs are about.

use std::array;

use renderer_core::Image;

use super::srgb_encode;

/// How alike an image and its target are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// The peak signal-to-noise ratio in dB, over all pixels and channels; infinite for equal pictures.
    pub psnr: f64,
    /// The mean structural similarity of the channels (Wang et al., "Image Quality Assessment: From Error
    /// Visibility to Structural Similarity", 2004), with Gaussian windows of deviation 1.5 and 11 by 11
    /// pixels about pixels that count, those that cross the border left out; 1 for equal pictures. Of images
    /// with a side of fewer than 11 pixels, and where no window is about a pixel that counts, that of one
    /// window of all pixels.
    pub ssim: f64,
}

/// The side of a window, and the deviation of its weights.
const WINDOW: usize = 11;
const DEVIATION: f64 = 1.5;
/// What keeps quotients of dark and flat windows finite.
const FLAT: [f64; 2] = [0.01 * 0.01, 0.03 * 0.03];

impl Quality {
    /// Of an image beside a target of the same size. Pixels of weight 0 count as equal.
    ///
    /// # Panics
    ///
    /// If the sizes differ, or there is not a weight for each pixel.
    pub fn of(image: &Image, target: &Image, weights: Option<&[f32]>) -> Self {
        let size = (target.width, target.height);
        assert_eq!((image.width, image.height), size, "the images have the same size");
        let counts = |index: usize| weights.is_none_or(|weights| weights[index] > 0.0);
        let channel = |of: &Image, channel: usize| -> Vec<f64> {
            let pixels = of.pixels.iter().zip(&target.pixels).enumerate();
            let value = |(index, (own, target)): (usize, (&[f32; 3], &[f32; 3]))| {
                let pixel = if counts(index) { own } else { target };
                srgb_encode(pixel[channel])
            };
            pixels.map(value).collect()
        };
        let counted = (0..target.pixels.len()).filter(|&index| counts(index)).count();
        let (mut squares, mut ssim) = (0.0, 0.0);
        for index in 0..3 {
            let (a, b) = (channel(image, index), channel(target, index));
            squares += a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
            ssim += similarity(&a, &b, target.width as usize, &counts) / 3.0;
        }
        Self { psnr: -10.0 * (squares / (3 * counted) as f64).log10(), ssim }
    }
}

/// The mean similarity of the windows of two channels, which stand in rows of `width`, about pixels that count.
fn similarity(a: &[f64], b: &[f64], width: usize, counts: &dyn Fn(usize) -> bool) -> f64 {
    let (columns, rows) =
        ((width + 1).saturating_sub(WINDOW), (a.len() / width + 1).saturating_sub(WINDOW));
    let is_about = |window: usize| {
        let [column, row] = [window % columns, window / columns].map(|first| first + WINDOW / 2);
        counts(row * width + column)
    };
    let about: Vec<usize> = (0..columns * rows).filter(|&window| is_about(window)).collect();
    if about.is_empty() {
        let mean = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / a.len() as f64;
        let pairs = || a.iter().zip(b);
        return of_window(
            mean(&mut a.iter().copied()),
            mean(&mut b.iter().copied()),
            mean(&mut a.iter().map(|a| a * a)),
            mean(&mut b.iter().map(|b| b * b)),
            mean(&mut pairs().map(|(a, b)| a * b)),
        );
    }
    let product =
        |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a * b).collect() };
    let means = [a.to_vec(), b.to_vec(), product(a, a), product(b, b), product(a, b)];
    let [a, b, aa, bb, ab] = means.map(|values| windowed(&values, width));
    let windows = about.iter().map(|&i| of_window(a[i], b[i], aa[i], bb[i], ab[i]));
    windows.sum::<f64>() / about.len() as f64
}

/// The similarity of two windows: of their means, of the means of squares, and of that of products.
fn of_window(a: f64, b: f64, aa: f64, bb: f64, ab: f64) -> f64 {
    let [c1, c2] = FLAT;
    let (varying, together) = ((aa - a * a) + (bb - b * b), ab - a * b);
    (2.0 * a * b + c1) * (2.0 * together + c2) / ((a * a + b * b + c1) * (varying + c2))
}

/// The weighted means of all windows that lie within an image: of rows first, then of columns of those.
fn windowed(values: &[f64], width: usize) -> Vec<f64> {
    let weights: [f64; WINDOW] =
        array::from_fn(|i| (-(i as f64 - 5.0).powi(2) / (2.0 * DEVIATION * DEVIATION)).exp());
    let sum: f64 = weights.iter().sum();
    let mean =
        |of: &mut dyn Iterator<Item = f64>| of.zip(weights).map(|(a, b)| a * b).sum::<f64>() / sum;
    let columns = width + 1 - WINDOW;
    let rows = values.chunks_exact(width).flat_map(|row| row.windows(WINDOW));
    let rows: Vec<f64> = rows.map(|window| mean(&mut window.iter().copied())).collect();
    let below = (WINDOW - 1) * columns;
    let windows =
        (0..rows.len() - below).map(|from| rows[from..=from + below].iter().step_by(columns));
    windows.map(|window| mean(&mut window.copied())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::images::srgb_decode;

    fn image(width: u32, height: u32, value: impl Fn(u32, u32) -> f32) -> Image {
        let pixels = (0..width * height).map(|i| [value(i % width, i / width); 3]).collect();
        Image { width, height, pixels }
    }

    #[test]
    fn equal_pictures_are_alike() {
        for side in [4, 16] {
            let picture = image(side, side, |x, y| (x * 7 % 5 + y) as f32 / 30.0);
            let quality = Quality::of(&picture, &picture, None);
            assert!(quality.psnr.is_infinite() && (quality.ssim - 1.0).abs() < 1e-12);
        }
    }

    /// One level of sRGB off everywhere is 48.13 dB; the similarity of flat pictures is that of their means.
    #[test]
    fn flat_pictures_have_known_figures() {
        let linear = |level: f64| srgb_decode(level / 255.0) as f32;
        let [a, b] = [100.0, 101.0].map(|level| image(16, 12, |_, _| linear(level)));
        let Quality { psnr, ssim } = Quality::of(&a, &b, None);
        assert!((psnr - 20.0 * 255.0_f64.log10()).abs() < 1e-3, "{psnr}");
        let [a, b] = [100.0 / 255.0, 101.0 / 255.0];
        let expected = (2.0 * a * b + 1e-4) / (a * a + b * b + 1e-4);
        assert!((ssim - expected).abs() < 1e-6, "{ssim} {expected}");
    }

    /// What a mask leaves out makes no picture more alike.
    #[test]
    fn windows_about_masked_pixels_do_not_count() {
        let wave = |sign: f32| image(48, 24, move |x, _| 0.2 + sign * 0.1 * (x as f32).sin());
        let left: Vec<f32> = (0..48 * 24).map(|i| f32::from(u8::from(i % 48 < 24))).collect();
        let [whole, masked] =
            [None, Some(&left[..])].map(|of| Quality::of(&wave(1.0), &wave(-1.0), of));
        assert!(whole.ssim < -0.5 && masked.ssim < -0.4, "{whole:?} {masked:?}");
        assert!((whole.psnr - masked.psnr).abs() < 0.5, "{whole:?} {masked:?}");
        assert!(Quality::of(&wave(1.0), &wave(-1.0), Some(&[0.0; 48 * 24])).ssim > 0.999);
    }

    /// A picture and its negative about grey vary against each other.
    #[test]
    fn opposites_are_not_alike() {
        let wave = |sign: f32| image(24, 24, move |x, _| 0.2 + sign * 0.1 * (x as f32).sin());
        assert!(Quality::of(&wave(1.0), &wave(-1.0), None).ssim < -0.5);
    }

    #[test]
    fn what_is_masked_is_equal() {
        let (a, b) =
            (image(12, 12, |_, _| 0.5), image(12, 12, |x, _| if x < 6 { 0.5 } else { 0.9 }));
        let weights: Vec<f32> = (0..144).map(|i| if i % 12 < 6 { 1.0 } else { 0.0 }).collect();
        assert!(Quality::of(&a, &b, Some(&weights)).psnr.is_infinite());
        assert!(Quality::of(&a, &b, None).psnr < 30.0);
    }
}
