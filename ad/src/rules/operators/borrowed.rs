//! Operators between what is borrowed: `&a * &b`, and those of types that are not `Copy`.
//!
//! There is one derivative for all forms in which an operator may be written. `#[differentiable]` on
//! the `impl` for references makes it; where the one for values has the attribute, it is made of
//! that one's rule.

#![allow(non_camel_case_types)]

use core::ops;

use super::{
    AddAssignPullback, AddPullback, DivAssignPullback, DivPullback, Kept, MulAssignPullback,
    MulPullback, NegPullback, RemAssignPullback, RemPullback, SubAssignPullback, SubPullback,
};
use crate::{Differentiable, Tangent};

/// Names for the operators.
pub mod operation {
    /// `-a`
    pub enum Neg {}
    /// `a + b`
    pub enum Add {}
    /// `a - b`
    pub enum Sub {}
    /// `a * b`
    pub enum Mul {}
    /// `a / b`
    pub enum Div {}
    /// `a % b`
    pub enum Rem {}
    /// `a += b`
    pub enum AddAssign {}
    /// `a -= b`
    pub enum SubAssign {}
    /// `a *= b`
    pub enum MulAssign {}
    /// `a /= b`
    pub enum DivAssign {}
    /// `a %= b`
    pub enum RemAssign {}
}

/// The derivative comes from the operator of values.
pub enum OfValues {}

/// The derivative comes from an operator of references.
pub enum OfReferences {}

/// Says that an operator has the attribute: on one of its forms, those of values and of references.
pub trait AttributeOnOneForm<Operation, Rhs> {}

/// The derivative of an operator between what is borrowed, which the `Form` gives; `()` is the right operand of the negative.
#[diagnostic::on_unimplemented(
    message = "no derivative rule for an operator between `{Self}` and `{Rhs}`",
    note = "rules exist for f32, f64 and glam's float vectors, matrices and quaternions",
    note = "operators of your own type: put `#[differentiable]` on the `impl` of the operator, for values or for references"
)]
pub trait BorrowedOperator<Operation, Rhs: Differentiable, Form>: Differentiable {
    /// What the operator makes.
    type Output: Differentiable;

    /// The value.
    fn value(&self, rhs: &Rhs) -> Self::Output;

    /// The value, and the pullback to both operands.
    fn vjp(
        &self,
        rhs: &Rhs,
    ) -> (
        Self::Output,
        impl FnOnce(Tangent<Self::Output>) -> (Tangent<Self>, Tangent<Rhs>)
        + use<Self, Operation, Rhs, Form>,
    );

    /// The value and its tangent.
    fn jvp(
        &self,
        rhs: &Rhs,
        tangent: &Tangent<Self>,
        rhs_tangent: &Tangent<Rhs>,
    ) -> (Self::Output, Tangent<Self::Output>);
}

/// The derivative of an operator that changes what stands to its left.
#[diagnostic::on_unimplemented(
    message = "no derivative rule for an assigning operator between `{Self}` and `{Rhs}`",
    note = "rules exist for f32, f64 and glam's float vectors, matrices and quaternions",
    note = "operators of your own type: put `#[differentiable]` on the `impl` of the operator"
)]
pub trait BorrowedAssignment<Operation, Rhs: Differentiable, Form>: Differentiable {
    /// Changes the left operand.
    fn assign(&mut self, rhs: &Rhs);

    /// Changes it; the pullback is from the cotangent of what it is afterwards to those of what it
    /// was before and of the right operand.
    fn vjp(
        &mut self,
        rhs: &Rhs,
    ) -> (
        (),
        impl FnOnce((), Tangent<Self>) -> (Tangent<Self>, Tangent<Rhs>)
        + use<Self, Operation, Rhs, Form>,
    );

    /// Changes it and its tangent.
    fn jvp(
        &mut self,
        rhs: &Rhs,
        tangent: &mut Tangent<Self>,
        rhs_tangent: &Tangent<Rhs>,
    ) -> ((), ());
}

