//! Processes that `mpirun` has started.

use std::thread;

use mpi::Threading;
use mpi::environment::Universe;
use mpi::topology::{Rank, SimpleCommunicator};
use mpi::traits::{Communicator, Destination, Root, Source};

use super::Team;

/// All processes of an `mpirun`.
///
/// If one of them panics it ends at once, without a word to the others, who might wait for it: `mpirun` then
/// ends them.
pub(crate) struct World {
    world: SimpleCommunicator,
    /// What is left when it is dropped.
    _universe: Universe,
}

impl World {
    /// Joins, which can be done once; nothing if this has been done before. The threads of a pool have to
    /// leave messages to the thread that has joined.
    pub fn join() -> Option<Self> {
        let (universe, _) = mpi::initialize_with_threading(Threading::Funneled)?;
        Some(Self { world: universe.world(), _universe: universe })
    }
}

impl Drop for World {
    fn drop(&mut self) {
        if thread::panicking() {
            std::process::abort();
        }
    }
}

impl Team for World {
    fn rank(&self) -> usize {
        self.world.rank() as usize
    }

    fn size(&self) -> usize {
        self.world.size() as usize
    }

    fn send(&self, to: usize, numbers: &[f64]) {
        self.world.process_at_rank(to as Rank).send(numbers);
    }

    fn receive(&self, from: usize, numbers: &mut [f64]) {
        self.world.process_at_rank(from as Rank).receive_into(numbers);
    }

    fn broadcast(&self, numbers: &mut [f64]) {
        self.world.process_at_rank(0).broadcast_into(numbers);
    }

    fn exchange(&self, text: &str) -> Vec<String> {
        let said = |rank: Rank| {
            let process = self.world.process_at_rank(rank);
            let is_own = rank == self.world.rank();
            let mut length = text.len() as u64;
            process.broadcast_into(&mut length);
            let mut bytes = if is_own { text.into() } else { vec![0; length as usize] };
            process.broadcast_into(&mut bytes[..]);
            String::from_utf8_lossy(&bytes).into_owned()
        };
        (0..self.world.size()).map(said).collect()
    }
}
