//! Derivatives of functions and methods that glam's vectors have beyond [`Vector`](crate::vector::Vector).

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use super::{scale, scale_elements, scale_vector};
use crate::vector::Vector;
use crate::{Additive, Real};

macro_rules! glam_rules {
    ($($type:ident $scalar:ident;)*) => {
        /// The `_vjp` siblings of methods that all of glam's float vectors have.
        pub trait GlamRules: Vector {
            /// 0
            fn signum_vjp(self) -> (Self, impl FnOnce(Self) -> Self);
            /// 0
            fn floor_vjp(self) -> (Self, impl FnOnce(Self) -> Self);
            /// 0
            fn ceil_vjp(self) -> (Self, impl FnOnce(Self) -> Self);
            /// 0
            fn round_vjp(self) -> (Self, impl FnOnce(Self) -> Self);
            /// 0
            fn trunc_vjp(self) -> (Self, impl FnOnce(Self) -> Self);
            /// 1; the jumps carry no derivative.
            fn fract_vjp(self) -> (Self, impl FnOnce(Self) -> Self);
            /// The product of the other elements, to each.
            fn element_product_vjp(self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self);
            /// Half to each.
            fn midpoint_vjp(self, other: Self) -> (Self, impl FnOnce(Self) -> (Self, Self));
            /// The cotangents of both factors and the summand.
            fn mul_add_vjp(
                self,
                a: Self,
                b: Self,
            ) -> (Self, impl FnOnce(Self) -> (Self, Self, Self));
            /// The cotangents of the vector and of what it is projected onto; 0 to both where
            /// the latter is 0.
            fn project_onto_vjp(self, onto: Self) -> (Self, impl FnOnce(Self) -> (Self, Self));
        }

        $(
            impl GlamRules for $type {
                glam_rules!(@steps $type: signum_vjp signum, floor_vjp floor, ceil_vjp ceil,
                    round_vjp round, trunc_vjp trunc);

                #[inline(always)]
                fn fract_vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
                    (self.fract(), |g| g)
                }

                #[inline(always)]
                fn element_product_vjp(self) -> ($scalar, impl FnOnce($scalar) -> Self) {
                    (self.element_product(), move |g| {
                        let elements = self.to_array();
                        // A division by the element would fail at 0.
                        Self::from_array(core::array::from_fn(|i| {
                            let others = (0..elements.len()).filter(|&j| j != i);
                            scale(g, others.map(|j| elements[j]).product())
                        }))
                    })
                }

                #[inline(always)]
                fn midpoint_vjp(self, other: Self) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
                    (self.midpoint(other), |g: Self| (g * $scalar::HALF, g * $scalar::HALF))
                }

                #[inline(always)]
                fn mul_add_vjp(
                    self,
                    a: Self,
                    b: Self,
                ) -> (Self, impl FnOnce(Self) -> (Self, Self, Self)) {
                    (self.mul_add(a, b), move |g| {
                        (scale_elements(g, a), scale_elements(g, self), g)
                    })
                }

                #[inline(always)]
                fn project_onto_vjp(
                    self,
                    onto: Self,
                ) -> (Self, impl FnOnce(Self) -> (Self, Self)) {
                    // v (u . v) / (v . v) for the projection of u onto v.
                    let norm = onto.dot(onto);
                    let share = self.dot(onto) / norm;
                    (self.project_onto(onto), move |g: Self| {
                        if norm == 0.0 || g == Self::ZERO {
                            return (Self::zero(), Self::zero());
                        }
                        let share_bar = g.dot(onto) / norm;
                        let to_onto = g * share
                            + scale_vector(share_bar, self - onto * ($scalar::TWO * share));
                        (scale_vector(share_bar, onto), to_onto)
                    })
                }
            }
        )*
    };
    (@steps $type:ident: $($vjp:ident $method:ident),*) => {$(
        #[inline(always)]
        fn $vjp(self) -> (Self, impl FnOnce(Self) -> Self) {
            (self.$method(), |_| Self::zero())
        }
    )*};
}

glam_rules! {
    Vec2 f32;
    Vec3 f32;
    Vec4 f32;
    DVec2 f64;
    DVec3 f64;
    DVec4 f64;
}

