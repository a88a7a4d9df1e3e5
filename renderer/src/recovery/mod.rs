//! Recovering what an image shows: a scene, a target image, the parameters that may vary.
//!
//! ```no_run
//! use renderer::Settings;
//! use renderer::experiment::Experiment;
//! use renderer::optimize::progress;
//! use renderer::recovery::Recovery;
//!
//! let experiment = Experiment::load("photo.toml".as_ref())?;
//! let recovery = Recovery::new(&experiment, "photo.toml", &Settings::default())?;
//! let outcome = recovery.run(&recovery.settings(), progress().as_mut())?;
//! println!("{}", recovery.scene_at(&outcome.best.x).camera.look_from);
//! # Ok::<(), renderer::Error>(())
//! ```
//!
#![doc = include_str!("../../docs/recoveries.md")]

mod beside_edges;
mod check;
#[cfg_attr(not(feature = "cli"), expect(dead_code, reason = "teams are led by the command line"))]
mod left_out;
mod levels;
mod noise;
mod objective;
mod regularizer;
mod remeshing;
mod resampling;
#[cfg(feature = "cli")]
mod share;
mod target;
#[cfg_attr(not(feature = "cli"), expect(dead_code, reason = "teams are led by the command line"))]
pub(crate) mod team;
mod variable;

use std::borrow::Cow;
use std::sync::{Arc, Mutex};

pub use check::{Compared, Finding, Verdict};
pub(crate) use levels::check_levels;
pub(crate) use objective::ImageObjective;
pub(crate) use remeshing::check_remeshing;
#[cfg(feature = "cli")]
pub(crate) use remeshing::with_topologies;
pub use renderer_files::images::Quality;
pub use target::TargetImage;

use left_out::LeftOut;
use regularizer::Regularizer;
use team::{Alone, Team};

use crate::Error;
use crate::Image;
use crate::arithmetic::Arithmetic;
use crate::experiment::{
    Experiment, OptimizeSection, Remeshing, TunedParameter, WeightedTerm, overlap,
};
use crate::loss::LossKind;
use crate::optimize::{
    Evaluation, Fingerprint, Objective, Observer, Optimization, Optimizer, Outcome,
    Settings as OptimizeSettings, Variable,
};
use crate::scene::{Invalid, Object, ParameterId, Scene};
use crate::settings::{Edges, Settings};

/// An optimisation of scene parameters against an image, or one for each view of the scene: then loss and
/// gradient are the sums of those of the views, added up in their order.
#[derive(Clone)]
pub struct Recovery<'a> {
    scene: Cow<'a, Scene>,
    section: OptimizeSection,
    settings: Settings,
    targets: Arc<Vec<TargetImage>>,
    ids: Vec<ParameterId>,
    regularizers: Vec<Regularizer>,
    variables: Vec<Variable>,
    allow_non_finite: bool,
    left_out: Arc<Mutex<LeftOut>>,
}

impl<'a> Recovery<'a> {
    /// Loads or renders the target, and takes the parameters of the experiment's section
    /// `[optimize]`. `place` names the experiment in errors; a target that is given by values is rendered
    /// as the scene is.
    ///
    /// # Errors
    ///
    /// If the target or the parameters are missing, two parameters
    /// [overlap](ParameterId::overlaps), there is [no derivative](Scene::check_differentiable) by one, one has
    /// a term that is for other parameters, the target cannot be read, or its size is not that of the camera.
    pub fn new(
        experiment: &'a Experiment,
        place: &str,
        settings: &Settings,
    ) -> Result<Self, Error> {
        let scene = &experiment.scene;
        let mut section = experiment.optimize.clone().unwrap_or_default();
        if section.parameters.is_empty() {
            return Err(Error::new(
                place,
                "no parameter to optimise: name one (`renderer params` lists them)",
            ));
        }
        check_overlaps(scene, &section, place)?;
        check_learning_rates(scene, &section, place)?;
        let ids: Vec<_> = section.parameters.iter().map(|tuned| tuned.id).collect();
        let settings = Settings { edges: scene.edges_for(settings.edges, &ids), ..*settings };
        let (targets, truth) = target::load(scene, &section, place, &settings)
            .map_err(|error| experiment.place(error))?;
        for target in targets.iter().filter(|target| !target.held_out) {
            scene.check_differentiable(&Settings { pass: target.pass, ..settings }, &ids)?;
        }
        let views = matched_views(&targets);
        check_cameras(scene, &ids, &views, place)?;
        check_batch(scene, &section, place)?;
        resampling::check_resampling(scene, &section, place)?;
        check_levels(scene, section.coarse_to_fine).map_err(|problem| {
            Error::new(format_args!("{place}: optimize.coarse_to_fine"), problem)
        })?;
        remeshing::check_optimizer(scene, &section, place)?;
        // A batch of all views is none: each loss is that of all.
        section.batch = section.batch.filter(|batch| batch.size < views.len());
        let variables = section
            .parameters
            .iter()
            .map(|tuned| {
                // Vertices that come and go have no true places.
                let truth = truth.as_ref().filter(|_| tuned.remesh.is_none());
                let target = truth.map(|truth| truth.get(tuned.id).into_owned());
                variable::variable(scene, tuned, section.learning_rate, target)
            })
            .collect::<Result<_, _>>()?;
        let regularizers =
            regularizer::of(scene, &section.parameters).map_err(|Invalid { path, problem }| {
                Error::new(format_args!("{place}: {path}"), problem)
            })?;
        let (allow_non_finite, left_out) = (false, Arc::default());
        Ok(Self {
            scene: Cow::Borrowed(scene),
            section,
            settings,
            targets: Arc::new(targets),
            ids,
            regularizers,
            variables,
            allow_non_finite,
            left_out,
        })
    }

