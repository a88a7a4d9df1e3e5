//! What textures cost that vary.

use ad::differentiable;
use glam::DVec3;
use renderer_core::scene::{Texture, Wrap};

use super::{add, vector};

/// Below this, differences count by their squares: it makes the term smooth where a texture does not vary.
const SMALLEST: f64 = 1e-3;

/// The mean over the texels of the length of all differences, of all channels, from the next texel to the right
/// and the next one below (Rudin, Osher and Fatemi, "Nonlinear Total Variation Based Noise Removal Algorithms",
/// 1992; of colours, Blomgren and Chan 1998). A texture that repeats goes on at its borders; a map of the
/// environment goes around, and ends at the poles.
#[derive(Clone, Debug)]
pub struct TotalVariation {
    width: usize,
    height: usize,
    /// Along rows and along columns.
    repeats: [bool; 2],
}

#[differentiable]
fn variation(texel: DVec3, right: DVec3, below: DVec3) -> f64 {
    let squares = (right - texel).length_squared() + (below - texel).length_squared();
    (squares + SMALLEST * SMALLEST).sqrt() - SMALLEST
}

impl TotalVariation {
    /// Of a texture, or of a map of the environment.
    pub fn new(texture: &Texture, is_environment: bool) -> Self {
        let (width, height) = (texture.width as usize, texture.height as usize);
        let repeats = match is_environment {
            true => [true, false],
            false => [texture.wrap == Wrap::Repeat; 2],
        };
        Self { width, height, repeats }
    }

    /// The energy of these numbers, and its gradient.
    pub fn energy(&self, x: &[f64]) -> (f64, Vec<f64>) {
        let (mut sum, mut gradient) = (0.0, vec![0.0; x.len()]);
        let part = 1.0 / (self.width * self.height) as f64;
        for row in 0..self.height {
            for column in 0..self.width {
                let at = |row: usize, column: usize| row * self.width + column;
                let texels = [
                    at(row, column),
                    at(row, next(column, self.width, self.repeats[0])),
                    at(next(row, self.height, self.repeats[1]), column),
                ];
                let [texel, right, below] = texels.map(|index| vector(x, index));
                let (value, pullback) = variation::vjp(texel, right, below);
                let (texel, right, below) = pullback(part);
                sum += part * value;
                for (index, cotangent) in texels.into_iter().zip([texel, right, below]) {
                    add(&mut gradient, index, cotangent);
                }
            }
        }
        (sum, gradient)
    }
}

/// The texel after one of so many, if there is any; at the end, where there is none, the same again.
fn next(index: usize, count: usize, repeats: bool) -> usize {
    match index + 1 {
        next if next < count => next,
        _ if repeats => 0,
        _ => index,
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::agrees_with_differences;
    use super::*;

    fn texture(width: u32, height: u32, wrap: Wrap) -> Texture {
        let texels = vec![[0.5_f64; 3]; (width * height) as usize].into();
        Texture { name: String::new(), width, height, wrap, texels }
    }

    #[test]
    fn the_gradient_is_that_of_the_energy() {
        for (width, height, wrap) in
            [(3, 2, Wrap::Repeat), (2, 3, Wrap::Clamp), (4, 1, Wrap::Mirror)]
        {
            let x: Vec<f64> =
                (0..3 * width * height).map(|i| f64::from(i * 7 % 11) / 11.0).collect();
            let variation = TotalVariation::new(&texture(width, height, wrap), false);
            agrees_with_differences(&x, |x| variation.energy(x));
        }
    }

    /// A map that is black above and white below has one step, at the horizon and not at the poles.
    #[test]
    fn maps_end_at_the_poles() {
        let halves: Vec<f64> =
            (0..8 * 3).map(|number| if number < 12 { 0.0 } else { 1.0 }).collect();
        for (is_environment, steps) in [(true, 1.0), (false, 2.0)] {
            let variation = TotalVariation::new(&texture(4, 2, Wrap::Repeat), is_environment);
            let (value, _) = variation.energy(&halves);
            let expected = steps / 2.0 * 3.0_f64.sqrt();
            assert!((value - expected).abs() < SMALLEST, "{value} {expected}");
        }
    }

    /// One step from black to white costs what it is high; a texture that repeats has it twice.
    #[test]
    fn steps_cost_their_height() {
        let black_and_white: Vec<f64> =
            (0..4 * 3).flat_map(|texel| [if texel % 4 < 2 { 0.0 } else { 1.0 }; 3]).collect();
        for (wrap, steps) in [(Wrap::Clamp, 1.0), (Wrap::Repeat, 2.0)] {
            let (value, _) =
                TotalVariation::new(&texture(4, 3, wrap), false).energy(&black_and_white);
            let expected = steps / 4.0 * 3.0_f64.sqrt();
            assert!((value - expected).abs() < SMALLEST, "{value} {expected}");
        }
        let (value, gradient) =
            TotalVariation::new(&texture(4, 3, Wrap::Repeat), false).energy(&[0.3; 36]);
        assert_eq!(value, 0.0);
        assert!(gradient.iter().all(|number| *number == 0.0));
    }
}
