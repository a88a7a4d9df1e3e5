//! The rules of the methods of vectors.

use super::linear::{
    self, Along, Chosen, Elements, Gradient, Maps, Negated, Pulled, Scaled, Symmetric, inner,
};
use super::row::rules;
use super::scalar::power_partials;
use super::scale_vector::{scale_elements, scale_vector};
use super::{RealRules, chain, scale};
use crate::vector::{Vector, Vector3};
use crate::{Additive, Real, Select};

rules! {
    /// The rules of the methods of [`Vector`].
    VectorRules for every Vector {
        splat(value: Self::Scalar) -> Self: |g| g.element_sum();
        element_sum(v) -> Self::Scalar: Self::splat;
        /// All to the first of the smallest elements.
        min_element(v) -> Self::Scalar = value => Pulled(|g| to_first_equal(v, value, g));
        /// All to the first of the largest elements.
        max_element(v) -> Self::Scalar = value => Pulled(|g| to_first_equal(v, value, g));
        dot(a, b: Self) -> Self::Scalar => (Gradient(b), Gradient(a));
        length(v) -> Self::Scalar = length => Pulled(|g| length_pullback(v, length, g));
        length_squared(v) -> Self::Scalar => Gradient(v + v);
        length_recip(v) -> Self::Scalar = recip => Pulled(|g| length_recip_pullback(v, recip, g));
        /// 0 where the points coincide.
        distance(a, b: Self) -> Self::Scalar = distance => {
            let by_difference = Pulled(move |g| length_pullback(a - b, distance, g));
            (by_difference, Negated(by_difference))
        };
        distance_squared(a, b: Self) -> Self::Scalar => {
            let twice = (a - b) + (a - b);
            (Gradient(twice), Gradient(-twice))
        };
        /// (I - u u^T)/|v| with u the unit vector; 0 at 0.
        normalize(v) = unit => Symmetric(|g| normalize_pullback(unit, v.length_recip(), g));
        /// 0 where the value is 0.
        normalize_or_zero(v) = unit => Symmetric(|g| normalize_pullback(unit, v.length_recip(), g));
        /// The smaller one, element by element; a tie is the receiver's.
        min(x, y) = value => {
            let first = are_equal(value, x);
            (Chosen(first), Chosen(Self::ONE - first))
        };
        /// The larger one, element by element; a tie is the receiver's.
        max(x, y) = value => {
            let first = are_equal(value, x);
            (Chosen(first), Chosen(Self::ONE - first))
        };
        /// The receiver within the bounds and on them, else the bound.
        clamp(x, low, high) = value => {
            let one_if = |holds| Select::select(holds, Self::Scalar::ONE, Self::Scalar::ZERO);
            let below = x.zip_elements(low, |x, low| one_if(x.cmplt(low)));
            let within = are_equal(value, x);
            let outside = Self::ONE - within;
            (Chosen(within), Chosen(outside * below), Chosen(outside * (Self::ONE - below)))
        };
        abs(v) => Symmetric(|g: Self| g.zip_elements(v, |g, x| x.abs_vjp().1(g)));
        recip(v) => Symmetric(|g: Self| g.zip_elements(v, |g, x| x.recip_vjp().1(g)));
        sqrt(v) => Symmetric(|g: Self| g.zip_elements(v, |g, x| x.sqrt_vjp().1(g)));
        exp(v) = value => Elements(value);
        powf(v, exponent: Self::Scalar) -> Self = value => {
            let by_base = v.zip_elements(value, |x, value| power_partials(x, exponent, value).0);
            let by_exponent = v.zip_elements(value, |x, value| power_partials(x, exponent, value).1);
            (Elements(by_base), Along(by_exponent))
        };
        lerp(a, b: Self, s: Self::Scalar) -> Self
            => (Scaled(Self::Scalar::ONE - s), Scaled(s), Along(b - a));
        /// v - 2 (v . n) n; all elements of the normal count as free.
        reflect(v, normal: Self) -> Self => {
            let along = move |number: Self::Scalar| scale_vector(number + number, normal);
            let twice = (v + v).dot(normal);
            let by_normal = Maps(
                move |t: Self| -(along(inner(t, v)) + t.map_elements(|t| chain(t, twice))),
                move |g: Self| {
                    let by_product = inner(g + g, normal);
                    -(g.map_elements(|g| scale(g, twice)) + scale_vector(by_product, v))
                },
            );
            (Symmetric(move |g: Self| g - along(inner(g, normal))), by_normal)
        };
    }
}

rules! {
    /// The rules of the methods of [`Vector3`].
    Vector3Rules for every Vector3 {
        new(x: Self::Scalar, y: Self::Scalar, z: Self::Scalar) -> Self: |g| (g.x(), g.y(), g.z());
        x(v) -> Self::Scalar: |g| Self::new(g, Additive::zero(), Additive::zero());
        y(v) -> Self::Scalar: |g| Self::new(Additive::zero(), g, Additive::zero());
        z(v) -> Self::Scalar: |g| Self::new(Additive::zero(), Additive::zero(), g);
        cross(a, b) => {
            let times = |v: Self| Maps(move |t| cross(t, v), move |g| -cross(g, v));
            (times(b), Negated(times(a)))
        };
    }
}

/// `g x v`, where a zero element of `g` annihilates whatever it meets.
#[inline(always)]
fn cross<V: Vector3>(g: V, v: V) -> V {
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
    vector.map_elements(|v| linear::unless(singular, cotangent * (v / length)))
}

/// The pullback of `recip = 1/|vector|`: -v/|v|^3; 0 at 0.
#[inline(always)]
fn length_recip_pullback<V: Vector>(vector: V, recip: V::Scalar, cotangent: V::Scalar) -> V {
    let singular = !recip.is_finite() | cotangent.vanishes();
    // One factor at a time: the square of a large one would not be representable.
    vector.map_elements(|v| linear::unless(singular, -(cotangent * recip * (v * recip) * recip)))
}

/// The pullback of `unit = vector * length_recip`.
#[inline(always)]
pub(crate) fn normalize_pullback<V: Vector>(unit: V, length_recip: V::Scalar, cotangent: V) -> V {
    let defined = length_recip.is_finite() & length_recip.cmpgt(V::Scalar::ZERO);
    let along = scale_elements(cotangent, unit).element_sum();
    let across = cotangent - scale_vector(along, unit);
    across.map_elements(|a| linear::unless(!defined, scale(a, length_recip)))
}

/// 1 where elements are equal, else 0.
#[inline(always)]
fn are_equal<V: Vector>(a: V, b: V) -> V {
    a.zip_elements(b, |a, b| Select::select(a.cmpeq(b), V::Scalar::ONE, V::Scalar::ZERO))
}

/// `cotangent` to the first element that equals `value`.
#[inline(always)]
fn to_first_equal<V: Vector>(vector: V, value: V::Scalar, cotangent: V::Scalar) -> V {
    let remaining = core::cell::Cell::new(cotangent);
    vector.map_elements(|element| {
        let differs = !element.cmpeq(value);
        let share = linear::unless(differs, remaining.get());
        remaining.set(linear::unless(!differs, remaining.get()));
        share
    })
}
