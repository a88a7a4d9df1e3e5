//! Parallel loops whose bodies need scratch memory.
//!
//! rayon compiles its machinery anew for every closure that it is given: with a loop for each kernel, arithmetic and
//! pass that was a fifth of the code of this crate. Here it sees closures behind `dyn`, one type for each type of
//! results; a call through a pointer and a lock are nothing beside a strip of pixels, but much beside
//! a single ray: items have to be worth some.

use std::sync::{Mutex, MutexGuard, PoisonError};

use rayon::prelude::*;

use crate::counts::flush;

/// The results of `work` for all of `items`, in their order. A call has scratch memory from `start`, which
/// another call may have used before; [counts](crate::counts) are added up after each.
pub fn map<I: Send, W: Send, R: Send>(
    items: Vec<I>,
    start: impl Fn() -> W + Sync,
    work: impl Fn(&mut W, I) -> R + Sync,
) -> Vec<R> {
    let idle = Idle::default();
    let run: &(dyn Fn(I) -> R + Sync) = &|item| {
        let mut scratch = idle.take().unwrap_or_else(&start);
        let result = work(&mut scratch, item);
        idle.give(scratch);
        flush();
        result
    };
    items.into_par_iter().map(run).collect()
}

/// Memory that is not in use, which calls hand on to each other.
pub struct Idle<W>(Mutex<Vec<W>>);

impl<W> Idle<W> {
    /// Some of it, if there is any.
    pub fn take(&self) -> Option<W> {
        self.lock().pop()
    }

    /// Gives memory back.
    pub fn give(&self, memory: W) {
        self.lock().push(memory);
    }

    fn lock(&self) -> MutexGuard<'_, Vec<W>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<W> Default for Idle<W> {
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

#[cfg(test)]
mod tests {
    use super::map;

    #[test]
    fn results_keep_the_order_and_scratch_memory_is_used_again() {
        let starts = std::sync::atomic::AtomicUsize::new(0);
        let start = || {
            starts.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            Vec::new()
        };
        let squares = map((0..1000).collect(), start, |scratch: &mut Vec<u64>, item: u64| {
            scratch.push(item);
            item * item
        });
        assert!(
            squares.iter().enumerate().all(|(index, &square)| square == (index * index) as u64)
        );
        assert!(starts.into_inner() <= rayon::current_num_threads() + 1);
    }
}
