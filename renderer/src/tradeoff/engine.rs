//! The ways to a gradient.

use ad::lanes::Lanes;
use glam::{DVec3, Vec3};

use super::replay::Replay;
use crate::arithmetic::Precision;
use crate::image::Image;
use crate::integrator::{
    Path, PixelLoss, Prepared, RenderSettings, Sampling, Wanted, gradient, loss, render,
};
use crate::loss::ImageLoss;
use crate::recovery::Recovery;
use crate::scene::{ParameterId, Parameters, Scene};

/// A way to the gradient of a loss at the parameters of a scene.
pub(super) trait Engine {
    /// Moves away from the parameters, so that the next gradient has to take them over, as in an
    /// optimisation. Not measured.
    fn leave(&mut self) {}

    /// Takes the parameters over; their gradient.
    fn gradient(&mut self) -> Vec<f64>;

    /// The image that the gradient is of, where it may be another one than the reference's.
    fn image(&self) -> Option<Image> {
        None
    }
}

/// What engines are asked for.
#[derive(Clone, Copy)]
pub(super) struct Question<'a> {
    pub recovery: &'a Recovery<'a>,
    pub settings: RenderSettings,
}

impl<'a> Question<'a> {
    fn scene(&self) -> &'a Scene {
        self.recovery.scene()
    }

    fn ids(&self) -> &'a [ParameterId] {
        self.recovery.ids()
    }

    fn loss(&self) -> ImageLoss<'a> {
        self.recovery.loss()
    }

    fn prepared<L: Lanes>(&self) -> Prepared<'a, L> {
        Prepared::with_settings(self.scene(), self.settings)
    }

    /// The parameters, each by a hair away from where it is; if `geometry` says so, all spheres and
    /// vertices, too.
    fn moved(&self, geometry: Geometry) -> Parameters {
        let mut ids = self.ids().to_vec();
        if geometry != Geometry::AsAsked {
            ids.extend(self.scene().parameter_ids().into_iter().filter(is_geometry));
        }
        let mut parameters = self.scene().parameters.clone();
        for id in ids {
            parameters.get_mut(id).iter_mut().for_each(|value| *value *= 1.0 + 1e-9);
        }
        parameters
    }
}

/// Whether the tree depends on a parameter.
pub(super) fn is_geometry(id: &ParameterId) -> bool {
    use ParameterId::*;
    matches!(id, Vertices(_) | Vertex { .. } | SphereCenter(_) | SphereRadius(_))
}

/// What happens to spheres and meshes between gradients.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Geometry {
    /// Those move that are asked for, and the tree is fitted to them.
    AsAsked,
    /// All move, and the tree is fitted to them.
    Fitted,
    /// All move, and the tree is built anew.
    Anew,
}

/// The generated adjoint: one pass for all derivatives.
pub(super) struct Adjoint<'a, L: Lanes> {
    question: Question<'a>,
    prepared: Prepared<'a, L>,
    moved: Parameters,
    geometry: Geometry,
}

impl<'a, L: Lanes> Adjoint<'a, L> {
    pub fn new(question: Question<'a>) -> Self {
        Self::with_geometry(question, Geometry::AsAsked)
    }

    pub fn with_geometry(question: Question<'a>, geometry: Geometry) -> Self {
        let moved = question.moved(geometry);
        Self { question, prepared: question.prepared(), moved, geometry }
    }
}

impl<L: Lanes> Adjoint<'_, L> {
    /// Changes the rays through pixels.
    pub fn set_sampling(&mut self, sampling: Sampling) {
        self.question.settings.sampling = sampling;
        self.prepared.set_sampling(sampling);
    }

    /// Takes the parameters over.
    fn arrive(&mut self) {
        match self.geometry {
            Geometry::Anew => self.prepared = self.question.prepared(),
            _ => self.prepared.set_parameters(&self.question.scene().parameters),
        }
    }

    /// The gradient of a loss of the image by the wanted parameters, one after the other.
    fn gradient_of(&self, loss: &impl PixelLoss) -> Vec<f64> {
        let ids = self.question.ids();
        let result = gradient(&self.prepared, loss, Wanted::by(ids));
        ids.iter().flat_map(|&id| result.gradient.get(id)).copied().collect()
    }
}

impl<L: Lanes> Engine for Adjoint<'_, L> {
    fn leave(&mut self) {
        self.prepared.set_parameters(&self.moved);
    }

    fn gradient(&mut self) -> Vec<f64> {
        self.arrive();
        self.gradient_of(&self.question.loss())
    }

    fn image(&self) -> Option<Image> {
        Some(render(&self.prepared))
    }
}

