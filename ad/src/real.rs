//! The scalar that a kernel is generic over.
//!
//! A kernel written once over `S: Real` runs at `f32` and `f64`, on [`Dual`](crate::Dual) numbers
//! (forward mode, and over a generated adjoint second derivatives), and on whatever else
//! implements the trait, SIMD lanes included. For lanes a comparison has one answer per lane, so
//! `Real` does not require `PartialOrd`: comparisons ([`cmplt`](Real::cmplt) and its siblings, the
//! names are glam's) give a [`Mask`], and a kernel chooses with [`select`](fn@crate::select),
//! `max`, `min` and `clamp` instead of `if`. Code for plain scalars writes ordinary Rust on `f32`
//! or `f64` and needs nothing of this.

use core::fmt::Debug;
use core::ops::{
    Add, AddAssign, BitAnd, BitOr, Div, DivAssign, Mul, MulAssign, Neg, Not, Sub, SubAssign,
};

#[cfg(feature = "glam")]
use glam::{DVec3, Vec3};

use crate::rules::operators::{
    AddPullback, Arithmetic, DivPullback, MulPullback, NegPullback, SubPullback,
};
use crate::vector::Vector3;
use crate::{Additive, Differentiable, Fields, NoDerivative};

#[cfg(not(feature = "glam"))]
type Vec3 = crate::vector::Xyz<f32>;
#[cfg(not(feature = "glam"))]
type DVec3 = crate::vector::Xyz<f64>;

/// The outcome of a comparison: `bool`, or one truth value per lane.
pub trait Mask:
    Copy
    + Debug
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
    + Not<Output = Self>
    + NoDerivative
    + Differentiable<Tangent = ()>
    + 'static
{
    /// True where `value` is, in every lane.
    fn splat(value: bool) -> Self;
    /// Whether every lane is true.
    fn all(self) -> bool;
    /// Whether some lane is true.
    fn any(self) -> bool;
}

impl Mask for bool {
    #[inline(always)]
    fn splat(value: bool) -> Self {
        value
    }

    #[inline(always)]
    fn all(self) -> bool {
        self
    }

    #[inline(always)]
    fn any(self) -> bool {
        self
    }
}

/// Values between which a [`Mask`] can choose. See the function [`select`](fn@crate::select).
pub trait Select: Copy {
    /// One truth value, or one per lane.
    type Mask: Mask;

    /// `if_true` where `mask` holds, else `if_false`.
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self;
}

impl<T: Select, const N: usize> Select for [T; N] {
    type Mask = T::Mask;

    #[inline(always)]
    fn select(mask: T::Mask, if_true: Self, mut if_false: Self) -> Self {
        for (chosen, if_true) in if_false.iter_mut().zip(if_true) {
            *chosen = T::select(mask, if_true, *chosen);
        }
        if_false
    }
}

macro_rules! select_by_bool {
    ($($type:ty),* $(,)?) => {$(
        impl Select for $type {
            type Mask = bool;

            #[inline(always)]
            fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
                if mask { if_true } else { if_false }
            }
        }
    )*};
}

#[cfg(feature = "glam")]
pub(crate) use select_by_bool;

/// The comparisons of numbers that bring a derivative along: those of their `value`s.
macro_rules! compared_by_value {
    ($Mask:ty) => {
        $crate::real::compared_by_value!($Mask, cmplt cmple cmpgt cmpge cmpeq);
    };
    ($Mask:ty, $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> $Mask {
            Real::$name(self.value, other.value)
        }
    )*};
}
pub(crate) use compared_by_value;

select_by_bool!(f32, f64);