/// The `_vjp` sibling of `extend`.
pub trait ExtendRules: Vector {
    /// A vector of one element more.
    type Longer;

    /// The cotangents of the vector and of the element.
    #[allow(clippy::type_complexity)]
    fn extend_vjp(
        self,
        last: Self::Scalar,
    ) -> (Self::Longer, impl FnOnce(Self::Longer) -> (Self, Self::Scalar));
}

/// The `_vjp` sibling of `truncate`.
pub trait TruncateRules: Vector {
    /// A vector of one element less.
    type Shorter;

    /// Nothing to the last element.
    fn truncate_vjp(self) -> (Self::Shorter, impl FnOnce(Self::Shorter) -> Self);
}

macro_rules! lengths {
    ($($shorter:ident $longer:ident $scalar:ident $last:ident;)*) => {$(
        impl ExtendRules for $shorter {
            type Longer = $longer;

            #[inline(always)]
            #[allow(clippy::type_complexity)]
            fn extend_vjp(
                self,
                last: $scalar,
            ) -> ($longer, impl FnOnce($longer) -> (Self, $scalar)) {
                (self.extend(last), |g: $longer| (g.truncate(), g.$last))
            }
        }

        impl TruncateRules for $longer {
            type Shorter = $shorter;

            #[inline(always)]
            fn truncate_vjp(self) -> ($shorter, impl FnOnce($shorter) -> Self) {
                (self.truncate(), |g: $shorter| g.extend(<$scalar>::zero()))
            }
        }
    )*};
}

lengths! {
    Vec2 Vec3 f32 z;
    Vec3 Vec4 f32 w;
    DVec2 DVec3 f64 z;
    DVec3 DVec4 f64 w;
}

/// glam's functions that make vectors, with derivatives.
///
/// `glam::vec3` is a function without one; these are the same to call, and
/// `use ad::rules::construct::vec3` brings the derivative along.
pub mod construct {
    macro_rules! constructors {
        ($($name:ident $type:ident $scalar:ident
            ($($element:ident $dot:ident),*) ($($tuple:ident),*);)*) => {$(
            #[doc = concat!("The vector of these elements, as `glam::", stringify!($name), "`.")]
            #[inline(always)]
            pub const fn $name($($element: $scalar),*) -> glam::$type {
                glam::$type::new($($element),*)
            }

            #[doc = concat!("The derivative of the function `", stringify!($name), "`.")]
            #[allow(non_camel_case_types)]
            pub enum $name {}

            impl $name {
                /// The path of the function.
                #[doc(hidden)]
                pub fn named() -> &'static str {
                    core::any::type_name::<Self>()
                }

                /// The vector, and the cotangents of its elements.
                #[inline(always)]
                #[allow(clippy::type_complexity)]
                pub fn vjp(
                    $($element: $scalar),*
                ) -> (glam::$type, impl FnOnce(glam::$type) -> ($($tuple),*)) {
                    (glam::$type::new($($element),*), |g: glam::$type| ($(g.$element),*))
                }

                /// The vector, and that of the tangents of its elements.
                #[inline(always)]
                #[allow(clippy::too_many_arguments)]
                pub fn jvp(
                    $($element: $scalar,)* $($dot: $scalar),*
                ) -> (glam::$type, glam::$type) {
                    (glam::$type::new($($element),*), glam::$type::new($($dot),*))
                }
            }
        )*};
    }

    constructors! {
        vec2 Vec2 f32 (x x_dot, y y_dot) (f32, f32);
        vec3 Vec3 f32 (x x_dot, y y_dot, z z_dot) (f32, f32, f32);
        vec4 Vec4 f32 (x x_dot, y y_dot, z z_dot, w w_dot) (f32, f32, f32, f32);
        dvec2 DVec2 f64 (x x_dot, y y_dot) (f64, f64);
        dvec3 DVec3 f64 (x x_dot, y y_dot, z z_dot) (f64, f64, f64);
        dvec4 DVec4 f64 (x x_dot, y y_dot, z z_dot, w w_dot) (f64, f64, f64, f64);
    }
}
