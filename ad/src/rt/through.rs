//! Forward mode by way of a pullback written by hand.
//!
//! The pullback of a scalar result gives for the cotangent 1 the partial derivatives; their inner
//! product with the tangents is the derivative along these. A result of several numbers would need
//! a pullback for each, and a pullback runs once. Whether there is a way is found out where the
//! rule is used, so that a function with a rule for reverse mode alone can be called in a
//! differentiable function as long as nobody asks for its forward mode.

use core::cell::Cell;
use core::marker::PhantomData;

use crate::vector::Xyz;
use crate::{Differentiable, Real, Tangent};

/// The value, the pullback and the tangents of a call.
pub struct Through<R, P, D>(Cell<Option<(R, P, D)>>);

impl<R, P, D> Through<R, P, D> {
    /// The parts.
    #[inline(always)]
    pub fn new(value: R, pullback: P, tangents: D) -> Self {
        Self(Cell::new(Some((value, pullback, tangents))))
    }

    #[inline(always)]
    fn parts(&self) -> (R, P, D) {
        self.0.take().expect("used once")
    }
}

/// The pullback gives the partial derivatives.
pub trait ByPullback<Kind> {
    /// The result.
    type Value;
    /// The value and its tangent.
    fn push_forward(&self) -> (Self::Value, Self::Value);
}

impl<R, P, G, D, K> ByPullback<(G, K)> for &Through<R, P, D>
where
    R: Real,
    P: FnOnce(R) -> G,
    G: Inner<R, D, K>,
{
    type Value = R;

    #[inline(always)]
    fn push_forward(&self) -> (R, R) {
        let (value, pullback, tangents) = self.parts();
        (value, pullback(R::ONE).inner(&tangents))
    }
}

/// The fallback for functions without a rule, which is an error where the function is used.
pub trait WithoutRule {
    /// The result.
    type Value: Differentiable;
    /// Does not compile.
    fn push_forward(&self) -> (Self::Value, Tangent<Self::Value>);
}

/// Fails when it is used.
struct Missing<P>(PhantomData<P>);

impl<P> Missing<P> {
    const RULE: () = panic!(
        "forward mode reaches a function whose derivative is written by hand, as `vjp = ..`, and \
         whose result is not one number or which has parameters of a type of its own: give it \
         `jvp = ..` as well"
    );
}

impl<R: Differentiable, P, D> WithoutRule for Through<R, P, D> {
    type Value = R;

    fn push_forward(&self) -> (R, Tangent<R>) {
        let () = Missing::<P>::RULE;
        unreachable!("does not compile")
    }
}

/// Numbers and vectors.
pub enum Same {}

/// Sequences, of elements by `Kind`.
pub struct Length<Kind>(Kind);

/// The inner product of cotangents with tangents `D`; a tangent of zero annihilates all.
///
/// `Kind` keeps the implementations apart; it is inferred.
pub trait Inner<S, D: ?Sized, Kind> {
    /// The product.
    fn inner(&self, tangent: &D) -> S;
}

impl<S: Real> Inner<S, S, Same> for S {
    #[inline(always)]
    fn inner(&self, tangent: &S) -> S {
        S::select(tangent.vanishes(), S::zero(), *tangent * *self)
    }
}

impl<S: Real> Inner<S, (), Same> for () {
    #[inline(always)]
    fn inner(&self, (): &()) -> S {
        S::zero()
    }
}

impl<S, G: Inner<S, D, K>, D: ?Sized, K> Inner<S, &D, (K,)> for G {
    #[inline(always)]
    fn inner(&self, tangent: &&D) -> S {
        self.inner(*tangent)
    }
}

impl<S: Real> Inner<S, Xyz<S>, Same> for Xyz<S> {
    #[inline(always)]
    fn inner(&self, tangent: &Xyz<S>) -> S {
        [self.x, self.y, self.z].inner(&[tangent.x, tangent.y, tangent.z])
    }
}

impl<S: Real, G: Inner<S, D, K>, D, K> Inner<S, [D], Length<K>> for [G] {
    #[inline(always)]
    fn inner(&self, tangent: &[D]) -> S {
        let products = self.iter().zip(tangent).map(|(partial, tangent)| partial.inner(tangent));
        products.fold(S::zero(), |sum, product| sum + product)
    }
}

impl<S: Real, G: Inner<S, D, K>, D, K, const N: usize> Inner<S, [D; N], Length<K>> for [G; N] {
    #[inline(always)]
    fn inner(&self, tangent: &[D; N]) -> S {
        self.as_slice().inner(tangent.as_slice())
    }
}

impl<S: Real, G: Inner<S, D, K>, D, K> Inner<S, [D], Length<K>> for Vec<G> {
    #[inline(always)]
    fn inner(&self, tangent: &[D]) -> S {
        self.as_slice().inner(tangent)
    }
}

impl<S: Real, G: Inner<S, D, K>, D, K> Inner<S, Vec<D>, Length<K>> for Vec<G> {
    #[inline(always)]
    fn inner(&self, tangent: &Vec<D>) -> S {
        self.as_slice().inner(tangent.as_slice())
    }
}

macro_rules! tuples {
    ($(($($cotangent:ident $tangent:ident $kind:ident $index:tt),*))*) => {$(
        impl<S: Real, $($cotangent: Inner<S, $tangent, $kind>, $tangent, $kind),*>
            Inner<S, ($($tangent,)*), ($($kind,)*)> for ($($cotangent,)*)
        {
            #[inline(always)]
            fn inner(&self, tangent: &($($tangent,)*)) -> S {
                S::zero() $(+ self.$index.inner(&tangent.$index))*
            }
        }
    )*};
}

tuples! {
    (A K U 0)
    (A K U 0, B L V 1)
    (A K U 0, B L V 1, C M W 2)
    (A K U 0, B L V 1, C M W 2, D N X 3)
    (A K U 0, B L V 1, C M W 2, D N X 3, E O Y 4)
    (A K U 0, B L V 1, C M W 2, D N X 3, E O Y 4, F P Z 5)
}
