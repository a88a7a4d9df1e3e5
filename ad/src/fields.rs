//! The numbers of a struct, one after the other and by the names of its fields.
//!
//! Optimisers, files and lists of parameters see a struct of numbers as one flat row. `#[derive(Fields)]`
//! gives a struct that is generic over its scalar, and its tangent, this view; the same struct of
//! another scalar comes from it by [`map`](Fields::map):
//!
//! ```
//! use ad::vector::Vector3;
//! use ad::{Differentiable, Fields, Real, Vec3};
//!
//! #[derive(Clone, Copy, Debug, Differentiable, Fields)]
//! struct Sphere<S: Real> {
//!     center: Vec3<S>,
//!     radius: S,
//! }
//!
//! let sphere = Sphere::<f64> { center: Vector3::new(1.0, 2.0, 3.0), radius: 4.0 };
//! assert_eq!(sphere.number(1), 2.0);
//! assert_eq!(Sphere::<f64>::FIELDS[1].name, "radius");
//!
//! let single: Sphere<f32> = sphere.map(|x| x as f32);
//! assert_eq!(single.radius, 4.0_f32);
//! ```
//!
//! A tangent has the numbers of its struct in the same order, so that `tangent.number(i)` is the
//! derivative by `value.number(i)`. Turned down: visitors, which cannot walk two structs side by
//! side, and slices, which a struct of lanes does not lie in.

use crate::Real;
use crate::vector::Xyz;

/// A field of a struct: its name, and how many numbers it holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// The name as it is written in the struct.
    pub name: &'static str,
    /// The number of scalars in the field.
    pub len: usize,
}

/// A value made of numbers `S` alone. Derived for structs with one type parameter, the scalar.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to be made of numbers `{S}` alone",
    note = "put `#[derive(Fields)]` on a struct that is generic over its scalar"
)]
pub trait Fields<S>: Sized {
    /// The same, of another scalar.
    type With<T: Real>: Fields<T>;

    /// How many numbers there are.
    const LEN: usize;

    /// The fields of a struct in their order; none of a number or a vector.
    const FIELDS: &'static [Field];

    /// The number at `index`, counted through all fields.
    ///
    /// # Panics
    ///
    /// If `index` is not below [`LEN`](Self::LEN).
    fn number(&self, index: usize) -> S;

    /// The value whose numbers `f` gives, in their order.
    fn from_fn(f: &mut impl FnMut(usize) -> S) -> Self;

    /// Calls `f` with the index and the value of each number.
    fn visit(&self, f: &mut impl FnMut(usize, S));

    /// The same value of another scalar: `f` of each number.
    #[inline(always)]
    fn map<T: Real>(&self, mut f: impl FnMut(S) -> T) -> Self::With<T> {
        Self::With::from_fn(&mut |index| f(self.number(index)))
    }
}

impl<S: Real> Fields<S> for S {
    type With<T: Real> = T;

    const LEN: usize = 1;
    const FIELDS: &'static [Field] = &[];

    #[inline(always)]
    fn number(&self, index: usize) -> S {
        assert!(index == 0, "a scalar is one number");
        *self
    }

    #[inline(always)]
    fn from_fn(f: &mut impl FnMut(usize) -> S) -> S {
        f(0)
    }

    #[inline(always)]
    fn visit(&self, f: &mut impl FnMut(usize, S)) {
        f(0, *self);
    }
}

macro_rules! vector_fields {
    ($type:ty, $scalar:ty $(, $generic:ident)?) => {
        impl$(<$generic: Real>)? Fields<$scalar> for $type {
            type With<T: Real> = T::Vec3;

            const LEN: usize = 3;
            const FIELDS: &'static [Field] = &[];

            #[inline(always)]
            fn number(&self, index: usize) -> $scalar {
                [self.x, self.y, self.z][index]
            }

            #[inline(always)]
            fn from_fn(f: &mut impl FnMut(usize) -> $scalar) -> Self {
                let (x, y, z) = (f(0), f(1), f(2));
                Self { x, y, z }
            }

            #[inline(always)]
            fn visit(&self, f: &mut impl FnMut(usize, $scalar)) {
                f(0, self.x);
                f(1, self.y);
                f(2, self.z);
            }
        }
    };
}

#[cfg(feature = "glam")]
pub(crate) use vector_fields;

vector_fields!(Xyz<S>, S, S);

impl<S, F: Fields<S>, const N: usize> Fields<S> for [F; N] {
    type With<T: Real> = [F::With<T>; N];

    const LEN: usize = N * F::LEN;
    const FIELDS: &'static [Field] = &[];

    #[inline(always)]
    fn number(&self, index: usize) -> S {
        self[index / F::LEN].number(index % F::LEN)
    }

    #[inline(always)]
    fn from_fn(f: &mut impl FnMut(usize) -> S) -> Self {
        core::array::from_fn(|element| F::from_fn(&mut |index| f(element * F::LEN + index)))
    }

    #[inline(always)]
    fn visit(&self, f: &mut impl FnMut(usize, S)) {
        for (element, value) in self.iter().enumerate() {
            value.visit(&mut |index, number| f(element * F::LEN + index, number));
        }
    }
}
