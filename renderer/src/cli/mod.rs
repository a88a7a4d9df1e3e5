//! The command line: arguments in, files and tables out.

mod bench;
mod demo;
mod dial;
mod gradient;
mod optimize;
mod out_folder;
mod output;
mod params;
mod render;
mod report;
mod sampling;
mod strip;
mod tradeoff;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand, ValueEnum};
use output::{print_error, print_stats, print_warnings};

use crate::Error;
use crate::arithmetic::{Arithmetic, Precision};
use crate::experiment::{Experiment, Target, TunedParameter, overlap};
use crate::recovery::Recovery;

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

    /// Pixels that go through the kernels side by side: 1, 8, or 16 (f32 alone) [default: the most]
    #[arg(long, global = true, value_name = "N")]
    lanes: Option<usize>,

    /// Print afterwards how much work it was: rays, nodes, lookups, pullbacks
    #[arg(long, global = true)]
    stats: bool,
}

impl Arguments {
    /// What the kernels are to compute in, if anything is said of it.
    fn arithmetic(&self) -> Result<Option<Arithmetic>, Error> {
        if self.precision.is_none() && self.lanes.is_none() {
            return Ok(None);
        }
        let precision = match self.precision {
            None | Some(PrecisionArgument::F32) => Precision::F32,
            Some(PrecisionArgument::F64) => Precision::F64,
        };
        let Some(lanes) = self.lanes else { return Ok(Some(Arithmetic::fastest(precision))) };
        let arithmetic = Arithmetic::new(precision, lanes);
        arithmetic.map(Some).ok_or_else(|| {
            let possible = match precision {
                Precision::F32 => "1, 8 or 16 with --precision f32",
                Precision::F64 => "1 or 8 with --precision f64",
            };
            Error::new(format_args!("--lanes {lanes}"), format_args!("there can be {possible}"))
        })
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
        let mut experiment = load(&self.scene)?;
        let mut section = experiment.optimize.take().unwrap_or_default();
        if let Some(target) = &self.target {
            section.target = Some(Target::Image(target.clone()));
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
                tuned.push(listed.unwrap_or(TunedParameter {
                    id,
                    learning_rate: None,
                    min: None,
                    max: None,
                }));
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
    let arguments = Arguments::parse();
    let result = run(&arguments);
    if arguments.stats && result.is_ok() {
        print_stats();
    }
    match result {
        Ok(code) => code,
        Err(error) => {
            print_error(&error);
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    if let Some(threads) = arguments.threads {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads.into())
            .build_global()
            .map_err(|error| Error::new("--threads", error))?;
    }
    let chosen = arguments.arithmetic()?;
    let arithmetic = chosen.unwrap_or_default();
    let done = match &arguments.command {
        Some(Command::Gradient(arguments)) => return gradient::run(arguments, chosen),
        None => demo::run(arithmetic),
        Some(Command::Render(arguments)) => render::run(arguments, arithmetic),
        Some(Command::Params(arguments)) => params::run(arguments),
        Some(Command::Optimize(arguments)) => optimize::run(arguments, chosen),
        Some(Command::Report(arguments)) => report::run(arguments),
        Some(Command::Bench(arguments)) => bench::run(arguments, arithmetic),
        Some(Command::Tradeoff(arguments)) => tradeoff::run(arguments),
    };
    done.map(|()| ExitCode::SUCCESS)
}

/// Loads an experiment, and prints what is left out of it.
fn load(path: &Path) -> Result<Experiment, Error> {
    let experiment = Experiment::load(path)?;
    print_warnings(&experiment.warnings);
    Ok(experiment)
}

/// The name of a file without folder and extension, to name results after.
fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "scene".into(), |stem| stem.to_string_lossy().into_owned())
}
