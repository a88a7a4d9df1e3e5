//! Images side by side, brightened or darkened to be seen.

use renderer::Image;

/// Black pixels between two images.
const GAP: u32 = 4;

/// Images of one height side by side, brightened by the factor `exposure`.
///
/// # Panics
///
/// If there is no image, or their heights differ.
pub fn strip(images: &[Image], exposure: f32) -> Image {
    let height = images[0].height;
    assert!(images.iter().all(|image| image.height == height), "images of one height");
    let gaps = GAP * (images.len() as u32 - 1);
    let width = images.iter().map(|image| image.width).sum::<u32>() + gaps;
    let mut strip = Image::black(width, height);
    let mut left = 0;
    for image in images {
        let rows = image.pixels.chunks(image.width as usize);
        for (from, to) in rows.zip(strip.pixels.chunks_mut(width as usize)) {
            for (from, to) in from.iter().zip(&mut to[left..]) {
                *to = from.map(|value| value * exposure);
            }
        }
        left += (image.width + GAP) as usize;
    }
    strip
}

/// The largest value of an image. One over it as exposure makes that white.
pub fn brightest(image: &Image) -> f32 {
    image.pixels.as_flattened().iter().copied().fold(0.0, f32::max)
}
