//! Processes of one run, as `mpirun` starts them.
//!
//! What their numbers are is known from the environment before MPI is asked: complaints about arguments come
//! from rank 0 alone, and who runs without `mpirun` does not wait for MPI to start.

use std::collections::hash_map::DefaultHasher;
use std::env;
use std::fs;
use std::hash::{Hash, Hasher};
use std::thread;

use super::output;
use crate::Error;
use crate::recovery::team::{Alone, Team};

/// Makes ranks other than 0 silent.
///
/// # Errors
///
/// If several processes have been started for something that they cannot share.
pub(super) fn check(can_share: bool) -> Result<(), Error> {
    let number = |name| env::var(name).ok().and_then(|text| text.parse::<usize>().ok());
    if number("OMPI_COMM_WORLD_RANK").is_some_and(|rank| rank > 0) {
        output::silence();
    }
    let problem = if number("OMPI_COMM_WORLD_SIZE").is_none_or(|size| size == 1) {
        return Ok(());
    } else if !can_share {
        "only `renderer optimize` shares its work; run this without it"
    } else if cfg!(not(feature = "mpi")) {
        "this build works alone; build with --features mpi"
    } else {
        return Ok(());
    };
    Err(Error::new("mpirun", problem))
}

/// The processes of this run.
#[cfg(feature = "mpi")]
pub(super) fn team() -> Box<dyn Team> {
    use crate::recovery::team::World;

    // Of Open MPI, of what speaks PMIx (Open MPI 5, Slurm), and of MPICH.
    let names = ["OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"];
    let world =
        if names.iter().any(|name| env::var_os(name).is_some()) { World::join() } else { None };
    let Some(world) = world else { return Box::new(Alone) };
    if world.rank() > 0 {
        output::silence();
    }
    Box::new(world)
}

/// The processes of this run: this one.
#[cfg(not(feature = "mpi"))]
pub(super) fn team() -> Box<dyn Team> {
    Box::new(Alone)
}

/// The threads of this rank, unless it is alone: those that it may run on, shared with the ranks of this
/// machine that may run on the same.
pub(super) fn threads(team: &dyn Team) -> Option<usize> {
    if team.size() == 1 {
        return None;
    }
    let machine = fs::read_to_string("/proc/sys/kernel/random/boot_id").unwrap_or_default();
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let cores = status.lines().find(|line| line.starts_with("Cpus_allowed_list"));
    let mut hasher = DefaultHasher::new();
    (machine, cores).hash(&mut hasher);
    let own = hasher.finish().to_string();
    let sharing = team.exchange(&own).iter().filter(|place| **place == own).count();
    let cores = thread::available_parallelism().map_or(1, usize::from);
    Some((cores / sharing).max(1))
}
