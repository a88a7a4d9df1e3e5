//! What edges would change about a recovery that leaves them out.

use glam::DVec3;

use super::{Recovery, TargetImage};
use crate::experiment::Target;
use crate::loss::PixelLoss;
use crate::scene::{Integrator, Scene};
use crate::settings::{Edges, Settings};

impl Recovery<'_> {
    /// The losses of the images of a scene as they are, without edges, and with them. Nothing where images have edges
    /// already, or can have none: where light takes all paths, and where gradients would know too many lights. Nothing
    /// either where the target is [made of values](Target::Values): it has the edges that the images have.
    #[cfg_attr(not(feature = "cli"), expect(dead_code, reason = "the command line tells of it"))]
    pub(crate) fn losses_beside_edges(&self, scene: &Scene) -> Option<[f64; 2]> {
        let with_edges = Settings { edges: Edges::On, ..self.settings };
        let is_open = self.settings.edges == Edges::Off
            && scene.integrator == Integrator::Direct
            && !matches!(self.section.target, Some(Target::Values(_)))
            && scene.check_differentiable(&with_edges, &self.ids).is_ok();
        is_open
            .then(|| [self.settings, with_edges].map(|settings| self.image_loss(scene, &settings)))
    }

    /// The loss of the images of a scene, rendered so.
    fn image_loss(&self, scene: &Scene, settings: &Settings) -> f64 {
        let recovery = self.with_settings(settings);
        let loss = |target: &TargetImage| {
            let image = recovery.render_target(target, scene);
            let loss = target.loss(self.loss_kind());
            let pixels = image.pixels.iter().enumerate().map(|(index, pixel)| {
                let (x, y) = (index as u32 % image.width, index as u32 / image.width);
                loss.evaluate(x, y, DVec3::from_array(pixel.map(f64::from))).0
            });
            pixels.sum::<f64>()
        };
        self.matched().map(loss).sum()
    }
}
