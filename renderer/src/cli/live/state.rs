//! What the run and the page tell each other.

use std::ops::ControlFlow;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use serde_json::{Value, json};

use super::course::Course;
use crate::optimize::{Schedule, Settings, Step, Stop, StopReason, Topology};
use crate::recovery::{Recovery, with_topologies};
use crate::scene::{ParameterId, Scene};

/// The factors on learning rates that are taken.
const FACTORS: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

/// Shared by the run and the threads of the server.
pub(in crate::cli) struct State {
    now: Mutex<Now>,
    changed: Condvar,
    ids: Vec<ParameterId>,
    optimizer: &'static str,
    /// Nothing if the optimiser finds the lengths of its steps itself.
    schedule: Option<Schedule>,
    /// The least and the greatest learning rate.
    rates: [f64; 2],
}

/// The run as it is.
struct Now {
    phase: Phase,
    step: Option<Step>,
    /// The numbers of the latest iteration.
    x: Vec<f64>,
    /// The scene whose numbers they are.
    scene: Arc<Scene>,
    /// That of the numbers to come, if triangles of meshes have changed.
    next: Option<Arc<Scene>>,
    course: Course,
    /// A factor on learning rates that was asked for and is not in use yet.
    factor: Option<f64>,
    /// How it ended.
    end: Option<String>,
}

/// Where a run is.
pub(super) struct Position {
    /// The number of the latest iteration.
    pub iteration: Option<u64>,
    scene: Arc<Scene>,
    x: Vec<f64>,
}

impl Position {
    /// The scene with the numbers of these parameters.
    pub fn scene(&self, ids: &[ParameterId]) -> Scene {
        let mut scene = Scene::clone(&self.scene);
        scene.assign_all(ids, &self.x);
        scene
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Running,
    Paused,
    Stopping,
    Stopped,
    Finished,
}

impl State {
    pub fn new(recovery: &Recovery<'_>, settings: &Settings) -> Self {
        let variables = recovery.variables();
        let rates = || variables.iter().flat_map(|variable| &variable.learning_rate).copied();
        let shapes = recovery.ids().iter().map(|&id| {
            // Vertices that come and go have no curves.
            let stays = recovery.remeshings().iter().all(|(remeshed, _)| *remeshed != id);
            stays.then(|| recovery.scene().shape(id))
        });
        let shapes: Vec<_> = shapes.collect();
        let now = Now {
            phase: Phase::Running,
            step: None,
            x: recovery.initial(),
            scene: Arc::new(recovery.scene().clone()),
            next: None,
            course: Course::new(variables, &shapes),
            factor: None,
            end: None,
        };
        Self {
            now: Mutex::new(now),
            changed: Condvar::new(),
            ids: recovery.ids().to_vec(),
            optimizer: settings.optimizer.name(),
            schedule: (!settings.optimizer.finds_step_lengths()).then_some(settings.schedule),
            rates: [rates().fold(f64::INFINITY, f64::min), rates().fold(0.0, f64::max)],
        }
    }

    /// A thread of the server that has panicked has left nothing half done here.
    fn now(&self) -> MutexGuard<'_, Now> {
        self.now.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes in how triangles of meshes have changed before the next iteration.
    pub fn change(&self, topologies: &[Topology]) {
        let scene = self.now().scene.clone();
        let scene = with_topologies(&scene, &self.ids, topologies);
        self.now().next = scene.map(Arc::new);
    }

    /// Takes in where an iteration is.
    pub fn move_to(&self, x: &[f64]) {
        let mut now = self.now();
        if let Some(scene) = now.next.take() {
            now.course.count_anew(self.ids.iter().map(|&id| scene.count(id)));
            now.scene = scene;
        }
        x.clone_into(&mut now.x);
    }

    /// Takes in an iteration, and waits for as long as the page has paused the run and `goes_on` says so. `Break` if the
    /// page stops it.
    pub fn record(&self, step: &Step, goes_on: impl Fn() -> bool) -> ControlFlow<()> {
        let mut now = self.now();
        now.step = Some(*step);
        let Now { x, course, .. } = &mut *now;
        course.record(step.record.iteration, step.record.loss, x);
        while now.phase == Phase::Paused && goes_on() {
            let waited = self.changed.wait_timeout(now, Duration::from_millis(100));
            now = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        if now.phase == Phase::Stopping {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// The factor on learning rates that was asked for since it was last taken.
    pub fn take_factor(&self) -> Option<f64> {
        self.now().factor.take()
    }

    /// Takes in how the run has ended.
    pub fn finish(&self, end: &Stop) {
        let phase = match end.reason {
            StopReason::Interrupted => Phase::Stopped,
            _ => Phase::Finished,
        };
        let mut now = self.now();
        (now.phase, now.end) = (phase, Some(end.detail.clone()));
    }

    /// Pauses the run after its iteration.
    pub fn pause(&self) {
        self.go_from(Phase::Running, Phase::Paused);
    }

    /// Ends a pause.
    pub fn go_on(&self) {
        self.go_from(Phase::Paused, Phase::Running);
    }

    /// Ends the run after its iteration, with a checkpoint.
    pub fn stop(&self) {
        self.go_from(Phase::Running, Phase::Stopping);
        self.go_from(Phase::Paused, Phase::Stopping);
    }

    fn go_from(&self, from: Phase, to: Phase) {
        let mut now = self.now();
        if now.phase == from {
            now.phase = to;
            self.changed.notify_all();
        }
    }

    /// Multiplies the learning rates of the steps to come by a factor.
    ///
    /// # Errors
    ///
    /// If there are none, or the factor is out of range.
    pub fn set_factor(&self, factor: f64) -> Result<(), String> {
        if self.schedule.is_none() {
            return Err(format!("{} finds the lengths of its steps itself", self.optimizer));
        }
        if !FACTORS.contains(&factor) {
            return Err("the factor must be from 1e-9 to 1e9".to_owned());
        }
        self.now().factor = Some(factor);
        Ok(())
    }

    /// Where the run is.
    pub(super) fn position(&self) -> Position {
        let now = self.now();
        let iteration = now.step.map(|step| step.record.iteration);
        Position { iteration, scene: now.scene.clone(), x: now.x.clone() }
    }

    /// Everything but images.
    pub fn json(&self) -> Value {
        let now = self.now();
        let phase = match now.phase {
            Phase::Running => "running",
            Phase::Paused => "paused",
            Phase::Stopping => "stopping",
            Phase::Stopped => "stopped",
            Phase::Finished => "finished",
        };
        let course = now.course.json();
        let step = now.step.map(|step| {
            let Step { record, iterations, learning_rate_factor: in_use, .. } = step;
            let factor = now.factor.unwrap_or(in_use);
            let rate = self.schedule.map(|schedule| {
                let factor = schedule.factor(record.iteration, iterations) * factor;
                self.rates.map(|rate| rate * factor)
            });
            json!({
                "iteration": record.iteration, "iterations": iterations, "loss": record.loss,
                "ratio": step.loss_ratio(), "gradient_norm": record.gradient_norm,
                "seconds": record.seconds, "rates": rate, "factor": factor,
            })
        });
        json!({
            "phase": phase, "end": now.end, "optimizer": self.optimizer,
            "has_rate": self.schedule.is_some(), "step": step, "course": course,
        })
    }
}
