//! The state of a run, and the file that keeps it.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::mem::replace;
use std::path::PathBuf;

use renderer_core::Error;
use renderer_files::disk::{create_folder, write_atomically};
use serde::{Deserialize, Serialize};

use super::optimizer::Method;
use super::trajectory::Trajectory;
use super::{
    CHECKPOINT_FILE, Change, Checkpointing, Fingerprint, Point, Record, Schedule, Settings, Starts,
    Stop, StopReason, Topology,
};

/// Changes whenever the file or the arithmetic of the optimiser does.
const FORMAT: u32 = 6;

/// The part of its loss that a step on a coarse level leaves at most, if the level goes on.
const LEVEL_GOES_ON: f64 = 29.0 / 30.0;

/// Everything a run needs to continue. All numbers are finite, since JSON has no others.
#[derive(Clone, Serialize, Deserialize)]
pub(super) struct State {
    /// Steps taken.
    pub iteration: u64,
    /// Evaluations made, over all parts of the run.
    pub evaluations: u64,
    /// Seconds of work.
    pub seconds: f64,
    /// Where the next evaluation takes place; for a finished run, where the last one did.
    pub x: Vec<f64>,
    pub method: Method,
    /// How many levels it is away from the finest, and where each finer one began.
    pub level: u32,
    pub finer_from: Vec<u64>,
    /// The loss at the initial parameters, of the finest level.
    pub initial_loss: Option<f64>,
    /// The lowest loss so far of the level that it is of; the first of them.
    pub best: Option<Point>,
    pub best_level: u32,
    /// The latest usable evaluation.
    pub last: Option<Point>,
    /// The history of the run, one entry for each usable evaluation.
    pub history: Vec<Record>,
    pub trajectory: Trajectory,
    /// The meshes whose triangles have changed; most runs have none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub topologies: Vec<Topology>,
    /// The iteration before which they have changed last.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub changed_at: Option<u64>,
    /// The factors that an observer has put on learning rates, and the iterations after which; most runs have none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub learning_rate_factors: Vec<(u64, f64)>,
    pub stop: Option<Stop>,
}

/// The parts of a state that are of its elements.
pub(super) struct Replaced {
    topologies: Vec<Topology>,
    x: Vec<f64>,
    method: Method,
}

impl State {
    pub fn new(x: Vec<f64>, settings: &Settings) -> Self {
        Self {
            iteration: 0,
            evaluations: 0,
            seconds: 0.0,
            method: Method::new(&settings.optimizer, x.len()),
            x,
            level: settings.coarse_to_fine,
            finer_from: Vec::new(),
            initial_loss: None,
            best: None,
            best_level: settings.coarse_to_fine,
            last: None,
            history: Vec::new(),
            trajectory: Trajectory::new(),
            topologies: Vec::new(),
            changed_at: None,
            learning_rate_factors: Vec::new(),
            stop: None,
        }
    }

    /// What learning rates are multiplied by, beside the schedule.
    pub fn learning_rate_factor(&self) -> f64 {
        self.learning_rate_factors.last().map_or(1.0, |(_, factor)| *factor)
    }

    /// Takes in an evaluation at `x`. The lowest loss of samples is that of the easiest one, so then the
    /// latest is the best.
    pub fn record(&mut self, record: Record, is_sampled: bool) {
        let Record { iteration, loss, .. } = record;
        let point = Point { iteration, loss, x: self.x.clone() };
        let has_changed = self.changed_at == Some(iteration);
        if has_changed {
            self.trajectory.restart();
        }
        let is_first = is_sampled || has_changed || self.level < self.best_level;
        if self.best.as_ref().is_none_or(|best| is_first || loss < best.loss) {
            self.best_level = self.level;
            self.best = Some(point.clone());
        }
        self.trajectory.record(&point);
        self.last = Some(point);
        self.history.push(record);
    }

    /// Whether the last step lowered the loss of its level so little that a finer one says more, and its method
    /// would search ever longer for lower ones: the loss of one that does not compare them may rise and fall.
    pub fn is_level_flat(&self, settings: &Settings) -> bool {
        match self.history_of_level() {
            [.., before, after] if settings.optimizer.finds_step_lengths() => {
                after.loss > LEVEL_GOES_ON * before.loss
            }
            _ => false,
        }
    }

    /// The iterations of this level.
    pub fn history_of_level(&self) -> &[Record] {
        let begun = self.finer_from.last().copied().unwrap_or(0) as usize;
        &self.history[begun.min(self.history.len())..]
    }