    /// This inverse problem, with the same target, rendered with other settings.
    pub fn with_settings(&self, settings: &Settings) -> Self {
        Self { settings: *settings, ..self.clone() }
    }

    /// This inverse problem, without views, with a smaller image: `scene` is that of this problem but for the
    /// size, which divides this one's. A pixel of the target is the mean of those that it covers.
    pub fn coarser<'b>(&self, scene: &'b Scene) -> Recovery<'b> {
        let copy = self.clone();
        let reduced = |target: &TargetImage| target.clone().reduced(scene.size());
        let targets = Arc::new(copy.targets.iter().map(reduced).collect());
        Recovery { scene: Cow::Borrowed(scene), targets, ..copy }
    }

    /// How the scene is rendered.
    pub fn render_settings(&self) -> &Settings {
        &self.settings
    }

    /// The values of the parameters that vary as they stand, one after the other.
    pub fn initial(&self) -> Vec<f64> {
        self.variables.iter().flat_map(|variable| variable.initial.clone()).collect()
    }

    /// Leaves pixels out whose radiance, loss or gradient is not finite, instead of stopping at them.
    /// Which they are is searched for in each evaluation that has some. That takes about three times as
    /// long as the evaluation, and up to a thousand times where derivatives alone are not finite.
    pub fn allowing_non_finite(self) -> Self {
        Self { allow_non_finite: true, ..self }
    }

    /// The latest evaluation that has [left pixels out](Self::allowing_non_finite), for people.
    pub fn left_out(&self) -> Option<String> {
        Some(self.left_out.lock().ok()?.text()?.to_owned())
    }

    /// The settings of the section `[optimize]`, without checkpoints.
    pub fn settings(&self) -> OptimizeSettings {
        let default = OptimizeSettings::default();
        OptimizeSettings {
            iterations: self.section.iterations.unwrap_or(default.iterations),
            tolerance: self.section.tolerance.unwrap_or(default.tolerance),
            gradient_tolerance: self
                .section
                .gradient_tolerance
                .unwrap_or(default.gradient_tolerance),
            optimizer: self.section.optimizer.unwrap_or(default.optimizer),
            schedule: self.section.schedule.unwrap_or(default.schedule),
            coarse_to_fine: self.section.coarse_to_fine,
            starts: self.section.starts,
            is_sampled: self.section.batch.is_some() || self.resampling().is_some(),
            epoch: self.section.batch.map_or(1, |batch| batch.epoch(self.matched_views().len())),
            ..default
        }
    }

    /// Tells this problem from others: the scene, the target, the loss, the precision.
    pub fn fingerprint(&self) -> Fingerprint {
        let scene = &self.scene;
        // All lanes of a precision are the same problem.
        let precision = self.settings.arithmetic.precision();
        let arithmetic = Arithmetic::fastest(precision);
        // What follows from the parameters does not tell problems apart.
        let edges = match self.settings.edges {
            edges if edges == scene.edges_for(Edges::Auto, &self.ids) => Edges::Auto,
            edges => edges,
        };
        let settings = Settings { arithmetic, edges, ..self.settings };
        let mut fingerprint = Fingerprint::new()
            .text(&format!("{:?}", self.loss_kind()))
            .text(&format!("{settings:?}"))
            .text(&format!("{:?}", self.section.batch))
            .text(&format!("{:?}", self.terms()))
            .text(&format!("{:?}", (scene.bounces, scene.light_samples, scene.integrator)))
            .text(&format!("{:?}", scene.spheres));
        if let Some(sampling) = self.resampling() {
            fingerprint = fingerprint.text(&format!("{sampling:?}"));
        }
        for remeshing in self.remeshings() {
            fingerprint = fingerprint.text(&format!("{remeshing:?}"));
        }
        for id in scene.parameters() {
            let path = scene.path(id).to_string();
            fingerprint = fingerprint.text(&path).numbers(&scene.get(id));
        }
        let indices = |numbers: &[u32]| -> Vec<u8> {
            numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
        };
        for mesh in &scene.meshes {
            fingerprint = fingerprint
                .bytes(&indices(mesh.triangles.as_flattened()))
                .bytes(&indices(&mesh.materials));
        }
        let bits = |values: &[f32]| -> Vec<u8> {
            values.iter().flat_map(|value| value.to_le_bytes()).collect()
        };
        self.targets.iter().fold(fingerprint, |fingerprint, target| {
            let TargetImage { view, pass, image, held_out, saturates, weights, weight } = target;
            let settings = (view, pass, image.width, held_out, saturates, weight);
            fingerprint
                .text(&format!("{settings:?}"))
                .bytes(&bits(image.pixels.as_flattened()))
                .bytes(&bits(weights.as_deref().unwrap_or_default()))
        })
    }

    /// Renders a scene, through its first view if it has any. Pixels that are not finite are black if they may
    /// be [left out](Self::allowing_non_finite).
    pub fn render(&self, scene: &Scene) -> Image {
        self.render_target(&self.targets[0], scene)
    }

    /// Renders what of a scene a target shows.
    pub fn render_target(&self, target: &TargetImage, scene: &Scene) -> Image {
        let mut image = target.render(scene, &self.settings);
        if self.allow_non_finite {
            image.blacken_non_finite();
        }
        image
    }

    /// How alike the images of a scene and the targets are, one by one: those of views that are
    /// [held out](TargetImage::held_out) tell what is found from what merely fits.
    pub fn qualities(&self, scene: &Scene) -> Vec<Quality> {
        let quality = |target: &TargetImage| target.quality(&self.render_target(target, scene));
        self.targets.iter().map(quality).collect()
    }

    /// The parameters that vary.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The scene as it stands: the initial guess.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The image to be matched, the first if there are several.
    pub fn target(&self) -> &Image {
        &self.targets[0].image
    }

    /// All images to be matched or compared with, in the order of the views.
    pub fn targets(&self) -> &[TargetImage] {
        &self.targets
    }

    /// The scene with other values of the parameters that vary, one after the other in `x`. Where triangles of meshes
    /// have changed, this is asked of the problem [since then](Self::with_topologies).
    pub fn scene_at(&self, x: &[f64]) -> Scene {
        let mut scene = self.scene.clone().into_owned();
        scene.assign_all(&self.ids, x);
        scene
    }

    /// Optimises.
    ///
    /// # Errors
    ///
    /// If the settings cannot be used, or a checkpoint cannot be read or written.
    pub fn run(
        &self,
        settings: &OptimizeSettings,
        observer: &mut dyn Observer,
    ) -> Result<Outcome, Error> {
        self.run_shared(&Alone, settings, observer)
    }

    /// Optimises, as rank 0 of a team.
    pub(crate) fn run_shared(
        &self,
        team: &dyn Team,
        settings: &OptimizeSettings,
        observer: &mut dyn Observer,
    ) -> Result<Outcome, Error> {
        if matches!(settings.optimizer, Optimizer::Lm(_)) && !self.loss_kind().is_curved() {
            let problem = "is straight everywhere, and lm looks for minima by its curvature: take another loss, or another optimizer";
            return Err(Error::new("optimize.loss", problem));
        }
        let optimization = Optimization::start(&self.variables, settings)?;
        let resamples = settings.is_sampled && !settings.optimizer.finds_step_lengths();
        let resampling = self.resampling().filter(|_| resamples);
        let mut objective =
            ImageObjective::shared(self, &self.settings, team).resampled(resampling);
        optimization.run(&mut objective, observer)
    }

    /// Loss and gradient as a function of the parameters that vary: what [`run`](Self::run)
    /// minimises, for who adds up several of them or brings another method. Its random numbers stay the same.
    pub fn objective(&self) -> Box<dyn Objective + '_> {
        Box::new(ImageObjective::new(self, &self.settings))
    }

    /// Loss and gradient at the scene as it stands.
    ///
    /// # Errors
    ///
    /// If one of them is not finite: what is behind it, unless that is
    /// [allowed](Self::allowing_non_finite).
    pub fn evaluate(&self) -> Result<Evaluation, Error> {
        let x = self.initial();
        let mut objective = self.objective();
        let evaluation = objective.evaluate(&x);
        if evaluation.is_finite() {
            return Ok(evaluation);
        }
        let unknown = || format!("the loss is {}, with its gradient", evaluation.loss);
        Err(Error::not_finite("gradient", objective.explain(&x).unwrap_or_else(unknown)))
    }

    /// The parameters that vary, in the order of [`variables`](Self::variables).
    pub fn ids(&self) -> &[ParameterId] {
        &self.ids
    }

    pub(crate) fn loss_kind(&self) -> LossKind {
        self.section.loss.unwrap_or_default()
    }

    /// The terms of the loss that are not of images, with what they are of.
    fn terms(&self) -> Vec<(ParameterId, &[WeightedTerm])> {
        let with_terms = self.section.parameters.iter().filter(|tuned| !tuned.terms.is_empty());
        with_terms.map(|tuned| (tuned.id, &tuned.terms[..])).collect()
    }

    /// How triangles change, where they do.
    pub(crate) fn remeshings(&self) -> Vec<(ParameterId, Remeshing)> {
        let parameters = self.section.parameters.iter();
        parameters.filter_map(|tuned| Some((tuned.id, tuned.remesh?))).collect()
    }

    /// What losses are added up of: all targets but those of views that are held out.
    fn matched(&self) -> impl Iterator<Item = &TargetImage> + Clone {
        self.targets.iter().filter(|target| !target.held_out)
    }

    /// The views that are matched, if the scene has any.
    fn matched_views(&self) -> Vec<usize> {
        matched_views(&self.targets)
    }
}

