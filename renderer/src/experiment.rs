//! An experiment: a scene, and what of it to recover from which image.
//!
#![doc = include_str!("../docs/scene.md")]

use std::path::PathBuf;

use crate::loss::LossKind;
use crate::optimize::{Optimizer, Schedule};
use crate::scene::{ParameterId, Scene};
use crate::warning::Warning;

/// A scene and, if its file says so, an optimisation.
#[derive(Clone, Debug, PartialEq)]
pub struct Experiment {
    /// The scene as it stands, and so the initial guess.
    pub scene: Scene,
    /// What to optimise.
    pub optimize: Option<OptimizeSection>,
    /// What was left out of the files that it is from, because nothing here shows it.
    pub warnings: Vec<Warning>,
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
    /// The parameter to optimise.
    pub id: ParameterId,
    /// The learning rate of this parameter alone; above 0.
    pub learning_rate: Option<f64>,
    /// Its lower bound, as many numbers as the parameter has.
    pub min: Option<Vec<f64>>,
    /// Its upper bound, as many numbers as the parameter has, nowhere below `min`.
    pub max: Option<Vec<f64>>,
}

impl Experiment {
    /// An experiment that is from no file.
    pub fn new(scene: Scene, optimize: Option<OptimizeSection>) -> Self {
        Self { scene, optimize, warnings: Vec::new() }
    }
}

/// What is wrong with varying a parameter beside `given` ones, if it has numbers in common with one.
pub(crate) fn overlap(scene: &Scene, given: &[TunedParameter], id: ParameterId) -> Option<String> {
    let other = given.iter().map(|tuned| tuned.id).find(|other| other.overlaps(id))?;
    Some(match other == id {
        true => "is given twice".into(),
        false => format!("overlaps {}, which is given too", scene.path(other)),
    })
}
