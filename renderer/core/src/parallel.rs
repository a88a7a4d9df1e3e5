//! Parallel loops.
//!
//! rayon compiles its machinery anew for every closure, item and result: with a loop for each kernel, arithmetic and
//! pass that was a fifth of the code of this crate. Here it sees one loop over indices with a closure behind `dyn`. A
//! call through a pointer and two locks are nothing beside a strip of pixels, but much beside a single ray: items
//! have to be worth some.

use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

use rayon::prelude::*;

use crate::counts::flush;

/// How many numbers are worked on one after the other.
const RANGE: usize = 4096;

/// The results of `work` for all of `items`, in their order. A call has scratch memory from `start`, which
/// another call may have used before; [counts](crate::counts) are added up after each.
pub fn map_init<I: Send, W: Send, R: Send>(
    items: Vec<I>,
    start: impl Fn() -> W + Sync,
    work: impl Fn(&mut W, I) -> R + Sync,
) -> Vec<R> {
    let idle = Idle::default();
    let slots: Vec<_> = items.into_iter().map(|item| Mutex::new((Some(item), None))).collect();
    each(slots.len(), &|index| {
        let Some(item) = lock(&slots[index]).0.take() else { return };
        let mut scratch = idle.take().unwrap_or_else(&start);
        let result = work(&mut scratch, item);
        idle.give(scratch);
        flush();
        lock(&slots[index]).1 = Some(result);
    });
    let result = |slot: Mutex<(Option<I>, Option<R>)>| {
        slot.into_inner().unwrap_or_else(PoisonError::into_inner).1
    };
    slots.into_iter().filter_map(result).collect()
}

/// The results of `work` for all of `items`, in their order.
pub fn map<I: Send, R: Send>(items: Vec<I>, work: impl Fn(I) -> R + Sync) -> Vec<R> {
    map_init(items, || (), |(), item| work(item))
}

/// The results of `work` for the numbers below `count`, some at a time, in their order.
pub fn map_ranges<R: Send>(count: usize, work: impl Fn(Range<usize>) -> R + Sync) -> Vec<R> {
    let starts = (0..count).step_by(RANGE).collect();
    map(starts, |start: usize| work(start..(start + RANGE).min(count)))
}

fn each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Memory that is not in use, which calls hand on to each other.
pub struct Idle<W>(Mutex<Vec<W>>);

impl<W> Idle<W> {
    /// Some of it, if there is any.
    pub fn take(&self) -> Option<W> {
        lock(&self.0).pop()
    }

    /// Gives memory back.
    pub fn give(&self, memory: W) {
        lock(&self.0).push(memory);
    }
}

impl<W> Default for Idle<W> {
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

#[cfg(test)]
mod tests {
    use super::{RANGE, map_init, map_ranges};

    #[test]
    fn results_keep_the_order_and_scratch_memory_is_used_again() {
        let starts = std::sync::atomic::AtomicUsize::new(0);
        let start = || {
            starts.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            Vec::new()
        };
        let squares = map_init((0..1000).collect(), start, |scratch: &mut Vec<u64>, item: u64| {
            scratch.push(item);
            item * item
        });
        assert!(
            squares.iter().enumerate().all(|(index, &square)| square == (index * index) as u64)
        );
        assert!(starts.into_inner() <= rayon::current_num_threads() + 1);
    }

    #[test]
    fn ranges_hold_every_number_once() {
        for count in [0, 1, RANGE, 2 * RANGE + 1] {
            let numbers = map_ranges(count, |range| range.collect::<Vec<_>>()).concat();
            assert!(numbers.into_iter().eq(0..count));
        }
    }
}
