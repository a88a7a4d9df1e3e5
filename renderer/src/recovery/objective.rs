//! The loss of an image as a function of numbers.

use ad::lanes::Lanes;

use super::Recovery;
use crate::integrator::{
    GradientResult, Prepared, Sampling, Wanted, find_non_finite, gradient, gradient_of_finite,
};
use crate::optimize::{Evaluation, Objective};
use crate::scene::{Invalid, ParameterId, Parameters};

/// Sets parameters to the values that stand one after the other in `x`.
pub(super) fn assign(parameters: &mut Parameters, ids: &[ParameterId], mut x: &[f64]) {
    for &id in ids {
        let values = parameters.get_mut(id);
        let (mine, rest) = x.split_at(values.len());
        values.copy_from_slice(mine);
        x = rest;
    }
}

/// The loss of the rendered image as a function of the parameters that vary.
pub(super) struct ImageObjective<'a, S: Lanes> {
    recovery: &'a Recovery<'a>,
    prepared: Prepared<'a, S>,
    parameters: Parameters,
    wanted: Wanted<'a>,
}

impl<'a, S: Lanes> ImageObjective<'a, S> {
    pub fn new(recovery: &'a Recovery<'a>) -> Self {
        Self {
            recovery,
            prepared: Prepared::with_settings(recovery.scene, recovery.settings),
            parameters: recovery.scene.parameters.clone(),
            wanted: Wanted::by(&recovery.ids),
        }
    }
}

impl<S: Lanes> ImageObjective<'_, S> {
    /// The wanted elements of a gradient, one after the other.
    fn evaluation(&self, result: &GradientResult) -> Evaluation {
        let elements = self.recovery.ids.iter().flat_map(|&id| result.gradient.get(id));
        Evaluation { loss: result.loss, gradient: elements.copied().collect() }
    }

    /// What is wrong with the parameters as they stand.
    fn invalid(&self) -> Option<Invalid> {
        self.recovery.scene.check_values(&self.parameters, &self.recovery.ids).err()
    }
}

/// An objective whose rays can be changed; all else that is prepared stays.
pub(crate) trait SteeredObjective: Objective {
    /// How many mirrors and transparent surfaces light meets at most, and the rays through pixels.
    fn steer(&mut self, bounces: u32, sampling: Sampling);
}

impl<S: Lanes> SteeredObjective for ImageObjective<'_, S> {
    fn steer(&mut self, bounces: u32, sampling: Sampling) {
        self.prepared.set_bounces(bounces);
        self.prepared.set_sampling(sampling);
    }
}

impl<S: Lanes> Objective for ImageObjective<'_, S> {
    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        assign(&mut self.parameters, &self.recovery.ids, x);
        if self.invalid().is_some() {
            return Evaluation { loss: f64::NAN, gradient: vec![f64::NAN; x.len()] };
        }
        self.prepared.set_parameters(&self.parameters);
        let (recovery, loss) = (self.recovery, self.recovery.loss());
        let evaluation = self.evaluation(&gradient(&self.prepared, &loss, self.wanted));
        if evaluation.is_finite() || !recovery.allow_non_finite {
            return evaluation;
        }
        let Some(found) = find_non_finite(&self.prepared, &loss, &recovery.ids) else {
            return evaluation;
        };
        let result = gradient_of_finite(&self.prepared, &loss, self.wanted, &found);
        if let Ok(mut left_out) = recovery.left_out.lock() {
            *left_out = Some(found.to_string());
        }
        self.evaluation(&result)
    }

    fn explain(&mut self, x: &[f64]) -> Option<String> {
        assign(&mut self.parameters, &self.recovery.ids, x);
        if let Some(Invalid { path, problem }) = self.invalid() {
            return Some(format!("{path} {problem}"));
        }
        self.prepared.set_parameters(&self.parameters);
        let recovery = self.recovery;
        let found = find_non_finite(&self.prepared, &recovery.loss(), &recovery.ids)?;
        Some(found.to_string())
    }
}
