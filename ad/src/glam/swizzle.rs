//! The rules of swizzles.
//!
//! There are 480 of them, each for two types or more, so a function that calls one writes its rule beside it, by
//! [`swizzle`](crate::swizzle). Turned down: a table of all, which would take longer to compile than the rest of the
//! rules.

#[doc(hidden)]
pub use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec3A, Vec4};

/// The rule of a swizzle, as a trait: its methods, what it makes and of which elements, and how many elements a
/// vector has to have. The adjoint adds each number to the element that it is one of.
#[doc(hidden)]
#[macro_export]
macro_rules! swizzle {
    ($rules:ident $vjp:ident $jvp:ident $made:ident $elements:tt 2) => {
        $crate::swizzle!(@trait $rules $vjp $jvp $made $elements Vec2 DVec2 Vec3 Vec3A DVec3 Vec4 DVec4);
    };
    ($rules:ident $vjp:ident $jvp:ident $made:ident $elements:tt 3) => {
        $crate::swizzle!(@trait $rules $vjp $jvp $made $elements Vec3 Vec3A DVec3 Vec4 DVec4);
    };
    ($rules:ident $vjp:ident $jvp:ident $made:ident $elements:tt 4) => {
        $crate::swizzle!(@trait $rules $vjp $jvp $made $elements Vec4 DVec4);
    };
    (@trait $rules:ident $vjp:ident $jvp:ident $made:ident $elements:tt $($vector:ident)*) => {
        trait $rules: $crate::rules::Kin {
            fn $vjp(self) -> (Self::$made, impl FnOnce(Self::$made) -> Self + use<Self>);
            fn $jvp(self, tangent: Self) -> (Self::$made, Self::$made);
        }

        $($crate::swizzle!(@impl $rules $vjp $jvp $made $elements $vector);)*
    };
    (@impl $rules:ident $vjp:ident $jvp:ident $made:ident ($($element:ident)*) $vector:ident) => {
        impl $rules for $crate::rules::swizzle::$vector {
            #[inline(always)]
            fn $vjp(self) -> (Self::$made, impl FnOnce(Self::$made) -> Self + use<>) {
                ([$(self.$element),*].into(), |cotangent: Self::$made| {
                    let mut parts = cotangent.to_array().into_iter();
                    let mut to_vector = <Self as $crate::Additive>::zero();
                    $(to_vector.$element += parts.next().unwrap_or_default();)*
                    to_vector
                })
            }

            #[inline(always)]
            fn $jvp(self, tangent: Self) -> (Self::$made, Self::$made) {
                ([$(self.$element),*].into(), [$(tangent.$element),*].into())
            }
        }
    };
}
