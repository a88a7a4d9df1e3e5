//! The loop.

use std::borrow::Cow;
use std::time::{Duration, Instant};

use renderer_core::Error;

use super::checkpoint::{CheckpointFile, Replaced, State};
use super::variable::{self, Flat};
use super::{
    Change, Evaluation, Objective, Observer, Outcome, Point, Record, Settings, Start, Step, Stop,
    StopReason, Topology, Variable,
};

/// An optimisation that is ready to run: its input is checked and its checkpoint, if any, is read.
pub struct Optimization<'a> {
    variables: Cow<'a, [Variable]>,
    settings: &'a Settings,
    flat: Flat,
    file: Option<CheckpointFile>,
    state: State,
    start: Start,
}

impl<'a> Optimization<'a> {
    /// Checks the input and reads the checkpoint. Writes nothing: call it before anything else
    /// that writes into the output folder.
    ///
    /// # Errors
    ///
    /// If a variable or a setting is unusable (the place is its path or field), or if the output
    /// folder holds a checkpoint that stands in the way (the place is that file).
    pub fn start(variables: &'a [Variable], settings: &'a Settings) -> Result<Self, Error> {
        settings.check()?;
        let flat = Flat::new(variables)?;
        settings.optimizer.check_count(flat.x.len())?;
        let preconditioned =
            variables.iter().find_map(|of| of.preconditioner.as_ref().zip(Some(of)));
        if let (Some((preconditioner, of)), true) =
            (preconditioned, settings.optimizer.finds_step_lengths())
        {
            let problem = format!(
                "{} learns by itself which steps are easy; leave the preconditioner of {} out ({})",
                settings.optimizer.name(),
                of.path,
                preconditioner.name()
            );
            return Err(Error::new("optimize.optimizer", problem));
        }
        let mut stored = None;
        let mut file = None;
        if let Some(checkpointing) = &settings.checkpointing {
            let fingerprint = variable::fingerprint(variables);
            let found = CheckpointFile::new(checkpointing, fingerprint, settings);
            stored = found.load(flat.x.len(), settings, checkpointing.resume)?;
            file = Some(found);
        }
        let start = match &stored {
            None => Start::Fresh,
            Some(state) if state.is_finished() => Start::Finished { iteration: state.iteration },
            Some(state) => Start::Resumed { iteration: state.iteration },
        };
        let state = stored.unwrap_or_else(|| State::new(flat.x.clone(), settings));
        Ok(Self { variables: Cow::Borrowed(variables), settings, flat, file, state, start })
    }

    /// How the run will begin.
    pub fn beginning(&self) -> Start {
        self.start
    }

    /// Runs to the end. A finished run returns its result without an evaluation.
    ///
    /// # Errors
    ///
    /// If the loss or the gradient at the initial parameters is not finite (nothing is left
    /// behind), what is optimised cannot be [changed](Objective::change), or a checkpoint cannot be written.
    ///
    /// # Panics
    ///
    /// If the gradient of `objective` has another length than the variables together.
    pub fn run(
        mut self,
        objective: &mut dyn Objective,
        observer: &mut dyn Observer,
    ) -> Result<Outcome, Error> {
        observer.start(self.start);
        let stop = match self.state.stop.take() {
            Some(stop) => stop,
            None => self.iterate(objective, observer)?,
        };
        let may_be_initial =
            self.begins_elsewhere() && self.state.best_level == 0 && !self.settings.is_sampled;
        let State { best, last, initial_loss, history, trajectory, .. } = self.state;
        let State { topologies, evaluations, seconds, .. } = self.state;
        let (Some(best), Some(last), Some(initial_loss)) = (best, last, initial_loss) else {
            // Nothing was evaluated, and the only reason for that is the initial point.
            return Err(Error::not_finite("optimize", stop.detail));
        };
        // On the way through coarser levels it may have got lost.
        let best = match may_be_initial && topologies.is_empty() && initial_loss < best.loss {
            true => Point { iteration: 0, loss: initial_loss, x: self.flat.x },
            false => best,
        };
        let trajectory = trajectory.finish(&last);
        let start = self.start;
        let outcome = Outcome {
            best,
            topologies,
            last,
            history,
            trajectory,
            initial_loss,
            stop,
            evaluations,
            seconds,
            start,
        };
        observer.finish(&outcome);
        Ok(outcome)
    }

