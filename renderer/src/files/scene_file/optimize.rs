//! The section `[optimize]` of a scene file.

use std::path::Path;

use super::format::ordered::Ordered;
use super::format::value::Numbers;
use super::format::{LaplacianEntry, OptimizeEntry, ParameterEntry};
use super::{Problem, file_in};
use crate::Error;
use crate::experiment::{OptimizeSection, Target, Term, TunedParameter, WeightedTerm, overlap};
use crate::laplacian::System;
use crate::loss::LossKind;
use crate::optimize::{Batch, Scale, Starts};
use crate::recovery::{check_levels, check_remeshing};
use crate::scene::{Invalid, ParameterId, Scene};

/// The section `entry` of a file in `folder` that describes `scene`.
pub(super) fn read(
    entry: &OptimizeEntry,
    scene: &Scene,
    folder: &Path,
) -> Result<OptimizeSection, Problem> {
    let target = match (&entry.target, &entry.target_values[..]) {
        (Some(_), [_, ..]) => {
            let problem = "give either target, an image, or target_values, not both";
            return Err(Problem::new("optimize.target", problem));
        }
        (Some(image), []) => {
            Some(Target::Image(file_in(folder, image, || "optimize.target".to_owned())?))
        }
        (None, [_, ..]) => Some(Target::Values(target_values(&entry.target_values, scene)?)),
        (None, []) => None,
    };
    if let ([_, ..], Some(Target::Image(_))) = (scene.views(), &target) {
        let problem = "a scene with views has a target for each of them: `target` in [[view]]";
        return Err(Problem::new("optimize.target", problem));
    }
    if let ([_, ..], Some(_)) = (scene.views(), &entry.mask) {
        let problem = "a scene with views has a mask for each of them: `mask` in [[view]]";
        return Err(Problem::new("optimize.mask", problem));
    }
    let mask = entry.mask.as_ref();
    let mask = mask.map(|mask| file_in(folder, mask, || "optimize.mask".to_owned())).transpose()?;
    if let Some(LossKind::Huber { delta }) = entry.loss
        && !(delta > 0.0 && delta.is_finite())
    {
        return Err(Problem::new("optimize.loss.delta", format!("must be above 0, is {delta}")));
    }
    if let Some(levels) = entry.coarse_to_fine {
        check_levels(scene, levels)
            .map_err(|problem| Problem::new("optimize.coarse_to_fine", problem))?;
    }
    let batch = match (entry.batch, entry.seed) {
        (Some(0), _) => return Err(Problem::new("optimize.batch", "must be at least 1, is 0")),
        (Some(_), _) if scene.views().is_empty() => {
            let problem = "is a number of views; the scene has none";
            return Err(Problem::new("optimize.batch", problem));
        }
        (Some(size), seed) => Some(Batch { size, seed: seed.unwrap_or_default() }),
        (None, Some(_)) if entry.starts.is_none() => {
            let problem = "orders the views of batches and draws starts: give `batch` or `starts`";
            return Err(Problem::new("optimize.seed", problem));
        }
        (None, _) => None,
    };
    let starts = match entry.starts {
        Some(0) => return Err(Problem::new("optimize.starts", "must be at least 1, is 0")),
        Some(count) => Some(Starts { count, seed: entry.seed.unwrap_or_default() }),
        None => None,
    };
    let mut parameters: Vec<TunedParameter> = Vec::new();
    for parameter in &entry.parameters {
        let tuned = tuned_parameter(parameter, scene)?;
        if let Some(problem) = overlap(scene, &parameters, tuned.id) {
            return Err(at(&parameter.path, "path", problem));
        }
        parameters.push(tuned);
    }
    let spread = parameters.iter().find(|tuned| tuned.spread.is_some());
    let differ = parameters.iter().any(|tuned| tuned.spread.iter().flatten().any(|&by| by > 0.0));
    match (starts, spread) {
        (Some(Starts { count: 2.., .. }), _) if !differ => {
            let problem = "differ by the `spread` of parameters, and none has one above 0";
            return Err(Problem::new("optimize.starts", problem));
        }
        (None, Some(tuned)) => {
            let problem = "is that of several starts: give `starts` in [optimize]";
            return Err(at(&scene.path(tuned.id).to_string(), "spread", problem));
        }
        _ => {}
    }
    let above_zero = |value: f64| value > 0.0 && value.is_finite();
    check("optimize.learning_rate", entry.learning_rate, above_zero, "must be above 0")?;
    check("optimize.tolerance", entry.tolerance, not_negative, "must not be negative")?;
    let gradient_tolerance = entry.gradient_tolerance;
    check("optimize.gradient_tolerance", gradient_tolerance, not_negative, "must not be negative")?;
    let at_field = |Error { place, problem, .. }| Problem::new(place, problem);
    entry.optimizer.unwrap_or_default().check().map_err(at_field)?;
    if let Some(schedule) = &entry.schedule {
        schedule.check().map_err(at_field)?;
        entry.optimizer.unwrap_or_default().check_schedule(schedule).map_err(at_field)?;
    }
    Ok(OptimizeSection {
        target,
        mask,
        views: Vec::new(),
        coarse_to_fine: entry.coarse_to_fine.unwrap_or_default(),
        batch,
        resample: entry.resample,
        starts,
        parameters,
        loss: entry.loss,
        optimizer: entry.optimizer,
        schedule: entry.schedule,
        learning_rate: entry.learning_rate,
        iterations: entry.iterations,
        tolerance: entry.tolerance,
        gradient_tolerance,
    })
}

