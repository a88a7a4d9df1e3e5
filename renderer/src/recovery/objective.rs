//! The loss of images as a function of numbers.

use std::borrow::Cow;

use glam::DVec3;

use super::levels::{halved, spread};
use super::team::{Alone, Begun, Task, Team, sum_in_order, topologies_to_numbers};
use super::{Recovery, TargetImage};
use crate::Error;
use crate::optimize::{Change, Evaluation, Objective, Topology, Variable};
use crate::render::Renderer;
use crate::scene::{Integrator, Invalid, ParameterId, Scene};
use crate::settings::{Sampling, Settings};
use crate::{Image, LossAndGradient};

/// The loss of the rendered images as a function of the parameters that vary.
pub(crate) struct ImageObjective<'a> {
    /// The problem at the beginning, whose targets stay.
    pub(super) original: &'a Recovery<'a>,
    /// The problem since triangles of meshes have changed.
    pub(super) recovery: Cow<'a, Recovery<'a>>,
    /// Who shares the targets.
    pub(super) team: &'a dyn Team,
    renderer: Renderer,
    /// What each iteration has random numbers of its own for.
    resampling: Option<Sampling>,
    scene: Scene,
    /// The iteration, and how often its images are halved.
    begun: Begun,
    /// All that is matched, so often halved, in the order of the views.
    targets: Vec<Cow<'a, TargetImage>>,
    /// What of it is matched in this iteration: all, before the first has begun.
    chosen: Vec<usize>,
    /// What the sum of the losses is multiplied by: where only some views are seen, they stand for all.
    factor: f64,
}

impl<'a> ImageObjective<'a> {
    pub fn new(recovery: &'a Recovery<'a>, settings: &Settings) -> Self {
        Self::shared(recovery, settings, &Alone)
    }

    /// The objective of a rank, which is evaluated in rank 0 while the others [`serve`](Self::serve).
    pub fn shared(recovery: &'a Recovery<'a>, settings: &Settings, team: &'a dyn Team) -> Self {
        Self::halved(recovery, Cow::Borrowed(recovery), settings, team, 0)
    }

    /// Takes other random numbers in each iteration, if there is something to take them for.
    pub fn resampled(self, resampling: Option<Sampling>) -> Self {
        Self { resampling, ..self }
    }

    /// All views, halved so often.
    fn halved(
        original: &'a Recovery<'a>,
        recovery: Cow<'a, Recovery<'a>>,
        settings: &Settings,
        team: &'a dyn Team,
        level: u32,
    ) -> Self {
        let mut scene = halved(&recovery.scene, level);
        let matched = original.matched();
        let targets: Vec<_> = match level {
            0 => matched.map(Cow::Borrowed).collect(),
            _ => matched.map(|target| Cow::Owned(target.halved(level))).collect(),
        };
        targets[0].look(&mut scene);
        let settings = Settings { pass: targets[0].pass, ..*settings };
        let renderer = Renderer::unchecked(&scene, &settings);
        let chosen = (0..targets.len()).collect();
        let begun = Begun { iteration: 0, level };
        Self {
            original,
            recovery,
            team,
            renderer,
            resampling: None,
            scene,
            begun,
            targets,
            chosen,
            factor: 1.0,
        }
    }

    /// Changes the rays through pixels and the depth of paths; all else that is prepared stays.
    pub fn resample(&mut self, sampling: Sampling, bounces: u32) {
        self.renderer.resample(sampling);
        self.renderer.set_bounces(bounces);
    }

    /// Moves to these values; returns what is wrong with them.
    pub(super) fn assign(&mut self, x: &[f64]) -> Result<(), Invalid> {
        self.scene.assign_all(&self.recovery.ids, x);
        self.scene.check_values(&self.recovery.ids)?;
        self.renderer.update(&self.scene);
        Ok(())
    }

    /// Takes up the problem with other triangles, as rank 0, and tells the others.
    fn go_on_with(&mut self, topologies: &[Topology], recovery: Recovery<'static>) {
        Task::Change.ask(self.team, self.begun, &topologies_to_numbers(topologies));
        self.take_up(recovery);
    }

