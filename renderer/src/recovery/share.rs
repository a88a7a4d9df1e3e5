//! A recovery whose images several processes share.

use super::left_out::LeftOut;
use super::team::{Begun, Task, Team};
use super::{ImageObjective, Recovery};
use crate::optimize::Objective;

impl Recovery<'_> {
    /// Leads a team, as rank 0, while `run` goes on.
    pub(crate) fn lead<T>(&self, team: &dyn Team, run: impl FnOnce() -> T) -> T {
        let result = run();
        Task::End.ask(team, Begun::default(), &[]);
        self.tell_left_out(team);
        result
    }

    /// Does its share of what rank 0 [leads](Self::lead), as another rank.
    pub(crate) fn serve(&self, team: &dyn Team) {
        ImageObjective::shared(self, &self.settings, team).serve();
        self.tell_left_out(team);
    }

    /// Makes all ranks know what one of them has left out last.
    fn tell_left_out(&self, team: &dyn Team) {
        if let Ok(mut left_out) = self.left_out.lock() {
            let all = team.exchange(&left_out.to_line());
            *left_out = LeftOut::latest(&all);
        }
    }

    /// How many images an iteration compares, on average.
    pub(crate) fn images_at_a_time(&self) -> usize {
        let images = self.matched().count();
        let Some(batch) = self.section.batch else { return images };
        let mut views: Vec<_> = self.matched().map(|target| target.view).collect();
        views.dedup();
        (images * batch.size.min(views.len())).div_ceil(views.len())
    }

    /// Tells ranks apart that have not the same to do.
    pub(crate) fn mark(&self) -> String {
        format!("{} {:?}", self.fingerprint(), self.ids)
    }
}

impl ImageObjective<'_> {
    /// Does its share for rank 0 until that ends.
    pub fn serve(&mut self) {
        let mut x = self.recovery.initial();
        loop {
            let (task, Begun { iteration, level }) = Task::next(self.team, &mut x);
            if task == Task::End {
                return;
            }
            self.begin(iteration, level);
            // Rank 0 asks for nothing where the scene cannot be.
            let _ = self.assign(&x);
            match task {
                Task::Evaluate => drop(self.sum_of_losses(x.len())),
                _ => drop(self.sum_of_curvatures(x.len())),
            }
        }
    }
}