/// The functions `$function`, which generated code calls, and the operator of values as one of what is
/// borrowed. A sum keeps operands as its rule says.
macro_rules! operators {
    ($($function:ident $operation:ident $rule:ident $pullback:ident $jvp:ident $($sum:ident)?;)*) => {$(
        /// The operator between what is borrowed.
        #[inline(always)]
        pub fn $function<A, B, Form>(a: &A, b: &B) -> A::Output
        where
            A: BorrowedOperator<operation::$operation, B, Form>,
            B: Differentiable,
        {
            a.value(b)
        }

        /// The derivative of the operator.
        pub enum $function {}

        impl $function {
            /// The value and the pullback.
            #[inline(always)]
            pub fn vjp<A, B, Form>(
                a: &A,
                b: &B,
            ) -> (
                A::Output,
                impl FnOnce(Tangent<A::Output>) -> (Tangent<A>, Tangent<B>) + use<A, B, Form>,
            )
            where
                A: BorrowedOperator<operation::$operation, B, Form>,
                B: Differentiable,
            {
                a.vjp(b)
            }

            /// The value and its tangent.
            #[inline(always)]
            pub fn jvp<A, B, Form>(
                a: &A,
                b: &B,
                a_dot: &Tangent<A>,
                b_dot: &Tangent<B>,
            ) -> (A::Output, Tangent<A::Output>)
            where
                A: BorrowedOperator<operation::$operation, B, Form>,
                B: Differentiable,
            {
                a.jvp(b, a_dot, b_dot)
            }
        }

        #[diagnostic::do_not_recommend]
        impl<A, B> BorrowedOperator<operation::$operation, B, OfValues> for A
        where
            A: $rule<B> + Clone,
            B: Differentiable + Clone,
        {
            type Output = <A as ops::$operation<B>>::Output;

            #[inline(always)]
            fn value(&self, rhs: &B) -> Self::Output {
                ops::$operation::$function(self.clone(), rhs.clone())
            }

            #[inline(always)]
            fn vjp(
                &self,
                rhs: &B,
            ) -> (
                Self::Output,
                impl FnOnce(Tangent<Self::Output>) -> (Tangent<A>, Tangent<B>) + use<A, B>,
            ) {
                let value = self.value(rhs);
                (value, operators!(@pullback A B self rhs $rule $pullback $($sum)?))
            }

            #[inline(always)]
            fn jvp(
                &self,
                rhs: &B,
                tangent: &Tangent<A>,
                rhs_tangent: &Tangent<B>,
            ) -> (Self::Output, Tangent<Self::Output>) {
                self.clone().$jvp(rhs.clone(), tangent.clone(), rhs_tangent.clone())
            }
        }
    )*};
    (@pullback $a:ident $b:ident $left:ident $right:ident $rule:ident $pullback:ident $sum:ident) => {{
        let kept = <$a as $rule<$b>>::Kept::default();
        kept.keep($left, $right);
        move |cotangent| $a::$pullback(&kept, cotangent)
    }};
    (@pullback $a:ident $b:ident $left:ident $right:ident $rule:ident $pullback:ident) => {{
        let (left, right) = ($left.clone(), $right.clone());
        move |cotangent| $a::$pullback(left, right, cotangent)
    }};
}

operators! {
    add Add AddPullback add_pullback add_jvp sum;
    sub Sub SubPullback sub_pullback sub_jvp sum;
    mul Mul MulPullback mul_pullback mul_jvp;
    div Div DivPullback div_pullback div_jvp;
    rem Rem RemPullback rem_pullback rem_jvp;
}

