//! An experiment: a scene, and what of it to recover from which image.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::Error;
use crate::files::scene_file;
use crate::scene::{ParameterId, Scene};

/// A scene and, if its file says so, an optimisation.
#[derive(Clone, Debug, PartialEq)]
pub struct Experiment {
    /// The scene as it stands, and so the initial guess.
    pub scene: Scene,
    /// What to optimise.
    pub optimize: Option<OptimizeSection>,
}

/// The section `[optimize]` of a scene file. What it leaves open is for the command line or the
/// defaults to decide.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OptimizeSection {
    /// What to match.
    pub target: Option<Target>,
    /// What may vary.
    pub parameters: Vec<TunedParameter>,
    /// How to measure the distance to the target.
    pub loss: Option<LossKind>,
    /// The learning rate of parameters that name none; above 0.
    pub learning_rate: Option<f64>,
    /// Stop after so many steps.
    pub iterations: Option<u64>,
    /// Stop when the loss is no larger; 0 or more.
    pub tolerance: Option<f64>,
    /// Stop when the norm of the gradient is no larger; 0 or more.
    pub gradient_tolerance: Option<f64>,
}

/// What an optimisation is to match.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// An image file.
    Image(PathBuf),
    /// The image of the scene with these parameters set to these values.
    Values(Vec<(ParameterId, Vec<f64>)>),
}

/// A parameter that may vary.
#[derive(Clone, Debug, PartialEq)]
pub struct TunedParameter {
    /// Which one.
    pub id: ParameterId,
    /// Its own learning rate; above 0.
    pub learning_rate: Option<f64>,
    /// Its lower bound, as many numbers as the parameter has.
    pub min: Option<Vec<f64>>,
    /// Its upper bound, as many numbers as the parameter has, nowhere below `min`.
    pub max: Option<Vec<f64>>,
}

/// The distance between two images.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LossKind {
    /// The mean of the squared differences of all channels.
    MeanSquared,
    /// The sum of the squared differences of all channels.
    SumSquared,
    /// The mean of the absolute differences of all channels.
    L1,
}

impl Experiment {
    /// Reads a scene file, or an `.obj`, which is then framed and lit by default: the camera looks
    /// at the centre of the bounding box from the front, to the right and above; a point light
    /// `key` stands above the camera.
    ///
    /// # Errors
    ///
    /// If a file cannot be read, is broken, or describes what cannot be rendered. The message names
    /// the file and, where it can, the line and the field.
    pub fn load(path: &Path) -> Result<Self, Error> {
        let is_obj = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("obj"));
        if is_obj {
            let scene = scene_file::load_obj_scene(path)?;
            return Ok(Self { scene, optimize: None });
        }
        scene_file::load(path)
    }

    /// Parses the text of a scene file whose relative paths begin in `base_dir`; messages call it
    /// `name`.
    ///
    /// # Errors
    ///
    /// As [`load`](Self::load).
    pub fn parse(text: &str, base_dir: &Path, name: &str) -> Result<Self, Error> {
        scene_file::parse(text, base_dir, name)
    }
}
