//! What the command line changes in a scene: its size, and the numbers of parameters.

use std::path::Path;

use super::load;
use crate::Error;
use crate::experiment::Experiment;
use crate::scene::{ParameterId, Scene};

#[derive(clap::Args)]
pub(super) struct Changes {
    /// The width of the image in pixels; the height follows, unless it is given too
    #[arg(long, value_name = "PIXELS")]
    width: Option<u32>,

    /// The height of the image in pixels; the width follows, unless it is given too
    #[arg(long, value_name = "PIXELS")]
    height: Option<u32>,

    /// Set a parameter (can be repeated): light.key.position=1,2,3
    #[arg(long = "set", value_name = "PATH=VALUE")]
    set: Vec<String>,
}

impl Changes {
    /// Loads a scene or a mesh, changed.
    pub fn load(&self, path: &Path) -> Result<Experiment, Error> {
        let mut experiment = load(path)?;
        self.resize(&mut experiment.scene);
        for change in &self.set {
            set(&mut experiment.scene, change)
                .map_err(|problem| Error::new(format_args!("--set {change}"), problem))?;
        }
        experiment.scene.validate(path.display())?;
        Ok(experiment)
    }

    fn resize(&self, scene: &mut Scene) {
        let scaled = |size: u32, by: u32, of: u32| {
            let scaled = (f64::from(size) * f64::from(by) / f64::from(of)).round();
            (scaled as u32).max(1)
        };
        (scene.width, scene.height) = match (self.width, self.height) {
            (None, None) => return,
            (Some(width), Some(height)) => (width, height),
            (Some(width), None) => (width, scaled(scene.height, width, scene.width)),
            (None, Some(height)) => (scaled(scene.width, height, scene.height), height),
        };
    }
}

/// Makes a change.
fn set(scene: &mut Scene, change: &str) -> Result<(), String> {
    let (id, values) = assignment(scene, change)?;
    scene.assign(id, &values);
    Ok(())
}

/// A path, `=`, and as many numbers as the parameter has, or one for all of them.
pub(super) fn assignment(scene: &Scene, change: &str) -> Result<(ParameterId, Vec<f64>), String> {
    let (path, values) = change.split_once('=').ok_or("is not PATH=VALUE")?;
    let id = scene.find_parameter(path.trim())?;
    let number = |text: &str| {
        let text = text.trim();
        text.parse::<f64>().map_err(|_| format!("`{text}` is not a number"))
    };
    let values = values.trim().trim_start_matches('[').trim_end_matches(']');
    let mut values: Vec<f64> = values.split(',').map(number).collect::<Result<_, _>>()?;
    let count = scene.count(id);
    if values.len() == 1 {
        values = vec![values[0]; count];
    }
    if values.len() != count {
        return Err(format!("needs {count} numbers, has {}", values.len()));
    }
    Ok((id, values))
}
