//! Derivatives of the methods of vectors.

use super::{chain, scale, scale_elements, scale_vector};
use crate::rules::RealRules;
use crate::vector::{Vector, Vector3};
use crate::{Additive, Real, Select};

/// The `_vjp` siblings of the methods of [`Vector`].
pub trait VectorRules: Vector {
    /// The sum of the cotangents of the elements.
    #[inline(always)]
    fn splat_vjp(value: Self::Scalar) -> (Self, impl FnOnce(Self) -> Self::Scalar) {
        (Self::splat(value), |g: Self| g.element_sum())
    }

    /// The cotangent of the sum, to each element.
    #[inline(always)]
    fn element_sum_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self) {
        (self.element_sum(), Self::splat)
    }

    /// All to the first of the smallest elements.
    #[inline(always)]
    fn min_element_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self) {
        let value = self.min_element();
        (value, move |g| to_first_equal(self, value, g))
    }

    /// All to the first of the largest elements.
    #[inline(always)]
    fn max_element_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self) {
        let value = self.max_element();
        (value, move |g| to_first_equal(self, value, g))
    }

    /// Each vector, times the cotangent, to the other.
    #[inline(always)]
    fn dot_vjp(self, other: Self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> (Self, Self)) {
        (self.dot(other), move |g| (scale_vector(g, other), scale_vector(g, self)))
    }

    /// v/|v|; 0 at 0.
    #[inline(always)]
    fn length_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self) {
        let length = self.length();
        (length, move |g| length_pullback(self, length, g))
    }

    /// 2 v
    #[inline(always)]
    fn length_squared_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self) {
        (self.length_squared(), move |g| scale_vector(g + g, self))
    }

    /// -v/|v|^3; 0 at 0.
    #[inline(always)]
    fn length_recip_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self) {
        let value = self.length_recip();
        (value, move |g| {
            let defined = value.is_finite() & !g.vanishes();
            // One factor at a time: the square of a large one would not be representable.
            self.map_elements(|s| {
                Self::Scalar::select(
                    defined,
                    -(g * value * (s * value) * value),
                    Self::Scalar::zero(),
                )
            })
        })
    }

    /// The derivative of the length of the difference; 0 where the points coincide.
    #[inline(always)]
    fn distance_vjp(
        self,
        other: Self,
    ) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> (Self, Self)) {
        let distance = self.distance(other);
        (distance, move |g| {
            let to_self = length_pullback(self - other, distance, g);
            (to_self, -to_self)
        })
    }

    /// Twice the difference.
    #[inline(always)]
    fn distance_squared_vjp(
        self,
        other: Self,
    ) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> (Self, Self)) {
        (self.distance_squared(other), move |g| {
            let to_self = scale_vector(g + g, self - other);
            (to_self, -to_self)
        })
    }

    /// (I - u u^T)/|v| with u the unit vector; 0 at 0.
    #[inline(always)]
    fn normalize_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let unit = self.normalize();
        (unit, move |g| normalize_pullback(unit, self.length_recip(), g))
    }

    /// As [`normalize_vjp`](Self::normalize_vjp); 0 where the value is 0.
    #[inline(always)]
    fn normalize_or_zero_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let unit = self.normalize_or_zero();
        (unit, move |g| normalize_pullback(unit, self.length_recip(), g))
    }

    /// The smaller one's cotangent, element by element; a tie is the receiver's.
    #[inline(always)]
    fn min_vjp(self, other: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
        let value = self.min(other);
        (value, move |g| route_elements(self, value, g))
    }

    /// The larger one's cotangent, element by element; a tie is the receiver's.
    #[inline(always)]
    fn max_vjp(self, other: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
        let value = self.max(other);
        (value, move |g| route_elements(self, value, g))
    }

    /// The receiver's within the bounds and on them, else the bound's.
    #[inline(always)]
    fn clamp_vjp(self, low: Self, high: Self) -> (Self, impl FnOnce(Self) -> (Self, Self, Self)) {
        let value = self.clamp(low, high);
        (value, move |g| {
            let (to_self, outside) = route_elements(self, value, g);
            let (to_low, to_high) = route_elements(low, value, outside);
            (to_self, to_low, to_high)
        })
    }

    /// The sign of each element; 0 at 0.
    #[inline(always)]
    fn abs_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.abs(), move |g: Self| g.zip_elements(self, |g, s| s.abs_vjp().1(g)))
    }

    /// -1/x^2 of each element; 0 at 0.
    #[inline(always)]
    fn recip_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.recip(), move |g: Self| g.zip_elements(self, |g, s| s.recip_vjp().1(g)))
    }

    /// exp(x) of each element.
    #[inline(always)]
    fn exp_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        let value = self.exp();
        (value, move |g: Self| g.zip_elements(value, chain))
    }

    /// 1/(2 sqrt(x)) of each element; 0 at 0.
    #[inline(always)]
    fn sqrt_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
        (self.sqrt(), move |g: Self| g.zip_elements(self, |g, s| s.sqrt_vjp().1(g)))
    }

    /// The rule of the scalar `powf` for each element.
    #[inline(always)]
    fn powf_vjp(self, exponent: Self::Scalar) -> (Self, impl FnOnce(Self) -> (Self, Self::Scalar)) {
        (self.powf(exponent), move |g: Self| {
            let to_self = g.zip_elements(self, |g, s| s.powf_vjp(exponent).1(g).0);
            let to_exponent = g.zip_elements(self, |g, s| s.powf_vjp(exponent).1(g).1);
            (to_self, to_exponent.element_sum())
        })
    }

    /// The cotangents of both ends and of the parameter.
    #[inline(always)]
    fn lerp_vjp(
        self,
        other: Self,
        s: Self::Scalar,
    ) -> (Self, impl FnOnce(Self) -> (Self, Self, Self::Scalar)) {
        (self.lerp(other, s), move |g: Self| {
            (
                g.map_elements(|g| scale(g, Self::Scalar::ONE - s)),
                g.map_elements(|g| scale(g, s)),
                scale_elements(g, other - self).element_sum(),
            )
        })
    }

    /// The cotangents of the vector and of the normal, all of whose elements count as free.
    #[inline(always)]
    fn reflect_vjp(self, normal: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
        (self.reflect(normal), move |g: Self| {
            let twice_g_n = scale_elements(g + g, normal).element_sum();
            let twice_v_n = (self + self).dot(normal);
            (
                g - scale_vector(twice_g_n, normal),
                -(g.map_elements(|g| scale(g, twice_v_n)) + scale_vector(twice_g_n, self)),
            )
        })
    }
}

