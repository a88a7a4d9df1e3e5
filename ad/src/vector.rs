//! Vectors: what the rules and generic kernels need of them, with the names that glam has, and [`Xyz`]
//! for scalars of which glam has none.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use crate::differentiable::Parts;
use crate::rules::operators::{
    AddPullback, Arithmetic, DivPullback, MulPullback, NegPullback, SubPullback,
};
use crate::{Additive, Differentiable, NoTangent, Real, Select};

/// A vector over [`Scalar`](Vector::Scalar), with glam's names and glam's values.
///
/// In generic code the scalar stands on the right: `v * s` (the supertraits of [`Real`] cannot
/// name a vector).
pub trait Vector:
    Differentiable<Tangent = Self, Shape = ()>
    + Additive
    + Copy
    + Debug
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
    + Mul<Self::Scalar, Output = Self>
    + MulPullback<Self::Scalar>
    + Div<Self::Scalar, Output = Self>
    + DivPullback<Self::Scalar>
    + 'static
{
    /// The type of the elements.
    type Scalar: Real;

    /// The vector of zeros.
    const ZERO: Self;
    /// The vector of ones.
    const ONE: Self;

    /// All elements `value`.
    fn splat(value: Self::Scalar) -> Self;
    /// `f` of each element.
    fn map_elements(self, f: impl Fn(Self::Scalar) -> Self::Scalar) -> Self;
    /// `f` of each pair of elements.
    fn zip_elements(
        self,
        other: Self,
        f: impl Fn(Self::Scalar, Self::Scalar) -> Self::Scalar,
    ) -> Self;
    /// The sum of the elements.
    fn element_sum(self) -> Self::Scalar;
    /// The smallest element.
    fn min_element(self) -> Self::Scalar;
    /// The largest element.
    fn max_element(self) -> Self::Scalar;
    /// The inner product.
    fn dot(self, other: Self) -> Self::Scalar;
    /// The Euclidean norm.
    fn length(self) -> Self::Scalar;
    /// The square of the Euclidean norm.
    fn length_squared(self) -> Self::Scalar;
    /// One over the Euclidean norm.
    fn length_recip(self) -> Self::Scalar;
    /// The length of the difference.
    fn distance(self, other: Self) -> Self::Scalar;
    /// The squared length of the difference.
    fn distance_squared(self, other: Self) -> Self::Scalar;
    /// The unit vector of the same direction; not finite for the zero vector.
    fn normalize(self) -> Self;
    /// The unit vector of the same direction, or zero where that is not finite.
    fn normalize_or_zero(self) -> Self;
    /// The smaller of each pair of elements.
    fn min(self, other: Self) -> Self;
    /// The larger of each pair of elements.
    fn max(self, other: Self) -> Self;
    /// Each element clamped to the elements of `low` and `high`.
    fn clamp(self, low: Self, high: Self) -> Self;
    /// The absolute value of each element.
    fn abs(self) -> Self;
    /// One over each element.
    fn recip(self) -> Self;
    /// e to the power of each element.
    fn exp(self) -> Self;
    /// The square root of each element.
    fn sqrt(self) -> Self;
    /// Each element to the power of `exponent`.
    fn powf(self, exponent: Self::Scalar) -> Self;
    /// The point at `s` on the way from `self` (0) to `other` (1).
    fn lerp(self, other: Self, s: Self::Scalar) -> Self;
    /// `self` mirrored at the plane with the unit normal `normal`.
    fn reflect(self, normal: Self) -> Self;
}

/// A vector in space.
pub trait Vector3: Vector {
    /// The vector `(x, y, z)`.
    fn new(x: Self::Scalar, y: Self::Scalar, z: Self::Scalar) -> Self;
    /// The first element.
    fn x(self) -> Self::Scalar;
    /// The second element.
    fn y(self) -> Self::Scalar;
    /// The third element.
    fn z(self) -> Self::Scalar;
    /// The vector product.
    fn cross(self, other: Self) -> Self;
}

/// The vector of three scalars for which glam has none, as [`Dual`](crate::Dual) numbers and lanes, and of
/// every scalar without the feature `glam`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Xyz<S> {
    /// The first element.
    pub x: S,
    /// The second element.
    pub y: S,
    /// The third element.
    pub z: S,
}

impl<S: Real> Differentiable for Xyz<S> {
    type Tangent = Self;
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}

    #[inline(always)]
    fn irregularity(&self) -> f64 {
        self.x.irregularity() + self.y.irregularity() + self.z.irregularity()
    }
}

impl<S: Real> Parts for Xyz<S> {
    type Parts = Xyz<NoTangent<S>>;

    #[inline(always)]
    fn parts() -> Self::Parts {
        Xyz::default()
    }
}

impl<S: Real> Additive for Xyz<S> {
    #[inline(always)]
    fn zero() -> Self {
        Self { x: S::zero(), y: S::zero(), z: S::zero() }
    }