/// The values to aim at, which must make a scene that can be rendered.
fn target_values(
    entries: &Ordered<Numbers>,
    scene: &Scene,
) -> Result<Vec<(ParameterId, Vec<f64>)>, Problem> {
    let mut target = scene.clone();
    let mut values = Vec::new();
    for (path, numbers) in entries {
        let place = format!("optimize.target_values.{path}");
        let id = scene.find_parameter(path).map_err(|problem| Problem::new(&place, problem))?;
        let place_of = |problem| Problem::new(&place, problem);
        let numbers = sized(numbers, scene, id, false).map_err(place_of)?;
        target.assign(id, &numbers);
        values.push((id, numbers));
    }
    target.check().map_err(|Invalid { path, problem }| {
        Problem::new(format!("optimize.target_values.{path}"), problem)
    })?;
    Ok(values)
}

fn tuned_parameter(entry: &ParameterEntry, scene: &Scene) -> Result<TunedParameter, Problem> {
    let path = &entry.path;
    let id = scene.find_parameter(path).map_err(|problem| at(path, "path", problem))?;
    if let Some(rate) = entry.learning_rate
        && !(rate > 0.0 && rate.is_finite())
    {
        return Err(at(path, "learning_rate", format!("must be above 0, is {rate}")));
    }
    let scale = entry.scale.unwrap_or_default();
    let smallest = scene.get(id).iter().copied().fold(f64::INFINITY, f64::min);
    if scale == Scale::Log && smallest <= 0.0 {
        let problem = format!("\"log\" needs initial values above 0, and one is {smallest}");
        return Err(at(path, "scale", problem));
    }
    let bound = |field: &str, numbers: &Option<Numbers>| match numbers {
        Some(numbers) => match sized(numbers, scene, id, true) {
            Ok(values) if values.iter().any(|v| v.is_nan()) => {
                Err(at(path, field, "is not a number"))
            }
            Ok(values) => Ok(Some(values)),
            Err(problem) => Err(at(path, field, problem)),
        },
        None => Ok(None),
    };
    let (min, max) = (bound("min", &entry.min)?, bound("max", &entry.max)?);
    if let (Some(min), Some(max)) = (&min, &max)
        && let Some((low, high)) = min.iter().zip(max).find(|(low, high)| low > high)
    {
        return Err(at(path, "min", format!("{low} is above max {high}")));
    }
    let spread = bound("spread", &entry.spread)?;
    if let Some(wrong) = spread.iter().flatten().find(|spread| !not_negative(**spread)) {
        return Err(at(path, "spread", format!("must be 0 or more, is {wrong}")));
    }
    for (i, &initial) in scene.get(id).iter().enumerate() {
        let (low, high) = (min.as_ref().map(|min| min[i]), max.as_ref().map(|max| max[i]));
        if low.is_some_and(|low| initial < low) {
            return Err(at(path, "min", format!("is above the initial value {initial}")));
        }
        if high.is_some_and(|high| initial > high) {
            return Err(at(path, "max", format!("is below the initial value {initial}")));
        }
    }
    if entry.large_steps.is_some_and(|lambda| !(lambda > 0.0 && lambda <= System::LARGEST_LAMBDA)) {
        let problem = format!("must be above 0 and at most {:e}", System::LARGEST_LAMBDA);
        return Err(at(path, "large_steps", problem));
    }
    if entry.large_steps.is_some() && scale == Scale::Log {
        let problem = "has coordinates of its own; leave it out, or scale = \"log\"";
        return Err(at(path, "large_steps", problem));
    }
    let is_surface = id.whole_mesh().is_some();
    if entry.large_steps.is_some() && !is_surface {
        return Err(at(path, "large_steps", "is for all vertices of a mesh"));
    }
    let laplacian = entry
        .laplacian
        .map(|LaplacianEntry { weight, weights }| ("laplacian", Term::Laplacian(weights), weight));
    let given = [
        ("edge_length", Term::EdgeLength, entry.edge_length),
        ("normal_consistency", Term::NormalConsistency, entry.normal_consistency),
        ("total_variation", Term::TotalVariation, entry.total_variation),
    ];
    let given = given.into_iter().filter_map(|(field, term, weight)| Some((field, term, weight?)));
    let mut terms = Vec::new();
    for (field, term, weight) in laplacian.into_iter().chain(given) {
        if !not_negative(weight) {
            let problem = format!("must have a weight of 0 or more, has {weight}");
            return Err(at(path, field, problem));
        }
        match term {
            Term::TotalVariation if id.field != "texels" => {
                return Err(at(path, field, "is for the texels of a texture"));
            }
            Term::Laplacian(_) | Term::EdgeLength | Term::NormalConsistency if !is_surface => {
                return Err(at(path, field, "is for all vertices of a mesh"));
            }
            _ => terms.push(WeightedTerm { term, weight }),
        }
    }
    let (learning_rate, large_steps) = (entry.learning_rate, entry.large_steps);
    let remesh = entry.remesh;
    let tuned =
        TunedParameter { id, scale, learning_rate, min, max, spread, large_steps, terms, remesh };
    check_remeshing(scene, &tuned).map_err(|problem| at(path, "remesh", problem))?;
    Ok(tuned)
}