/// The image first, then the derivative of the loss by it, then the adjoint along the same rays, which
/// are traced again: what a loss takes that is no sum over pixels.
pub(super) struct ImageFirst<'a, L: Lanes>(pub Adjoint<'a, L>);

impl<L: Lanes> Engine for ImageFirst<'_, L> {
    fn leave(&mut self) {
        self.0.leave();
    }

    fn gradient(&mut self) -> Vec<f64> {
        let Self(adjoint) = self;
        adjoint.arrive();
        let image = render(&adjoint.prepared);
        let loss = adjoint.question.loss();
        let places = (0..image.height).flat_map(|y| (0..image.width).map(move |x| (x, y)));
        let pixels = places.zip(&image.pixels);
        let cotangents = pixels
            .map(|((x, y), &pixel)| loss.evaluate(x, y, Vec3::from_array(pixel).as_dvec3()).1);
        adjoint.gradient_of(&Cotangents { width: image.width, pixels: cotangents.collect() })
    }
}

/// The loss whose derivative by each pixel is given.
struct Cotangents {
    width: u32,
    pixels: Vec<DVec3>,
}

impl PixelLoss for Cotangents {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        let cotangent = self.pixels[(y * self.width + x) as usize];
        (radiance.dot(cotangent), cotangent)
    }
}

/// Central differences of the loss: two images for each derivative.
pub(super) struct Differences<'a, L: Lanes> {
    question: Question<'a>,
    prepared: Prepared<'a, L>,
    parameters: Parameters,
    /// The numbers to differentiate by, and the step of each.
    steps: Vec<(ParameterId, usize, f64)>,
}

impl<'a, L: Lanes> Differences<'a, L> {
    pub fn new(question: Question<'a>, steps: Vec<(ParameterId, usize, f64)>) -> Self {
        let parameters = question.scene().parameters.clone();
        Self { question, prepared: question.prepared(), parameters, steps }
    }
}

impl<L: Lanes> Engine for Differences<'_, L> {
    fn gradient(&mut self) -> Vec<f64> {
        let Self { question, prepared, parameters, steps } = self;
        let image_loss = question.loss();
        let derivative = |&(id, index, step): &(ParameterId, usize, f64)| {
            let at = parameters.get(id)[index];
            let mut loss_at = |value| {
                parameters.get_mut(id)[index] = value;
                prepared.set_parameters(parameters);
                loss(prepared, &image_loss)
            };
            let (above, below) = (loss_at(at + step), loss_at(at - step));
            parameters.get_mut(id)[index] = at;
            (above - below) / (2.0 * step)
        };
        steps.iter().map(derivative).collect()
    }
}

/// How [`Replay`] gets to derivatives.
#[derive(Clone)]
pub(super) enum ReplayMode {
    /// Dual numbers: all paths once for each of these numbers.
    Forward(Vec<usize>),
    /// The same in single precision, with sums over pixels in the precision given.
    SingleForward(Vec<usize>, Precision),
    /// A tape for each so many pixels.
    Tape(usize),
}

/// The kernels on dual numbers or on tapes, along paths that are found first.
pub(super) struct Replayed<'a, L: Lanes> {
    question: Question<'a>,
    prepared: Prepared<'a, L>,
    mode: ReplayMode,
}

impl<'a, L: Lanes> Replayed<'a, L> {
    /// One ray through the middle of each pixel.
    pub fn new(question: Question<'a>, mode: ReplayMode) -> Self {
        assert_eq!(question.settings.sampling, Sampling::Center, "paths lead through the middle");
        Self { question, prepared: question.prepared(), mode }
    }
}

impl<L: Lanes> Engine for Replayed<'_, L> {
    fn gradient(&mut self) -> Vec<f64> {
        let scene = self.question.scene();
        let ids = self.question.ids();
        let paths: Vec<Path> = crate::integrator::paths(&self.prepared, Wanted::by(ids));
        let replay = Replay { scene, ids, paths: &paths, loss: &self.question.loss() };
        match &self.mode {
            ReplayMode::Forward(elements) => {
                replay.by_forward_mode::<f64>(elements, Precision::F64)
            }
            ReplayMode::SingleForward(elements, sums) => {
                replay.by_forward_mode::<f32>(elements, *sums)
            }
            ReplayMode::Tape(chunk) => replay.by_tape(*chunk),
        }
    }
}
