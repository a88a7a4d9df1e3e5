//! Arguments made of dual numbers, and the parts of results.

use core::array;

use super::{Directions, Dual};
use crate::Real;
use crate::check::{Coordinates, Function};
use crate::vector::Xyz;

/// A value that dual numbers can take the place of.
pub trait Lift: Coordinates {
    /// The same, of dual numbers.
    type Lifted<const K: usize>;

    /// The value, moving in `K` directions: each coordinate takes the next element, what it moves by
    /// along each of them.
    fn lift<const K: usize>(
        &self,
        directions: &mut impl Iterator<Item = [f64; K]>,
    ) -> Self::Lifted<K>;
}

/// What is made of dual numbers.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not made of dual numbers",
    note = "pass a function that is generic over its scalar, `fn f<S: ad::Real>(..)`"
)]
pub trait Split {
    /// The same, of their values or their derivatives.
    type Part;

    /// The derivatives along a direction, or else the values.
    fn part(&self, direction: Option<usize>) -> Self::Part;
}

macro_rules! scalars {
    ($($type:ident)*) => {$(
        impl Lift for $type {
            type Lifted<const K: usize> = Dual<$type, Directions<$type, K>>;

            fn lift<const K: usize>(
                &self,
                directions: &mut impl Iterator<Item = [f64; K]>,
            ) -> Self::Lifted<K> {
                let along = directions.next().unwrap_or([0.0; K]);
                Dual::new(*self, Directions(along.map(|along| along as $type)))
            }
        }
    )*};
}

scalars!(f32 f64);

macro_rules! discrete {
    ($($type:ty)*) => {$(
        impl Lift for $type {
            type Lifted<const K: usize> = $type;

            fn lift<const K: usize>(&self, _: &mut impl Iterator<Item = [f64; K]>) -> $type {
                *self
            }
        }
    )*};
}

discrete!(bool char i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize);

impl<T: Lift> Lift for Xyz<T> {
    type Lifted<const K: usize> = Xyz<T::Lifted<K>>;

    fn lift<const K: usize>(
        &self,
        directions: &mut impl Iterator<Item = [f64; K]>,
    ) -> Self::Lifted<K> {
        let [x, y, z] = [&self.x, &self.y, &self.z].map(|element| element.lift(directions));
        Xyz { x, y, z }
    }
}

impl<T: Lift, const N: usize> Lift for [T; N] {
    type Lifted<const K: usize> = [T::Lifted<K>; N];

    fn lift<const K: usize>(
        &self,
        directions: &mut impl Iterator<Item = [f64; K]>,
    ) -> Self::Lifted<K> {
        self.each_ref().map(|element| element.lift(directions))
    }
}

impl<T: Lift> Lift for Vec<T> {
    type Lifted<const K: usize> = Vec<T::Lifted<K>>;

    fn lift<const K: usize>(
        &self,
        directions: &mut impl Iterator<Item = [f64; K]>,
    ) -> Self::Lifted<K> {
        self.iter().map(|element| element.lift(directions)).collect()
    }
}

impl<S: Real, const K: usize> Split for Dual<S, Directions<S, K>> {
    type Part = S;

    fn part(&self, direction: Option<usize>) -> S {
        match direction {
            Some(direction) => self.derivative.0[direction],
            None => self.value,
        }
    }
}

impl<S: Real, const K: usize> Split for Xyz<Dual<S, Directions<S, K>>> {
    type Part = Xyz<S>;

    fn part(&self, direction: Option<usize>) -> Xyz<S> {
        let [x, y, z] = [self.x, self.y, self.z].part(direction);
        Xyz { x, y, z }
    }
}

impl<T: Split, const N: usize> Split for [T; N] {
    type Part = [T::Part; N];

    fn part(&self, direction: Option<usize>) -> Self::Part {
        self.each_ref().map(|element| element.part(direction))
    }
}

impl<T: Split> Split for Vec<T> {
    type Part = Vec<T::Part>;

    fn part(&self, direction: Option<usize>) -> Self::Part {
        self.iter().map(|element| element.part(direction)).collect()
    }
}

macro_rules! tuples {
    ($(($($name:ident $index:tt),*))*) => {$(
        impl<$($name: Lift),*> Lift for ($($name,)*) {
            type Lifted<const K: usize> = ($($name::Lifted<K>,)*);

            #[allow(unused_variables, clippy::unused_unit)]
            fn lift<const K: usize>(
                &self,
                directions: &mut impl Iterator<Item = [f64; K]>,
            ) -> Self::Lifted<K> {
                ($(self.$index.lift(directions),)*)
            }
        }

        impl<$($name: Split),*> Split for ($($name,)*) {
            type Part = ($($name::Part,)*);

            #[allow(unused_variables, clippy::unused_unit)]
            fn part(&self, direction: Option<usize>) -> Self::Part {
                ($(self.$index.part(direction),)*)
            }
        }
    )*};
}

tuples! {
    ()
    (A 0)
    (A 0, B 1)
    (A 0, B 1, C 2)
    (A 0, B 1, C 2, D 3)
    (A 0, B 1, C 2, D 3, E 4)
    (A 0, B 1, C 2, D 3, E 4, F 5)
}

/// How many directions are followed at once where all are wanted.
pub const AT_ONCE: usize = 4;

/// The derivatives of `function` at `point` by each of its coordinates, in turn: those of all
/// coordinates of the result.
pub(crate) fn along_each_coordinate<P, R>(
    function: impl Function<P::Lifted<AT_ONCE>, Output = R>,
    point: &P,
) -> Vec<Vec<f64>>
where
    P: Lift,
    R: Split<Part: Coordinates>,
{
    let count = point.coordinates().len();
    let mut derivatives = Vec::with_capacity(count);
    for first in (0..count).step_by(AT_ONCE) {
        let unit = |i: usize| array::from_fn(|k| if first + k == i { 1.0 } else { 0.0 });
        let result = function.at(point.lift(&mut (0..count).map(unit)));
        let here = AT_ONCE.min(count - first);
        derivatives.extend((0..here).map(|k| result.part(Some(k)).coordinates()));
    }
    derivatives
}