    /// Whether iteration 0 is another evaluation than that of the initial parameters, whose loss is compared with
    /// others.
    fn begins_elsewhere(&self) -> bool {
        let Settings { coarse_to_fine, starts, .. } = self.settings;
        *coarse_to_fine > 0 || starts.is_some()
    }

    /// Iterates until something stops it, and leaves a checkpoint of that.
    fn iterate(
        &mut self,
        objective: &mut dyn Objective,
        observer: &mut dyn Observer,
    ) -> Result<Stop, Error> {
        let clock = Instant::now();
        let seconds_before = self.state.seconds;
        let mut watched = Duration::ZERO;
        let mut last_saved: Option<Instant> = None;
        let mut objective = Counted { objective, evaluations: self.state.evaluations };
        let mut known: Option<Evaluation> = None;
        if let Some(stop) = self.begin(&mut objective, observer)? {
            return self.stop(stop, &mut objective);
        }
        loop {
            let State { iteration, level, .. } = self.state;
            if level > 0 && iteration >= self.settings.end_of(level) {
                self.state.refine(self.settings);
                known = None;
                continue;
            }
            let before = self.change(&mut objective, observer)?;
            objective.begin(iteration, level);
            let evaluation = known.take().unwrap_or_else(|| objective.evaluate(&self.state.x));
            self.state.seconds = seconds_before + (clock.elapsed() - watched).as_secs_f64();
            self.state.evaluations = objective.evaluations;
            if let Some(stop) = self.non_finite(&evaluation, &mut objective) {
                if let Some(before) = before {
                    // What was found is of these.
                    self.state.go_back(before);
                }
                return self.stop(stop, &mut objective);
            }

            let record = Record {
                iteration,
                loss: evaluation.loss,
                gradient_norm: self.flat.projected_norm(&self.state.x, &evaluation.gradient),
                seconds: self.state.seconds,
            };
            self.state.record(record, self.settings.is_sampled);
            let iterations = self.settings.iterations;
            let initial_loss = *self.state.initial_loss.get_or_insert(record.loss);
            let learning_rate_factor = self.state.learning_rate_factor();
            let step = Step { record, level, initial_loss, iterations, learning_rate_factor };
            let begun = Instant::now();
            observer.parameters(&self.state.x);
            let interrupted = observer.step(&step).is_break();
            watched += begun.elapsed();
            if let Some(factor) = observer.learning_rate_factor() {
                self.state.learning_rate_factors.push((iteration, factor));
                // What nobody can repeat must not be lost.
                last_saved = None;
            }
            let stop = Stop::at(self.state.history_of_level(), self.settings);
            let mut is_level_done = level > 0 && self.state.is_level_flat(self.settings);
            match stop {
                Some(stop) if level == 0 || stop.reason == StopReason::Iterations => {
                    return self.stop(stop, &mut objective);
                }
                Some(_) => is_level_done = true,
                None => {}
            }

            // From here to the next evaluation the state is one that a checkpoint can hold.
            let factor = self.settings.schedule.factor(iteration, self.settings.iterations)
                * self.state.learning_rate_factor();
            let State { method, x, .. } = &mut self.state;
            if !is_level_done {
                match method.step(&self.flat, factor, x, evaluation, &mut objective) {
                    Ok(evaluation) => known = evaluation,
                    Err(_) if level > 0 => is_level_done = true,
                    Err(why) => {
                        let stop = Stop::line_search(iteration, &why);
                        return self.stop(stop, &mut objective);
                    }
                }
            }
            self.state.iteration += 1;
            if is_level_done {
                self.state.refine(self.settings);
                known = None;
            }
            if interrupted {
                return self.stop(Stop::interrupted(iteration), &mut objective);
            }
            if let (Some(file), Some(checkpointing)) = (&self.file, &self.settings.checkpointing)
                && last_saved.is_none_or(|saved| saved.elapsed() >= checkpointing.every)
            {
                file.save(&self.state)?;
                last_saved = Some(Instant::now());
            }
        }
    }

