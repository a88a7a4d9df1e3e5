//! The arithmetic operators.
//!
//! Each has a pullback trait, which the types of both operands choose. A rule either needs the
//! operands, as those of products do, and gets them from the reverse sweep, which finds out what it
//! has to save; or it says by its [`Kept`] type what it keeps of them: the rules of sums of numbers
//! and vectors [`Nothing`], those that `#[differentiable]` makes from an operator of one's own the
//! [`Operands`], since such an `Add` may be any function.
//!
//! What changes the place to its left (`+=` and its kin) has traits of its own, for an `AddAssign` of
//! one's own need not be an `Add`; that of numbers and vectors is.
//!
//! Turned down: one pullback from both operands for all operators (a loop would save the terms of each
//! sum); giving the pullback of a sum as a closure (it has no name by which a loop could hold one
//! for each iteration without a tape for those that hold nothing).

mod assigning;
#[doc(hidden)]
pub mod borrowed;
pub(crate) mod elementwise;
mod integers;
mod kept;
pub(crate) mod numbers;

pub use assigning::{
    AddAssignPullback, Arithmetic, DivAssignPullback, MulAssignPullback, RemAssignPullback,
    SubAssignPullback,
};
pub use borrowed::{
    AttributeOnOneForm, BorrowedAssignment, BorrowedOperator, OfReferences, OfValues, operation,
};
pub use kept::{Kept, Nothing, Operands};
pub(crate) use numbers::quotient_pullback_of_finite;

use core::ops::{Add, Div, Mul, Neg, Rem, Sub};

use crate::{Differentiable, Tangent};

/// The pullback of unary minus.
#[diagnostic::on_unimplemented(
    message = "no derivative rule for unary minus on `{Self}`",
    note = "rules exist for f32, f64 and glam's float vectors, by value: dereference a reference with `*`",
    note = "an operator of your own type: put `#[differentiable]` on its `impl`"
)]
pub trait NegPullback: Differentiable + Neg<Output: Differentiable> + Sized {
    /// What is kept of the operand, which counts as both.
    type Kept: Kept<Self, Self>;

    /// The cotangent of the operand.
    fn neg_pullback(kept: &Self::Kept, cotangent: Tangent<<Self as Neg>::Output>) -> Tangent<Self>;

    /// The negative and its tangent.
    fn neg_jvp(
        self,
        tangent: Tangent<Self>,
    ) -> (<Self as Neg>::Output, Tangent<<Self as Neg>::Output>);
}

/// The pullback trait of an operator of two operands: its rule keeps of them what its `Kept` says, or gets
/// them from the reverse sweep.
macro_rules! binary_operator {
    ($operator:ident $symbol:literal $($kept:ident)? $({ $($more:item)* })?) => { pastey::paste! {
        #[doc = concat!("The pullback of `", $symbol, "`.")]
        #[diagnostic::on_unimplemented(
            message = "no derivative rule for an operator between `{Self}` and `{Rhs}`",
            note = "rules exist for f32, f64 and glam's float vectors, by value: dereference a reference with `*`",
            note = "operators of your own type: put `#[differentiable]` on the `impl` of the operator"
        )]
        pub trait [<$operator Pullback>]<Rhs: Differentiable = Self>:
            Differentiable + $operator<Rhs, Output: Differentiable> + Sized
        {
            $(
                /// What is kept of the operands.
                type $kept: Kept<Self, Rhs>;
            )?

            binary_operator!(@pullback [<$operator:lower _pullback>] $operator $($kept)?);

            /// The result and its tangent, from the operands and theirs.
            fn [<$operator:lower _jvp>](
                self,
                rhs: Rhs,
                tangent: Tangent<Self>,
                rhs_tangent: Tangent<Rhs>,
            ) -> (<Self as $operator<Rhs>>::Output, Tangent<<Self as $operator<Rhs>>::Output>);

            $($($more)*)?
        }
    }};
    (@pullback $pullback:ident $operator:ident $kept:ident) => {
        /// The cotangents of the left and the right operand.
        fn $pullback(
            kept: &Self::$kept,
            cotangent: Tangent<<Self as $operator<Rhs>>::Output>,
        ) -> (Tangent<Self>, Tangent<Rhs>);
    };
    (@pullback $pullback:ident $operator:ident) => {
        /// The cotangents of the left and the right operand.
        fn $pullback(
            self,
            rhs: Rhs,
            cotangent: Tangent<<Self as $operator<Rhs>>::Output>,
        ) -> (Tangent<Self>, Tangent<Rhs>);
    };
}

// The partial derivatives of sums are constants for numbers and vectors: nothing is saved for them.
binary_operator!(Add "+" Kept);
binary_operator!(Sub "-" Kept);
binary_operator!(Mul "*" {
    /// As [`mul_pullback`](Self::mul_pullback), where both operands are finite: then no cotangent
    /// of zero can meet an infinite partial derivative.
    #[inline(always)]
    fn mul_pullback_of_finite(
        self,
        rhs: Rhs,
        cotangent: Tangent<<Self as Mul<Rhs>>::Output>,
    ) -> (Tangent<Self>, Tangent<Rhs>) {
        self.mul_pullback(rhs, cotangent)
    }
});
binary_operator!(Div "/");
binary_operator!(Rem "%");
