//! `&mut` that a call is given, where the parameter may be a `&`.
//!
//! The macro knows no signature of what it calls, and a pullback takes cotangents of `&mut` parameters alone. Where
//! several of them could be meant, each is given by [`Taken::by`], whose result is of the parameter's type, and
//! goes with the pullback: which cotangents that takes its type then tells. Turned down: telling them by the number that the
//! pullback takes, since `a.add(b)` takes one by `(&mut self, &V)` and by `(&self, &mut V)`.

use std::marker::PhantomData;

use super::{MethodPullback, OfChanged, Take};

/// The parameter is a `&`.
pub enum Looked {}

/// The parameter is a `&mut`.
pub enum Changed {}

/// How a call took what it was given: `Looked` or `Changed`.
pub struct Taken<How>(PhantomData<fn() -> How>);

impl<How> Taken<How> {
    /// The call tells.
    #[inline(always)]
    #[allow(clippy::new_without_default)]
    pub fn new() -> Self {
        Self(PhantomData)
    }

    /// What the call is given.
    #[inline(always)]
    pub fn by<'a, T: ?Sized, R: Reborrow<'a, T, How = How>>(&self, place: &'a mut T) -> R {
        R::reborrow(place)
    }
}

/// A reference that a `&mut T` may be passed as.
pub trait Reborrow<'a, T: ?Sized> {
    /// `Looked` or `Changed`.
    type How;

    /// The reference.
    fn reborrow(place: &'a mut T) -> Self;
}

impl<'a, T: Holds<U> + ?Sized, U: ?Sized> Reborrow<'a, T> for &'a U {
    type How = Looked;

    #[inline(always)]
    fn reborrow(place: &'a mut T) -> Self {
        place.held()
    }
}

impl<'a, T: Holds<U> + ?Sized, U: ?Sized> Reborrow<'a, T> for &'a mut U {
    type How = Changed;

    #[inline(always)]
    fn reborrow(place: &'a mut T) -> Self {
        place.held()
    }
}

/// What references are coerced to.
pub trait Holds<U: ?Sized> {
    /// What is held.
    fn held(&mut self) -> &mut U;
}

macro_rules! holds {
    ($([$($generics:tt)*] $from:ty => $to:ty;)*) => {$(
        impl<$($generics)*> Holds<$to> for $from {
            #[inline(always)]
            fn held(&mut self) -> &mut $to {
                self
            }
        }
    )*};
}

holds! {
    [T: ?Sized] T => T;
    [T] Vec<T> => [T];
    [T, const N: usize] [T; N] => [T];
    [T: ?Sized] Box<T> => T;
}

/// The pullback of a call, and how the call took each `&mut` that it was given.
pub struct Told<F, Arguments> {
    pullback: F,
    arguments: PhantomData<fn() -> Arguments>,
}

/// The value of a call, and its pullback with what the call took.
#[inline(always)]
pub fn told<V, F, Arguments>((value, pullback): (V, F), _: Arguments) -> (V, Told<F, Arguments>) {
    (value, Told { pullback, arguments: PhantomData })
}

impl<F, Arguments> Told<F, Arguments> {
    /// Calls the pullback; `taken` are the cotangents of the arguments that were changed.
    #[inline(always)]
    pub fn pull_back<C, R: ?Sized, Given: Joined, Kind>(
        self,
        cotangent: C,
        receiver: &mut R,
        taken: Given,
    ) -> F::Parts
    where
        F: MethodPullback<C, R, Given::All, Kind>,
    {
        self.pullback.pull_back(cotangent, receiver, taken.joined())
    }
}

/// The cotangent of an argument for the pullback of a call that took it so: `(cotangent,)`, or `()`.
pub trait TakeFrom<P: ?Sized, Given, Kind> {
    /// What is given.
    fn take_from(place: &mut P) -> Given;
}

impl<P: ?Sized> TakeFrom<P, (), ()> for Looked {
    #[inline(always)]
    fn take_from(_: &mut P) {}
}

impl<P: Take<T, Kind> + ?Sized, T, Kind: OfChanged<T>> TakeFrom<P, (T,), Kind> for Changed {
    #[inline(always)]
    fn take_from(place: &mut P) -> (T,) {
        (place.take(),)
    }
}

macro_rules! arguments {
    ($(($($how:ident)*) $($take:ident $taken:ident)*;)*) => {$(
        impl<F, $($how),*> Told<F, ($(Taken<$how>,)*)> {$(
            /// The cotangent of the argument at that place.
            #[inline(always)]
            pub fn $take<P: ?Sized, Given, Kind>(&self, place: &mut P) -> Given
            where
                $taken: TakeFrom<P, Given, Kind>,
            {
                $taken::take_from(place)
            }
        )*}
    )*};
}

arguments! {
    (A) take_0 A;
    (A B) take_0 A take_1 B;
    (A B C) take_0 A take_1 B take_2 C;
    (A B C D) take_0 A take_1 B take_2 C take_3 D;
    (A B C D E) take_0 A take_1 B take_2 C take_3 D take_4 E;
    (A B C D E G) take_0 A take_1 B take_2 C take_3 D take_4 E take_5 G;
}

/// Tuples of `(cotangent,)` and `()`.
pub trait Joined {
    /// The cotangents, without what is `()`.
    type All;

    /// Takes them out.
    fn joined(self) -> Self::All;
}

macro_rules! joined {
    ($given:tt $taken:tt) => {
        joined!(@of $given $taken);
    };
    ([$($given:tt)*] [$($taken:ident)*] $next:ident $($rest:ident)*) => {
        joined!(@of [$($given)*] [$($taken)*]);
        joined!([$($given)* ($next,)] [$($taken)* $next] $($rest)*);
        joined!([$($given)* ()] [$($taken)*] $($rest)*);
    };
    (@of [] []) => {};
    (@of [$($given:tt)*] [$($taken:ident)*]) => {
        impl<$($taken),*> Joined for ($($given,)*) {
            type All = ($($taken,)*);

            #[inline(always)]
            #[allow(non_snake_case, clippy::unused_unit)]
            fn joined(self) -> Self::All {
                let ($($given,)*) = self;
                ($($taken,)*)
            }
        }
    };
}

joined!([] [] A B C D E G);
