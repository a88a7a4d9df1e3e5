//! When a checkpointed loop stores its state.

/// The states before the segments of a loop, which are about as many as a segment has iterations.
///
/// How many iterations there will be need not be known: whenever there are twice as many states as a
/// segment has iterations, every other one is dropped and segments get twice as long.
pub struct Checkpoints<S> {
    states: Vec<S>,
    /// The iterations of a segment.
    length: usize,
    /// Those that have begun.
    iterations: usize,
    /// Those before the next state.
    left: usize,
}

impl<S> Checkpoints<S> {
    /// For a loop of at least so many iterations.
    #[inline]
    pub fn expecting(iterations: usize) -> Self {
        Self { states: Vec::new(), length: iterations.isqrt().max(1), iterations: 0, left: 0 }
    }

    /// Stores the state before an iteration, if this begins a segment.
    #[inline(always)]
    pub fn begin_iteration(&mut self, state: impl FnOnce() -> S) {
        if self.left == 0 {
            self.begin_segment(state());
        }
        self.iterations += 1;
        self.left -= 1;
    }

    fn begin_segment(&mut self, state: S) {
        if self.states.len() == 2 * self.length {
            let mut index = 0;
            self.states.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.length *= 2;
        }
        self.states.push(state);
        self.left = self.length;
    }

    /// The segments from the last to the first: the number of their iterations, and the state before
    /// them.
    #[inline]
    pub fn into_segments(self) -> impl Iterator<Item = (usize, S)> {
        let Self { states, length, iterations, .. } = self;
        let segment = move |(index, state)| (length.min(iterations - index * length), state);
        states.into_iter().enumerate().rev().map(segment)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_are_all_iterations_once() {
        for count in 0..300 {
            for expected in [0, count / 3, count] {
                let mut checkpoints = Checkpoints::expecting(expected);
                (0..count).for_each(|iteration| checkpoints.begin_iteration(|| iteration));
                let mut end = count;
                let mut states = 0;
                for (length, start) in checkpoints.into_segments() {
                    assert_eq!(start + length, end);
                    (end, states) = (start, states + 1);
                    assert!(length <= 2 * count.isqrt().max(1));
                }
                assert_eq!(end, 0);
                assert!(states <= 2 * count.isqrt() + 2, "{states} states of {count} iterations");
            }
        }
    }
}
