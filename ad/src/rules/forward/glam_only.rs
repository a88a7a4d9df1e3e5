//! Methods that glam's vectors have beyond [`Vector`](crate::vector::Vector).

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use super::symmetric;
use super::vector::{inner, scalar_result};
use crate::rules::{ExtendRules, GlamRules, TruncateRules, scale_elements, scale_vector};
use crate::{Additive, Real};

/// The `_jvp` siblings of methods that all of glam's float vectors have.
pub trait GlamForward: GlamRules {
    symmetric! {
        signum_jvp = signum_vjp();
        floor_jvp = floor_vjp();
        ceil_jvp = ceil_vjp();
        round_jvp = round_vjp();
        trunc_jvp = trunc_vjp();
        fract_jvp = fract_vjp();
        midpoint_jvp = midpoint_vjp(other other_tangent 1);
        mul_add_jvp = mul_add_vjp(a a_tangent 1, b b_tangent 2);
    }

    scalar_result! {
        element_product_jvp = element_product_vjp();
    }

    /// The share of what is projected onto, and that itself; 0 where the latter is 0.
    #[inline(always)]
    fn project_onto_jvp(self, onto: Self, tangent: Self, onto_tangent: Self) -> (Self, Self) {
        // v (u . v) / (v . v) for the projection of u onto v.
        let (value, _) = self.project_onto_vjp(onto);
        let norm = onto.dot(onto);
        let defined = !norm.cmpeq(Self::Scalar::ZERO);
        let share = self.dot(onto) / norm;
        let rest = self - onto * (share + share);
        let share_tangent = (inner(tangent, onto) + inner(onto_tangent, rest)) / norm;
        let along =
            scale_vector(share_tangent, onto) + scale_elements(onto_tangent, Self::splat(share));
        let zero = Self::Scalar::zero();
        (value, along.map_elements(|t| crate::Select::select(defined, t, zero)))
    }
}

macro_rules! glam_forward {
    ($($type:ident)*) => {$(
        impl GlamForward for $type {}
    )*};
}

glam_forward!(Vec2 Vec3 Vec4 DVec2 DVec3 DVec4);

/// The `_jvp` sibling of `extend`.
pub trait ExtendForward: ExtendRules {
    /// The tangent, extended by that of the element.
    fn extend_jvp(
        self,
        last: Self::Scalar,
        tangent: Self,
        last_tangent: Self::Scalar,
    ) -> (Self::Longer, Self::Longer);
}

/// The `_jvp` sibling of `truncate`.
pub trait TruncateForward: TruncateRules {
    /// The tangent without its last element.
    fn truncate_jvp(self, tangent: Self) -> (Self::Shorter, Self::Shorter);
}

macro_rules! lengths {
    ($($shorter:ident $longer:ident $scalar:ident;)*) => {$(
        impl ExtendForward for $shorter {
            #[inline(always)]
            fn extend_jvp(
                self,
                last: $scalar,
                tangent: Self,
                last_tangent: $scalar,
            ) -> ($longer, $longer) {
                (self.extend(last), tangent.extend(last_tangent))
            }
        }

        impl TruncateForward for $longer {
            #[inline(always)]
            fn truncate_jvp(self, tangent: Self) -> ($shorter, $shorter) {
                (self.truncate(), tangent.truncate())
            }
        }
    )*};
}

lengths! {
    Vec2 Vec3 f32;
    Vec3 Vec4 f32;
    DVec2 DVec3 f64;
    DVec3 DVec4 f64;
}