    /// Goes on one level finer. What a method learned of the steps of another level is no longer true.
    pub fn refine(&mut self, settings: &Settings) {
        self.level -= 1;
        self.finer_from.push(self.iteration);
        if settings.optimizer.finds_step_lengths() {
            self.method = Method::new(&settings.optimizer, self.x.len());
        }
    }

    /// Goes on with other elements; what there was in their place.
    pub fn change(&mut self, change: Change) -> Replaced {
        let Change { topologies, x, carry, .. } = change;
        let method = self.method.clone();
        self.method.carry(&carry);
        self.changed_at = Some(self.iteration);
        let topologies = replace(&mut self.topologies, topologies);
        Replaced { topologies, x: replace(&mut self.x, x), method }
    }

    /// Goes back to the elements before.
    pub fn go_back(&mut self, before: Replaced) {
        Replaced { topologies: self.topologies, x: self.x, method: self.method } = before;
    }

    /// Returns `true` if no further iteration was needed when the checkpoint was written.
    pub fn is_finished(&self) -> bool {
        self.stop.as_ref().is_some_and(|stop| stop.reason != StopReason::Interrupted)
    }

    /// Whether the parts agree with each other, for `len` elements at the beginning of the run.
    fn is_coherent(&self, len: usize) -> bool {
        let len = if self.topologies.is_empty() { len } else { self.x.len() };
        let point = |point: &Option<Point>| point.as_ref().is_some_and(|p| p.x.len() == len);
        let evaluated_here = match &self.stop {
            Some(Stop { reason, .. }) => matches!(
                reason,
                StopReason::Tolerance
                    | StopReason::GradientTolerance
                    | StopReason::Iterations
                    | StopReason::LineSearch
            ),
            None => false,
        };
        self.x.len() == len
            && self.method.fits(len)
            && point(&self.best)
            && point(&self.last)
            && self.initial_loss.is_some()
            && self.history.len() as u64 == self.iteration + u64::from(evaluated_here)
            && (0..).zip(&self.history).all(|(i, record)| record.iteration == i)
    }

    /// Makes ready to continue under `settings`, which may stop the run at another iteration.
    ///
    /// # Errors
    ///
    /// The iteration and the reason, if a run under `settings` would have stopped before.
    fn continue_under(&mut self, settings: &Settings) -> Result<(), (u64, Stop)> {
        // Before the finest level nothing but the number of iterations stops a run.
        let finest_from = match self.level {
            0 => self.finer_from.last().copied().unwrap_or(0),
            _ => u64::MAX,
        };
        let stops = |iteration: u64| {
            let start = if iteration < finest_from { 0 } else { finest_from };
            let stop = Stop::at(&self.history[start as usize..=iteration as usize], settings);
            stop.filter(|stop| iteration >= finest_from || stop.reason == StopReason::Iterations)
        };
        let earlier = |iteration| Some((iteration, stops(iteration)?));
        if let Some(earlier) = (0..self.iteration).find_map(earlier) {
            return Err(earlier);
        }
        let stopped_by_criterion = self.history.len() as u64 > self.iteration;
        if let Some(stop) = stopped_by_criterion.then(|| stops(self.iteration)).flatten() {
            self.stop = Some(stop);
        } else if self.stop.as_ref().is_some_and(|stop| stop.reason == StopReason::LineSearch) {
            // No criterion changes what the line search would find.
        } else if stopped_by_criterion || !self.is_finished() {
            // The evaluation that met the old criterion is repeated, to step from it.
            self.stop = None;
            self.history.truncate(self.history.len() - usize::from(stopped_by_criterion));
        }
        Ok(())
    }
}

/// What the file holds.
#[derive(Serialize, Deserialize)]
struct Checkpoint<S> {
    format: u32,
    /// Fingerprint of the problem.
    problem: String,
    /// What the run was started with, or its fingerprints, by [name](STARTED_WITH). Earlier formats have none.
    #[serde(default)]
    started_with: BTreeMap<String, String>,
    /// Fingerprint of the state as JSON: tells a disk that lost bits.
    checksum: String,
    state: S,
}

/// The checkpoint file of one run.
pub(super) struct CheckpointFile {
    path: PathBuf,
    problem: String,
    started_with: BTreeMap<String, String>,
}

/// What a run has to be resumed with, and what is said where it is not.
const STARTED_WITH: [(&str, &str); 6] = [
    ("variables", "other parameters, initial values, learning rates or bounds"),
    ("optimizer", "another optimizer"),
    ("schedule", "another schedule"),
    ("iterations", "another number of iterations, which its schedule or its coarse levels span"),
    ("coarse_to_fine", "another number of coarse levels"),
    ("starts", "other starts"),
];

