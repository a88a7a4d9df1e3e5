//! Many processes that share the views of a recovery.
//!
//! Rank 0 alone runs the optimiser: it takes every decision, writes every file and prints every line. For an
//! evaluation it tells the others where and of which iteration; each renders a share of the images, and
//! [what they come to](sum) is added in the order of the views, so that any number of ranks gives the bits of
//! one process. Nobody else has to know of step lengths, stops, signals or checkpoints, so no rank can leave
//! a loop alone.
//!
//! Turned down: the same optimiser in all ranks, each deciding from the same numbers. It saves no traffic,
//! since gradients would have to reach all ranks where now parameters do; it holds the state of the
//! optimiser and its factorisations once for each rank; and whatever one rank alone knows (signals, time, a page
//! that watches) needs a message of its own.

#[cfg(feature = "mpi")]
mod mpi;
mod sum;
mod topologies;

#[cfg(feature = "mpi")]
pub(crate) use mpi::World;
pub(super) use sum::sum_in_order;
#[cfg(feature = "cli")]
pub(super) use topologies::topologies_of_numbers;
pub(super) use topologies::topologies_to_numbers;

use crate::Error;

/// Processes, numbered from 0, which all call the same functions of this in the same order.
pub(crate) trait Team {
    /// The number of this process.
    fn rank(&self) -> usize;

    /// How many there are.
    fn size(&self) -> usize;

    /// Sends numbers to another rank, which [receives](Self::receive) as many.
    fn send(&self, to: usize, numbers: &[f64]);

    /// Receives numbers that another rank sends.
    fn receive(&self, from: usize, numbers: &mut [f64]);

    /// Makes the numbers of all ranks those of rank 0.
    fn broadcast(&self, numbers: &mut [f64]);

    /// What all ranks say, in their order.
    fn exchange(&self, text: &str) -> Vec<String>;
}

/// One process that shares with nobody.
pub(crate) struct Alone;

impl Team for Alone {
    fn rank(&self) -> usize {
        0
    }

    fn size(&self) -> usize {
        1
    }

    fn send(&self, _: usize, _: &[f64]) {}

    fn receive(&self, _: usize, _: &mut [f64]) {}

    fn broadcast(&self, _: &mut [f64]) {}

    fn exchange(&self, text: &str) -> Vec<String> {
        vec![text.to_owned()]
    }
}

/// What this rank has prepared, if all ranks have prepared the same, as `mark` tells.
///
/// # Errors
///
/// If one of them could not, or has something else. Rank 0 gets the error to print.
pub(crate) fn agree<T>(
    team: &dyn Team,
    prepared: Result<T, Error>,
    mark: impl FnOnce(&T) -> String,
) -> Result<T, Error> {
    if team.size() == 1 {
        return prepared;
    }
    let said = match &prepared {
        Ok(prepared) => format!("+{}", mark(prepared)),
        Err(error) => format!("-{error}"),
    };
    let all = team.exchange(&said);
    let prepared = prepared?;
    let differs = all.iter().position(|said| said.starts_with('-'));
    let differs = differs.or_else(|| all.iter().position(|said| *said != all[0]));
    match differs {
        None => Ok(prepared),
        Some(rank) => {
            let other = "has another problem than rank 0: its files differ, or its program, or its processor \
                         gives other bits";
            let problem = all[rank].strip_prefix('-').unwrap_or(other);
            Err(Error::new(format_args!("rank {rank}"), problem))
        }
    }
}

/// What rank 0 asks the others for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Task {
    /// Their part of loss and gradient, at parameters.
    Evaluate,
    /// Their part of the curvature, at parameters.
    Curvature,
    /// To go on with other triangles, as [numbers](topologies_to_numbers).
    Change,
    /// To leave.
    End,
}

/// Where a task is to be done.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Begun {
    pub iteration: u64,
    pub level: u32,
}

impl Task {
    const ALL: [Self; 4] = [Self::Evaluate, Self::Curvature, Self::Change, Self::End];

    /// Asks for it, as rank 0, with what it is about.
    pub fn ask(self, team: &dyn Team, begun: Begun, numbers: &[f64]) {
        if team.size() == 1 {
            return;
        }
        // These numbers are small: a double holds them exactly.
        let (iteration, count) = (begun.iteration as f64, numbers.len() as f64);
        team.broadcast(&mut [f64::from(self as u8), iteration, begun.level.into(), count]);
        if !numbers.is_empty() {
            team.broadcast(&mut numbers.to_vec());
        }
    }

    /// What rank 0 asks for next, and where; `numbers` become those that it is about.
    pub fn next(team: &dyn Team, numbers: &mut Vec<f64>) -> (Self, Begun) {
        let mut head = [0.0; 4];
        team.broadcast(&mut head);
        let [task, iteration, level, count] = head;
        numbers.resize(count as usize, 0.0);
        if !numbers.is_empty() {
            team.broadcast(numbers);
        }
        let begun = Begun { iteration: iteration as u64, level: level as u32 };
        (Self::ALL[task as usize], begun)
    }
}

#[cfg(all(test, feature = "cli"))]
pub(super) mod tests;
