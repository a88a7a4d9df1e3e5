//! `renderer gradient`

use ad::check;
use serde_json::{Map, Value};

use super::Problem;
use super::dial::Dial;
use super::output::{json_numbers, print, print_warning, short};
use crate::Error;
use crate::arithmetic::Arithmetic;
use crate::optimize::Evaluation;
use crate::scene::{Differentiability, Object, ParameterId, Scene};

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
    let recovery = arguments.dial.recovery(&arguments.problem, &experiment, chosen)?;
    let scene = &experiment.scene;
    let Evaluation { loss, gradient } = recovery.evaluate()?;
    recovery.left_out().iter().for_each(print_warning);

    let mut rest = &gradient[..];
    let blocks: Vec<_> = recovery
        .ids()
        .iter()
        .map(|&id| {
            let (block, others) = rest.split_at(scene.get(id).len());
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
        let stride = stride(block.len(), scene.shape(id).last().copied().unwrap_or(1));
        for (i, &value) in block.iter().enumerate().step_by(stride) {
            let step = step(scene, id);
            let at = scene.get(id)[i];
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
            let (checked, all) = (block.len().div_ceil(stride), block.len());
            print(format_args!(
                "  ({checked} of {all} numbers, evenly spaced: every {stride}th; what lies between \
                 was not checked)"
            ))?;
        }
    }
    if missed {
        print(
            "Finite differences also see silhouettes and shadow edges move; the gradient holds the interior term only.",
        )?;
    }
    Ok(())
}

/// The first step of the differences. A bilinear texture has a kink at every texel: places on it move by
/// so little that few pixels come across one.
fn step(scene: &Scene, id: ParameterId) -> f64 {
    match id.field {
        "texture_coordinates" => 1e-6,
        _ => 1e-3 * scene.natural_scale(id),
    }
}

/// The distance between elements of a parameter of `count` numbers, `row` in each row, that are
/// compared. Not a multiple of the row, of which it would only see one column: the x of all vertices.
fn stride(count: usize, row: usize) -> usize {
    let stride = count.div_ceil(MOST_CHECKED).max(1);
    if stride > 1 && row > 1 && stride.is_multiple_of(row) { stride + 1 } else { stride }
}

/// Which number of a parameter: `y`, for a vertex `17.y`, for a texel `row.column.r`.
fn position(scene: &Scene, id: ParameterId, index: usize) -> String {
    let shape = scene.shape(id);
    let names = match (id.object, id.field) {
        (_, "texture_coordinates") => "uv",
        (Object::Texture(_) | Object::Material(_), _) | (Object::Light(_), "color") => "rgb",
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_is_compared() {
        for (row, counts) in [(3, [9, 72, 75, 144, 864, 900_003]), (2, [6, 48, 50, 96, 480, 1000])]
        {
            for count in counts {
                let stride = stride(count, row);
                let compared: Vec<usize> = (0..count).step_by(stride).collect();
                assert!((1..=MOST_CHECKED).contains(&compared.len()), "{count} {stride}");
                let columns = (0..row).filter(|column| compared.iter().any(|i| i % row == *column));
                assert_eq!(columns.count(), row, "{count} {stride}");
            }
        }
        assert_eq!((stride(1, 1), stride(3, 3)), (1, 1));
    }
}
