//! What has a derivative, and in which space the derivative lives.
//!
//! Every type that crosses a `#[differentiable]` function implements [`Differentiable`]: it names
//! the type of its tangents and cotangents. Floats and vectors are their own tangents; integers
//! and booleans have the tangent `()`, so that they vanish from generated code by their type;
//! structs get a twin (`Ray` -> `RayTangent`) from `#[derive(Differentiable)]`.
//!
//! Tangent and cotangent share one type. Keeping them apart would let the compiler catch a mix-up
//! of forward and reverse mode, but would double every derived struct; all spaces here are finite
//! products of scalars, where the two coincide.

use core::fmt::Debug;
use core::marker::PhantomData;
use core::ops::ControlFlow;

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

/// A type whose values can be differentiated.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no derivative",
    label = "no derivative passes through a `{Self}`",
    note = "put `#[derive(Differentiable)]` on your own struct",
    note = "mark a struct field that carries no derivative with `#[constant]`"
)]
pub trait Differentiable {
    /// The space of its tangents and cotangents.
    type Tangent: Additive;
}

/// The tangent (and cotangent) type of `T`.
pub type Tangent<T> = <T as Differentiable>::Tangent;

/// A commutative group under accumulation: what a cotangent has to be.
pub trait Additive: Clone + Debug {
    /// The neutral element of [`accumulate`](Additive::accumulate).
    ///
    /// For floats this is `-0.0`, which equals `0.0` and is the only exact identity in IEEE 754
    /// (`-0.0 + x` is `x`, bit for bit, for every `x`); so the compiler may delete the addition.
    fn zero() -> Self;

    /// Adds `other` to `self`.
    fn accumulate(&mut self, other: Self);
}

/// The tangent of something that carries no derivative, such as a `#[constant]` field of type `T`.
pub struct NoTangent<T: ?Sized>(PhantomData<fn() -> T>);

impl<T: ?Sized> NoTangent<T> {
    /// The only value.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T: ?Sized> Default for NoTangent<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: ?Sized> Clone for NoTangent<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: ?Sized> Copy for NoTangent<T> {}

impl<T: ?Sized> Debug for NoTangent<T> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("NoTangent")
    }
}

impl<T: ?Sized> PartialEq for NoTangent<T> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl<T: ?Sized> Additive for NoTangent<T> {
    fn zero() -> Self {
        Self::new()
    }

    fn accumulate(&mut self, _: Self) {}
}

macro_rules! own_tangent {
    ($($type:ty => $zero:expr),* $(,)?) => {$(
        impl Differentiable for $type {
            type Tangent = $type;
        }

        impl Additive for $type {
            #[inline(always)]
            fn zero() -> Self {
                $zero
            }

            #[inline(always)]
            fn accumulate(&mut self, other: Self) {
                *self += other;
            }
        }
    )*};
}

own_tangent! {
    f32 => -0.0,
    f64 => -0.0,
    Vec2 => Vec2::splat(-0.0),
    Vec3 => Vec3::splat(-0.0),
    Vec4 => Vec4::splat(-0.0),
    DVec2 => DVec2::splat(-0.0),
    DVec3 => DVec3::splat(-0.0),
    DVec4 => DVec4::splat(-0.0),
}

/// A type without a derivative: integers, truth values, masks.
#[diagnostic::on_unimplemented(
    message = "a `{Self}` has a derivative, which would be cut here without a word",
    label = "this is used as if it were constant",
    note = "wrap it in `ad::stop_gradient(..)` if that is what you mean"
)]
pub trait NoDerivative: Differentiable<Tangent = ()> {}

macro_rules! no_derivative {
    ($($type:ty),* $(,)?) => {$(
        impl Differentiable for $type {
            type Tangent = ();
        }

        impl NoDerivative for $type {}
    )*};
}

no_derivative!(core::cmp::Ordering);

impl<T: NoDerivative> NoDerivative for Option<T> {}

no_derivative!(bool, char, str, i8, i16, i32, i64, i128, isize, u8, u16, u32, u64, u128, usize);

impl<T: Differentiable + ?Sized> Differentiable for &T {
    type Tangent = Tangent<T>;
}

/// The cotangent of an option is that of its content; nothing flows into a `None`.
impl<T: Differentiable> Differentiable for Option<T> {
    type Tangent = Tangent<T>;
}

/// One cotangent for either outcome; that of the outcome which did not occur stays zero.
impl<B: Differentiable, C: Differentiable> Differentiable for ControlFlow<B, C> {
    type Tangent = (Tangent<B>, Tangent<C>);
}

impl<T: Differentiable, const N: usize> Differentiable for [T; N] {
    type Tangent = [Tangent<T>; N];
}

impl<T: Additive, const N: usize> Additive for [T; N] {
    #[inline(always)]
    fn zero() -> Self {
        core::array::from_fn(|_| T::zero())
    }

    #[inline(always)]
    fn accumulate(&mut self, other: Self) {
        for (mine, theirs) in self.iter_mut().zip(other) {
            mine.accumulate(theirs);
        }
    }
}

macro_rules! tuples {
    ($(($($name:ident $index:tt),*))*) => {$(
        impl<$($name: Differentiable),*> Differentiable for ($($name,)*) {
            type Tangent = ($(Tangent<$name>,)*);
        }

        impl<$($name: Additive),*> Additive for ($($name,)*) {
            #[inline(always)]
            fn zero() -> Self {
                ($($name::zero(),)*)
            }

            #[inline(always)]
            #[allow(unused_variables)]
            fn accumulate(&mut self, other: Self) {
                $(self.$index.accumulate(other.$index);)*
            }
        }
    )*};
}

#[allow(clippy::unused_unit)]
mod tuples {
    use super::{Additive, Differentiable, Tangent};

    tuples! {
        ()
        (A 0)
        (A 0, B 1)
        (A 0, B 1, C 2)
        (A 0, B 1, C 2, D 3)
        (A 0, B 1, C 2, D 3, E 4)
        (A 0, B 1, C 2, D 3, E 4, F 5)
        (A 0, B 1, C 2, D 3, E 4, F 5, G 6)
        (A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7)
        (A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7, I 8)
        (A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7, I 8, J 9)
        (A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7, I 8, J 9, K 10)
        (A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7, I 8, J 9, K 10, L 11)
    }
}
