//! `renderer gradient`

use std::process::ExitCode;

use serde_json::{Map, Value};

use super::Problem;
use super::accuracy::AccuracyArguments;
use super::output::{json_numbers, print, print_note, print_warning, short};
use crate::Error;
use crate::arithmetic::Arithmetic;
use crate::optimize::Evaluation;
use crate::recovery::{Finding, Verdict};
use crate::scene::{Object, ParameterId, Scene};
use crate::settings::Edges;

#[derive(clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    problem: Problem,

    #[command(flatten)]
    accuracy: AccuracyArguments,

    /// Compare with finite differences: of the loss in double precision, or of finely sampled images where
    /// a parameter moves edges. Ends with exit code 1 if a parameter is off by more than the tolerance, and
    /// says so if noise does not let it tell
    #[arg(long)]
    check: bool,

    /// By how much a gradient may be off, relative to its norm
    #[arg(long, value_name = "E", default_value_t = 0.02, requires = "check",
          value_parser = super::accuracy::accuracy)]
    tolerance: f64,

    /// Print an object: path -> numbers; with --check also `check` and `uncertainty`, objects: path -> relative
    /// error, and how exactly it is known
    #[arg(long)]
    json: bool,
}

/// Prints the gradient; returns whether it holds what is asked of it.
pub(super) fn run(arguments: &Arguments, chosen: Option<Arithmetic>) -> Result<ExitCode, Error> {
    let experiment = arguments.problem.load()?;
    let recovery = arguments.accuracy.recovery(&arguments.problem, &experiment, chosen)?;
    let scene = &experiment.scene;
    let Evaluation { loss, gradient } = recovery.evaluate()?;
    recovery.left_out().iter().for_each(print_warning);

    let mut rest = &gradient[..];
    let blocks: Vec<_> = recovery
        .ids()
        .iter()
        .map(|&id| {
            let (block, others) = rest.split_at(scene.count(id));
            rest = others;
            (id, block)
        })
        .collect();
    if !arguments.json {
        print(format_args!("loss {}", short(loss)))?;
    }
    let (mut object, mut errors, mut off) = (Map::new(), Map::new(), Vec::new());
    let mut uncertainties = Map::new();
    for (id, block) in blocks {
        let path = scene.path(id).to_string();
        let verdict = arguments.check.then(|| recovery.check(id, block));
        match &verdict {
            _ if arguments.json => {}
            Some(verdict) => print_verdict(scene, id, verdict, arguments.tolerance)?,
            None => {
                print(&path)?;
                for (i, value) in block.iter().enumerate() {
                    print(format_args!("  {:>12}  {}", position(scene, id, i), short(*value)))?;
                }
            }
        }
        object.insert(path.clone(), json_numbers(block, &scene.shape(id)));
        if let Some(verdict) = verdict {
            if verdict.at(arguments.tolerance) == Finding::Disagrees {
                off.push(id);
            }
            uncertainties.insert(path.clone(), verdict.uncertainty.into());
            errors.insert(path, verdict.error.into());
        }
    }
    if arguments.json {
        if arguments.check {
            object.insert("check".into(), errors.into());
            object.insert("uncertainty".into(), uncertainties.into());
        }
        print(format_args!("{:#}", Value::Object(object)))?;
    }
    if off.iter().any(|&id| recovery.scene().moves_edges(id)) {
        print_note(match recovery.render_settings().edges {
            Edges::Off => {
                "With --edges off the gradient holds the interior term only: silhouettes and shadow edges that \
                 move are missing."
            }
            _ => {
                "What few rays miss of small facets, highlights and thin shadows is missing in the gradient, too: \
                 with more --samples it comes closer to the differences."
            }
        });
    }
    Ok(if off.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Prints how a gradient compares with differences.
fn print_verdict(
    scene: &Scene,
    id: ParameterId,
    verdict: &Verdict,
    tolerance: f64,
) -> Result<(), Error> {
    print(scene.path(id))?;
    print(format_args!("  {:>16}  {:>13}  {:>18}  {:>9}", "", "gradient", "difference", "+-"))?;
    for compared in &verdict.compared {
        let place = match compared.element {
            Some(element) => position(scene, id, element),
            None => "random direction".to_owned(),
        };
        print(format_args!(
            "  {place:>16}  {:>13}  {:>18}  {:>9.1e}",
            short(compared.gradient),
            short(compared.difference),
            compared.uncertainty
        ))?;
    }
    let word = match verdict.at(tolerance) {
        Finding::Agrees => "agrees",
        Finding::Unknown => "cannot tell",
        Finding::Disagrees => "DISAGREES",
    };
    let Verdict { error, uncertainty, .. } = verdict;
    print(format_args!("  {word}: off by {error:.1e} of its norm, known to {uncertainty:.1e}"))
}

/// Which number of a parameter: `y`, for a vertex `17.y`, for a texel `row.column.r`.
fn position(scene: &Scene, id: ParameterId, index: usize) -> String {
    let shape = scene.shape(id);
    let names = match (id.object, id.field) {
        (_, "texture_coordinates") => "uv",
        (Object::Texture(_) | Object::Material(_), _)
        | (Object::Light(_), "color")
        | (Object::Environment, _) => "rgb",
        _ => "xyz",
    };
    let column = |i: usize| names.get(i..=i).map_or(i.to_string(), str::to_owned);
    match shape[..] {
        [] => String::new(),
        [_] => column(index),
        [_, width] => format!("{}.{}", index / width, column(index % width)),
        [_, width, depth, ..] => {
            let texel = index / depth;
            format!("{}.{}.{}", texel / width, texel % width, column(index % depth))
        }
    }
}