/// The views among these targets that are matched.
fn matched_views(targets: &[TargetImage]) -> Vec<usize> {
    let matched = targets.iter().filter(|target| !target.held_out);
    let mut views: Vec<usize> = matched.filter_map(|target| target.view).collect();
    views.dedup();
    views
}

/// Whether a loss depends on each camera that is to vary.
fn check_cameras(
    scene: &Scene,
    ids: &[ParameterId],
    matched: &[usize],
    place: &str,
) -> Result<(), Error> {
    let is_idle =
        |id: &&ParameterId| matches!(id.object, Object::View(index) if !matched.contains(&index));
    match ids.iter().find(is_idle) {
        None => Ok(()),
        Some(&id) => {
            let problem = "no loss depends on this camera: its view is held out, or has no target";
            Err(Error::new(format_args!("{place}: {}", scene.path(id)), problem))
        }
    }
}

/// Whether there are views to choose from, and a method that compares losses gets the same loss each time.
fn check_batch(scene: &Scene, section: &OptimizeSection, place: &str) -> Result<(), Error> {
    let Some(batch) = section.batch else { return Ok(()) };
    let optimizer = section.optimizer.unwrap_or_default();
    let problem = if batch.size == 0 {
        "needs at least one view".to_owned()
    } else if scene.views().is_empty() {
        "is a number of views, and the scene has none".to_owned()
    } else if optimizer.finds_step_lengths() {
        compares_losses(optimizer, "views", "the batch")
    } else {
        return Ok(());
    };
    Err(Error::new(format_args!("{place}: optimize.batch"), problem))
}

