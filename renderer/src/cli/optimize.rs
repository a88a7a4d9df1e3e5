//! `renderer optimize`

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use renderer_files::disk::create_folder;
use serde_json::{Map, Value, json};

use super::accuracy::AccuracyArguments;
use super::edges::recommend_edges;
use super::inputs::inputs;
use super::interrupt::Interrupt;
use super::live::{LiveArguments, LiveServer};
use super::out_folder::{check_out_folder, check_unfinished, lock, remove_earlier_results};
use super::output::{abbreviate, print, print_error, print_note, print_warning, short};
use super::strip::save_strip;
use super::views::{quality_lines, save_views};
use super::watched::Watched;
use super::{Problem, record, stem};
use crate::arithmetic::Arithmetic;
use crate::experiment::Experiment;
use crate::files::{save_png, save_scene};
use crate::optimize::{
    Checkpointing, Optimization, Optimizer, Outcome, Quiet, Schedule, Settings, Start, StopReason,
    progress, write_report,
};
use crate::recovery::Recovery;
use crate::recovery::team::{Team, agree};
use crate::remesh::{self_intersecting, turned_over};
use crate::scene::{ParameterId, Scene};
use crate::{Error, Image};

#[derive(clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    problem: Problem,

    #[command(flatten)]
    accuracy: AccuracyArguments,

    /// Folder for the results [default: out/NAME-OF-SCENE]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Stop after so many steps
    #[arg(long, value_name = "N")]
    iterations: Option<u64>,

    /// Stop when the loss is no larger
    #[arg(long, value_name = "X", value_parser = tolerance)]
    tolerance: Option<f64>,

    /// The method: adam, adamw, sgd (needs a learning rate), rmsprop, lbfgs or lm (for few numbers); one that the scene
    /// file names too keeps the numbers given there
    #[arg(long, value_name = "NAME", value_parser = Optimizer::named)]
    optimizer: Option<Optimizer>,

    /// How the learning rates change in the course of the run: constant, exponential, step or cosine
    #[arg(long, value_name = "NAME", value_parser = Schedule::named)]
    schedule: Option<Schedule>,

    /// The learning rate of parameters that the scene file gives none of their own; for methods that take one, which lm
    /// and lbfgs do not
    #[arg(long, value_name = "X", value_parser = learning_rate)]
    learning_rate: Option<f64>,

    /// Continue a run that was interrupted, or a finished one to more --iterations; a schedule that is not constant,
    /// and coarse levels, keep their number
    #[arg(long)]
    resume: bool,

    /// Replace the run that the folder holds, finished or not, and its results
    #[arg(long, conflicts_with = "resume")]
    overwrite: bool,

    #[command(flatten)]
    live: LiveArguments,
}

pub(super) fn run(
    arguments: &Arguments,
    chosen: Option<Arithmetic>,
    team: &dyn Team,
) -> Result<ExitCode, Error> {
    let experiment = agree(team, arguments.experiment(team), |_| String::new())?;
    let scene_path = &arguments.problem.scene;
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(stem(scene_path)));
    let prepared = arguments.prepare(&experiment, &out, chosen, team);
    let (recovery, live) = agree(team, prepared, |(recovery, _)| recovery.mark())?;
    if team.rank() > 0 {
        recovery.serve(team);
        return Ok(ExitCode::SUCCESS);
    }
    recovery.noisy_materials().iter().for_each(print_warning);
    if team.size() > 1 {
        let (ranks, threads) = (team.size(), rayon::current_num_threads());
        print_note(format_args!("{ranks} ranks; threads of this one: {threads}"));
        let images = recovery.images_at_a_time();
        if images < ranks {
            let problem = "more ranks than images in an iteration";
            print_warning(format_args!("mpirun: {problem}: {} have nothing to do", ranks - images));
        }
    }
    let earlier = arguments.earlier();
    let lead = || recover(&experiment, &recovery, team, &out, earlier, live);
    let outcome = recovery.lead(team, lead).map_err(|error| in_file(scene_path, error))?;
    recovery.left_out().iter().for_each(print_warning);
    let found = recovery.with_topologies(&outcome.topologies)?;
    print(report(&found, &outcome, &out))?;
    if outcome.stop.reason == StopReason::Interrupted {
        print_note("go on with the same command and --resume");
        return Ok(ExitCode::from(INTERRUPTED));
    }
    if outcome.stop.reason.is_failure() {
        print_error(&failure(scene_path, &outcome));
        return Ok(ExitCode::from(FAILED));
    }
    if arguments.accuracy.leaves_edges_open() {
        recommend_edges(&found, &outcome.best);
    }
    Ok(ExitCode::SUCCESS)
}

