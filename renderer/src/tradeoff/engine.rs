//! The ways to a gradient.

use ad::lanes::Lanes;

use super::replay::Replay;
use crate::image::Image;
use crate::integrator::{Path, Prepared, RenderSettings, Sampling, Wanted, gradient, loss, render};
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

    /// The parameters, each by a hair away from where it is.
    fn moved(&self) -> Parameters {
        let mut parameters = self.scene().parameters.clone();
        for &id in self.ids() {
            parameters.get_mut(id).iter_mut().for_each(|value| *value *= 1.0 + 1e-9);
        }
        parameters
    }
}

/// The generated adjoint: one pass for all derivatives.
pub(super) struct Adjoint<'a, L: Lanes> {
    question: Question<'a>,
    prepared: Prepared<'a, L>,
    moved: Parameters,
    /// Whether the tree is built anew for every gradient, instead of being fitted.
    rebuilds: bool,
}

impl<'a, L: Lanes> Adjoint<'a, L> {
    pub fn new(question: Question<'a>, rebuilds: bool) -> Self {
        Self { question, prepared: question.prepared(), moved: question.moved(), rebuilds }
    }
}

impl<L: Lanes> Engine for Adjoint<'_, L> {
    fn leave(&mut self) {
        self.prepared.set_parameters(&self.moved);
    }

    fn gradient(&mut self) -> Vec<f64> {
        let Question { recovery, .. } = self.question;
        let scene = recovery.scene();
        match self.rebuilds {
            true => self.prepared = self.question.prepared(),
            false => self.prepared.set_parameters(&scene.parameters),
        }
        let result = gradient(&self.prepared, &recovery.loss(), Wanted::by(recovery.ids()));
        recovery.ids().iter().flat_map(|&id| result.gradient.get(id)).copied().collect()
    }

    fn image(&self) -> Option<Image> {
        Some(render(&self.prepared))
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
            ReplayMode::Forward(elements) => replay.by_forward_mode(elements),
            ReplayMode::Tape(chunk) => replay.by_tape(*chunk),
        }
    }
}
