//! Derivatives as colours.

use glam::Vec3;
use renderer::Image;

/// The mean over channels in colours from blue at `-scale` over white to red at `scale`.
pub fn false_colors(derivatives: &Image, scale: f32) -> Image {
    let color = |derivative: &[f32; 3]| {
        let signed = (derivative.iter().sum::<f32>() / 3.0 / scale).clamp(-1.0, 1.0);
        let end = if signed > 0.0 { Vec3::new(0.7, 0.0, 0.02) } else { Vec3::new(0.02, 0.05, 0.7) };
        // The root tells small derivatives from none.
        Vec3::ONE.lerp(end, signed.abs().sqrt()).to_array()
    };
    Image { pixels: derivatives.pixels.iter().map(color).collect(), ..*derivatives }
}
