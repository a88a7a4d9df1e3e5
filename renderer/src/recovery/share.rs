//! A recovery whose images several processes share.

use super::left_out::LeftOut;
use super::team::{Begun, Task, Team, topologies_of_numbers};
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
        let objective = ImageObjective::shared(self, &self.settings, team);
        objective.resampled(self.resampling()).serve();
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
        let views = self.matched_views().len();
        (images * batch.size.min(views)).div_ceil(views)
    }

    /// Tells ranks apart that have not the same to do.
    pub(crate) fn mark(&self) -> String {
        format!("{} {:?}", self.fingerprint(), self.ids)
    }
}

impl ImageObjective<'_> {
    /// Does its share for rank 0 until that ends.
    pub fn serve(mut self) {
        let mut numbers = Vec::new();
        loop {
            let (task, Begun { iteration, level }) = Task::next(self.team, &mut numbers);
            match task {
                Task::End => return,
                Task::Change => {
                    let topologies = topologies_of_numbers(&numbers);
                    // Rank 0 has taken up the same.
                    if let Ok(recovery) = self.original.with_topologies(&topologies) {
                        self.take_up(recovery);
                    }
                    continue;
                }
                Task::Evaluate | Task::Curvature => {}
            }
            self.begin(iteration, level);
            // Rank 0 asks for nothing where the scene cannot be.
            let _ = self.assign(&numbers);
            match task {
                Task::Curvature => drop(self.sum_of_curvatures(numbers.len())),
                _ => drop(self.sum_of_losses(numbers.len())),
            }
        }
    }
}
