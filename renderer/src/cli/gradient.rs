//! `renderer gradient`

use ad::check;
use serde_json::{Map, Value};

use super::Problem;
use super::dial::Dial;
use super::output::{json_numbers, print, short};
use crate::Error;
use crate::arithmetic::Arithmetic;
use crate::optimize::Evaluation;
use crate::recovery::natural_scale;
use crate::scene::{Differentiability, Scene};

/// Elements of one parameter that `--check` compares; more would take minutes on a mesh.
const MOST_CHECKED: usize = 24;

#[derive(clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    problem: Problem,

    #[command(flatten)]
    dial: Dial,

    /// Compare with finite differences of the renderer in double arithmetic
    #[arg(long)]
    check: bool,

    /// Print an object: path -> numbers
    #[arg(long, conflicts_with = "check")]
    json: bool,
}

pub(super) fn run(arguments: &Arguments, chosen: Option<Arithmetic>) -> Result<(), Error> {
    let experiment = arguments.problem.load()?;
    let place = arguments.problem.scene.display().to_string();
    let recovery = arguments.dial.recovery(&experiment, &place, chosen)?;
    let scene = &experiment.scene;
    let Evaluation { loss, gradient } = recovery.evaluate()?;

    let mut rest = &gradient[..];
    let blocks: Vec<_> = recovery
        .ids()
        .iter()
        .map(|&id| {
            let (block, others) = rest.split_at(scene.parameters.get(id).len());
            rest = others;
            (id, block)
        })
        .collect();
    if arguments.json {
        let entry =
            |(id, block)| (scene.path(id).to_string(), json_numbers(block, &scene.shape(id)));
        let object: Map<String, Value> = blocks.into_iter().map(entry).collect();
        return print(format_args!("{:#}", Value::Object(object)));
    }

    print(format_args!("loss {}", short(loss)))?;
    let mut missed = false;
    for (id, block) in blocks {
        print(scene.path(id))?;
        if !arguments.check {
            for (i, value) in block.iter().enumerate() {
                print(format_args!("  {:>12}  {}", position(scene, id, i), short(*value)))?;
            }
            continue;
        }
        print(format_args!(
            "  {:>12}  {:>13}  {:>18}  {:>9}",
            "", "gradient", "finite difference", "off by"
        ))?;
        let largest = block.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let stride = block.len().div_ceil(MOST_CHECKED);
        for (i, &value) in block.iter().enumerate().step_by(stride) {
            let step = 1e-3 * natural_scale(scene, id);
            let at = scene.parameters.get(id)[i];
            let expected = check::derivative(recovery.loss_along(id, i), at, step).value;
            let error =
                (value - expected).abs() / expected.abs().max(largest).max(f64::MIN_POSITIVE);
            missed |= error > 1e-3 && id.differentiability() == Differentiability::Interior;
            print(format_args!(
                "  {:>12}  {:>13}  {:>18}  {:>9.1e}",
                position(scene, id, i),
                short(value),
                short(expected),
                error
            ))?;
        }
        if stride > 1 {
            print(format_args!("  (every {stride}th of {} numbers)", block.len()))?;
        }
    }
    if missed {
        print(
            "Finite differences also see silhouettes and shadow edges move; the gradient holds the interior term only.",
        )?;
    }
    Ok(())
}

/// Which number of a parameter: `y`, or for a vertex `17.y`.
fn position(scene: &Scene, id: crate::scene::ParameterId, index: usize) -> String {
    let axis = |i: usize| ["x", "y", "z"][i % 3];
    match scene.shape(id)[..] {
        [] => String::new(),
        [_] => axis(index).into(),
        _ => format!("{}.{}", index / 3, axis(index)),
    }
}
