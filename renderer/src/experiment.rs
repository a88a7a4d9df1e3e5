//! An experiment: a scene, and what of it to recover from which image.
//!
#![doc = include_str!("../docs/scene.md")]

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::laplacian::Weights;
use crate::loss::LossKind;
use crate::optimize::{Batch, Optimizer, Scale, Schedule, Starts};
use crate::scene::{ParameterId, Scene};
use crate::settings::Pass;
use crate::{Error, ErrorKind, Warning, one_line};

/// A scene and, if its file says so, an optimisation.
#[derive(Clone, Debug, PartialEq)]
pub struct Experiment {
    /// The scene as it stands, and so the initial guess.
    pub scene: Scene,
    /// What to optimise.
    pub optimize: Option<OptimizeSection>,
    /// What was left out of the files that it is from, because nothing here shows it.
    pub warnings: Vec<Warning>,
    /// The files that it is made from and compared with, but for images that files of cameras name.
    pub(crate) files: Vec<NamedFile>,
}

/// A file, and what names it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NamedFile {
    pub path: PathBuf,
    /// A field of a scene file, a line of a file that the scene file names, or an argument.
    pub by: String,
}

/// The section `[optimize]` of a scene file. What it leaves open is for the command line or the
/// defaults to decide.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OptimizeSection {
    /// What to match.
    pub target: Option<Target>,
    /// How much each pixel counts: an image file of the size of the target, in a scene without views.
    pub mask: Option<PathBuf>,
    /// What to match in each view, in the order of the views; what is not there has its default.
    pub views: Vec<ViewTarget>,
    /// How many views an iteration looks at, if not all of them.
    pub batch: Option<Batch>,
    /// Whether each iteration takes random numbers of its own where light takes all paths, half of them independent
    /// of the others. If it is not said, it does where the targets are image files, the loss is a square, and the method
    /// compares no losses.
    pub resample: Option<bool>,
    /// How often the images are halved to begin with.
    pub coarse_to_fine: u32,
    /// Several beginnings, if there are to be any beside the scene as it stands.
    pub starts: Option<Starts>,
    /// What may vary.
    pub parameters: Vec<TunedParameter>,
    /// How to measure the distance to the target.
    pub loss: Option<LossKind>,
    /// The method.
    pub optimizer: Option<Optimizer>,
    /// How the learning rates change in the course of the run.
    pub schedule: Option<Schedule>,
    /// The learning rate of parameters that name none; above 0.
    pub learning_rate: Option<f64>,
    /// Stop after so many steps.
    pub iterations: Option<u64>,
    /// Stop when the loss is no larger; 0 or more.
    pub tolerance: Option<f64>,
    /// Stop when the norm of the gradient is no larger; 0 or more.
    pub gradient_tolerance: Option<f64>,
}

impl OptimizeSection {
    /// The files that say what to match.
    pub fn files(&self) -> Vec<&Path> {
        let target = match &self.target {
            Some(Target::Image(image)) => Some(image),
            _ => None,
        };
        let of_views = self.views.iter().flat_map(|view| {
            let passes = view.passes.iter().map(|matched| &matched.file);
            view.image.iter().chain(passes).chain(&view.mask)
        });
        let files = of_views.chain(target).chain(&self.mask);
        files.map(PathBuf::as_path).collect()
    }
}

/// What an optimisation is to match.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// An image file.
    Image(PathBuf),
    /// The image of the scene with these parameters set to these values.
    Values(Vec<(ParameterId, Vec<f64>)>),
}

/// What to match in a view.
#[derive(Clone, Debug, PartialEq)]
pub struct ViewTarget {
    /// An image file; nothing if the target is made of [values](Target::Values), or is other passes alone.
    pub image: Option<PathBuf>,
    /// What is matched beside the image or in place of it.
    pub passes: Vec<MatchedPass>,
    /// An image file of how much each pixel counts.
    pub mask: Option<PathBuf>,
    /// What the loss of the view is multiplied by; 0 or more.
    pub weight: f64,
    /// Whether it is only compared with what is found, and never matched.
    pub held_out: bool,
}

impl Default for ViewTarget {
    /// No files, weight 1, not held out.
    fn default() -> Self {
        Self { image: None, passes: Vec::new(), mask: None, weight: 1.0, held_out: false }
    }
}

/// What a view is to show of surfaces other than radiance.
#[derive(Clone, Debug, PartialEq)]
pub struct MatchedPass {
    /// What it is: coverage, depth or normals.
    pub pass: Pass,
    /// An image file; of depth and normals [OpenEXR](crate::files::load_pass).
    pub file: PathBuf,
    /// What its loss is multiplied by, beside the weight of the view; 0 or more.
    pub weight: f64,
}

