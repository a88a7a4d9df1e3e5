//! What generated code calls. Not for use by hand: it may change with every release.

use core::marker::PhantomData;

use crate::{Additive, Differentiable, NoDerivative, Shape, Tangent};

pub use crate::differentiable::Parts;
use crate::differentiable::no_derivative;

mod cells;
mod checkpoints;
mod clones;
mod constants;
pub(crate) mod cotangent;
mod kept;
mod names;
mod order;
mod products;
mod pullback;
mod reborrow;
mod repeated;
mod tangent;
mod texts;
pub(crate) mod through;

pub use cells::{Holder, HoldsNoNumber, MayHold, StaysWhileShared, shared_by_a_copy};
pub use checkpoints::Checkpoints;
pub use clones::{Comparable, Copied, CopiedElements, NotComparable};
pub use constants::{Accepts, Beside, KeepsNothing, MayKeep, OfChanged, Vanishing, of_constant};
pub use cotangent::{
    Absorb, At, Constant, Content, Enter, Length, Lent, NotLent, Nothing, Same, Take, at, sum,
    take, take_changed,
};
pub use kept::{Decrease, Difference, Increase, Negation, Sum};
pub use names::{
    Found, FunctionWithoutDerivative, Hidden, MethodWithDerivative, SameOwner, SameReceiver,
    changes_nothing, check_mode_of, has_other_name, other_function, same_function, same_owner,
    same_receiver, same_type, text, unchanging,
};
pub use order::{BuiltIn, right_first};
pub use products::{Products, ProductsOutOfLine, rarely, scale, vanishing, with_products};
pub use pullback::{
    Lends, LendsNothing, MethodPullback, MethodPullbackOnto, Offered, PullbackOnto,
};
pub use reborrow::{Joined, Reborrow, TakeFrom, Taken, Told, told};
pub use repeated::{Fingerprint, Fingerprints, Look, NotPrinted, Printed, same_again};
pub use tangent::{
    Last, Pass, Slot, copy, pass, pass_part, read, repeated, same_length, still, tangent_of,
    target, with_zero, zero_like, zero_of,
};
pub use texts::Read;
pub use through::{ByPullback, Through, WithoutRule};

mod iterate;

pub use iterate::{
    AddsUp, Flat, MultipliesUp, Side, advance, are_told_apart, build_like, chunks_exact,
    empty_product, empty_sum, held, is_of_items, is_sequence, lends_parts, lent_content, position,
    record, record_like, windows, with_cotangents,
};

/// The traits whose methods generated code calls. They come without names, which could hide those
/// of the user.
pub mod methods {
    pub use super::cells::MayHold as _;
    pub use super::constants::Accepts as _;
    pub use super::names::Modes as _;
    pub use super::texts::MayBeRead as _;
    #[cfg(feature = "glam")]
    pub use crate::glam::methods::*;
    pub use crate::rules::{
        CloneRules as _, CopiedRules as _, DequeRules as _, DerefRules as _, FlattenRules as _,
        FloatRules as _, FromRules as _, IntegerRules as _, IntoRules as _, OptionRules as _,
        OwnedRules as _, PartRules as _, RealRules as _, ResultRules as _, SequenceRules as _,
        SignedRules as _, TryIntoRules as _, VecRules as _, Vector3Rules as _, VectorRules as _,
    };
    pub use crate::vector::{Vector as _, Vector3 as _};
}

/// Methods with the names of those of vectors that glam has not, by reference: a trait of the user's
/// with such a method is ambiguous beside them.
pub mod by_reference {
    use crate::vector::Vector3;

    /// The elements of a vector.
    pub trait Coordinates: Vector3 {
        /// The first element.
        fn x(&self) -> Self::Scalar {
            Vector3::x(*self)
        }
        /// The second element.
        fn y(&self) -> Self::Scalar {
            Vector3::y(*self)
        }
        /// The third element.
        fn z(&self) -> Self::Scalar {
            Vector3::z(*self)
        }
    }

    impl<V: Vector3> Coordinates for V {}
}

/// The space `T` of cotangents, as a value: lets the forward sweep tell the reverse sweep, which
/// knows no types, what kind of zero to start from. Takes no room.
pub struct Space<T>(PhantomData<fn() -> T>);

impl<T> Clone for Space<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Space<T> {}

impl<T: Additive> Space<T> {
    /// The space of a variable that comes to be within a loop, which tells by
    /// [`is_of`](Self::is_of).
    #[inline(always)]
    pub fn of_unknown() -> Self {
        Self(PhantomData)
    }

    /// Says of what this is the space.
    #[inline(always)]
    pub fn is_of<V: Differentiable<Tangent = T> + ?Sized>(self, _value: &V) {}

    /// The zero of the space.
    #[inline(always)]
    pub fn zero(self) -> T {
        T::zero()
    }

    /// Moves out what has gathered in the place for which a variable of this space stands.
    #[inline(always)]
    pub fn taken<Kind>(self, place: &mut (impl Take<T, Kind> + ?Sized)) -> T {
        place.take()
    }