/// The same for the operators that change what stands to their left.
macro_rules! assigning_operators {
    ($($function:ident $operation:ident $rule:ident $pullback:ident $jvp:ident $($sum:ident)?;)*) => {$(
        /// The operator with what is borrowed.
        #[inline(always)]
        pub fn $function<A, B, Form>(a: &mut A, b: &B)
        where
            A: BorrowedAssignment<operation::$operation, B, Form>,
            B: Differentiable,
        {
            a.assign(b);
        }

        /// The derivative of the operator.
        pub enum $function {}

        impl $function {
            /// The pullback.
            #[inline(always)]
            pub fn vjp<A, B, Form>(
                a: &mut A,
                b: &B,
            ) -> ((), impl FnOnce((), Tangent<A>) -> (Tangent<A>, Tangent<B>) + use<A, B, Form>)
            where
                A: BorrowedAssignment<operation::$operation, B, Form>,
                B: Differentiable,
            {
                a.vjp(b)
            }

            /// Changes the tangent, too.
            #[inline(always)]
            pub fn jvp<A, B, Form>(
                a: &mut A,
                b: &B,
                a_dot: &mut Tangent<A>,
                b_dot: &Tangent<B>,
            ) -> ((), ())
            where
                A: BorrowedAssignment<operation::$operation, B, Form>,
                B: Differentiable,
            {
                a.jvp(b, a_dot, b_dot)
            }
        }

        #[diagnostic::do_not_recommend]
        impl<A, B> BorrowedAssignment<operation::$operation, B, OfValues> for A
        where
            A: $rule<B> + ops::$operation<B> + Clone,
            B: Differentiable + Clone,
        {
            #[inline(always)]
            fn assign(&mut self, rhs: &B) {
                ops::$operation::$function(self, rhs.clone());
            }

            #[inline(always)]
            fn vjp(
                &mut self,
                rhs: &B,
            ) -> ((), impl FnOnce((), Tangent<A>) -> (Tangent<A>, Tangent<B>) + use<A, B>) {
                let before = &*self;
                let pullback = operators!(@pullback A B before rhs $rule $pullback $($sum)?);
                self.assign(rhs);
                ((), move |(), cotangent| pullback(cotangent))
            }

            #[inline(always)]
            fn jvp(
                &mut self,
                rhs: &B,
                tangent: &mut Tangent<A>,
                rhs_tangent: &Tangent<B>,
            ) -> ((), ()) {
                *tangent = self.clone().$jvp(rhs.clone(), tangent.clone(), rhs_tangent.clone());
                self.assign(rhs);
                ((), ())
            }
        }
    )*};
}

assigning_operators! {
    add_assign AddAssign AddAssignPullback add_assign_pullback add_assign_jvp sum;
    sub_assign SubAssign SubAssignPullback sub_assign_pullback sub_assign_jvp sum;
    mul_assign MulAssign MulAssignPullback mul_assign_pullback mul_assign_jvp;
    div_assign DivAssign DivAssignPullback div_assign_pullback div_assign_jvp;
    rem_assign RemAssign RemAssignPullback rem_assign_pullback rem_assign_jvp;
}

/// The negative of what is borrowed.
#[inline(always)]
pub fn neg<A: BorrowedOperator<operation::Neg, (), Form>, Form>(a: &A) -> A::Output {
    a.value(&())
}

/// The derivative of the operator.
pub enum neg {}

impl neg {
    /// The value and the pullback.
    #[inline(always)]
    pub fn vjp<A: BorrowedOperator<operation::Neg, (), Form>, Form>(
        a: &A,
    ) -> (A::Output, impl FnOnce(Tangent<A::Output>) -> Tangent<A> + use<A, Form>) {
        let (value, pullback) = a.vjp(&());
        (value, |cotangent| pullback(cotangent).0)
    }

    /// The value and its tangent.
    #[inline(always)]
    pub fn jvp<A: BorrowedOperator<operation::Neg, (), Form>, Form>(
        a: &A,
        a_dot: &Tangent<A>,
    ) -> (A::Output, Tangent<A::Output>) {
        a.jvp(&(), a_dot, &())
    }
}

#[diagnostic::do_not_recommend]
impl<A: NegPullback + Clone> BorrowedOperator<operation::Neg, (), OfValues> for A {
    type Output = <A as ops::Neg>::Output;

    #[inline(always)]
    fn value(&self, (): &()) -> Self::Output {
        -self.clone()
    }

    #[inline(always)]
    fn vjp(
        &self,
        rhs: &(),
    ) -> (Self::Output, impl FnOnce(Tangent<Self::Output>) -> (Tangent<A>, ()) + use<A>) {
        let kept = A::Kept::default();
        kept.keep(self, self);
        (self.value(rhs), move |cotangent| (A::neg_pullback(&kept, cotangent), ()))
    }

    #[inline(always)]
    fn jvp(&self, (): &(), tangent: &Tangent<A>, (): &()) -> (Self::Output, Tangent<Self::Output>) {
        self.clone().neg_jvp(tangent.clone())
    }
}
