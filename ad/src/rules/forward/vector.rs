//! Methods of vectors.

use super::symmetric;
use crate::Real;
use crate::rules::{RealRules, Vector3Rules, VectorRules, chain};
use crate::vector::{Vector, Vector3};

/// The inner product of a tangent with partial derivatives.
#[inline(always)]
pub(super) fn inner<V: Vector>(tangent: V, partials: V) -> V::Scalar {
    tangent.zip_elements(partials, chain).element_sum()
}

/// Siblings of methods with a scalar result.
macro_rules! scalar_result {
    ($($jvp:ident = $vjp:ident($($other:ident)?);)*) => {$(
        scalar_result!(@one $jvp $vjp $($other)?);
    )*};
    (@one $jvp:ident $vjp:ident) => {
        #[doc = concat!("From `", stringify!($vjp), "`.")]
        #[inline(always)]
        fn $jvp(self, tangent: Self) -> (Self::Scalar, Self::Scalar) {
            let (value, pullback) = self.$vjp();
            (value, inner(tangent, pullback(Self::Scalar::ONE)))
        }
    };
    (@one $jvp:ident $vjp:ident $other:ident) => {
        #[doc = concat!("From `", stringify!($vjp), "`.")]
        #[inline(always)]
        fn $jvp(
            self,
            $other: Self,
            tangent: Self,
            other_tangent: Self,
        ) -> (Self::Scalar, Self::Scalar) {
            let (value, pullback) = self.$vjp($other);
            let (by_self, by_other) = pullback(Self::Scalar::ONE);
            (value, (inner(tangent, by_self) + inner(other_tangent, by_other)))
        }
    };
}

pub(super) use scalar_result;

/// The `_jvp` siblings of the methods of [`Vector`].
pub trait VectorForward: VectorRules {
    symmetric! {
        normalize_jvp = normalize_vjp();
        normalize_or_zero_jvp = normalize_or_zero_vjp();
        abs_jvp = abs_vjp();
        recip_jvp = recip_vjp();
        exp_jvp = exp_vjp();
        sqrt_jvp = sqrt_vjp();
        min_jvp = min_vjp(other other_tangent 1);
        max_jvp = max_vjp(other other_tangent 1);
        clamp_jvp = clamp_vjp(low low_tangent 1, high high_tangent 2);
    }

    scalar_result! {
        dot_jvp = dot_vjp(other);
        length_jvp = length_vjp();
        length_squared_jvp = length_squared_vjp();
        length_recip_jvp = length_recip_vjp();
        distance_jvp = distance_vjp(other);
        distance_squared_jvp = distance_squared_vjp(other);
        min_element_jvp = min_element_vjp();
        max_element_jvp = max_element_vjp();
    }

    /// The tangent in each element.
    #[inline(always)]
    fn splat_jvp(value: Self::Scalar, tangent: Self::Scalar) -> (Self, Self) {
        (Self::splat(value), Self::splat(tangent))
    }

    /// The sum of the tangents.
    #[inline(always)]
    fn element_sum_jvp(self, tangent: Self) -> (Self::Scalar, Self::Scalar) {
        (self.element_sum(), tangent.element_sum())
    }

    /// The rule of the scalar `powf` for each element.
    #[inline(always)]
    fn powf_jvp(
        self,
        exponent: Self::Scalar,
        tangent: Self,
        exponent_tangent: Self::Scalar,
    ) -> (Self, Self) {
        let along_base = tangent.zip_elements(self, |t, base| base.powf_vjp(exponent).1(t).0);
        let along_exponent =
            self.map_elements(|base| base.powf_vjp(exponent).1(exponent_tangent).1);
        (self.powf(exponent), along_base + along_exponent)
    }

    /// The tangents of both ends, mixed as these are, and the difference times that of the
    /// parameter.
    #[inline(always)]
    fn lerp_jvp(
        self,
        other: Self,
        s: Self::Scalar,
        tangent: Self,
        other_tangent: Self,
        s_tangent: Self::Scalar,
    ) -> (Self, Self) {
        let along_ends = tangent.map_elements(|t| chain(t, Self::Scalar::ONE - s))
            + other_tangent.map_elements(|t| chain(t, s));
        (self.lerp(other, s), along_ends + (other - self).map_elements(|d| chain(s_tangent, d)))
    }

    /// v - 2 (v . n) n, by v and by n.
    #[inline(always)]
    fn reflect_jvp(self, normal: Self, tangent: Self, normal_tangent: Self) -> (Self, Self) {
        let product = inner(tangent, normal) + inner(normal_tangent, self);
        let twice_v_n = (self + self).dot(normal);
        let along = normal.map_elements(|n| chain(product + product, n))
            + normal_tangent.map_elements(|t| chain(t, twice_v_n));
        (self.reflect(normal), tangent - along)
    }
}

impl<V: Vector> VectorForward for V {}

/// The `_jvp` siblings of the methods of [`Vector3`].
pub trait Vector3Forward: Vector3Rules {
    scalar_result! {
        x_jvp = x_vjp();
        y_jvp = y_vjp();
        z_jvp = z_vjp();
    }

    /// The vector of the tangents.
    #[inline(always)]
    fn new_jvp(
        x: Self::Scalar,
        y: Self::Scalar,
        z: Self::Scalar,
        x_tangent: Self::Scalar,
        y_tangent: Self::Scalar,
        z_tangent: Self::Scalar,
    ) -> (Self, Self) {
        (Self::new(x, y, z), Self::new(x_tangent, y_tangent, z_tangent))
    }

    /// Both products.
    #[inline(always)]
    fn cross_jvp(self, other: Self, tangent: Self, other_tangent: Self) -> (Self, Self) {
        // The pullbacks of b and of a are a x g and g x b, up to the sign.
        let along_self = self.cross_vjp(other).1(tangent).0;
        let along_other = self.cross_vjp(other).1(other_tangent).1;
        (self.cross(other), -(along_self + along_other))
    }
}

impl<V: Vector3> Vector3Forward for V {}

macro_rules! new_rules {
    ($($name:ident $type:ident $scalar:ident ($($element:ident $tangent:ident),*);)*) => {$(
        #[doc = concat!("The `_jvp` sibling of `", stringify!($type), "::new`.")]
        pub trait $name: Sized {
            /// The vector of the tangents.
            #[allow(clippy::too_many_arguments)]
            fn new_jvp($($element: $scalar,)* $($tangent: $scalar),*) -> (Self, Self);
        }

        impl $name for glam::$type {
            #[inline(always)]
            fn new_jvp($($element: $scalar,)* $($tangent: $scalar),*) -> (Self, Self) {
                (Self::new($($element),*), Self::new($($tangent),*))
            }
        }
    )*};
}

new_rules! {
    Vec2Forward Vec2 f32 (x x_tangent, y y_tangent);
    Vec4Forward Vec4 f32 (x x_tangent, y y_tangent, z z_tangent, w w_tangent);
    DVec2Forward DVec2 f64 (x x_tangent, y y_tangent);
    DVec4Forward DVec4 f64 (x x_tangent, y y_tangent, z z_tangent, w w_tangent);
}