impl CheckpointFile {
    /// `variables` is the fingerprint of the variables.
    pub fn new(checkpointing: &Checkpointing, variables: Fingerprint, settings: &Settings) -> Self {
        let Settings { schedule, coarse_to_fine, iterations, .. } = settings;
        let spans = *coarse_to_fine > 0 || *schedule != Schedule::Constant;
        let starts = settings.starts.map(|Starts { count, seed }| format!("{count} of {seed}"));
        let marks = [
            variables.to_string(),
            settings.optimizer.mark(Fingerprint::new()).to_string(),
            schedule.mark(Fingerprint::new()).to_string(),
            if spans { iterations.to_string() } else { String::new() },
            coarse_to_fine.to_string(),
            starts.unwrap_or_default(),
        ];
        let names = STARTED_WITH.map(|(name, _)| name.to_owned());
        Self {
            path: checkpointing.folder.join(CHECKPOINT_FILE),
            problem: checkpointing.problem.to_string(),
            started_with: names.into_iter().zip(marks).collect(),
        }
    }

    /// Writes `state`, whole or not at all, into the folder, which is made if need be.
    pub fn save(&self, state: &State) -> Result<(), Error> {
        if let Some(folder) = self.path.parent() {
            create_folder(folder)?;
        }
        let json = |error| {
            let problem = format!("the checkpoint cannot be written: {error}");
            Error::new(self.path.display(), problem)
        };
        let checkpoint = Checkpoint {
            format: FORMAT,
            problem: self.problem.clone(),
            started_with: self.started_with.clone(),
            checksum: checksum(state).map_err(json)?,
            state,
        };
        write_atomically(&self.path, &serde_json::to_vec(&checkpoint).map_err(json)?)
    }

    /// The state that the folder holds, whatever run it belongs to, or nothing.
    pub fn load(
        &self,
        len: usize,
        settings: &Settings,
        resume: bool,
    ) -> Result<Option<State>, Error> {
        let bytes = match fs::read(&self.path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => {
                let problem = format!("the checkpoint cannot be read: {error}");
                return Err(self.error(problem));
            }
        };
        let checkpoint: Checkpoint<State> =
            serde_json::from_slice(&bytes).map_err(|error| self.damaged(&error.to_string()))?;
        let mut state = checkpoint.state;
        if checksum(&state).ok().as_ref() != Some(&checkpoint.checksum) {
            return Err(self.damaged("its checksum is wrong"));
        }

        if !resume {
            return if state.is_finished() { Ok(None) } else { Err(self.unfinished(&state)) };
        }
        self.check_same_run(&checkpoint.problem, &checkpoint.started_with, checkpoint.format)?;
        if !state.is_coherent(len) {
            return Err(self.incoherent());
        }
        state.continue_under(settings).map_err(|(iteration, stop)| {
            self.error(format!(
                "the run that it holds cannot be resumed with these stopping criteria: they would \
                 have stopped it at iteration {iteration} ({})",
                stop.detail
            ))
        })?;
        Ok(Some(state))
    }

    fn check_same_run(
        &self,
        problem: &str,
        started_with: &BTreeMap<String, String>,
        format: u32,
    ) -> Result<(), Error> {
        let differs = |name: &str| started_with.get(name) != self.started_with.get(name);
        let other: Vec<&str> =
            STARTED_WITH.iter().filter(|(name, _)| differs(name)).map(|(_, what)| *what).collect();
        let different = if format != FORMAT {
            format!("was written by another version (format {format}, not {FORMAT})")
        } else if problem != self.problem {
            "belongs to another problem: the scene, the target, the loss, or how images are rendered for it (their size, samples, precision, edges) has changed".to_owned()
        } else if !other.is_empty() {
            format!("belongs to a run with {}", other.join(", and "))
        } else {
            return Ok(());
        };
        Err(self.error(format!(
            "the checkpoint {different}; restore what it was started with, or start anew in \
             another folder"
        )))
    }

    fn unfinished(&self, state: &State) -> Error {
        self.error(format!(
            "the folder holds an unfinished run, which goes on at iteration {}; resume it (--resume), \
             use another folder, or replace the run (--overwrite)",
            state.iteration
        ))
    }

    /// Parts that do not fit together.
    pub fn incoherent(&self) -> Error {
        self.damaged("its parts do not fit together")
    }

    fn damaged(&self, how: &str) -> Error {
        self.error(format!("the checkpoint is damaged ({how}); remove the file to start over"))
    }

    fn error(&self, problem: String) -> Error {
        Error::new(self.path.display(), problem)
    }
}

fn checksum(state: &State) -> serde_json::Result<String> {
    Ok(Fingerprint::new().bytes(&serde_json::to_vec(state)?).to_string())
}
