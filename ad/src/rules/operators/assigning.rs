//! Operators that change the place to their left.

use core::ops::{Add, Div, Mul, Rem, Sub};

use super::{AddPullback, DivPullback, Kept, MulPullback, RemPullback, SubPullback};
use crate::{Differentiable, Tangent};

/// Numbers and what they make up: of these `a += b` is `a = a + b`, and so with the other operators.
pub trait Arithmetic {}

macro_rules! assigning_operators {
    ($(
        $name:ident $pullback:ident($($operand:ident: $type:ty),*) $jvp:ident $symbol:literal =
            $operator:ident $plain:ident $plain_pullback:ident $plain_jvp:ident $($kept:ident)?;
    )*) => {$(
        #[doc = concat!("The pullback of `", $symbol, "`.")]
        #[diagnostic::on_unimplemented(
            message = "no derivative rule for an assigning operator between `{Self}` and `{Rhs}`",
            note = "rules exist for f32, f64 and glam's float vectors, by value: dereference a reference with `*`",
            note = "operators of your own type: put `#[differentiable]` on the `impl` of the operator"
        )]
        pub trait $name<Rhs: Differentiable = Self>: Differentiable + Sized {
            $(
                /// What is kept of the operands.
                type $kept: Kept<Self, Rhs>;
            )?

            /// From the cotangent of what the place holds afterwards to those of what it held
            /// before and of the right operand.
            fn $pullback(
                $($operand: $type,)*
                cotangent: Tangent<Self>,
            ) -> (Tangent<Self>, Tangent<Rhs>);

            /// The tangent of what the place holds afterwards, from what it held before, the right
            /// operand, and their tangents.
            fn $jvp(
                self,
                rhs: Rhs,
                tangent: Tangent<Self>,
                rhs_tangent: Tangent<Rhs>,
            ) -> Tangent<Self>;
        }

        #[diagnostic::do_not_recommend]
        impl<A, Rhs> $name<Rhs> for A
        where
            A: Arithmetic + $operator<Rhs, Output = A> + $plain<Rhs>,
            Rhs: Differentiable,
        {
            $(type $kept = <A as $plain<Rhs>>::$kept;)?

            #[inline(always)]
            fn $pullback(
                $($operand: $type,)*
                cotangent: Tangent<A>,
            ) -> (Tangent<A>, Tangent<Rhs>) {
                A::$plain_pullback($($operand,)* cotangent)
            }

            #[inline(always)]
            fn $jvp(
                self,
                rhs: Rhs,
                tangent: Tangent<A>,
                rhs_tangent: Tangent<Rhs>,
            ) -> Tangent<A> {
                self.$plain_jvp(rhs, tangent, rhs_tangent).1
            }
        }
    )*};
}

assigning_operators! {
    AddAssignPullback add_assign_pullback(kept: &<Self as AddAssignPullback<Rhs>>::Kept)
        add_assign_jvp "+=" = Add AddPullback add_pullback add_jvp Kept;
    SubAssignPullback sub_assign_pullback(kept: &<Self as SubAssignPullback<Rhs>>::Kept)
        sub_assign_jvp "-=" = Sub SubPullback sub_pullback sub_jvp Kept;
    MulAssignPullback mul_assign_pullback(before: Self, rhs: Rhs)
        mul_assign_jvp "*=" = Mul MulPullback mul_pullback mul_jvp;
    DivAssignPullback div_assign_pullback(before: Self, rhs: Rhs)
        div_assign_jvp "/=" = Div DivPullback div_pullback div_jvp;
    RemAssignPullback rem_assign_pullback(before: Self, rhs: Rhs)
        rem_assign_jvp "%=" = Rem RemPullback rem_pullback rem_jvp;
}
