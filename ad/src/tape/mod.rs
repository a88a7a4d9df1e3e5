//! Reverse mode by operator overloading: a tape that is recorded at run time.
//!
//! [`Var`] is a [`Real`](crate::Real), so every generic function runs on it unchanged. It needs no
//! attribute and follows whatever path the program takes, at the price of writing down each
//! operation: expect several times the cost of a generated adjoint (`cargo bench -p ad --bench ad`
//! measures both). It is the other way to a gradient that shares no code with the generated one.
//!
//! ```
//! use ad::{Real, tape};
//!
//! fn rosenbrock<S: Real>(x: S, y: S) -> S {
//!     let (a, b) = (S::ONE - x, y - x * x);
//!     a * a + S::from_f64(100.0) * b * b
//! }
//!
//! let (value, gradient) = tape::gradient(|v| rosenbrock(v[0], v[1]), &[0.5, 1.0]);
//! assert_eq!((value, gradient), (56.5, vec![-151.0, 150.0]));
//! ```
//!
//! # How it is made
//!
//! The tape is a Wengert list: for each operation the indices of at most two operands (`u32`) and
//! the partial derivatives by them, 24 bytes in a list that grows by chunks. The reverse sweep goes
//! over it once, backwards. Operations on constants alone are not recorded.
//!
//! Scalars are `Copy` and carry no lifetime (`Real` is `'static`), so they cannot hold a reference
//! to the list: there is one for each thread, of which a [`Recording`] uses the end. The memory
//! stays with the thread. A variable knows its recording, and using it in another one, or on another
//! thread, panics: its index would mean something else there. Turned down: a reference in each scalar (no `'static`, so no generic kernel
//! of this crate); a counted reference (not `Copy`); a closure for each operation (an allocation
//! each).

mod list;
mod real;

use core::cell::Cell;
use core::marker::PhantomData;
use core::sync::atomic::{AtomicU32, Ordering};

use list::{List, Node};

/// A number whose operations are recorded. One that does not depend on a variable is a constant
/// and leaves no record.
#[derive(Clone, Copy)]
pub struct Var {
    value: f64,
    origin: Origin,
}

/// Where a number comes from: the recording in the upper half, the index of the node in the lower;
/// 0 for a constant. One integer, so that a variable travels in two registers.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Origin(u64);

impl Origin {
    const CONSTANT: Self = Self(0);

    #[inline(always)]
    fn new(recording: u32, node: u32) -> Self {
        Self(u64::from(recording) << 32 | u64::from(node))
    }

    #[inline(always)]
    fn recording(self) -> u32 {
        (self.0 >> 32) as u32
    }

    #[inline(always)]
    fn node(self) -> u32 {
        self.0 as u32
    }

    #[inline(always)]
    fn is_constant(self) -> bool {
        self == Self::CONSTANT
    }
}

/// The list of a thread, and the recording that uses its end; 0 if there is none.
struct Tape {
    recording: Cell<u32>,
    list: List,
}

thread_local! {
    static TAPE: Tape = const { Tape { recording: Cell::new(0), list: List::new() } };
}

/// The number of recordings begun by all threads. None has the number 0.
static RECORDINGS: AtomicU32 = AtomicU32::new(0);

impl Var {
    /// A number without derivative.
    #[inline(always)]
    pub const fn constant(value: f64) -> Self {
        Self { value, origin: Origin::CONSTANT }
    }

    /// The number.
    #[inline(always)]
    pub const fn value(self) -> f64 {
        self.value
    }

    /// `f(self)` from its value and its derivative.
    #[inline(always)]
    fn unary(self, value: f64, partial: f64) -> Self {
        self.binary(Self::constant(0.0), value, [partial, 0.0])
    }

    /// `f(self, other)` from its value and its partial derivatives.
    #[inline(always)]
    fn binary(self, other: Self, value: f64, [first, second]: [f64; 2]) -> Self {
        if self.origin.is_constant() && other.origin.is_constant() {
            return Self::constant(value);
        }
        Self { value, origin: record(self.origin, other.origin, first, second) }
    }
}

/// Writes down an operation. What it takes and returns fits into registers.
#[inline(never)]
fn record(first: Origin, second: Origin, by_first: f64, by_second: f64) -> Origin {
    TAPE.with(|tape| {
        let recording = tape.recording.get();
        for operand in [first, second] {
            if !operand.is_constant() && operand.recording() != recording {
                foreign();
            }
        }
        let operands = [first.node(), second.node()];
        Origin::new(recording, tape.list.push(Node { partials: [by_first, by_second], operands }))
    })
}

