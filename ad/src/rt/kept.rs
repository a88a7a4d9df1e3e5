//! What sums and differences keep for the reverse sweep: the types of their operands, and, of types
//! that the user wrote, whatever their rules ask for.

use core::marker::PhantomData;
use core::ops::{Add, Neg, Sub};

use crate::rules::{
    AddAssignPullback, AddPullback, Kept, NegPullback, SubAssignPullback, SubPullback,
};
use crate::{Differentiable, Tangent};

macro_rules! records {
    ($($symbol:literal $name:ident $rule:ident $pullback:ident $result:ty;)*) => {$(
        #[doc = concat!("What `", $symbol, "` keeps.")]
        pub struct $name<A, B, K> {
            kept: K,
            operands: PhantomData<fn(A, B)>,
        }

        // The bounds stand on the methods: where one is not met, this is said of the operand.
        impl<A, B: Differentiable, K: Default> $name<A, B, K> {
            /// What is kept of operands within a loop, which tells them by [`keep`](Self::keep).
            #[inline(always)]
            pub fn of_unknown() -> Self {
                Self { kept: K::default(), operands: PhantomData }
            }

            /// What is kept of these operands.
            #[inline(always)]
            pub fn of(left: &A, right: &B) -> Self
            where
                A: $rule<B, Kept = K>,
                K: Kept<A, B>,
            {
                let record = Self::of_unknown();
                record.keep(left, right);
                record
            }

            /// Says what the operands are in this iteration.
            #[inline(always)]
            pub fn keep(&self, left: &A, right: &B)
            where
                A: $rule<B, Kept = K>,
                K: Kept<A, B>,
            {
                self.kept.keep(left, right);
            }

            /// The cotangents of the operands that were kept last.
            #[inline(always)]
            pub fn pull_back(&self, cotangent: Tangent<$result>) -> (Tangent<A>, Tangent<B>)
            where
                A: $rule<B, Kept = K>,
            {
                A::$pullback(&self.kept, cotangent)
            }
        }
    )*};
}

records! {
    "a + b" Sum AddPullback add_pullback <A as Add<B>>::Output;
    "a - b" Difference SubPullback sub_pullback <A as Sub<B>>::Output;
    "a += b" Increase AddAssignPullback add_assign_pullback A;
    "a -= b" Decrease SubAssignPullback sub_assign_pullback A;
}

/// What `-a` keeps.
pub struct Negation<A, K> {
    kept: K,
    operand: PhantomData<fn(A)>,
}

impl<A, K: Default> Negation<A, K> {
    /// What is kept of an operand within a loop, which tells it by [`keep`](Self::keep).
    #[inline(always)]
    pub fn of_unknown() -> Self {
        Self { kept: K::default(), operand: PhantomData }
    }

    /// What is kept of this operand.
    #[inline(always)]
    pub fn of(operand: &A) -> Self
    where
        A: NegPullback<Kept = K>,
        K: Kept<A, A>,
    {
        let record = Self::of_unknown();
        record.keep(operand);
        record
    }

    /// Says what the operand is in this iteration.
    #[inline(always)]
    pub fn keep(&self, operand: &A)
    where
        A: NegPullback<Kept = K>,
        K: Kept<A, A>,
    {
        self.kept.keep(operand, operand);
    }

    /// The cotangent of the operand that was kept last.
    #[inline(always)]
    pub fn pull_back(&self, cotangent: Tangent<<A as Neg>::Output>) -> Tangent<A>
    where
        A: NegPullback<Kept = K>,
    {
        A::neg_pullback(&self.kept, cotangent)
    }
}
