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
        let length = iterations.isqrt().max(1);
        // One more where the end of the loop, which only its iterator finds, begins a segment.
        let states = Vec::with_capacity(iterations.div_ceil(length) + 1);
        Self { states, length, iterations: 0, left: 0 }
    }

    /// Begins an iteration; returns whether the state before it is to be stored.
    #[inline(always)]
    pub fn is_due(&mut self) -> bool {
        let is_due = self.left == 0;
        if is_due {
            self.begin_segment();
        }
        self.iterations += 1;
        self.left -= 1;
        is_due
    }

    fn begin_segment(&mut self) {
        if self.states.len() == 2 * self.length {
            let mut index = 0;
            self.states.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.length *= 2;
        }
        self.left = self.length;
    }

    /// Stores the state before the iteration that has begun.
    #[inline]
    pub fn push(&mut self, state: S) {
        self.states.push(state);
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