#[cold]
#[inline(never)]
fn foreign() -> ! {
    panic!("a variable was used outside of the recording that made it");
}

/// A tape being recorded, on this thread, from its [`start`](Recording::start) until it is dropped.
///
/// A recording within another one interrupts it: until the inner one is dropped, variables of the
/// outer one must not be used. Recordings end in the reverse order of their starts.
pub struct Recording {
    number: u32,
    /// Where its nodes begin.
    start: u64,
    /// The recording that this one interrupts.
    outer: u32,
    /// The list is the thread's.
    thread: PhantomData<*const ()>,
}

impl Recording {
    /// Starts to record.
    #[allow(clippy::new_without_default)]
    pub fn start() -> Self {
        let number = RECORDINGS.fetch_add(1, Ordering::Relaxed).wrapping_add(1);
        assert_ne!(number, 0, "no numbers are left for recordings");
        TAPE.with(|tape| Self {
            number,
            start: tape.list.len(),
            outer: tape.recording.replace(number),
            thread: PhantomData,
        })
    }

    /// Runs `f` on the list, if this recording is not interrupted.
    fn with_list<R>(&self, f: impl FnOnce(&List) -> R) -> R {
        TAPE.with(|tape| {
            if tape.recording.get() != self.number {
                foreign();
            }
            f(&tape.list)
        })
    }

    /// A variable, by which derivatives are wanted.
    pub fn variable(&self, value: f64) -> Var {
        let node = Node { partials: [0.0; 2], operands: [0; 2] };
        let node = self.with_list(|list| list.push(node));
        Var { value, origin: Origin::new(self.number, node) }
    }

    /// The reverse sweep from `result`, whose cotangent is 1.
    ///
    /// Panics if `result` belongs to another recording.
    pub fn cotangents(&self, result: Var) -> Cotangents {
        let (number, start) = (self.number, self.start);
        if result.origin.is_constant() {
            return Cotangents { number, start, cotangents: Vec::new() };
        }
        if result.origin.recording() != number {
            foreign();
        }
        let end = u64::from(result.origin.node()) + 1;
        let mut cotangents = vec![0.0; place(start, end)];
        cotangents[place(start, end - 1)] = 1.0;
        let all = &mut cotangents[..];
        self.with_list(|list| {
            list.for_each_backwards(start, end, |index, node| {
                let cotangent = all[place(start, index)];
                // A cotangent of zero annihilates an infinite partial derivative.
                if cotangent != 0.0 {
                    for (operand, partial) in node.operands.into_iter().zip(node.partials) {
                        all[place(start, operand.into())] += cotangent * partial;
                    }
                }
            });
        });
        Cotangents { number, start, cotangents }
    }
}

/// Where the cotangent of a node lies in a recording whose nodes begin at `start`: all constants
/// share the first place.
#[inline(always)]
fn place(start: u64, node: u64) -> usize {
    (node + 1).saturating_sub(start) as usize
}

impl Drop for Recording {
    fn drop(&mut self) {
        // While the thread ends there may be no list any more.
        let _ = TAPE.try_with(|tape| {
            tape.recording.set(self.outer);
            tape.list.truncate(self.start);
        });
    }
}

/// The derivatives of a result by every number of its recording.
pub struct Cotangents {
    number: u32,
    start: u64,
    /// That of the constants, then those of the recording's nodes.
    cotangents: Vec<f64>,
}

impl Cotangents {
    /// The derivative of the result by `var`; 0 by a constant.
    ///
    /// Panics if `var` belongs to another recording.
    pub fn by(&self, var: Var) -> f64 {
        if var.origin.is_constant() {
            return 0.0;
        }
        if var.origin.recording() != self.number {
            foreign();
        }
        // The result does not depend on what was recorded after it.
        let place = place(self.start, var.origin.node().into());
        self.cotangents.get(place).copied().unwrap_or(0.0)
    }
}

/// The value of `f` at `x`, and its gradient.
pub fn gradient(f: impl FnOnce(&[Var]) -> Var, x: &[f64]) -> (f64, Vec<f64>) {
    let recording = Recording::start();
    let variables: Vec<_> = x.iter().map(|&x| recording.variable(x)).collect();
    let result = f(&variables);
    let cotangents = recording.cotangents(result);
    (result.value, variables.iter().map(|&variable| cotangents.by(variable)).collect())
}
