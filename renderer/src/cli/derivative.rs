//! The derivative of an image, and its picture.

use super::changes::assignment;
use super::output::{print_note, short};
use crate::Error;
use crate::Image;
use crate::render::Renderer;
use crate::scene::Scene;

/// The derivative of the image along a direction, such as `light.key.position=1,0,0`.
pub(super) fn derivative(
    renderer: &Renderer,
    scene: &Scene,
    direction: &str,
) -> Result<Image, Error> {
    let refuse = |problem| Error::new(format_args!("--derivative {direction}"), problem);
    let along = assignment(scene, direction).map_err(refuse)?;
    if along.1.iter().all(|&number| number == 0.0) {
        return Err(refuse("the direction is zero: nothing moves along it".to_owned()));
    }
    Ok(renderer.jvp(scene, &[along])?.1)
}

/// A derivative in colours: red where pixels become brighter, blue where they become darker, white where nothing
/// changes.
pub(super) fn in_colors(derivative: &Image) -> Image {
    let luminance = |pixel: &[f32; 3]| pixel.iter().sum::<f32>() / 3.0;
    let mut sizes: Vec<f32> = derivative.pixels.iter().map(|p| luminance(p).abs()).collect();
    sizes.sort_unstable_by(f32::total_cmp);
    // Few pixels on edges have by far the largest derivatives, unless no others have any.
    let most = sizes.len() - 1;
    let scale = [most * 99 / 100, most].map(|at| sizes[at]).into_iter().find(|&size| size > 0.0);
    let Some(scale) = scale else {
        print_note("the derivative is 0 everywhere: the image is white");
        return Image { pixels: vec![[1.0; 3]; sizes.len()], ..*derivative };
    };
    print_note(format_args!("full red and blue: a derivative of {}", short(scale.into())));
    let color = |pixel: &[f32; 3]| {
        let value = (luminance(pixel) / scale).clamp(-1.0, 1.0);
        let rest = (1.0 - value.abs()).powi(2);
        if value > 0.0 { [1.0, rest, rest] } else { [rest, rest, 1.0] }
    };
    let pixels = derivative.pixels.iter().map(color).collect();
    Image { pixels, ..*derivative }
}
