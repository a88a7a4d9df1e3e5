//! The loss of an image as a function of numbers.

use super::Recovery;
use crate::LossAndGradient;
use crate::optimize::{Evaluation, Objective};
use crate::render::Renderer;
use crate::scene::{Invalid, Scene};
use crate::settings::{Sampling, Settings};

/// The loss of the rendered image as a function of the parameters that vary.
pub(crate) struct ImageObjective<'a> {
    recovery: &'a Recovery<'a>,
    renderer: Renderer,
    scene: Scene,
}

impl<'a> ImageObjective<'a> {
    pub fn new(recovery: &'a Recovery<'a>, settings: &Settings) -> Self {
        let renderer = Renderer::unchecked(recovery.scene, settings);
        Self { recovery, renderer, scene: recovery.scene.clone() }
    }

    /// Changes the rays through pixels and the depth of paths; all else that is prepared stays.
    pub fn resample(&mut self, sampling: Sampling, bounces: u32) {
        self.renderer.resample(sampling, Some(bounces));
    }

    /// Moves to these values; returns what is wrong with them.
    fn assign(&mut self, x: &[f64]) -> Result<(), Invalid> {
        self.scene.assign_all(&self.recovery.ids, x);
        self.scene.check_values(&self.recovery.ids)?;
        self.renderer.update(&self.scene);
        Ok(())
    }
}

/// A loss and its gradient, in a row.
fn evaluation(result: &LossAndGradient) -> Evaluation {
    Evaluation { loss: result.loss, gradient: result.gradient.concat() }
}

impl Objective for ImageObjective<'_> {
    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        if self.assign(x).is_err() {
            return Evaluation { loss: f64::NAN, gradient: vec![f64::NAN; x.len()] };
        }
        let Self { recovery, renderer, scene } = self;
        let (ids, loss) = (&recovery.ids, recovery.loss());
        let result = evaluation(&renderer.loss_and_gradient(scene, &loss, ids));
        if result.is_finite() || !recovery.allow_non_finite {
            return result;
        }
        let Some(found) = renderer.find_non_finite_gradient(scene, &loss, ids) else {
            return result;
        };
        if let Ok(mut left_out) = recovery.left_out.lock() {
            *left_out = Some(found.to_string());
        }
        evaluation(&renderer.gradient_of_finite(scene, &loss, ids, &found))
    }

    fn explain(&mut self, x: &[f64]) -> Option<String> {
        if let Err(Invalid { path, problem }) = self.assign(x) {
            return Some(format!("{path} {problem}"));
        }
        let Self { recovery, renderer, scene } = self;
        let found = renderer.find_non_finite_gradient(scene, &recovery.loss(), &recovery.ids)?;
        Some(found.to_string())
    }
}
