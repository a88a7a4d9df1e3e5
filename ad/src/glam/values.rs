//! What the traits of this crate say of glam's vectors.

use glam::{
    BVec2, BVec3, BVec3A, BVec4, BVec4A, DVec2, DVec3, DVec4, EulerRot, Vec2, Vec3, Vec3A, Vec4,
};

use crate::check::Coordinates;
use crate::differentiable::{Parts, no_derivative, own_tangent};
use crate::dual::Lift;
use crate::fields::vector_fields;
use crate::real::select_by_bool;
use crate::rt::At;
use crate::rt::cotangent::at_by_index;
use crate::rt::through::{Inner, Same};
use crate::rules::IntoRules;
use crate::rules::conversion::{FromRules, into};
use crate::vector::{Vector, Vector3, Xyz};
use crate::{
    Additive, Differentiable, Field, Fields, NoDerivative, NoTangent, Real, Select, Tangent,
};

no_derivative!(BVec2, BVec3, BVec3A, BVec4, BVec4A, EulerRot);

macro_rules! delegate {
    ($type:ident: $($name:ident($($argument:ident: $argument_type:ty),*) -> $result:ty;)*) => {$(
        #[inline(always)]
        fn $name(self, $($argument: $argument_type),*) -> $result {
            $type::$name(self, $($argument),*)
        }
    )*};
}

macro_rules! vectors {
    ($($parts:ident $elements:tt: $($vector:ident $scalar:ident),*;)*) => {$(
        vectors!(@parts $parts $elements);
        $(vectors!(@vector $parts $elements $vector $scalar);)*
    )*};
    (@parts $parts:ident { $($element:ident)* }) => {
        /// The elements of a vector that carries no derivative.
        #[derive(Default)]
        pub struct $parts<S> {
            $(
                #[allow(missing_docs)]
                pub $element: NoTangent<S>,
            )*
        }
    };
    (@vector $parts:ident { $($element:ident)* } $vector:ident $scalar:ident) => {
        own_tangent! { $vector => $vector::splat(-0.0), $vector::element_sum; }
        select_by_bool!($vector);
        into! { $vector; }
        at_by_index! { [] $vector, usize, $scalar; }

        impl Parts for $vector {
            type Parts = $parts<$scalar>;

            #[inline(always)]
            fn parts() -> Self::Parts {
                Self::Parts::default()
            }
        }

        impl Coordinates for $vector {
            fn write(&self, into: &mut Vec<f64>) {
                self.to_array().write(into);
            }

            fn read(&self, from: &mut impl Iterator<Item = f64>) -> Self {
                Self::from_array(self.to_array().read(from))
            }
        }

        impl Inner<$scalar, $vector, Same> for $vector {
            #[inline(always)]
            fn inner(&self, tangent: &$vector) -> $scalar {
                self.to_array().inner(&tangent.to_array())
            }
        }

        impl Vector for $vector {
            type Scalar = $scalar;

            const ZERO: Self = Self::ZERO;
            const ONE: Self = Self::ONE;

            #[inline(always)]
            fn splat(value: $scalar) -> Self {
                Self::splat(value)
            }

            #[inline(always)]
            fn map_elements(self, f: impl Fn($scalar) -> $scalar) -> Self {
                Self::new($(f(self.$element)),*)
            }

            #[inline(always)]
            fn zip_elements(self, other: Self, f: impl Fn($scalar, $scalar) -> $scalar) -> Self {
                Self::new($(f(self.$element, other.$element)),*)
            }

            delegate! {
                $vector:
                element_sum() -> $scalar;
                min_element() -> $scalar;
                max_element() -> $scalar;
                dot(other: Self) -> $scalar;
                length() -> $scalar;
                length_squared() -> $scalar;
                length_recip() -> $scalar;
                distance(other: Self) -> $scalar;
                distance_squared(other: Self) -> $scalar;
                normalize() -> Self;
                normalize_or_zero() -> Self;
                min(other: Self) -> Self;
                max(other: Self) -> Self;
                clamp(low: Self, high: Self) -> Self;
                abs() -> Self;
                recip() -> Self;
                exp() -> Self;
                sqrt() -> Self;
                powf(exponent: $scalar) -> Self;
                lerp(other: Self, s: $scalar) -> Self;
                reflect(normal: Self) -> Self;
            }
        }
    };
}

vectors! {
    Parts2 { x y }: Vec2 f32, DVec2 f64;
    Parts3 { x y z }: Vec3 f32, Vec3A f32, DVec3 f64;
    Parts4 { x y z w }: Vec4 f32, DVec4 f64;
}

macro_rules! vectors_of_space {
    ($($vector:ident $scalar:ident;)*) => {$(
        impl Vector3 for $vector {
            #[inline(always)]
            fn new(x: $scalar, y: $scalar, z: $scalar) -> Self {
                Self::new(x, y, z)
            }

            #[inline(always)]
            fn x(self) -> $scalar {
                self.x
            }

            #[inline(always)]
            fn y(self) -> $scalar {
                self.y
            }

            #[inline(always)]
            fn z(self) -> $scalar {
                self.z
            }

            delegate!($vector: cross(other: Self) -> Self;);
        }
    )*};
}

vectors_of_space! {
    Vec3 f32;
    Vec3A f32;
    DVec3 f64;
}

/// What vectors of space have that parameters are made of.
macro_rules! lifted {
    ($($vector:ident $scalar:ident;)*) => {$(
        vector_fields!($vector, $scalar);

        impl Lift for $vector {
            type Lifted<const K: usize> = Xyz<<$scalar as Lift>::Lifted<K>>;

            fn lift<const K: usize>(
                &self,
                directions: &mut impl Iterator<Item = [f64; K]>,
            ) -> Self::Lifted<K> {
                Xyz { x: self.x, y: self.y, z: self.z }.lift(directions)
            }
        }
    )*};
}

lifted! {
    Vec3 f32;
    DVec3 f64;
}
