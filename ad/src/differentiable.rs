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
//!
//! # Values of any length
//!
//! The tangent of a slice or a `Vec` is a `Vec` of tangents. A zero has to be made without knowing
//! a length ([`Additive::zero`] sees only the type), so elements that a tangent lacks are zeros,
//! and the empty `Vec` is the zero of every length; it costs no allocation. Accumulation grows the
//! shorter side, and a cotangent that a user passes in may be short or empty. What a pullback
//! returns for a parameter is brought to the parameter's own size: what [`Differentiable::shape`]
//! says in the forward sweep, [`Shape::fit`] applies in the reverse sweep. For types whose
//! tangents all have one size the shape is `()`, and nothing of this is left after compilation.
//!
//! Turned down: keeping the value until the reverse sweep to make zeros like it (it would have to
//! be cloned); making each zero with its full length (an allocation for each variable, and a shape
//! to be saved by each iteration of a loop).

use core::fmt::Debug;
use core::marker::PhantomData;

/// A type whose values can be differentiated.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no derivative",
    label = "no derivative passes through a `{Self}`",
    note = "put `#[derive(Differentiable)]` on your own struct or enum, and `#[constant]` below it if no derivative is to pass",
    note = "mark a field, a parameter or a `let` that carries no derivative with `#[constant]`",
    note = "a number of any type is an `S: ad::Real`"
)]
pub trait Differentiable {
    /// The space of its tangents and cotangents.
    type Tangent: Additive;

    /// What tells the size of the tangents of a value: `()` where the type says it all.
    type Shape: Shape<Self::Tangent>;

    /// The shape of this value.
    fn shape(&self) -> Self::Shape;

    /// The zero tangent of this value, of its size.
    #[doc(hidden)]
    #[inline(always)]
    fn zero_tangent(&self) -> Self::Tangent {
        let mut zero = Self::Tangent::zero();
        self.shape().fit(&mut zero);
        zero
    }

    /// 0 if this certainly holds neither infinity nor NaN, so that products with it need no care
    /// (see [singular points](crate::rules#singular-points), where the cotangent
    /// of the result is 0); else NaN, which is always right.
    ///
    /// A number that sums are made of. Turned down: a truth value (four instructions more for each);
    /// bits and `|` of them (the compiler gathers what is tested in vectors, and moves that to and
    /// fro between calls).
    #[doc(hidden)]
    #[inline(always)]
    fn irregularity(&self) -> f64 {
        f64::NAN
    }
}

/// The size of the tangents `T` of some value.
pub trait Shape<T> {
    /// Whether [`fit`](Shape::fit) does nothing for every value, so that lists of such shapes hold
    /// no more than their length.
    const FIXED: bool = false;

    /// Brings a tangent to this size: elements that it lacks become zeros, surplus ones go.
    fn fit(self, tangent: &mut T);
}

/// Tangents that all have one size.
impl<T> Shape<T> for () {
    const FIXED: bool = true;

    #[inline(always)]
    fn fit(self, _: &mut T) {}
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

    /// The only value, to write to.
    pub(crate) fn anywhere<'a>() -> &'a mut Self
    where
        T: 'a,
    {
        anywhere(Self::new())
    }
}

/// A value that takes no room, wherever it may live: there is no allocation.
fn anywhere<'a, T>(value: T) -> &'a mut T {
    const { assert!(size_of::<T>() == 0) };
    Box::leak(Box::new(value))
}

/// A type whose parts have names: what the cotangent of a `#[constant]` field shows of them.
/// `#[derive(Differentiable)]` implements it.
pub trait Parts {
    /// A struct of the same fields, each a [`NoTangent`].
    type Parts;

    /// The only value.
    fn parts() -> Self::Parts;
}

/// The parts of what carries no derivative carry none.
impl<T: Parts> core::ops::Deref for NoTangent<T> {
    type Target = T::Parts;

    #[inline(always)]
    fn deref(&self) -> &T::Parts {
        anywhere(T::parts())
    }
}

impl<T: Parts> core::ops::DerefMut for NoTangent<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut T::Parts {
        anywhere(T::parts())
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
    ($($type:ty => $zero:expr, $sum:expr;)*) => {$(
        impl Differentiable for $type {
            type Tangent = $type;
            type Shape = ();

            #[inline(always)]
            fn shape(&self) {}

            // Infinity and NaN differ from themselves by NaN.
            #[inline(always)]
            fn irregularity(&self) -> f64 {
                let sum: fn($type) -> _ = $sum;
                sum(*self - *self).into()
            }
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

#[cfg(feature = "glam")]
pub(crate) use own_tangent;

own_tangent! {
    f32 => -0.0, |x| x;
    f64 => -0.0, |x| x;
}

/// A type without a derivative: integers, truth values, masks.
#[diagnostic::on_unimplemented(
    message = "a `{Self}` has a derivative, which would be cut here without a word",
    label = "this is used as if it were constant",
    note = "wrap it in `ad::stop_gradient(..)` if that is what you mean",
    note = "a type of your own that holds no numbers with derivatives gets `#[derive(Differentiable)]` and `#[constant]`",
    note = "a method of your own that gives it and has the name of a comparison or a test (`is_..`, `len`, `any`, `cmp`) is called by its path: `Type::len(&value)`"
)]
pub trait NoDerivative: Differentiable {}

macro_rules! no_derivative {
    ($($type:ty),* $(,)?) => {$(
        impl Differentiable for $type {
            type Tangent = ();
            type Shape = ();

            #[inline(always)]
            fn shape(&self) {}

            #[inline(always)]
            fn irregularity(&self) -> f64 {
                0.0
            }
        }

        impl NoDerivative for $type {}
    )*};
}

pub(crate) use no_derivative;

no_derivative!(
    bool, char, str, String, i8, i16, i32, i64, i128, isize, u8, u16, u32, u64, u128, usize
);

no_derivative!(
    core::array::TryFromSliceError,
    core::char::ParseCharError,
    core::cmp::Ordering,
    core::fmt::Error,
    core::num::ParseFloatError,
    core::num::ParseIntError,
    core::num::TryFromIntError,
    core::str::ParseBoolError,
    core::str::Utf8Error,
    std::string::FromUtf8Error
);

impl<T: NoDerivative + ?Sized> NoDerivative for &T {}
impl<T: NoDerivative> NoDerivative for Option<T> {}
impl<T: NoDerivative, E: NoDerivative> NoDerivative for Result<T, E> {}
