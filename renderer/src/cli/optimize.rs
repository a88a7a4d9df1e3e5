//! `renderer optimize`

use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::Map;

use super::{Problem, abbreviate, short, stem};
use crate::Error;
use crate::experiment::Experiment;
use crate::files::{save_png, save_scene};
use crate::optimize::{Checkpointing, Optimization, Outcome, Start, progress, write_report};
use crate::recovery::{Precision, Recovery, render_at};

#[derive(clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    problem: Problem,

    /// Folder for the results [default: out/NAME-OF-SCENE]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Stop after so many steps
    #[arg(long, value_name = "N")]
    iterations: Option<u64>,

    /// Stop when the loss is no larger
    #[arg(long, value_name = "X")]
    tolerance: Option<f64>,

    /// Continue a run that was interrupted
    #[arg(long)]
    resume: bool,
}

pub(super) fn run(arguments: &Arguments, precision: Precision) -> Result<(), Error> {
    let mut experiment = arguments.problem.load()?;
    if let Some(section) = &mut experiment.optimize {
        section.iterations = arguments.iterations.or(section.iterations);
        section.tolerance = arguments.tolerance.or(section.tolerance);
    }
    let scene_path = &arguments.problem.scene;
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(stem(scene_path)));
    let place = scene_path.display().to_string();
    let recovery = Recovery::new(&experiment, &place, precision)?;
    let outcome = recover(&experiment, &recovery, &out, arguments.resume, precision)?;
    report(&recovery, &outcome, &out);
    Ok(())
}

/// Optimises, and leaves everything about it in the folder `out`.
pub(super) fn recover(
    experiment: &Experiment,
    recovery: &Recovery<'_>,
    out: &Path,
    resume: bool,
    precision: Precision,
) -> Result<Outcome, Error> {
    let mut settings = recovery.settings();
    settings.checkpointing = Some(Checkpointing {
        folder: out.to_owned(),
        every: Duration::from_secs(3),
        resume,
        problem: recovery.fingerprint(),
    });

    // Whatever is wrong shows before anything is written.
    let beginning = Optimization::start(recovery.variables(), &settings)?.beginning();
    match beginning {
        Start::Fresh => {}
        Start::Resumed { iteration } => eprintln!("continuing after iteration {iteration}"),
        Start::Finished { iteration } => eprintln!("had finished after iteration {iteration}"),
    }
    std::fs::create_dir_all(out)
        .map_err(|error| Error::new(out.display(), format_args!("cannot be made: {error}")))?;
    let target = recovery.target();
    save_png(target, &out.join("target.png"))?;
    save_png(&render_at(precision, &experiment.scene), &out.join("initial.png"))?;

    let outcome = recovery.run(&settings, progress().as_mut())?;

    let recovered = recovery.scene_at(&outcome.best.x);
    let image = render_at(precision, &recovered);
    save_png(&image, &out.join("final.png"))?;
    if let Some(difference) = image.absolute_difference(target) {
        save_png(&difference, &out.join("difference.png"))?;
    }
    save_scene(&recovered, out)?;
    write_report(out, recovery.variables(), &outcome, Map::new())?;
    Ok(outcome)
}

/// What was found, on standard output.
pub(super) fn report(recovery: &Recovery<'_>, outcome: &Outcome, out: &Path) {
    let mut x = &outcome.best.x[..];
    for variable in recovery.variables() {
        let (found, rest) = x.split_at(variable.initial.len());
        x = rest;
        println!("{}", variable.path);
        println!("  initial    {}", abbreviate(&variable.initial));
        println!("  recovered  {}", abbreviate(found));
        if let Some(target) = &variable.target {
            println!("  true       {}", abbreviate(target));
        }
    }
    let initial = outcome.initial_loss();
    let ratio = if initial > 0.0 {
        format!(" ({:.1e} of the initial {})", outcome.best.loss / initial, short(initial))
    } else {
        String::new()
    };
    println!("loss {}{ratio}", short(outcome.best.loss));
    println!("{}, {:.1} s", outcome.stop.detail, outcome.seconds);
    println!("results in {}", out.display());
}
