//! The network: an image in, a lamp out.

use candle_core::{Device, Result, Tensor, Var};
use candle_nn::{Linear, Module};

use crate::random::Random;
use crate::scene::Lamp;

/// The width and height of the images that it looks at.
pub const SIZE: usize = 32;
/// Each convolution: the width of its patches, and the channels that it makes of each.
const CONVOLUTIONS: [(usize, usize); 2] = [(4, 32), (2, 64)];
/// The numbers between the two layers that are fully connected.
const HIDDEN: usize = 64;
/// How much smaller the first weights of the last layer are than those of others, so that what has
/// learnt nothing answers about the middle of the box of lamps.
const CAUTION: f64 = 0.1;
/// How far beyond the box of lamps the answers reach at either end, in parts of its size.
const MARGIN: f64 = 0.1;

/// Two convolutions and two layers that are fully connected.
///
/// The patches of a convolution do not overlap: all of them together are one product of matrices. With
/// candle's convolutions of 3 x 3 pixels, training takes twice as long and is no better for it.
///
/// The answer is squashed into the box between [`Lamp::LOWEST`] and [`Lamp::HIGHEST`], a little
/// enlarged: from below the floor, say, a light leaves the image black, and what stays black has no
/// gradient to learn by.
pub struct Network {
    convolutions: Vec<(usize, Linear)>,
    hidden: Linear,
    last: Linear,
    variables: Vec<Var>,
}

impl Network {
    /// A network that has learnt nothing.
    ///
    /// # Errors
    ///
    /// If candle has no memory for it.
    pub fn new(random: &mut Random) -> Result<Self> {
        let mut variables = Vec::new();
        let mut linear =
            |inputs, outputs, scale| linear(inputs, outputs, scale, random, &mut variables);
        let (mut size, mut channels) = (SIZE, 3);
        let mut convolutions = Vec::new();
        for (patch, outputs) in CONVOLUTIONS {
            convolutions.push((patch, linear(patch * patch * channels, outputs, 1.0)?));
            (size, channels) = (size / patch, outputs);
        }
        let hidden = linear(size * size * channels, HIDDEN, 1.0)?;
        let last = linear(HIDDEN, Lamp::NUMBERS, CAUTION)?;
        Ok(Self { convolutions, hidden, last, variables })
    }

    /// What training changes.
    pub fn variables(&self) -> Vec<Var> {
        self.variables.clone()
    }

    /// The lamps of images `[batch, SIZE, SIZE, 3]`, as `[batch, Lamp::NUMBERS]`.
    ///
    /// # Errors
    ///
    /// If the images have another shape.
    pub fn lamps(&self, images: &Tensor) -> Result<Tensor> {
        // Radiance falls off with the square of the distance; its root is spread more evenly.
        let mut x = (images.sqrt()? - 0.5)?;
        for (patch, layer) in &self.convolutions {
            x = layer.forward(&patches(&x, *patch)?)?.relu()?;
        }
        let x = self.hidden.forward(&x.flatten_from(1)?)?.relu()?;
        in_box(&self.last.forward(&x)?)
    }
}

/// A layer with random weights, which are added to the `variables`. At `scale` 1, what comes out of it
/// and a rectifier varies as much as the `inputs` do (He, Zhang, Ren and Sun, "Delving deep into
/// rectifiers", 2015).
fn linear(
    inputs: usize,
    outputs: usize,
    scale: f64,
    random: &mut Random,
    variables: &mut Vec<Var>,
) -> Result<Linear> {
    let bound = scale * (6.0 / inputs as f64).sqrt();
    let weights = (0..inputs * outputs).map(|_| random.between(-bound, bound) as f32).collect();
    let weights = Var::from_vec::<_, f32>(weights, (outputs, inputs), &Device::Cpu)?;
    let bias = Var::from_vec(vec![0.0_f32; outputs], outputs, &Device::Cpu)?;
    variables.extend([weights.clone(), bias.clone()]);
    Ok(Linear::new(weights.into_inner(), Some(bias.into_inner())))
}

/// Cuts images `[batch, height, width, channels]` into patches: `[batch, height / patch,
/// width / patch, patch * patch * channels]`.
fn patches(images: &Tensor, patch: usize) -> Result<Tensor> {
    let (batch, height, width, channels) = images.dims4()?;
    let (rows, columns) = (height / patch, width / patch);
    images.reshape((batch, rows, patch, columns, patch * channels))?.transpose(2, 3)?.reshape((
        batch,
        rows,
        columns,
        patch * patch * channels,
    ))
}

/// Squashes what the last layer brings into the box of lamps.
fn in_box(x: &Tensor) -> Result<Tensor> {
    let (low, high) = (Lamp::LOWEST, Lamp::HIGHEST);
    let range = |low: f64, high: f64| (0.5 * (low + high), (0.5 + MARGIN) * (high - low));
    let [px, py, pz] = [0, 1, 2].map(|i| range(low.position[i], high.position[i]));
    let ranges = [px, py, pz, range(low.intensity.ln(), high.intensity.ln())];
    let row = |numbers: [f64; Lamp::NUMBERS]| {
        Tensor::new(&numbers.map(|number| number as f32), &Device::Cpu)
    };
    let (middle, half) = (row(ranges.map(|range| range.0))?, row(ranges.map(|range| range.1))?);
    let inside = x.tanh()?.broadcast_mul(&half)?.broadcast_add(&middle)?;
    let (position, logarithm) = (inside.narrow(1, 0, 3)?, inside.narrow(1, 3, 1)?);
    Tensor::cat(&[position, logarithm.exp()?], 1)
}