    #[inline(always)]
    fn accumulate(&mut self, other: Self) {
        self.x.accumulate(other.x);
        self.y.accumulate(other.y);
        self.z.accumulate(other.z);
    }
}

impl<S: Real> Select for Xyz<S> {
    type Mask = S::Mask;

    #[inline(always)]
    fn select(mask: S::Mask, if_true: Self, if_false: Self) -> Self {
        if_true.zip_elements(if_false, |t, f| S::select(mask, t, f))
    }
}

impl<S: Real> Neg for Xyz<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map_elements(|s| -s)
    }
}

macro_rules! elementwise {
    ($($operator:ident $method:ident $symbol:tt),*) => {$(
        impl<S: Real> $operator for Xyz<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip_elements(other, |a, b| a $symbol b)
            }
        }
    )*};
}

elementwise!(Add add +, Sub sub -, Mul mul *);

impl<S: Real> AddAssign for Xyz<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<S: Real> Mul<S> for Xyz<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: S) -> Self {
        self.map_elements(|s| s * factor)
    }
}

impl<S: Real> Div<S> for Xyz<S> {
    type Output = Self;

    #[inline(always)]
    fn div(self, divisor: S) -> Self {
        self.map_elements(|s| s / divisor)
    }
}

impl<S: Real> Vector for Xyz<S> {
    type Scalar = S;

    const ZERO: Self = Self { x: S::ZERO, y: S::ZERO, z: S::ZERO };
    const ONE: Self = Self { x: S::ONE, y: S::ONE, z: S::ONE };

    #[inline(always)]
    fn splat(value: S) -> Self {
        Self { x: value, y: value, z: value }
    }

    #[inline(always)]
    fn map_elements(self, f: impl Fn(S) -> S) -> Self {
        Self { x: f(self.x), y: f(self.y), z: f(self.z) }
    }

    #[inline(always)]
    fn zip_elements(self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        Self { x: f(self.x, other.x), y: f(self.y, other.y), z: f(self.z, other.z) }
    }

    #[inline(always)]
    fn element_sum(self) -> S {
        self.x + self.y + self.z
    }

    #[inline(always)]
    fn min_element(self) -> S {
        self.x.min(self.y.min(self.z))
    }

    #[inline(always)]
    fn max_element(self) -> S {
        self.x.max(self.y.max(self.z))
    }

    #[inline(always)]
    fn dot(self, other: Self) -> S {
        (self * other).element_sum()
    }

    #[inline(always)]
    fn length(self) -> S {
        self.dot(self).sqrt()
    }

    #[inline(always)]
    fn length_squared(self) -> S {
        self.dot(self)
    }

    #[inline(always)]
    fn length_recip(self) -> S {
        self.length().recip()
    }

    #[inline(always)]
    fn distance(self, other: Self) -> S {
        (self - other).length()
    }

    #[inline(always)]
    fn distance_squared(self, other: Self) -> S {
        (self - other).length_squared()
    }

    #[inline(always)]
    fn normalize(self) -> Self {
        self * self.length_recip()
    }

    #[inline(always)]
    fn normalize_or_zero(self) -> Self {
        let scale = self.length_recip();
        let usable = scale.is_finite() & scale.cmpgt(S::ZERO);
        Self::select(usable, self * scale, Self::ZERO)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip_elements(other, S::min)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip_elements(other, S::max)
    }

    #[inline(always)]
    fn clamp(self, low: Self, high: Self) -> Self {
        self.max(low).min(high)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.map_elements(S::abs)
    }

    #[inline(always)]
    fn recip(self) -> Self {
        self.map_elements(S::recip)
    }

    #[inline(always)]
    fn exp(self) -> Self {
        self.map_elements(S::exp)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map_elements(S::sqrt)
    }

    #[inline(always)]
    fn powf(self, exponent: S) -> Self {
        self.map_elements(|s| s.powf(exponent))
    }

    #[inline(always)]
    fn lerp(self, other: Self, s: S) -> Self {
        self * (S::ONE - s) + other * s
    }

    #[inline(always)]
    fn reflect(self, normal: Self) -> Self {
        self - normal * (S::TWO * self.dot(normal))
    }
}

impl<S: Real> Vector3 for Xyz<S> {
    #[inline(always)]
    fn new(x: S, y: S, z: S) -> Self {
        Self { x, y, z }
    }

    #[inline(always)]
    fn x(self) -> S {
        self.x
    }

    #[inline(always)]
    fn y(self) -> S {
        self.y
    }

    #[inline(always)]
    fn z(self) -> S {
        self.z
    }

    #[inline(always)]
    fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - other.y * self.z,
            y: self.z * other.x - other.z * self.x,
            z: self.x * other.y - other.x * self.y,
        }
    }
}