    /// The space of a part.
    #[inline(always)]
    pub fn part<U>(self, _part: impl FnOnce(&T) -> &U) -> Space<U> {
        Space(PhantomData)
    }

    /// Compiles where the space holds nothing but zero.
    #[inline(always)]
    pub fn vanishes(self)
    where
        T: Vanishing,
    {
    }

    /// A cotangent, seen from the field it is the cotangent of.
    #[inline(always)]
    pub fn enter<Kind>(self, cotangent: impl Enter<T, Kind>) -> T {
        cotangent.enter()
    }
}

/// The space in which the cotangent of `value` lives.
#[inline(always)]
pub fn space<T: Differentiable + ?Sized>(_value: &T) -> Space<Tangent<T>> {
    Space(PhantomData)
}

/// The shape of a parameter.
#[inline(always)]
pub fn shape<T: Differentiable + ?Sized>(value: &T) -> T::Shape {
    value.shape()
}

/// The cotangent of a parameter of this shape.
#[inline(always)]
pub fn fit<T, S: Shape<T>>(shape: S, mut cotangent: T) -> T {
    shape.fit(&mut cotangent);
    cotangent
}

/// The operand of an operator: a number, or what a reference to one refers to.
#[diagnostic::on_unimplemented(
    message = "a reference to `{Self}` cannot be an operand here",
    label = "not a number",
    note = "write `*x` for what a reference `x` refers to"
)]
pub trait ByValue: Sized {
    /// The number.
    type Value;

    /// The number.
    fn by_value(self) -> Self::Value;
}

impl<T: ByValue + Copy> ByValue for &T {
    type Value = T::Value;

    #[inline(always)]
    fn by_value(self) -> T::Value {
        (*self).by_value()
    }
}

macro_rules! by_value {
    ($($type:ty)*) => {$(
        impl ByValue for $type {
            type Value = Self;

            #[inline(always)]
            fn by_value(self) -> Self {
                self
            }
        }
    )*};
}

#[cfg(feature = "glam")]
pub(crate) use by_value;

by_value!(f32 f64 i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize);

/// What the derivative of a method that returns its receiver has in its place. The compiler names this type
/// where more is done with it than nothing, and with it the way out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CallTheNextMethodInAStatementOfItsOwn;

no_derivative!(CallTheNextMethodInAStatementOfItsOwn);

/// What a method returns on which another is called whose value nobody uses.
#[diagnostic::on_unimplemented(
    message = "another method is called on the `{Self}` that this one returns, and its value is not used",
    label = "returns a `{Self}`",
    note = "give what it returns a name: `let value = x.method();`",
    note = "methods in a chain that changes one value return `&mut Self`"
)]
pub trait Itself {}

impl Itself for CallTheNextMethodInAStatementOfItsOwn {}

/// Compiles for what a method returns that returns its receiver.
#[inline(always)]
pub fn returned_itself<T: Itself>(_value: &T) {}

/// Compiles for the types whose operators have rules.
#[inline(always)]
pub fn operand<T: Operand>() {}

/// What an operator can be pulled back from: its operands, which have to be there still.
#[diagnostic::on_unimplemented(
    message = "the operators of `{Self}` use up their operands, which their derivatives need",
    label = "not `Clone`",
    note = "derive `Clone`, or put the attribute on the operator of references"
)]
pub trait Operand {}

impl<T: Clone> Operand for T {}

/// A copy, where the value is used once more later.
#[inline(always)]
pub fn again<T: Clone>(value: &T) -> T {
    value.clone()
}

/// Passes on what has no derivative, and nothing else.
#[inline(always)]
pub fn constant<T: NoDerivative>(value: T) -> T {
    value
}

/// The conversion of an error that `?` does.
#[inline(always)]
pub fn propagate<E: NoDerivative, F: From<E>>(error: E) -> F {
    F::from(error)
}

/// The derivative of `propagate`: there is none.
#[allow(non_camel_case_types)]
pub enum propagate {}

impl propagate {
    /// Nothing flows back to an error.
    #[inline(always)]
    pub fn vjp<E: NoDerivative, F: From<E> + Differentiable>(
        error: E,
    ) -> (F, impl FnOnce(Tangent<F>) -> Tangent<E> + use<E, F>) {
        (F::from(error), |_| Additive::zero())
    }

    /// An error carries no tangent, which [`vjp`](Self::vjp) asks for.
    #[inline(always)]
    pub fn jvp<E: Differentiable, F: From<E> + Differentiable>(
        error: E,
        _: Tangent<E>,
    ) -> (F, Tangent<F>) {
        tangent::with_zero(F::from(error))
    }
}

/// A value of the type of another, where only the type counts.
pub fn like<T>(_: &T) -> T {
    never()
}

/// The value of a block whose end is never reached.
#[cold]
pub fn never<T>() -> T {
    unreachable!("control does not come here")
}

/// A tape with room for what all iterations of a loop over a range save.
#[inline(always)]
pub fn tape<T>(range: &impl Iterator) -> Vec<T> {
    Vec::with_capacity(iterations(range))
}

