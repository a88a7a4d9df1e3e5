//! How far a gradient or an image is from another.

#[cfg(feature = "cli")]
use crate::Image;
use crate::scene::{ParameterId, Scene};

/// The measure of gradients by some parameters of a scene.
///
/// Derivatives by an intensity and by a position have different units, so each is multiplied by the
/// [natural scale](Scene::natural_scale) of its parameter first: what the loss changes by when the
/// parameter changes a lot. The error is the Euclidean length of the difference over that of the
/// reference. Turned down: the largest error of a single derivative relative to itself, which is as
/// large as you like where one derivative happens to be near zero, and tells nothing of the step that
/// an optimiser takes.
#[derive(Clone, Debug, PartialEq)]
pub struct GradientMetric {
    /// The natural scale of each number.
    scales: Vec<f64>,
}

impl GradientMetric {
    /// A metric for gradients by these parameters, one after the other.
    pub fn new(scene: &Scene, ids: &[ParameterId]) -> Self {
        let block = |&id: &ParameterId| {
            let scale = scene.natural_scale(id);
            vec![scale; scene.count(id)]
        };
        Self { scales: ids.iter().flat_map(block).collect() }
    }

    /// How many numbers a gradient has.
    pub fn count(&self) -> usize {
        self.scales.len()
    }

    /// The natural scale of one number.
    pub fn scale(&self, index: usize) -> f64 {
        self.scales[index]
    }

    /// The relative error of a gradient: 0 if both vanish, infinite if the reference alone does or
    /// the gradient is not finite.
    ///
    /// # Panics
    ///
    /// If one of them has another number of elements.
    pub fn error(&self, gradient: &[f64], reference: &[f64]) -> f64 {
        let all: Vec<usize> = (0..self.count()).collect();
        self.error_among(&all, gradient, reference)
    }

    /// The relative error of the elements with these indices; `gradient` has them alone.
    pub(crate) fn error_among(
        &self,
        elements: &[usize],
        gradient: &[f64],
        reference: &[f64],
    ) -> f64 {
        assert_eq!((elements.len(), self.count()), (gradient.len(), reference.len()));
        let scaled = |f: &dyn Fn(usize) -> f64| {
            let terms = elements.iter().enumerate().map(|(i, &e)| (f(i) * self.scales[e]).powi(2));
            terms.sum::<f64>().sqrt()
        };
        let difference = scaled(&|i| gradient[i] - reference[elements[i]]);
        ratio(difference, scaled(&|i| reference[elements[i]]))
    }
}

/// The relative error of an image of the same size: the Euclidean length of the difference of all
/// channels over that of the reference.
#[cfg(feature = "cli")]
pub(crate) fn image_error(image: &Image, reference: &Image) -> f64 {
    let pairs = image.pixels.as_flattened().iter().zip(reference.pixels.as_flattened());
    let (difference, size) = pairs.fold((0.0, 0.0), |(difference, size), (&a, &b)| {
        let (a, b) = (f64::from(a), f64::from(b));
        (difference + (a - b).powi(2), size + b * b)
    });
    ratio(difference.sqrt(), size.sqrt())
}

fn ratio(difference: f64, size: f64) -> f64 {
    if difference == 0.0 {
        0.0
    } else if difference.is_finite() && size > 0.0 {
        difference / size
    } else {
        f64::INFINITY
    }
}