/// What becomes of a run that the folder for the results holds.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Earlier {
    /// It stands in the way.
    Kept,
    /// It goes on.
    Resumed,
    /// It makes room.
    Replaced,
}

impl Arguments {
    fn earlier(&self) -> Earlier {
        match (self.resume, self.overwrite) {
            (true, _) => Earlier::Resumed,
            (false, true) => Earlier::Replaced,
            (false, false) => Earlier::Kept,
        }
    }

    /// What the scene file and the command line say.
    fn experiment(&self, team: &dyn Team) -> Result<Experiment, Error> {
        if team.size() > 1 && self.accuracy.is_selecting() {
            let problem = "measures times in one process: take it without mpirun, and give the settings \
                           that it names here";
            return Err(Error::new("--accuracy", problem));
        }
        let mut experiment = self.problem.load()?;
        if let Some(section) = &mut experiment.optimize {
            section.iterations = self.iterations.or(section.iterations);
            section.tolerance = self.tolerance.or(section.tolerance);
            section.learning_rate = self.learning_rate.or(section.learning_rate);
            section.optimizer = method(self.optimizer, section.optimizer, Optimizer::name);
            section.schedule = method(self.schedule, section.schedule, Schedule::name);
            if self.learning_rate.is_some() {
                let check = section.optimizer.unwrap_or_default().check_learning_rate();
                check.map_err(|problem| Error::new("--learning-rate", problem))?;
            }
        }
        Ok(experiment)
    }

    /// What a rank needs before it begins; rank 0 alone looks after the folder and the page.
    fn prepare<'a>(
        &self,
        experiment: &'a Experiment,
        out: &Path,
        chosen: Option<Arithmetic>,
        team: &dyn Team,
    ) -> Result<(Recovery<'a>, Option<LiveServer>), Error> {
        let scene_path = &self.problem.scene;
        if team.rank() > 0 {
            // Rank 0 ends the run, and the others with it.
            Interrupt::new()?;
            return Ok((self.accuracy.recovery(&self.problem, experiment, chosen)?, None));
        }
        check_out_folder(out, inputs(experiment))?;
        let recovery = self.accuracy.recovery(&self.problem, experiment, chosen)?;
        Ok((recovery, self.live.bind(scene_path)?))
    }
}

/// An error of the section `[optimize]`, in the file that has it.
fn in_file(scene: &Path, mut error: Error) -> Error {
    if error.place.starts_with("optimize.") {
        error.place = format!("{}: {}", scene.display(), error.place);
    }
    error
}

/// The exit code of a run that was asked to end: that of a process that the interrupt signal ended.
const INTERRUPTED: u8 = 130;

/// The exit code of a run that came to numbers that are not finite.
const FAILED: u8 = 1;

/// Why a run came to no good end, and what is left of it.
fn failure(scene: &Path, outcome: &Outcome) -> Error {
    let problem = format!(
        "{}; what iteration {} had found is kept: smaller learning rates may help",
        outcome.stop.detail, outcome.best.iteration
    );
    Error::not_finite(scene.display(), problem)
}

/// What the command line names, with the numbers of the scene file if it names the same.
fn method<T>(named: Option<T>, listed: Option<T>, name: fn(&T) -> &'static str) -> Option<T> {
    match (named, listed) {
        (Some(named), Some(listed)) if name(&named) == name(&listed) => Some(listed),
        (named, listed) => named.or(listed),
    }
}

/// What a learning rate may be: a number above 0.
fn learning_rate(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err("must be above 0".to_owned()) }
}

/// A loss to reach: a number, 0 or more.
fn tolerance(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    if value >= 0.0 { Ok(value) } else { Err("must be 0 or more".to_owned()) }
}

