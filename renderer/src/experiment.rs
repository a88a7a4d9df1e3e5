//! An experiment: a scene, and what of it to recover from which image.
//!
//! # Scene files
//!
//! A whole experiment is one TOML file. Paths are relative to it, colours linear RGB, angles in
//! degrees; unknown fields are refused.
//!
//! ```toml
//! bounces = 4                 # the default: how many mirrors and transparent surfaces a ray meets at most
//!
//! [camera]
//! look_from = [0.0, 2.0, 8.0]
//! look_at = [0.0, 1.0, 0.0]
//! up = [0.0, 1.0, 0.0]        # the default
//! vfov = 45.0                 # the default
//! film_scale = 1.0            # the default: the factor on the size of the image plane
//! width = 640
//! height = 480
//!
//! [[light]]
//! name = "key"
//! type = "point"              # or "distant", or "spot": see below
//! position = [3.0, 5.0, 5.0]
//! color = [1.0, 1.0, 1.0]     # the default
//! radiant_intensity = 225.0   # W/sr; or power, in W, over all directions
//!
//! [[light]]
//! name = "sun"
//! type = "distant"
//! direction = [0.3, 1.0, 0.2] # towards the light
//! irradiance = 2.0            # on a surface that faces it, W/m²
//!
//! [[light]]
//! name = "stage"
//! type = "spot"
//! position = [0.0, 6.0, 0.0]
//! direction = [0.0, -1.0, 0.2] # in which it shines
//! radiant_intensity = 90.0    # within the inner angle
//! inner_angle = 0.0           # the default: from the axis, where the fall-off begins
//! outer_angle = 45.0          # the default: where it is dark
//!
//! [[mesh]]
//! path = "tree.obj"           # or .ply, .stl, .gltf, .glb (of which only the meshes are taken)
//! name = "tree"               # optional: makes all objects of the file one mesh of this name
//! material = "bark"           # optional: replaces the file's materials
//! translation = [0.0, 1.0, 0.0] # optional: where it stands; first it is scaled, then turned, then moved
//! rotation = [0.0, 90.0, 0.0] # optional: the axis times the angle in degrees
//! scale = 2.0                 # optional: one factor, or one for each axis
//!
//! [[sphere]]
//! name = "ball"
//! center = [1.0, 0.5, 1.0]
//! radius = 0.5
//! material = "bark"
//!
//! [material.bark]             # a new material, or changes to one that a mesh brings along
//! emission = [0.0, 0.0, 0.0]  # the defaults of a new one; radiance
//! diffuse = [0.7, 0.7, 0.7]
//! roughness = 0.0             # of the diffuse part, up to 1: dust, plaster, clay
//! specular = [0.0, 0.0, 0.0]
//! exponent = 1.0
//! mirror = [0.0, 0.0, 0.0]    # above 0: a mirror
//! # opacity = 0.5             # if it is there, the material is transparent; a mirror is not
//!
//! diffuse_texture = "wood"    # optional: multiplies the colour; also emission_ and specular_texture
//! # opacity_texture = "holes" # multiplies the opacity (1 if there is none): by the mean of its channels
//!
//! [texture.wood]
//! path = "wood.png"           # PNG and JPEG (sRGB), or EXR (linear); or, for a texture to recover:
//! # size = [64, 64]           # width and height, and
//! # color = [0.5, 0.5, 0.5]   # one colour everywhere
//! wrap = "repeat"             # the default; or "clamp", "mirror"
//! # channel = "opacity"       # of the image its alpha, or, where it has none, its brightness as stored
//!
//! [optimize]                  # optional, and so is everything in it
//! target = "photo.png"        # or [optimize.target_values], below
//! loss = "mean_squared"       # or "sum_squared", "l1"
//! optimizer = "adam"          # or "adamw", "sgd" (needs a learning rate), "rmsprop", "lbfgs"
//! schedule = "constant"       # of the learning rates; or "exponential", "step", "cosine"
//! learning_rate = 0.05
//! iterations = 500
//! tolerance = 1e-8            # on the loss
//! gradient_tolerance = 1e-8   # on the norm of the gradient
//!
//! [[optimize.parameter]]
//! path = "light.key.position"
//! learning_rate = 0.1
//! min = -20.0                 # one number, or one for each of the parameter's
//! max = [20.0, 20.0, 20.0]
//! ```
//!
//! `mesh.tree.vertices[17]` is one vertex of a mesh: they are counted from 0, in the order in which its
//! triangles first use them.
//!
//! Without `max`, the diffuse, specular and mirrored part of the light stays at most 1 (or what it is to
//! begin with, or in the target): a surface reflects no more than it receives.
//!
//! An optimizer or a schedule whose numbers are not the default ones is a table; their fields are
//! those of [`Optimizer`] and [`Schedule`]:
//!
//! ```toml
//! [optimize]
//! optimizer = { type = "sgd", momentum = 0.5 }
//! schedule = { type = "exponential", end = 0.1 }
//! ```
//!
//! Instead of an image, `[optimize.target_values]` may give the true values of some parameters; the
//! target is then the image that the scene has with them:
//!
//! ```toml
//! [optimize.target_values]
//! "light.key.position" = [1.0, 10.0, -50.0]
//! "light.key.radiant_intensity" = 5000.0
//! ```

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
    /// Which one.
    pub id: ParameterId,
    /// Its own learning rate; above 0.
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
