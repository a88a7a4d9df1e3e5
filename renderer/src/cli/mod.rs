//! The command line: arguments in, files and tables out.

mod accuracy;
mod bench;
mod changes;
mod demo;
mod derivative;
mod edges;
mod export;
mod gradient;
mod init;
mod inputs;
mod interrupt;
mod live;
mod optimize;
mod out_folder;
mod output;
mod params;
mod ranks;
mod record;
mod render;
mod report;
mod sampling;
mod strip;
mod tradeoff;
mod until;
mod usage;
mod views;
mod watched;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use changes::Changes;
use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};
use output::{print_error, print_stats, print_warning};

use crate::Error;
use crate::arithmetic::{Arithmetic, Precision};
use crate::experiment::{Experiment, NamedFile, Target, TunedParameter, overlap};
use crate::loss::LossKind;
use crate::memory;
use crate::recovery::Recovery;
use crate::recovery::team::Alone;
use crate::settings::Pass;

/// Renders scenes, and recovers cameras, lights and materials from images.
///
/// Without a command it runs a demonstration: the light of an embedded scene is recovered from one
/// image.
#[derive(Parser)]
#[command(name = "renderer", version)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,

    /// Threads to use [default: one for each core]
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=MOST_THREADS))]
    threads: Option<u16>,

    /// The scalar that the kernels compute in [default: f32]
    #[arg(long, global = true, value_enum)]
    precision: Option<PrecisionArgument>,

    /// Print afterwards how much work it was: rays, nodes, lookups, pullbacks
    #[arg(long, global = true)]
    stats: bool,

    /// The most memory that a scene, an image or a file may need: 500M, 8G [default: three quarters of
    /// the machine's]
    #[arg(long, global = true, value_name = "BYTES", value_parser = bytes)]
    max_memory: Option<u64>,
}

/// An amount of memory: a number, and k, M, G or T for thousands, millions and so on.
fn bytes(text: &str) -> Result<u64, String> {
    let text = text.trim().trim_end_matches('B');
    let units = [('k', 1e3), ('K', 1e3), ('M', 1e6), ('G', 1e9), ('T', 1e12)];
    let unit = units.into_iter().find(|(letter, _)| text.ends_with(*letter));
    let (number, factor) =
        unit.map_or((text, 1.0), |(_, factor)| (&text[..text.len() - 1], factor));
    match number.trim().parse::<f64>() {
        Ok(number) if number >= 0.0 && number.is_finite() => Ok((number * factor) as u64),
        _ => Err("is no amount of memory, such as 500M or 8G".into()),
    }
}

impl Arguments {
    /// What the kernels are to compute in, if anything is said of it.
    fn arithmetic(&self) -> Option<Arithmetic> {
        let precision = match self.precision? {
            PrecisionArgument::F32 => Precision::F32,
            PrecisionArgument::F64 => Precision::F64,
        };
        Some(Arithmetic::fastest(precision))
    }
}

#[derive(Clone, Copy, ValueEnum)]
enum PrecisionArgument {
    F32,
    F64,
}

#[derive(Subcommand)]
enum Command {
    /// Render a scene to an image
    Render(render::Arguments),
    /// List every parameter of a scene: path, shape, value, whether it can be differentiated by
    Params(params::Arguments),
    /// The gradient of the distance to a target image
    Gradient(gradient::Arguments),
    /// Recover parameters from a target image
    Optimize(optimize::Arguments),
    /// Write a commented scene file to start from
    Init(init::Arguments),
    /// Explain the format of scene files
    Scene,
    /// Write a scene for other programs: glTF (.glb), OBJ, or its cameras (transforms.json)
    Export(export::Arguments),
    /// Turn the folder of an optimisation into one HTML page
    Report(report::Arguments),
    /// Measure how long images and gradients of a scene take, and which part of it is what
    Bench(bench::Arguments),
    /// Measure speed against accuracy: what each setting costs on this scene, and what it is worth
    Tradeoff(tradeoff::Arguments),
}

/// What to match and what may vary, for the commands that need both.
#[derive(Args)]
struct Problem {
    /// A scene file (TOML), or a mesh (OBJ, PLY, STL, glTF), which is framed and lit by default
    scene: PathBuf,

    /// The image to match; replaces the target in the scene file
    #[arg(long, value_name = "IMAGE")]
    target: Option<PathBuf>,

    /// A parameter that may vary (can be repeated); replaces those in the scene file
    #[arg(long = "param", value_name = "PATH")]
    parameters: Vec<String>,

    /// How to measure the distance to the target: mean_squared, sum_squared, l1, huber or relative_squared
    /// [default: that of the scene file, or mean_squared]
    #[arg(long, value_name = "NAME", value_parser = LossKind::named)]
    loss: Option<LossKind>,

    #[command(flatten)]
    changes: Changes,

