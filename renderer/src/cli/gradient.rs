//! `renderer gradient`

use std::process::ExitCode;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Map, Value};

use super::Problem;
use super::accuracy::AccuracyArguments;
use super::output::{json_numbers, print, print_note, print_warning, short};
use crate::Error;
use crate::arithmetic::Arithmetic;
use crate::optimize::Evaluation;
use crate::recovery::{Finding, Recovery, Verdict};
use crate::scene::{Integrator, Object, ParameterId, Scene};
use crate::settings::{Edges, GradientSamples, Settings};

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

    /// Where light takes all paths: whether the derivatives of pixels are computed from the paths of the pixels
    /// themselves, which gives the exact gradient of the loss of the image that they show, or from others, half for
    /// half, which gives that of the loss without noise on average, if the loss is a square
    #[arg(long, value_enum, default_value_t = GradientSamples::Same, conflicts_with = "check")]
    gradient_samples: GradientSamples,

    /// Print an object: path -> numbers; with --check also `check` and `uncertainty`, objects: path -> relative
    /// error, and how exactly it is known
    #[arg(long)]
    json: bool,
}

/// Prints the gradient; returns whether it holds what is asked of it.
pub(super) fn run(arguments: &Arguments, chosen: Option<Arithmetic>) -> Result<ExitCode, Error> {
    let experiment = arguments.problem.load()?;
    let recovery = arguments.accuracy.recovery(&arguments.problem, &experiment, chosen)?;
    let recovery = arguments.with_gradient_samples(recovery)?;
    recovery.noisy_materials().iter().for_each(print_warning);
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
    let tolerance = arguments.tolerance;
    let (mut object, mut errors, mut off) = (Map::new(), Map::new(), Vec::new());
    let mut uncertainties = Map::new();
    let count = blocks.len();
    for (index, (id, block)) in blocks.into_iter().enumerate() {
        let path = scene.path(id).to_string();
        let verdict = arguments.check.then(|| {
            let what = format!("{path} ({} of {count})", index + 1);
            checking(ProgressBar::new_spinner(), what, || recovery.check(id, block, tolerance))
        });
        match &verdict {
            _ if arguments.json => {}
            Some(verdict) => print_verdict(scene, id, verdict, tolerance)?,
            None => {
                print(&path)?;
                for (i, value) in block.iter().enumerate() {
                    print(format_args!("  {:>12}  {}", position(scene, id, i), short(*value)))?;
                }
            }
        }
        object.insert(path.clone(), json_numbers(block, &scene.shape(id)));
        if let Some(verdict) = verdict {
            if verdict.at(tolerance) == Finding::Disagrees {
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

impl Arguments {
    fn with_gradient_samples<'a>(&self, recovery: Recovery<'a>) -> Result<Recovery<'a>, Error> {
        let settings = *recovery.render_settings();
        match (self.gradient_samples, recovery.scene().integrator) {
            (GradientSamples::Same, _) => Ok(recovery),
            (GradientSamples::Independent, Integrator::Direct) => {
                let problem = "independent paths are there where light takes all: `[integrator] type = \"path\"`";
                Err(Error::new("--gradient-samples", problem))
            }
            (samples, Integrator::Path(_)) => {
                let sampling = settings.sampling.with_gradient(samples);
                Ok(recovery.with_settings(&Settings { sampling, ..settings }))
            }
        }
    }
}

/// Checks a parameter, which may take minutes, while a line on a terminal names it.
fn checking<T>(line: ProgressBar, what: String, check: impl FnOnce() -> T) -> T {
    if let Ok(style) = ProgressStyle::with_template("checking {msg}, {elapsed}") {
        line.set_style(style);
    }
    line.set_message(what);
    line.enable_steady_tick(Duration::from_millis(500));
    let found = check();
    line.finish_and_clear();
    found
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

#[cfg(test)]
mod tests {
    use std::io;
    use std::sync::{Arc, Mutex};
    use std::thread::sleep;

    use indicatif::{ProgressDrawTarget, TermLike};

    use super::*;

    /// A terminal that keeps what is written to it.
    #[derive(Clone, Debug, Default)]
    struct Written(Arc<Mutex<String>>);

    impl TermLike for Written {
        fn width(&self) -> u16 {
            80
        }
        fn move_cursor_up(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_down(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_right(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_left(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn write_line(&self, text: &str) -> io::Result<()> {
            self.write_str(text)
        }
        fn write_str(&self, text: &str) -> io::Result<()> {
            self.0.lock().unwrap().push_str(text);
            Ok(())
        }
        fn clear_line(&self) -> io::Result<()> {
            self.0.lock().unwrap().clear();
            Ok(())
        }
        fn flush(&self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn the_parameter_that_is_checked_is_named_until_it_is() {
        let terminal = Written::default();
        let target = ProgressDrawTarget::term_like(Box::new(terminal.clone()));
        let line = ProgressBar::with_draw_target(None, target);
        let shown = checking(line, "light.key.color (2 of 3)".to_owned(), || {
            // The line is drawn by a thread of its own.
            for _ in 0..10_000 {
                if !terminal.0.lock().unwrap().is_empty() {
                    break;
                }
                sleep(Duration::from_millis(1));
            }
            terminal.0.lock().unwrap().clone()
        });
        assert!(shown.contains("checking light.key.color (2 of 3), 0"), "{shown}");
        assert_eq!(*terminal.0.lock().unwrap(), "");
    }
}
