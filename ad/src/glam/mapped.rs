//! `map` of vectors.

use core::convert::Infallible;
use core::marker::PhantomData;

use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec3A, Vec4};

use crate::rules::attempt::{Failure, Holds, Mapped, Takes};
use crate::{Differentiable, Tangent};

/// What a vector holds in place of its elements: there is no such value.
pub struct OfVector<V>(Infallible, PhantomData<V>);

impl<V> Differentiable for OfVector<V> {
    type Tangent = ();
    type Shape = ();

    #[inline(always)]
    fn shape(&self) {}
}

impl<V> Failure for OfVector<V> {}

macro_rules! vectors {
    ($($rules:ident $scalar:ident: $($vector:ident $count:literal { $($element:ident)+ })*;)*) => {$(
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

            impl Holds<$scalar> for OfVector<$vector> {
                type Whole = $vector;

                #[inline(always)]
                fn full(_: $scalar) -> $vector {
                    unreachable!("a vector has elements")
                }

                #[inline(always)]
                fn again(self) -> $vector {
                    match self.0 {}
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
                type Elements = [$scalar; $count];

                #[inline(always)]
                fn spread(self) -> Result<Result<$scalar, OfVector<Self>>, [$scalar; $count]> {
                    Err(self.to_array())
                }

                #[inline(always)]
                fn whole(elements: [$scalar; $count]) -> Self {
                    Self::from_array(elements)
                }

                #[inline(always)]
                fn joined(_: $scalar, (): (), elements: [$scalar; $count]) -> Self {
                    Self::from_array(elements)
                }

                #[inline(always)]
                fn apart(tangent: Tangent<Self>) -> ($scalar, (), [$scalar; $count]) {
                    (0.0, (), tangent.to_array())
                }
            }
        )*
    )*};
}

vectors! {
    SingleMapRules f32: Vec2 2 { x y } Vec3 3 { x y z } Vec3A 3 { x y z } Vec4 4 { x y z w };
    DoubleMapRules f64: DVec2 2 { x y } DVec3 3 { x y z } DVec4 4 { x y z w };
}