    /// Leave pixels out whose radiance, loss or gradient is not finite, and say so, instead of
    /// stopping at them
    #[arg(long)]
    allow_non_finite: bool,
}

impl Problem {
    /// The optimisation, with what the command line allows.
    fn allowing<'a>(&self, recovery: Recovery<'a>) -> Recovery<'a> {
        if self.allow_non_finite { recovery.allowing_non_finite() } else { recovery }
    }

    /// Loads the scene, with target and parameters as the command line wants them. A parameter that
    /// the scene file lists too keeps its learning rate and bounds.
    fn load(&self) -> Result<Experiment, Error> {
        let mut experiment = self.changes.load(&self.scene)?;
        let mut section = experiment.optimize.take().unwrap_or_default();
        section.loss = self.loss.or(section.loss);
        if let Some(target) = &self.target {
            section.target = Some(Target::Image(target.clone()));
            let by = "--target".to_owned();
            experiment.files.push(NamedFile { path: target.clone(), by });
        }
        if !self.parameters.is_empty() {
            let mut tuned: Vec<TunedParameter> = Vec::new();
            for path in &self.parameters {
                let id = experiment
                    .scene
                    .find_parameter(path)
                    .map_err(|problem| Error::new(format_args!("--param {path}"), problem))?;
                if let Some(problem) = overlap(&experiment.scene, &tuned, id) {
                    return Err(Error::new(format_args!("--param {path}"), problem));
                }
                let listed = section.parameters.iter().find(|tuned| tuned.id == id).cloned();
                tuned.push(listed.unwrap_or(TunedParameter::new(id)));
            }
            section.parameters = tuned;
        }
        experiment.optimize = Some(section);
        Ok(experiment)
    }
}

/// The most threads: far more than help, and few enough to start.
const MOST_THREADS: i64 = 1024;

/// Runs the command line of this process.
pub fn main() -> ExitCode {
    let command = usage::with_negative_numbers(Arguments::command());
    let arguments = command.try_get_matches().and_then(|it| Arguments::from_arg_matches(&it));
    let shares = |arguments: &Arguments| matches!(arguments.command, Some(Command::Optimize(_)));
    let checked = ranks::check(arguments.as_ref().map_or(true, shares));
    let arguments = match arguments {
        Ok(arguments) => arguments,
        Err(error) => return usage::explain(&error),
    };
    let result = checked.and_then(|()| run(&arguments));
    if arguments.stats && result.is_ok() {
        print_stats();
    }
    result.unwrap_or_else(|error| {
        print_error(&error);
        output::failure()
    })
}

fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    if let Some(bytes) = arguments.max_memory {
        memory::set_limit(bytes);
    }
    let team = match &arguments.command {
        Some(Command::Optimize(_)) => ranks::team(),
        _ => Box::new(Alone),
    };
    let threads = arguments.threads.map(usize::from);
    if let Some(threads) = threads.or_else(|| ranks::threads(team.as_ref())) {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build_global()
            .map_err(|error| Error::new("--threads", error))?;
    }
    let chosen = arguments.arithmetic();
    let arithmetic = chosen.unwrap_or_default();
    match &arguments.command {
        None => demo::run(arithmetic)?,
        Some(Command::Render(arguments)) => render::run(arguments, arithmetic)?,
        Some(Command::Params(arguments)) => params::run(arguments)?,
        Some(Command::Gradient(arguments)) => return gradient::run(arguments, chosen),
        Some(Command::Optimize(arguments)) => {
            return optimize::run(arguments, chosen, team.as_ref());
        }
        Some(Command::Init(arguments)) => init::run(arguments)?,
        Some(Command::Scene) => init::explain()?,
        Some(Command::Export(arguments)) => export::run(arguments)?,
        Some(Command::Report(arguments)) => report::run(arguments)?,
        Some(Command::Bench(arguments)) => bench::run(arguments, arithmetic)?,
        Some(Command::Tradeoff(arguments)) => tradeoff::run(arguments)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// Loads an experiment, and prints what is left out of it.
fn load(path: &Path) -> Result<Experiment, Error> {
    load_to_show(path, &[Pass::Radiance])
}

/// Loads an experiment, and prints what is left out of it that these passes would show.
fn load_to_show(path: &Path, passes: &[Pass]) -> Result<Experiment, Error> {
    let mut experiment = Experiment::load(path)?;
    let by = "the command line".to_owned();
    experiment.files.push(NamedFile { path: path.to_owned(), by });
    let shows_light = passes.contains(&Pass::Radiance);
    let warnings = experiment.warnings.iter();
    warnings.filter(|warning| shows_light || !warning.is_of_radiance).for_each(print_warning);
    Ok(experiment)
}

/// The name of a file without folder and extension, to name results after.
fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "scene".into(), |stem| stem.to_string_lossy().into_owned())
}
