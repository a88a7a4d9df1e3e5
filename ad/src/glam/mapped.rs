//! `map` of vectors.

use core::marker::PhantomData;

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use crate::rules::attempt::{Failure, Holds, Mapped, Takes};
use crate::{Differentiable, Tangent};

/// What a vector never holds in place of its elements.
pub struct OfVector<V>(PhantomData<V>);

impl<V> Differentiable for OfVector<V> {
    type Tangent = ();
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}
}

impl<V> Failure for OfVector<V> {}

macro_rules! vectors {
    ($($vector:ident [$scalar:ident; $n:literal]),*) => {$(
        impl Holds<$scalar> for OfVector<$vector> {
            type Whole = $vector;

            #[inline(always)]
            fn full(_: $scalar) -> $vector {
                unreachable!("a vector has elements")
            }

            #[inline(always)]
            fn again(self) -> $vector {
                unreachable!("a vector does not fail")
            }
        }

        impl Takes<$scalar> for OfVector<$vector> {
            #[inline(always)]
            fn taken(element: &$scalar) -> $scalar {
                *element
            }
        }

        impl Mapped for $vector {
            type Content = $scalar;
            type Failure = OfVector<Self>;
            type Elements = [$scalar; $n];

            #[inline(always)]
            fn spread(self) -> Result<Result<$scalar, OfVector<Self>>, [$scalar; $n]> {
                Err(self.to_array())
            }

            #[inline(always)]
            fn whole(elements: [$scalar; $n]) -> Self {
                Self::from_array(elements)
            }

            #[inline(always)]
            fn joined(_: $scalar, (): (), elements: [$scalar; $n]) -> Self {
                Self::from_array(elements)
            }

            #[inline(always)]
            fn apart(tangent: Tangent<Self>) -> ($scalar, (), [$scalar; $n]) {
                (0.0, (), tangent.to_array())
            }
        }
    )*};
}

vectors! { Vec2 [f32; 2], Vec3 [f32; 3], Vec4 [f32; 4], DVec2 [f64; 2], DVec3 [f64; 3], DVec4 [f64; 4] }

macro_rules! map_rules {
    ($($rules:ident $scalar:ident: $($vector:ident { $($element:ident)+ })*;)*) => {$(
        /// `map` of vectors whose type is written down.
        #[ad_macros::differentiable]
        pub trait $rules: Sized {
            /// A vector of what a function makes of each element.
            fn map<F: Fn($scalar) -> $scalar>(self, function: F) -> Self;
        }

        $(
            #[ad_macros::differentiable]
            impl $rules for $vector {
                fn map<F: Fn($scalar) -> $scalar>(self, function: F) -> Self {
                    $vector::new($(function(self.$element)),+)
                }
            }
        )*
    )*};
}

map_rules! {
    SingleMapRules f32: Vec2 { x y } Vec3 { x y z } Vec4 { x y z w };
    DoubleMapRules f64: DVec2 { x y } DVec3 { x y z } DVec4 { x y z w };
}
