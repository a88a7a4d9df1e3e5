//! What generated code calls. Not for use by hand: it may change with every release.

use core::marker::PhantomData;
use core::ops::{Add, Neg, Sub};

use crate::rules::{AddPullback, NegPullback, SubPullback};
use crate::{Additive, Differentiable, NoDerivative, NoTangent, Tangent};

mod iterate;

pub use iterate::{
    build_like, chunks_exact, empty_product, empty_sum, held, record, record_like, segments,
    windows,
};

/// The traits whose methods generated code calls. They come without names, which could hide those
/// of the user.
pub mod methods {
    pub use crate::rules::{
        DVec2Rules as _, DVec4Rules as _, RealRules as _, ScalarRules as _, Vec2Rules as _,
        Vec4Rules as _, Vector3Rules as _, VectorRules as _,
    };
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
    /// The zero of the space.
    #[inline(always)]
    pub fn zero(self) -> T {
        T::zero()
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

/// Says of a conversion that both sides are of one kind.
pub enum Same {}

/// Says of a conversion that one side is the tangent of a `#[constant]` field.
pub enum Constant {}

/// An operator whose pullback needs no operand, only their types.
pub struct Linear<A, B>(PhantomData<fn(A, B)>);

impl<A, B> Clone for Linear<A, B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A, B> Copy for Linear<A, B> {}

impl<A, B: Differentiable> Linear<A, B> {
    /// The pullback of `a + b`.
    #[inline(always)]
    pub fn pull_back_sum(
        self,
        cotangent: Tangent<<A as Add<B>>::Output>,
    ) -> (Tangent<A>, Tangent<B>)
    where
        A: AddPullback<B>,
    {
        A::add_pullback(cotangent)
    }

    /// The pullback of `a - b`.
    #[inline(always)]
    pub fn pull_back_difference(
        self,
        cotangent: Tangent<<A as Sub<B>>::Output>,
    ) -> (Tangent<A>, Tangent<B>)
    where
        A: SubPullback<B>,
    {
        A::sub_pullback(cotangent)
    }

    /// The pullback of `-a`.
    #[inline(always)]
    pub fn pull_back_negation(self, cotangent: Tangent<<A as Neg>::Output>) -> Tangent<A>
    where
        A: NegPullback,
    {
        A::neg_pullback(cotangent)
    }
}

/// The types of two operands.
#[inline(always)]
pub fn linear<A, B>(_: &A, _: &B) -> Linear<A, B> {
    Linear(PhantomData)
}

/// Adds a contribution to a cotangent. What flows to a `#[constant]` field is dropped.
///
/// `Kind` is inferred; it keeps the implementations apart.
pub trait Absorb<C, Kind> {
    /// `self += contribution`
    fn absorb(&mut self, contribution: C);
}

impl<T: Additive> Absorb<T, Same> for T {
    #[inline(always)]
    fn absorb(&mut self, contribution: T) {
        self.accumulate(contribution);
    }
}

impl<T: ?Sized, C: Additive> Absorb<C, Constant> for NoTangent<T> {
    #[inline(always)]
    fn absorb(&mut self, _: C) {}
}

/// The cotangent that a field's cotangent means for the value the field was made from. Nothing
/// comes out of a `#[constant]` field.
///
/// `Kind` is inferred; it keeps the implementations apart.
pub trait Enter<T, Kind> {
    /// The conversion.
    fn enter(self) -> T;
}

impl<T: Additive> Enter<T, Same> for T {
    #[inline(always)]
    fn enter(self) -> T {
        self
    }
}

impl<T: ?Sized, C: Additive> Enter<C, Constant> for NoTangent<T> {
    #[inline(always)]
    fn enter(self) -> C {
        C::zero()
    }
}

/// The cotangent of a variable before it was overwritten: moves out what has gathered.
#[inline(always)]
pub fn take<T: Additive>(cotangent: &mut T) -> T {
    core::mem::replace(cotangent, T::zero())
}

/// The cotangent of `x` in `[x; N]`.
#[inline(always)]
pub fn sum<T: Additive, const N: usize>(cotangents: [T; N]) -> T {
    let mut total = T::zero();
    for cotangent in cotangents {
        total.accumulate(cotangent);
    }
    total
}

/// Passes on what has no derivative, and nothing else.
#[inline(always)]
pub fn constant<T: NoDerivative>(value: T) -> T {
    value
}

/// The value of a block whose end is never reached.
#[cold]
pub fn never<T>() -> T {
    unreachable!("control does not come here")
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

/// `Copy`, asked for in a way that may turn out false. See [`ScalarResult`].
pub trait CopyIf<'a>: Copy {}

impl<T: Copy> CopyIf<'_> for T {}

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