impl<V: Vector> VectorRules for V {}

/// The `_vjp` siblings of the methods of [`Vector3`].
pub trait Vector3Rules: Vector3 {
    /// The cotangents of the elements.
    #[inline(always)]
    #[allow(clippy::type_complexity)]
    fn new_vjp(
        x: Self::Scalar,
        y: Self::Scalar,
        z: Self::Scalar,
    ) -> (Self, impl FnOnce(Self) -> (Self::Scalar, Self::Scalar, Self::Scalar)) {
        (Self::new(x, y, z), |g: Self| (g.x(), g.y(), g.z()))
    }

    /// The cotangent of the first element.
    #[inline(always)]
    fn x_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self) {
        (self.x(), |g| Self::new(g, Self::Scalar::zero(), Self::Scalar::zero()))
    }

    /// The cotangent of the second element.
    #[inline(always)]
    fn y_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self) {
        (self.y(), |g| Self::new(Self::Scalar::zero(), g, Self::Scalar::zero()))
    }

    /// The cotangent of the third element.
    #[inline(always)]
    fn z_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self) {
        (self.z(), |g| Self::new(Self::Scalar::zero(), Self::Scalar::zero(), g))
    }

    /// b x g and g x a.
    #[inline(always)]
    fn cross_vjp(self, other: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
        (self.cross(other), move |g| (-scaled_cross(g, other), scaled_cross(g, self)))
    }
}