/// The number of iterations of a loop over a range.
#[inline(always)]
pub fn iterations(range: &impl Iterator) -> usize {
    range.size_hint().0
}

/// A tape for all runs of a loop within loops, with room for what all iterations save. The loops
/// have these numbers of iterations.
#[inline(always)]
pub fn nested_tape<T, const N: usize>(iterations: [usize; N]) -> Vec<T> {
    Vec::with_capacity(iterations.iter().product())
}

/// What the iterations of a loop saved, on the stack: for loops whose trip count is a literal.
pub struct ArrayTape<T, const N: usize> {
    iterations: [Option<T>; N],
    len: usize,
}

impl<T, const N: usize> ArrayTape<T, N> {
    /// An empty tape.
    #[inline(always)]
    #[allow(clippy::new_without_default)]
    pub fn new() -> Self {
        Self { iterations: [const { None }; N], len: 0 }
    }

    /// Records the next iteration.
    #[inline(always)]
    pub fn push(&mut self, saved: T) {
        self.iterations[self.len] = Some(saved);
        self.len += 1;
    }

    /// How many are recorded.
    #[inline(always)]
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Takes out those from a position on.
    #[inline(always)]
    pub fn drain(
        &mut self,
        range: core::ops::RangeFrom<usize>,
    ) -> impl DoubleEndedIterator<Item = T> {
        let end = core::mem::replace(&mut self.len, range.start);
        self.iterations[range.start..end].iter_mut().filter_map(Option::take)
    }

    /// The recorded iterations, first to last.
    #[inline(always)]
    #[allow(clippy::should_implement_trait)]
    pub fn into_iter(self) -> impl DoubleEndedIterator<Item = T> {
        self.iterations.into_iter().flatten()
    }
}

/// A result whose gradient makes sense: one number, with cotangents of type `T`.
///
/// The lifetime lets generated code ask for this of types without parameters, for which it may turn
/// out false. [`Differentiable`] is not a supertrait: a false bound would hide the impl there is.
#[diagnostic::on_unimplemented(
    message = "`grad` needs a function with a scalar result, and this one returns `{Self}`",
    label = "not a scalar",
    note = "call `vjp` and choose the cotangent of the result yourself"
)]
pub trait ScalarResult<'a, T> {
    /// The cotangent 1.
    fn one() -> T;
}

#[diagnostic::do_not_recommend]
impl<S: crate::Real> ScalarResult<'_, S> for S {
    fn one() -> S {
        S::ONE
    }
}

/// `Copy`, asked for in a way that may turn out false. See [`ScalarResult`]. Of two fields whose
/// tangents are the same type `INDEX` makes two questions: else it is not known which one answers.
pub trait CopyIf<'a, const INDEX: usize = 0>: Copy {}

impl<T: Copy, const INDEX: usize> CopyIf<'_, INDEX> for T {}

macro_rules! branches {
    ($($name:ident: $($arm:ident)*;)*) => {$(
        /// The path that a branch took, with what its arm saved.
        #[allow(missing_docs)]
        pub enum $name<$($arm),*> {
            $($arm($arm)),*
        }
    )*};
}

branches! {
    Branch1: Arm0;
    Branch2: Arm0 Arm1;
    Branch3: Arm0 Arm1 Arm2;
    Branch4: Arm0 Arm1 Arm2 Arm3;
    Branch5: Arm0 Arm1 Arm2 Arm3 Arm4;
    Branch6: Arm0 Arm1 Arm2 Arm3 Arm4 Arm5;
    Branch7: Arm0 Arm1 Arm2 Arm3 Arm4 Arm5 Arm6;
    Branch8: Arm0 Arm1 Arm2 Arm3 Arm4 Arm5 Arm6 Arm7;
    Branch9: Arm0 Arm1 Arm2 Arm3 Arm4 Arm5 Arm6 Arm7 Arm8;
    Branch10: Arm0 Arm1 Arm2 Arm3 Arm4 Arm5 Arm6 Arm7 Arm8 Arm9;
    Branch11: Arm0 Arm1 Arm2 Arm3 Arm4 Arm5 Arm6 Arm7 Arm8 Arm9 Arm10;
    Branch12: Arm0 Arm1 Arm2 Arm3 Arm4 Arm5 Arm6 Arm7 Arm8 Arm9 Arm10 Arm11;
}

/// What a condition, an index or a bound looks at. It has no `DerefMut`, so that a method which
/// changes its receiver is refused there: the compiler names this type then, and with it the way out.
macro_rules! looked_at {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        pub struct $name<'a, T: ?Sized>(pub &'a T);

        impl<T: ?Sized> core::ops::Deref for $name<'_, T> {
            type Target = T;

            #[inline(always)]
            fn deref(&self) -> &T {
                self.0
            }
        }
    )*};
}

looked_at! {
    /// What has a derivative.
    BindTheCallWithLetBefore;
    /// What has none, and is given what has one.
    PassItStopGradientOfTheNumber;
}