/// Optimises, as rank 0 of a team, and leaves everything about it in the folder `out`; a page may watch.
pub(super) fn recover(
    experiment: &Experiment,
    recovery: &Recovery<'_>,
    team: &dyn Team,
    out: &Path,
    earlier: Earlier,
    live: Option<LiveServer>,
) -> Result<Outcome, Error> {
    let mut settings = recovery.settings();
    settings.checkpointing = Some(Checkpointing {
        folder: out.to_owned(),
        every: Duration::from_secs(3),
        resume: earlier == Earlier::Resumed,
        problem: recovery.fingerprint(),
    });

    // Whatever is wrong shows before anything is written: the settings, the checkpoint, and a loss
    // or a gradient that is not finite.
    let is_fresh = earlier == Earlier::Replaced
        || Optimization::start(recovery.variables(), &settings)?.beginning() == Start::Fresh;
    if is_fresh {
        if earlier != Earlier::Replaced {
            check_unfinished(out)?;
        }
        let only_evaluate = Settings { iterations: 0, checkpointing: None, ..settings.clone() };
        recovery.run_shared(team, &only_evaluate, &mut Quiet)?;
    }
    if is_fresh && earlier == Earlier::Resumed {
        print_note(format_args!("{}: no run to resume; a new one begins", out.display()));
    }
    create_folder(out)?;
    let _lock = lock(out)?;
    if is_fresh {
        remove_earlier_results(out)?;
    }
    let target = &recovery.targets()[0];
    let save = |image: &Image, file| save_png(&target.picture(image), &out.join(file));
    save(&target.image, "target.png")?;
    save(&recovery.render(&experiment.scene), "initial.png")?;

    let interrupt = Interrupt::new()?;
    let page = live.map(|live| live.start(recovery, &settings));
    let mut observer = Watched { observer: progress(), page, interrupt };
    let outcome = recovery.run_shared(team, &settings, &mut observer)?;

    let found = recovery.with_topologies(&outcome.topologies)?;
    let recovered = found.scene_at(&outcome.best.x);
    let image = recovery.render(&recovered);
    save(&image, "final.png")?;
    let mut extra = Map::new();
    if let Some(difference) = target.difference(&image) {
        let largest = record::save_difference(difference, out)?;
        extra.insert("largest_difference".to_owned(), largest);
    }
    if !recovered.views().is_empty() {
        extra.insert("views".to_owned(), save_views(recovery, &recovered, out)?);
    }
    save_scene(&recovered, out)?;
    extra.extend([
        ("parameters".to_owned(), surfaces(&found, &recovered)),
        ("settings".to_owned(), record::settings(recovery, &settings)),
        ("strip".to_owned(), save_strip(&found, &outcome.trajectory, out)?),
        ("pictures".to_owned(), record::save_pictures(recovery, &recovered, out)?),
    ]);
    write_report(out, found.variables(), &outcome, extra)?;
    Ok(outcome)
}

/// The triangles of meshes that have varied, for the entries of their parameters in the summary.
fn surfaces(recovery: &Recovery<'_>, recovered: &Scene) -> Value {
    let entry = |&id: &ParameterId| {
        let mesh = &recovered.meshes()[id.whole_mesh()?];
        let entry = json!({
            "triangles": mesh.triangles.len(),
            "turned_over": turned_over(mesh),
            "self_intersecting": self_intersecting(mesh),
        });
        Some((recovered.path(id).to_string(), entry))
    };
    Value::Object(recovery.ids().iter().filter_map(entry).collect())
}

/// What was found, with the triangles that meshes have at the end.
pub(super) fn report(recovery: &Recovery<'_>, outcome: &Outcome, out: &Path) -> String {
    let recovered = recovery.scene_at(&outcome.best.x);
    let mut lines = Vec::new();
    for (variable, &id) in recovery.variables().iter().zip(recovery.ids()) {
        let found = recovered.get(id);
        lines.push(variable.path.clone());
        // Triangles that have changed have other vertices than those that the run began with.
        if !outcome.topologies.iter().any(|of| recovery.ids()[of.variable] == id) {
            lines.push(format!("  initial    {}", abbreviate(&variable.initial)));
        }
        lines.push(format!("  recovered  {}", abbreviate(&found)));
        if let Some(mesh) = id.whole_mesh() {
            let mesh = &recovered.meshes()[mesh];
            let (count, turned, crossed) =
                (mesh.triangles.len(), turned_over(mesh), self_intersecting(mesh));
            lines.push(format!(
                "  triangles  {count}, of them turned over {turned}, intersecting others {crossed}"
            ));
        }
        if let Some(target) = &variable.target {
            lines.push(format!("  true       {}", abbreviate(target)));
        }
    }
    lines.extend(quality_lines(recovery, &recovered));
    let initial = outcome.initial_loss;
    let ratio = if initial <= 0.0 {
        String::new()
    } else if outcome.best.loss == initial {
        " (the initial one: nothing lower was found)".to_owned()
    } else {
        // What is close to the initial one may be above it.
        let ratio = outcome.best.loss / initial;
        let ratio = if ratio > 0.5 { format!("{ratio:.3}") } else { format!("{ratio:.1e}") };
        format!(" ({ratio} of the initial {})", short(initial))
    };
    lines.push(format!("loss {}{ratio}", short(outcome.best.loss)));
    lines.push(format!("{}, {:.1} s", outcome.stop.detail, outcome.seconds));
    lines.push(format!("results in {}", out.display()));
    lines.join("\n")
}