impl<V: Vector3> Vector3Rules for V {}

macro_rules! new_rules {
    ($($name:ident $type:ident $scalar:ident ($($element:ident),*) ($($tuple:ty),*);)*) => {$(
        #[doc = concat!("The `_vjp` sibling of `", stringify!($type), "::new`.")]
        pub trait $name: Sized {
            /// The cotangents of the elements.
            #[allow(clippy::type_complexity)]
            fn new_vjp($($element: $scalar),*) -> (Self, impl FnOnce(Self) -> ($($tuple),*));
        }

        impl $name for glam::$type {
            #[inline(always)]
            #[allow(clippy::type_complexity, refining_impl_trait)]
            fn new_vjp($($element: $scalar),*) -> (Self, impl FnOnce(Self) -> ($($tuple),*)) {
                (Self::new($($element),*), |g: Self| ($(g.$element),*))
            }
        }
    )*};
}

new_rules! {
    Vec2Rules Vec2 f32 (x, y) (f32, f32);
    Vec4Rules Vec4 f32 (x, y, z, w) (f32, f32, f32, f32);
    DVec2Rules DVec2 f64 (x, y) (f64, f64);
    DVec4Rules DVec4 f64 (x, y, z, w) (f64, f64, f64, f64);
}

/// `g x v`, where a zero element of `g` annihilates whatever it meets.
#[inline(always)]
fn scaled_cross<V: Vector3>(g: V, v: V) -> V {
    V::new(
        scale(g.y(), v.z()) - scale(g.z(), v.y()),
        scale(g.z(), v.x()) - scale(g.x(), v.z()),
        scale(g.x(), v.y()) - scale(g.y(), v.x()),
    )
}

/// The pullback of `length = |vector|`.
#[inline(always)]
fn length_pullback<V: Vector>(vector: V, length: V::Scalar, cotangent: V::Scalar) -> V {
    let singular = length.cmpeq(V::Scalar::ZERO) | cotangent.vanishes();
    vector
        .map_elements(|v| V::Scalar::select(singular, V::Scalar::zero(), cotangent * (v / length)))
}

/// The pullback of `unit = vector * length_recip`.
#[inline(always)]
fn normalize_pullback<V: Vector>(unit: V, length_recip: V::Scalar, cotangent: V) -> V {
    let defined = length_recip.is_finite() & length_recip.cmpgt(V::Scalar::ZERO);
    let along = scale_elements(cotangent, unit).element_sum();
    let across = cotangent - scale_vector(along, unit);
    across.map_elements(|a| V::Scalar::select(defined, scale(a, length_recip), V::Scalar::zero()))
}

/// `cotangent` to `vector` where its element is the value, else to the other.
#[inline(always)]
fn route_elements<V: Vector>(vector: V, value: V, cotangent: V) -> (V, V) {
    let chosen = value.zip_elements(vector, |value, element| {
        V::Scalar::select(value.cmpeq(element), V::Scalar::ONE, V::Scalar::ZERO)
    });
    let pick = |wanted: V::Scalar| {
        cotangent
            .zip_elements(chosen, |g, c| V::Scalar::select(c.cmpeq(wanted), g, V::Scalar::zero()))
    };
    (pick(V::Scalar::ONE), pick(V::Scalar::ZERO))
}

/// `cotangent` to the first element that equals `value`.
#[inline(always)]
fn to_first_equal<V: Vector>(vector: V, value: V::Scalar, cotangent: V::Scalar) -> V {
    let remaining = core::cell::Cell::new(cotangent);
    vector.map_elements(|element| {
        let equal = element.cmpeq(value);
        let share = V::Scalar::select(equal, remaining.get(), V::Scalar::zero());
        remaining.set(V::Scalar::select(equal, V::Scalar::zero(), remaining.get()));
        share
    })
}