/// A parameter that may vary.
#[derive(Clone, Debug, PartialEq)]
pub struct TunedParameter {
    /// The parameter to optimise.
    pub id: ParameterId,
    /// What its steps are taken in: its numbers, or their logarithms.
    pub scale: Scale,
    /// The learning rate of this parameter alone; above 0.
    pub learning_rate: Option<f64>,
    /// Its lower bound, as many numbers as the parameter has.
    pub min: Option<Vec<f64>>,
    /// Its upper bound, as many numbers as the parameter has, nowhere below `min`.
    pub max: Option<Vec<f64>>,
    /// How far each of its numbers is at most from that of the scene, on its scale, where there are several
    /// [starts](OptimizeSection::starts).
    pub spread: Option<Vec<f64>>,
    /// Of the vertices of a mesh: the lambda of the [coordinates](crate::laplacian::System) that first-order
    /// methods take their steps in, of uniform weights; above 0.
    pub large_steps: Option<f64>,
    /// Terms of the loss that are of these numbers alone.
    pub terms: Vec<WeightedTerm>,
    /// Of the vertices of a mesh: how its triangles change in the course of the run, if they do.
    pub remesh: Option<Remeshing>,
}

/// How the triangles of a mesh [change](crate::remesh::remesh) in the course of a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with an `edge_length` and an `every`")]
pub struct Remeshing {
    /// About how long edges become, in units of the vertices; above 0. Where those of the mesh are longer on average,
    /// they become so step by step: each time shorter by [a part](Self::STEP).
    pub edge_length: f64,
    /// After how many steps they change again; at least 1.
    pub every: u64,
}

impl Remeshing {
    /// The length of edges over that of the time before, at the least.
    pub const STEP: f64 = 0.8;

    /// Whether the triangles change before an iteration.
    pub fn is_due(&self, iteration: u64) -> bool {
        iteration > 0 && iteration.is_multiple_of(self.every)
    }

    /// The length of edges from an iteration on, of a mesh whose edges were `initial` long at the beginning of the run.
    pub fn edge_length_at(&self, iteration: u64, initial: f64) -> f64 {
        let step = i32::try_from(iteration / self.every.max(1)).unwrap_or(i32::MAX);
        self.edge_length.max(initial * Self::STEP.powi(step))
    }
}

impl TunedParameter {
    /// A parameter with the usual learning rate and bounds.
    pub fn new(id: ParameterId) -> Self {
        Self {
            id,
            scale: Scale::Linear,
            learning_rate: None,
            min: None,
            max: None,
            spread: None,
            large_steps: None,
            terms: Vec::new(),
            remesh: None,
        }
    }
}

/// A term of the loss that is of numbers alone, and not of images.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedTerm {
    /// What it is.
    pub term: Term,
    /// What it is multiplied by; 0 or more.
    pub weight: f64,
}

/// What numbers cost by themselves. All but the total variation are for all vertices of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Term {
    /// The mean squared [difference](crate::laplacian::Laplacian::energy) between vertices and the mean of their
    /// neighbours, in squared scene units; cotangents are those of the mesh as the scene has it.
    Laplacian(Weights),
    /// The mean squared difference between the lengths of edges and the mean length that the mesh of the scene
    /// has, relative to that.
    EdgeLength,
    /// The mean of one minus the cosine of the angle between the normals of neighbouring triangles.
    NormalConsistency,
    /// For the texels of a texture: the mean length of the differences between texels and the next ones.
    TotalVariation,
}

impl Experiment {
    /// An experiment that is from no file.
    pub fn new(scene: Scene, optimize: Option<OptimizeSection>) -> Self {
        Self { scene, optimize, warnings: Vec::new(), files: Vec::new() }
    }

    /// The error of a file, at the field that names it if it cannot be read.
    pub(crate) fn place(&self, error: Error) -> Error {
        let is_meant = |file: &&NamedFile| one_line(file.path.display()) == error.place;
        match self.files.iter().find(is_meant) {
            Some(file) if error.kind == ErrorKind::Io => at_field(file.by.clone(), error),
            _ => error,
        }
    }
}

/// The error of a file, at the field that names it.
pub(crate) fn at_field(field: String, mut error: Error) -> Error {
    error.problem = error.to_string();
    error.place = field;
    error
}

/// What is wrong with varying a parameter beside `given` ones, if it has numbers in common with one.
pub(crate) fn overlap(scene: &Scene, given: &[TunedParameter], id: ParameterId) -> Option<String> {
    let other = given.iter().map(|tuned| tuned.id).find(|other| other.overlaps(id))?;
    Some(match other == id {
        true => "is given twice".into(),
        false => format!("overlaps {}, which is given too", scene.path(other)),
    })
}