/// Whether a number can be a weight or a distance.
fn not_negative(value: f64) -> bool {
    value >= 0.0 && value.is_finite()
}

/// As many numbers as the parameter has; a bound may be one number for all of them.
fn sized(
    numbers: &Numbers,
    scene: &Scene,
    id: ParameterId,
    spread: bool,
) -> Result<Vec<f64>, String> {
    let length = scene.count(id);
    match numbers {
        Numbers::One(value) if spread || length == 1 => Ok(vec![*value; length]),
        Numbers::Many(values) if values.len() == length => Ok(values.clone()),
        Numbers::One(_) => Err(format!("needs {length} numbers, has 1")),
        Numbers::Many(values) => Err(format!("needs {length} numbers, has {}", values.len())),
    }
}

fn check(
    path: &str,
    value: Option<f64>,
    holds: impl Fn(f64) -> bool,
    rule: &str,
) -> Result<(), Problem> {
    match value {
        Some(value) if !holds(value) => Err(Problem::new(path, format!("{rule}, is {value}"))),
        _ => Ok(()),
    }
}

/// A problem with a field of one `[[optimize.parameter]]`.
fn at(path: &str, field: &str, problem: impl ToString) -> Problem {
    Problem::new(format!("optimize.parameter.{path}.{field}"), problem)
}
