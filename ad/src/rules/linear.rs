//! Linear maps with their adjoints: what partial derivatives are.

use super::scale_vector::scale_vector;
use super::{chain, scale};
use crate::vector::Vector;
use crate::{Additive, Mask, Real};

/// A partial derivative, from the tangents `A` of an argument to those of the result, `R`.
pub trait Linear<A, R> {
    /// The pushforward of a tangent.
    fn push(self, tangent: A) -> R;
    /// The pullback of a cotangent: the adjoint map.
    fn pull(self, cotangent: R) -> A;
}

/// The pullback of `map`, for a closure whose parameter has no type.
#[inline(always)]
pub fn adjoint<G, A>(cotangent: G, map: impl FnOnce(G) -> A) -> A {
    map(cotangent)
}

/// `partial` where it is not `singular`, else 0.
#[inline(always)]
pub fn unless<S: Real>(singular: S::Mask, partial: S) -> S {
    S::select(singular, S::zero(), partial)
}

/// The inner product of a tangent with partial derivatives.
#[inline(always)]
pub fn inner<V: Vector>(tangent: V, partials: V) -> V::Scalar {
    tangent.zip_elements(partials, chain).element_sum()
}

/// The tangent of a product by one factor. Where zero meets what is infinite or NaN the plain product gives
/// NaN, so a look at it spares the comparisons.
#[inline(always)]
fn factor_tangent<S: Real>(tangent: S, factor: S) -> S {
    let along = tangent * factor;
    match along.is_finite().all() {
        true => along,
        false => rare_factor_tangent(tangent, factor),
    }
}

/// The same, with the comparisons.
#[cold]
#[inline(never)]
fn rare_factor_tangent<S: Real>(tangent: S, factor: S) -> S {
    chain(tangent, factor)
}

/// The linear maps, each with its own data: its type is inferred where it is applied. Those without a
/// second closure are their own adjoints.
macro_rules! maps {
    ($($(#[$doc:meta])* $name:ident<$($param:ident),*>($($field:ident: $type:ty),*)
        [$($generics:tt)*] $from:ty => $to:ty: |$t:ident| $push:expr $(, |$g:ident| $pull:expr)?;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub struct $name<$($param),*>($(pub $param),*);

        #[allow(unused_variables)]
        impl<$($generics)*> Linear<$from, $to> for $name<$($type),*> {
            #[inline(always)]
            fn push(self, $t: $from) -> $to {
                let Self($($field),*) = self;
                $push
            }

            #[inline(always)]
            fn pull(self, cotangent: $to) -> $from {
                maps!(@pull self cotangent $name($($field),*) |$t| $push $(, |$g| $pull)?)
            }
        }
    )*};
    (@pull $map:ident $cotangent:ident $name:ident($($field:ident),*) |$t:ident| $push:expr) => {
        $map.push($cotangent)
    };
    (@pull $map:ident $cotangent:ident $name:ident($($field:ident),*)
        |$t:ident| $push:expr, |$g:ident| $pull:expr) => {{
        let ($name($($field),*), $g) = ($map, $cotangent);
        $pull
    }};
}

maps! {
    /// A number times a number.
    Times<P>(p: S) [S: Real] S => S: |t| chain(t, p);
    /// A number times a number that is finite as a rule.
    Factor<P>(p: S) [S: Real] S => S: |t| factor_tangent(t, p), |g| scale(g, p);
    /// A number where the mask holds, else 0.
    Where<M>(mask: S::Mask) [S: Real] S => S: |t| S::select(mask, t, S::zero());
    /// A vector times a vector, element by element.
    Elements<P>(p: V) [V: Vector] V => V: |t| t.zip_elements(p, chain);
    /// The elements of a vector where those of `p` are not 0.
    Chosen<P>(p: V) [V: Vector] V => V:
        |t| t.zip_elements(p, |t, p| unless(p.cmpeq(V::Scalar::ZERO), t));
    /// A vector times a number.
    Scaled<P>(p: V::Scalar) [V: Vector] V => V:
        |t| t.map_elements(|t| chain(t, p)), |g| g.map_elements(|g| scale(g, p));
    /// The inner product of a vector with a vector.
    Gradient<P>(p: V) [V: Vector] V => V::Scalar: |t| inner(t, p), |g| scale_vector(g, p);
    /// A number times a vector.
    Along<P>(p: V) [V: Vector] V::Scalar => V:
        |t| p.map_elements(|p| chain(t, p)), |g| inner(g, p);
    /// The vector that has a number in each element.
    Splat<>() [V: Vector] V::Scalar => V: |t| V::splat(t), |g| g.element_sum();
    /// The identity.
    Same<>() [T] T => T: |t| t;
    /// Zero.
    Zero<>() [A: Additive, R: Additive] A => R: |t| R::zero(), |g| A::zero();
    /// The opposite of a map.
    Negated<L>(map: L) [L: Linear<A, R>, A, R: core::ops::Neg<Output = R>] A => R:
        |t| -map.push(t), |g| map.pull(-g);
    /// A map that is its own adjoint.
    Symmetric<F>(map: F) [V, F: FnOnce(V) -> V] V => V: |t| map(t);
    /// The map from vectors to numbers with this pullback.
    Pulled<F>(pull: F) [V: Vector, F: FnOnce(V::Scalar) -> V] V => V::Scalar:
        |t| inner(t, pull(V::Scalar::ONE)), |g| pull(g);
    /// A map and its adjoint.
    Maps<F, G>(push: F, pull: G) [A, R, F: FnOnce(A) -> R, G: FnOnce(R) -> A] A => R:
        |t| push(t), |g| pull(g);
}