    /// Takes up the problem with other triangles.
    pub(super) fn take_up(&mut self, recovery: Recovery<'static>) {
        let settings = *self.renderer.settings();
        let (original, recovery) = (self.original, Cow::Owned(recovery));
        *self = Self::halved(original, recovery, &settings, self.team, self.begun.level)
            .resampled(self.resampling);
    }

    /// Loss and gradient of a target.
    fn evaluate_target(&mut self, index: usize) -> Evaluation {
        let Self { recovery, renderer, scene, targets, factor, .. } = self;
        let target = &targets[index];
        target.show(scene, renderer);
        let (ids, loss) = (&recovery.ids, target.loss(recovery.loss_kind()).times(*factor));
        let result = evaluation(&renderer.loss_and_gradient(scene, &loss, ids));
        if result.is_finite() || !recovery.allow_non_finite {
            return result;
        }
        let Some(found) = renderer.find_non_finite_gradient(scene, &loss, ids) else {
            return result;
        };
        if let Ok(mut left_out) = recovery.left_out.lock() {
            left_out.tell(index, of_view(target, scene, found.to_string()));
        }
        evaluation(&renderer.gradient_of_finite(scene, &loss, ids, &found))
    }

    /// The losses of the chosen targets, added up after their gradients.
    pub(super) fn sum_of_losses(&mut self, len: usize) -> Vec<f64> {
        if let Ok(mut left_out) = self.recovery.left_out.lock() {
            left_out.evaluations += 1;
        }
        let chosen = self.chosen.clone();
        sum_in_order(self.team, chosen.len(), len + 1, |index| {
            let Evaluation { loss, mut gradient } = self.evaluate_target(chosen[index]);
            // A gradient may fill much of the memory.
            gradient.reserve_exact(1);
            gradient.push(loss);
            gradient
        })
    }

    /// The curvatures of the chosen targets, added up before the number of those that have none.
    pub(super) fn sum_of_curvatures(&mut self, len: usize) -> Vec<f64> {
        let chosen = self.chosen.clone();
        sum_in_order(self.team, chosen.len(), len * len + 1, |index| {
            let mut curvature = vec![0.0; len * len];
            let is_missing = self.add_curvature(chosen[index], &mut curvature).is_none();
            curvature.push(f64::from(is_missing));
            curvature
        })
    }

    /// Adds the curvature of the loss of a target; nothing if it has none.
    fn add_curvature(&mut self, index: usize, sum: &mut [f64]) -> Option<()> {
        let Self { recovery, renderer, scene, targets, factor, .. } = self;
        let target = &targets[index];
        target.show(scene, renderer);
        let loss = target.loss(recovery.loss_kind()).times(*factor);
        let (image, derivatives) = derivatives(renderer, scene, &recovery.ids)?;
        let curvatures = image.pixels.iter().enumerate().map(|(index, pixel)| {
            let (x, y) = (index as u32 % image.width, index as u32 / image.width);
            loss.curvature(x, y, DVec3::from_array(pixel.map(f64::from)))
        });
        let curvatures: Vec<DVec3> = curvatures.collect::<Option<_>>()?;
        add_products(&curvatures, &derivatives, sum);
        Some(())
    }
}

/// An image, and its derivatives by every number of some parameters.
fn derivatives(
    renderer: &Renderer,
    scene: &Scene,
    ids: &[ParameterId],
) -> Option<(Image, Vec<Image>)> {
    let (mut image, mut derivatives) = (None, Vec::new());
    for &id in ids {
        let count = scene.get(id).len();
        for element in 0..count {
            let mut along = vec![0.0; count];
            along[element] = 1.0;
            let (value, derivative) = renderer.jvp(scene, &[(id, along)]).ok()?;
            image = Some(value);
            derivatives.push(derivative);
        }
    }
    Some((image?, derivatives))
}

/// Adds the sums over pixels of the products of all pairs of derivatives, weighted by curvatures.
fn add_products(curvatures: &[DVec3], derivatives: &[Image], sum: &mut [f64]) {
    let count = derivatives.len();
    for row in 0..count {
        for column in 0..=row {
            let pairs = derivatives[row].pixels.iter().zip(&derivatives[column].pixels);
            let product = |((a, b), curvature): ((&[f32; 3], &[f32; 3]), &DVec3)| {
                let [a, b] = [a, b].map(|pixel| DVec3::from_array(pixel.map(f64::from)));
                (a * b).dot(*curvature)
            };
            let value: f64 = pairs.zip(curvatures).map(product).sum();
            sum[row * count + column] += value;
            if row != column {
                sum[column * count + row] += value;
            }
        }
    }
}