/// Why a method that compares losses is not for what makes each loss that of others.
fn compares_losses(optimizer: Optimizer, others: &str, cause: &str) -> String {
    format!(
        "{} compares the losses of its steps, which are of other {others} each time; leave {cause} out",
        optimizer.name()
    )
}

/// Whether no number varies as part of two parameters.
fn check_overlaps(scene: &Scene, section: &OptimizeSection, place: &str) -> Result<(), Error> {
    let parameters = section.parameters.iter().enumerate();
    let overlap = |(index, tuned): (usize, &TunedParameter)| {
        Some((tuned.id, overlap(scene, &section.parameters[..index], tuned.id)?))
    };
    match { parameters }.find_map(overlap) {
        None => Ok(()),
        Some((id, problem)) => {
            Err(Error::new(format_args!("{place}: {}", scene.path(id)), problem))
        }
    }
}

/// Whether an optimiser whose steps are as long as the gradient has a learning rate for every
/// parameter.
fn check_learning_rates(
    scene: &Scene,
    section: &OptimizeSection,
    place: &str,
) -> Result<(), Error> {
    let Some(optimizer) = section.optimizer.filter(Optimizer::follows_gradient_length) else {
        return Ok(());
    };
    let unrated =
        |tuned: &&TunedParameter| section.learning_rate.is_none() && tuned.learning_rate.is_none();
    match section.parameters.iter().find(unrated) {
        None => Ok(()),
        Some(tuned) => Err(Error::new(
            format_args!("{place}: {}", scene.path(tuned.id)),
            format_args!(
                "has no learning rate; the steps of {} are the gradient times it, so none suits \
                 every scene: give one (`learning_rate`, --learning-rate)",
                optimizer.name()
            ),
        )),
    }
}
