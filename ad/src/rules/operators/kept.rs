//! What a rule keeps of the operands of an operator from the forward to the reverse sweep.

use core::cell::{Cell, RefCell};

/// What a rule keeps of operands of types `A` and `B`.
///
/// The operator may stand in a loop: what is kept last is asked for first.
pub trait Kept<A, B>: Default {
    /// Keeps operands.
    fn keep(&self, left: &A, right: &B);
}

/// The rule needs to know the types alone. Takes no room.
#[derive(Clone, Copy, Default)]
pub struct Nothing;

impl<A, B> Kept<A, B> for Nothing {
    #[inline(always)]
    fn keep(&self, _: &A, _: &B) {}
}

/// Copies of both operands. Those of an operator outside of loops, or of the last iteration, are
/// kept without an allocation.
pub struct Operands<A, B> {
    last: Cell<Option<(A, B)>>,
    earlier: RefCell<Vec<(A, B)>>,
}

impl<A, B> Default for Operands<A, B> {
    #[inline(always)]
    fn default() -> Self {
        Self { last: Cell::new(None), earlier: RefCell::new(Vec::new()) }
    }
}

impl<A: Clone, B: Clone> Kept<A, B> for Operands<A, B> {
    #[inline]
    fn keep(&self, left: &A, right: &B) {
        if let Some(previous) = self.last.replace(Some((left.clone(), right.clone()))) {
            self.earlier.borrow_mut().push(previous);
        }
    }
}

impl<A, B> Operands<A, B> {
    /// Gives back the operands that were kept last.
    ///
    /// # Panics
    ///
    /// If none are left: each are given back once.
    #[inline]
    pub fn give_back(&self) -> (A, B) {
        let operands = self.last.take().expect("each operator is pulled back as often as it ran");
        self.last.set(self.earlier.borrow_mut().pop());
        operands
    }
}