/// A loss and its gradient, in a row.
fn evaluation(result: &LossAndGradient) -> Evaluation {
    Evaluation { loss: result.loss, gradient: result.gradient.concat() }
}

/// What is said of a target, after the name of its view.
fn of_view(target: &TargetImage, scene: &Scene, what: String) -> String {
    match target.name(scene) {
        "" => what,
        name => format!("view `{name}`: {what}"),
    }
}

impl Objective for ImageObjective<'_> {
    fn begin(&mut self, iteration: u64, level: u32) {
        if level != self.begun.level {
            let sampling = match self.recovery.scene.integrator {
                Integrator::Direct => spread(self.recovery.settings.sampling, level),
                Integrator::Path(_) => self.recovery.settings.sampling,
            };
            let settings = Settings { sampling, ..*self.renderer.settings() };
            let (original, recovery) = (self.original, self.recovery.clone());
            *self = Self::halved(original, recovery, &settings, self.team, level)
                .resampled(self.resampling);
        }
        self.begun = Begun { iteration, level };
        if let Some(sampling) = self.resampling {
            self.renderer.resample(sampling.batch(sampling.count(), iteration as u32));
        }
        let Some(batch) = self.recovery.section.batch else { return };
        let views = self.recovery.matched_views();
        let chosen = batch.views(iteration, views.len());
        let is_chosen =
            |target: &TargetImage| chosen.iter().any(|&index| Some(views[index]) == target.view);
        self.chosen = (0..self.targets.len()).filter(|&i| is_chosen(&self.targets[i])).collect();
        self.factor = views.len() as f64 / chosen.len() as f64;
    }

    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        if self.assign(x).is_err() {
            return Evaluation { loss: f64::NAN, gradient: vec![f64::NAN; x.len()] };
        }
        Task::Evaluate.ask(self.team, self.begun, x);
        let mut gradient = self.sum_of_losses(x.len());
        let loss = gradient.pop().unwrap_or_default();
        let mut sum = Evaluation { loss, gradient };
        self.recovery.regularizers.iter().for_each(|term| term.add(x, &mut sum));
        sum
    }

    fn full_loss(&mut self, x: &[f64]) -> Option<f64> {
        self.recovery.section.batch?;
        self.assign(x).ok()?;
        let Self { recovery, renderer, scene, targets, .. } = self;
        let of_targets = targets.iter().map(|target| {
            target.show(scene, renderer);
            renderer.loss(&target.loss(recovery.loss_kind()))
        });
        let of_terms = recovery.regularizers.iter().map(|term| term.value(x));
        Some(of_targets.chain(of_terms).sum())
    }

    fn curvature(&mut self, x: &[f64]) -> Option<Vec<f64>> {
        self.assign(x).ok()?;
        Task::Curvature.ask(self.team, self.begun, x);
        let mut sum = self.sum_of_curvatures(x.len());
        (sum.pop() == Some(0.0)).then_some(sum)
    }

    fn change(&mut self, iteration: u64, x: &[f64]) -> Result<Option<Change>, Error> {
        let changed = self.recovery.remeshed(&self.original.scene, iteration, x)?;
        Ok(changed.map(|(recovery, change)| {
            self.go_on_with(&change.topologies, recovery);
            change
        }))
    }

    fn restore(&mut self, topologies: &[Topology]) -> Result<Vec<Variable>, Error> {
        self.go_on_with(topologies, self.original.with_topologies(topologies)?);
        Ok(self.recovery.variables().to_vec())
    }

    fn explain(&mut self, x: &[f64]) -> Option<String> {
        if let Err(Invalid { path, problem }) = self.assign(x) {
            return Some(format!("{path} {problem}"));
        }
        let Self { recovery, renderer, scene, targets, chosen, .. } = self;
        chosen.iter().find_map(|&index| {
            let target = &targets[index];
            target.show(scene, renderer);
            let loss = target.loss(recovery.loss_kind());
            let found = renderer.find_non_finite_gradient(scene, &loss, &recovery.ids)?;
            Some(of_view(target, scene, found.to_string()))
        })
    }
}