/// A real number, or several side by side.
///
/// Values follow the functions of the same name on `f64`. The derivative of each stands in
/// [`rules`](crate::rules), with what it is where mathematics has none.
pub trait Real:
    Differentiable<Tangent = Self, Shape = ()>
    + Additive
    + Select
    + Default
    + PartialEq
    + Send
    + Sync
    + Arithmetic
    + Neg<Output = Self>
    + NegPullback
    + Add<Output = Self>
    + AddPullback
    + Sub<Output = Self>
    + SubPullback
    + Mul<Output = Self>
    + MulPullback
    + Div<Output = Self>
    + DivPullback
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    + 'static
{
    /// The vector of three of these: glam's where it has one and the feature `glam` is on, else
    /// [`Xyz`](crate::vector::Xyz).
    type Vec3: Vector3<Scalar = Self> + Select<Mask = Self::Mask> + Fields<Self>;

    /// 0
    const ZERO: Self;
    /// 1
    const ONE: Self;
    /// 2
    const TWO: Self;
    /// 1/2
    const HALF: Self;
    /// The ratio of a circle's circumference to its diameter.
    const PI: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// The smallest positive normal number.
    const MIN_POSITIVE: Self;

    /// The number nearest to `value`, in every lane.
    fn from_f64(value: f64) -> Self;

    /// `self < other`
    fn cmplt(self, other: Self) -> Self::Mask;
    /// `self <= other`
    fn cmple(self, other: Self) -> Self::Mask;
    /// `self > other`
    fn cmpgt(self, other: Self) -> Self::Mask;
    /// `self >= other`
    fn cmpge(self, other: Self) -> Self::Mask;
    /// `self == other`
    fn cmpeq(self, other: Self) -> Self::Mask;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> Self::Mask;
    /// Whether this is exactly zero and stays so in every direction: what a cotangent has to be to
    /// annihilate an infinite partial derivative. A number that carries derivatives of its own, a
    /// [`Dual`](crate::Dual), vanishes only if these are zero too.
    fn vanishes(self) -> Self::Mask;

    /// The smaller of the two; the other one if one is NaN.
    fn min(self, other: Self) -> Self;
    /// The larger of the two; the other one if one is NaN.
    fn max(self, other: Self) -> Self;
    /// The value in `[low, high]` nearest to `self`; NaN if `self` is, but of lanes `low`.
    fn clamp(self, low: Self, high: Self) -> Self;
    /// |self|
    fn abs(self) -> Self;
    /// 1 with the sign of `self`; a zero has a sign too.
    fn signum(self) -> Self;
    /// The magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// The largest integer not above `self`.
    fn floor(self) -> Self;
    /// `1 / self`
    fn recip(self) -> Self;
    /// `self * a + b` with one rounding, where the machine has such an instruction or emulates it.
    fn mul_add(self, a: Self, b: Self) -> Self;
    /// `a * b - c * d` without the cancellation of the plain expression: at most 2 units in the
    /// last place off (Jeannerod, Louvet & Muller 2013).
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self;
    /// The square root.
    fn sqrt(self) -> Self;
    /// e to the power of `self`.
    fn exp(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
    /// `self` to the power of `exponent`.
    fn powf(self, exponent: Self) -> Self;
    /// `self` to the power of `exponent`.
    fn powi(self, exponent: i32) -> Self;
    /// The sine of an angle in radians.
    fn sin(self) -> Self;
    /// The cosine of an angle in radians.
    fn cos(self) -> Self;
    /// The tangent of an angle in radians.
    fn tan(self) -> Self;
    /// The angle in `[-pi/2, pi/2]` whose sine is `self`.
    fn asin(self) -> Self;
    /// The angle in `[0, pi]` whose cosine is `self`.
    fn acos(self) -> Self;
    /// The angle in `[-pi/2, pi/2]` whose tangent is `self`.
    fn atan(self) -> Self;
    /// The angle in `[-pi, pi]` of the point with ordinate `self` and the given abscissa.
    fn atan2(self, abscissa: Self) -> Self;
    /// The hyperbolic tangent.
    fn tanh(self) -> Self;
}

/// A [`Real`] that is one number: it compares to a `bool` and converts to `f64`.
pub trait Scalar: Real<Mask = bool> + PartialOrd {
    /// The value at double precision.
    fn to_f64(self) -> f64;
}

macro_rules! primitive {
    ($type:ident, $vec3:ty, $constants:ident, $difference_of_products:expr) => {
        impl Real for $type {
            type Vec3 = $vec3;

            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const HALF: Self = 0.5;
            const PI: Self = core::$constants::consts::PI;
            const EPSILON: Self = $type::EPSILON;
            const MIN_POSITIVE: Self = $type::MIN_POSITIVE;

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $type
            }

            #[inline(always)]
            fn cmplt(self, other: Self) -> bool {
                self < other
            }

            #[inline(always)]
            fn cmple(self, other: Self) -> bool {
                self <= other
            }

            #[inline(always)]
            fn cmpgt(self, other: Self) -> bool {
                self > other
            }

            #[inline(always)]
            fn cmpge(self, other: Self) -> bool {
                self >= other
            }

            #[inline(always)]
            fn cmpeq(self, other: Self) -> bool {
                self == other
            }

            #[inline(always)]
            fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
                $difference_of_products(a, b, c, d)
            }

            #[inline(always)]
            fn powi(self, exponent: i32) -> Self {
                $type::powi(self, exponent)
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                $type::is_finite(self)
            }

            #[inline(always)]
            fn vanishes(self) -> bool {
                self == 0.0
            }

            primitive!(@unary $type: abs signum floor recip sqrt exp ln sin cos tan asin acos atan tanh);
            primitive!(@binary $type: min max copysign powf atan2);
            primitive!(@ternary $type: clamp mul_add);
        }

        impl Scalar for $type {
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }
    };
    (@unary $type:ident: $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            $type::$name(self)
        }
    )*};
    (@binary $type:ident: $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> Self {
            $type::$name(self, other)
        }
    )*};
    (@ternary $type:ident: $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self, a: Self, b: Self) -> Self {
            $type::$name(self, a, b)
        }
    )*};
}

// Products of two f32 are exact in f64, so one subtraction and one rounding remain.
primitive!(f32, Vec3, f32, |a: f32, b: f32, c: f32, d: f32| {
    (f64::from(a) * f64::from(b) - f64::from(c) * f64::from(d)) as f32
});

// Kahan's algorithm: the rounding error of c * d is recovered and added back.
primitive!(f64, DVec3, f64, |a: f64, b: f64, c: f64, d: f64| {
    let product = c * d;
    let error = (-c).mul_add(d, product);
    a.mul_add(b, -product) + error
});
