//! Gradients of one problem in many settings.

use super::Setting;
use crate::arithmetic::Arithmetic;
use crate::optimize::Objective;
use crate::recovery::{ImageObjective, Recovery};
use crate::settings::{Edges, Settings};

/// A problem as it stands, prepared once for each scalar that its gradient is computed in.
pub(crate) struct Evaluator<'a> {
    recovery: &'a Recovery<'a>,
    x: Vec<f64>,
    prepared: Vec<(Arithmetic, ImageObjective<'a>)>,
}

impl<'a> Evaluator<'a> {
    pub fn new(recovery: &'a Recovery<'a>) -> Self {
        Self { recovery, x: recovery.initial(), prepared: Vec::new() }
    }

    pub fn recovery(&self) -> &'a Recovery<'a> {
        self.recovery
    }

    /// Whether gradients see edges: their rays are regular grids then.
    pub fn has_edges(&self) -> bool {
        let edges = self.recovery.render_settings().edges;
        self.recovery.scene().edges_for(edges, self.recovery.ids()) == Edges::On
    }

    /// The gradient in a setting.
    pub fn gradient(&mut self, setting: &Setting) -> Vec<f64> {
        let &Setting { arithmetic, bounces, sampling } = setting;
        let known = self.prepared.iter().position(|(of, _)| *of == arithmetic);
        let index = known.unwrap_or_else(|| {
            let settings = Settings { arithmetic, ..*self.recovery.render_settings() };
            self.prepared.push((arithmetic, ImageObjective::new(self.recovery, &settings)));
            self.prepared.len() - 1
        });
        let (_, objective) = &mut self.prepared[index];
        objective.resample(sampling, bounces);
        objective.evaluate(&self.x).gradient
    }
}