    /// Finds the loss and the numbers to begin with, or why there are none.
    fn begin(
        &mut self,
        objective: &mut Counted<'_>,
        observer: &mut dyn Observer,
    ) -> Result<Option<Stop>, Error> {
        if !self.state.topologies.is_empty() {
            self.restore(objective)?;
            observer.changed(&self.state.topologies);
        }
        if self.state.initial_loss.is_none() {
            let full_loss = objective.full_loss(&self.state.x);
            self.state.initial_loss = full_loss.filter(|loss| loss.is_finite());
        }
        if self.begins_elsewhere() && self.state.initial_loss.is_none() {
            objective.begin(0, 0);
            let finest = objective.evaluate(&self.state.x);
            if let Some(stop) = self.non_finite(&finest, objective) {
                return Ok(Some(stop));
            }
            self.state.initial_loss = Some(finest.loss);
        }
        if let (Some(starts), Start::Fresh) = (self.settings.starts, self.start) {
            let (x, level) = starts.most_promising(&self.flat, self.settings, objective);
            self.state.x = x;
            while self.state.level > level {
                self.state.refine(self.settings);
            }
        }
        Ok(None)
    }

    /// Goes on with other variables, if the objective changes before this iteration; what there was in their place.
    fn change(
        &mut self,
        objective: &mut Counted<'_>,
        observer: &mut dyn Observer,
    ) -> Result<Option<Replaced>, Error> {
        let iteration = self.state.iteration;
        // After the last step there is none that a change would be for.
        let is_last = iteration == self.settings.iterations;
        let is_changed = iteration == 0 || self.state.changed_at == Some(iteration);
        if is_last || is_changed || self.settings.optimizer.finds_step_lengths() {
            return Ok(None);
        }
        let Some(change) = objective.change(iteration, &self.state.x)? else { return Ok(None) };
        self.flat = Flat::new(&change.variables)?;
        self.variables = Cow::Owned(change.variables.clone());
        let before = self.state.change(change);
        observer.changed(&self.state.topologies);
        Ok(Some(before))
    }

    /// Goes on with the variables of the checkpoint.
    fn restore(&mut self, objective: &mut dyn Objective) -> Result<(), Error> {
        let variables = objective.restore(&self.state.topologies)?;
        self.flat = Flat::new(&variables)?;
        self.variables = Cow::Owned(variables);
        match &self.file {
            Some(file) if self.flat.x.len() != self.state.x.len() => Err(file.incoherent()),
            _ => Ok(()),
        }
    }

    /// Why the run ends, if what was evaluated is not finite.
    fn non_finite(&self, evaluation: &Evaluation, objective: &mut Counted<'_>) -> Option<Stop> {
        let stop = Stop::at_non_finite(evaluation, self.state.iteration, &self.variables)?;
        Some(stop.explained(objective.explain(&self.state.x)))
    }

    /// Leaves a checkpoint of the end of the run, unless there is nothing to keep.
    fn stop(&mut self, stop: Stop, objective: &mut Counted<'_>) -> Result<Stop, Error> {
        self.state.stop = Some(stop.clone());
        if let Some(best) = &mut self.state.best
            && let Some(loss) = objective.full_loss(&best.x)
        {
            best.loss = loss;
        }
        if let Some(file) = &self.file
            && self.state.last.is_some()
        {
            file.save(&self.state)?;
        }
        Ok(stop)
    }
}

/// An objective, and how often it was evaluated.
struct Counted<'a> {
    objective: &'a mut dyn Objective,
    evaluations: u64,
}

impl Objective for Counted<'_> {
    fn begin(&mut self, iteration: u64, level: u32) {
        self.objective.begin(iteration, level);
    }

    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        self.evaluations += 1;
        let evaluation = self.objective.evaluate(x);
        let gradient = evaluation.gradient.len();
        assert_eq!(gradient, x.len(), "the gradient must have one element per parameter");
        evaluation
    }

    fn full_loss(&mut self, x: &[f64]) -> Option<f64> {
        self.objective.full_loss(x)
    }

    fn curvature(&mut self, x: &[f64]) -> Option<Vec<f64>> {
        self.objective.curvature(x)
    }

    fn change(&mut self, iteration: u64, x: &[f64]) -> Result<Option<Change>, Error> {
        self.objective.change(iteration, x)
    }

    fn restore(&mut self, topologies: &[Topology]) -> Result<Vec<Variable>, Error> {
        self.objective.restore(topologies)
    }

    fn explain(&mut self, x: &[f64]) -> Option<String> {
        self.objective.explain(x)
    }
}
