//! What the command line changes in a scene: its size, and the numbers of parameters.

use std::path::Path;

use super::load_to_show;
use crate::Error;
use crate::experiment::Experiment;
use crate::scene::{ParameterId, Scene};
use crate::settings::Pass;

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
        self.load_to_show(path, &[Pass::Radiance])
    }

    /// Loads a scene or a mesh, changed, of which these passes are rendered.
    pub fn load_to_show(&self, path: &Path, passes: &[Pass]) -> Result<Experiment, Error> {
        let mut experiment = load_to_show(path, passes)?;
        let scene = &mut experiment.scene;
        [scene.width, scene.height] = self.resized([scene.width, scene.height]);
        for view in &mut scene.views {
            [view.width, view.height] = self.resized([view.width, view.height]);
        }
        for change in &self.set {
            set(&mut experiment.scene, change)
                .map_err(|problem| Error::new(format_args!("--set {change}"), problem))?;
        }
        experiment.scene.validate(path.display())?;
        Ok(experiment)
    }

    fn resized(&self, [width, height]: [u32; 2]) -> [u32; 2] {
        let scaled = |size: u32, by: u32, of: u32| {
            let scaled = (f64::from(size) * f64::from(by) / f64::from(of)).round();
            (scaled as u32).max(1)
        };
        match (self.width, self.height) {
            (None, None) => [width, height],
            (Some(wide), Some(high)) => [wide, high],
            (Some(wide), None) => [wide, scaled(height, wide, width)],
            (None, Some(high)) => [scaled(width, high, height), high],
        }
    }
}

/// Makes a change, to as many numbers as the parameter has, or to one for all of them.
fn set(scene: &mut Scene, change: &str) -> Result<(), String> {
    let (id, mut values) = numbers(scene, change)?;
    if let [value] = values[..] {
        values = vec![value; scene.count(id)];
    }
    scene.assign(id, &sized(scene, id, values)?);
    Ok(())
}

/// A path, `=`, and as many numbers as the parameter has.
pub(super) fn assignment(scene: &Scene, text: &str) -> Result<(ParameterId, Vec<f64>), String> {
    let (id, values) = numbers(scene, text)?;
    Ok((id, sized(scene, id, values)?))
}

/// A path, `=`, and numbers.
fn numbers(scene: &Scene, text: &str) -> Result<(ParameterId, Vec<f64>), String> {
    let (path, values) = text.split_once('=').ok_or("is not PATH=VALUE")?;
    let id = scene.find_parameter(path.trim())?;
    let number = |text: &str| {
        let text = text.trim();
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) => Err(format!("`{text}` is not a finite number")),
            Err(_) => Err(format!("`{text}` is not a number")),
        }
    };
    let values = values.trim().trim_start_matches('[').trim_end_matches(']');
    let values = values.split(',').map(number).collect::<Result<_, _>>()?;
    Ok((id, values))
}

/// These values, if the parameter has as many.
fn sized(scene: &Scene, id: ParameterId, values: Vec<f64>) -> Result<Vec<f64>, String> {
    let (count, given) = (scene.count(id), values.len());
    if given == count {
        return Ok(values);
    }
    let numbers = if count == 1 { "number" } else { "numbers" };
    Err(format!("needs {count} {numbers}, has {given}"))
}
