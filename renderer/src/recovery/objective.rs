//! The loss of images as a function of numbers.

use glam::DVec3;

use super::{Recovery, TargetImage};
use crate::optimize::{Evaluation, Objective};
use crate::render::Renderer;
use crate::scene::{Invalid, Scene};
use crate::settings::{Sampling, Settings};
use crate::{Image, LossAndGradient};

/// The loss of the rendered images as a function of the parameters that vary.
pub(crate) struct ImageObjective<'a> {
    recovery: &'a Recovery<'a>,
    renderer: Renderer,
    scene: Scene,
    /// What is matched in this iteration, in the order of the views.
    targets: Vec<&'a TargetImage>,
    /// What the sum of the losses is multiplied by: where only some views are seen, they stand for all.
    factor: f64,
}

impl<'a> ImageObjective<'a> {
    pub fn new(recovery: &'a Recovery<'a>, settings: &Settings) -> Self {
        let mut scene = recovery.scene.clone();
        let targets: Vec<&TargetImage> = recovery.matched().collect();
        targets[0].look(&mut scene);
        let settings = Settings { pass: targets[0].pass, ..*settings };
        let renderer = Renderer::unchecked(&scene, &settings);
        let mut objective = Self { recovery, renderer, scene, targets, factor: 1.0 };
        objective.begin(0);
        objective
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

    /// Shows what a target of this iteration is compared with.
    fn show(&mut self, index: usize) -> &'a TargetImage {
        let target = self.targets[index];
        target.show(&mut self.scene, &mut self.renderer);
        target
    }

    /// The image that is shown, and its derivatives by every number that varies.
    fn derivatives(&self) -> Option<(Image, Vec<Image>)> {
        let (mut image, mut derivatives) = (None, Vec::new());
        for &id in &self.recovery.ids {
            let count = self.scene.get(id).len();
            for element in 0..count {
                let mut along = vec![0.0; count];
                along[element] = 1.0;
                let (value, derivative) = self.renderer.jvp(&self.scene, &[(id, along)]).ok()?;
                image = Some(value);
                derivatives.push(derivative);
            }
        }
        Some((image?, derivatives))
    }

    /// Loss and gradient of a target of this iteration.
    fn evaluate_target(&mut self, index: usize) -> Evaluation {
        let target = self.show(index);
        let Self { recovery, renderer, scene, factor, .. } = self;
        let (ids, loss) = (&recovery.ids, target.loss(recovery.loss_kind()).times(*factor));
        let result = evaluation(&renderer.loss_and_gradient(scene, &loss, ids));
        if result.is_finite() || !recovery.allow_non_finite {
            return result;
        }
        let Some(found) = renderer.find_non_finite_gradient(scene, &loss, ids) else {
            return result;
        };
        if let Ok(mut left_out) = recovery.left_out.lock() {
            *left_out = Some(of_view(target, scene, found.to_string()));
        }
        evaluation(&renderer.gradient_of_finite(scene, &loss, ids, &found))
    }
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
    fn begin(&mut self, iteration: u64) {
        let Some(batch) = self.recovery.section.batch else { return };
        let all = self.recovery.matched();
        let mut views: Vec<usize> = all.filter_map(|target| target.view).collect();
        views.dedup();
        let chosen = batch.views(iteration, views.len());
        let is_chosen =
            |target: &&TargetImage| chosen.iter().any(|&index| Some(views[index]) == target.view);
        self.targets = self.recovery.matched().filter(is_chosen).collect();
        self.factor = views.len() as f64 / chosen.len() as f64;
    }

    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        if self.assign(x).is_err() {
            return Evaluation { loss: f64::NAN, gradient: vec![f64::NAN; x.len()] };
        }
        let mut sum = self.evaluate_target(0);
        for index in 1..self.targets.len() {
            let other = self.evaluate_target(index);
            sum.loss += other.loss;
            sum.gradient.iter_mut().zip(other.gradient).for_each(|(sum, other)| *sum += other);
        }
        self.recovery.regularizers.iter().for_each(|term| term.add(x, &mut sum));
        sum
    }

    fn curvature(&mut self, x: &[f64]) -> Option<Vec<f64>> {
        self.assign(x).ok()?;
        let mut sum = vec![0.0; x.len() * x.len()];
        for index in 0..self.targets.len() {
            let target = self.show(index);
            let loss = target.loss(self.recovery.loss_kind()).times(self.factor);
            let (image, derivatives) = self.derivatives()?;
            let width = image.width;
            let curvatures = image.pixels.iter().enumerate().map(|(index, pixel)| {
                let (x, y) = (index as u32 % width, index as u32 / width);
                loss.curvature(x, y, DVec3::from_array(pixel.map(f64::from)))
            });
            let curvatures: Vec<DVec3> = curvatures.collect::<Option<_>>()?;
            add_products(&curvatures, &derivatives, &mut sum);
        }
        Some(sum)
    }

    fn explain(&mut self, x: &[f64]) -> Option<String> {
        if let Err(Invalid { path, problem }) = self.assign(x) {
            return Some(format!("{path} {problem}"));
        }
        (0..self.targets.len()).find_map(|index| {
            let target = self.show(index);
            let Self { recovery, renderer, scene, .. } = self;
            let loss = target.loss(recovery.loss_kind());
            let found = renderer.find_non_finite_gradient(scene, &loss, &recovery.ids)?;
            Some(of_view(target, scene, found.to_string()))
        })
    }
}
