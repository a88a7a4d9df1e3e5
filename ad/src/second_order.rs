//! Second derivatives, forward over reverse: a generated gradient on dual numbers.

use crate::check::{Coordinates, Function};
use crate::vector::Xyz;
use crate::{Dual, Real};

/// A value that dual numbers can take the place of.
pub trait Lift: Coordinates {
    /// The same, of dual numbers.
    type Lifted;

    /// The value, moving with the next numbers of a direction, of which it takes as many as it has
    /// coordinates.
    fn lift(&self, direction: &mut impl Iterator<Item = f64>) -> Self::Lifted;
}

/// What is made of dual numbers.
pub trait Split {
    /// The same, of their values or their derivatives.
    type Part;

    /// The values and the derivatives.
    fn split(self) -> (Self::Part, Self::Part);
}

macro_rules! scalars {
    ($($type:ident $vector:ident)*) => {$(
        impl Lift for $type {
            type Lifted = Dual<$type>;

            fn lift(&self, direction: &mut impl Iterator<Item = f64>) -> Dual<$type> {
                Dual::new(*self, direction.next().unwrap_or(0.0) as $type)
            }
        }

        impl Lift for glam::$vector {
            type Lifted = Xyz<Dual<$type>>;

            fn lift(&self, direction: &mut impl Iterator<Item = f64>) -> Xyz<Dual<$type>> {
                let [x, y, z] = self.to_array().lift(direction);
                Xyz { x, y, z }
            }
        }
    )*};
}

scalars!(f32 Vec3 f64 DVec3);

macro_rules! discrete {
    ($($type:ty)*) => {$(
        impl Lift for $type {
            type Lifted = $type;

            fn lift(&self, _: &mut impl Iterator<Item = f64>) -> $type {
                *self
            }
        }
    )*};
}

discrete!(bool char i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize);

impl<T: Lift, const N: usize> Lift for [T; N] {
    type Lifted = [T::Lifted; N];

    fn lift(&self, direction: &mut impl Iterator<Item = f64>) -> Self::Lifted {
        self.each_ref().map(|element| element.lift(direction))
    }
}

impl<T: Lift> Lift for Vec<T> {
    type Lifted = Vec<T::Lifted>;

    fn lift(&self, direction: &mut impl Iterator<Item = f64>) -> Self::Lifted {
        self.iter().map(|element| element.lift(direction)).collect()
    }
}

impl<S: Real> Split for Dual<S> {
    type Part = S;

    fn split(self) -> (S, S) {
        (self.value, self.derivative)
    }
}

impl<S: Real> Split for Xyz<Dual<S>> {
    type Part = Xyz<S>;

    fn split(self) -> (Xyz<S>, Xyz<S>) {
        let Self { x, y, z } = self;
        let part = |of: fn(Dual<S>) -> S| Xyz { x: of(x), y: of(y), z: of(z) };
        (part(|dual| dual.value), part(|dual| dual.derivative))
    }
}

impl<T: Split, const N: usize> Split for [T; N] {
    type Part = [T::Part; N];

    fn split(self) -> (Self::Part, Self::Part) {
        let mut derivatives = [const { None }; N];
        let mut next = derivatives.iter_mut();
        let values = self.map(|element| {
            let (value, derivative) = element.split();
            *next.next().expect("one for each element") = Some(derivative);
            value
        });
        (values, derivatives.map(|derivative| derivative.expect("every element was split")))
    }
}

impl<T: Split> Split for Vec<T> {
    type Part = Vec<T::Part>;

    fn split(self) -> (Self::Part, Self::Part) {
        self.into_iter().map(T::split).unzip()
    }
}

macro_rules! tuples {
    ($(($($name:ident $index:tt),*))*) => {$(
        impl<$($name: Lift),*> Lift for ($($name,)*) {
            type Lifted = ($($name::Lifted,)*);

            #[allow(unused_variables, clippy::unused_unit)]
            fn lift(&self, direction: &mut impl Iterator<Item = f64>) -> Self::Lifted {
                ($(self.$index.lift(direction),)*)
            }
        }

        impl<$($name: Split),*> Split for ($($name,)*) {
            type Part = ($($name::Part,)*);

            #[allow(clippy::unused_unit)]
            fn split(self) -> (Self::Part, Self::Part) {
                let parts = ($(self.$index.split(),)*);
                let _ = &parts;
                (($(parts.$index.0,)*), ($(parts.$index.1,)*))
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

/// The gradient at `point`, and the Hessian there times `direction`, both exact.
///
/// `gradient` is `f::grad` of a function generic over its scalar, which dual numbers take the place
/// of: forward mode over reverse mode, at two to three times the cost of the gradient. Point and
/// direction are tuples of the arguments. A function of references is passed as a closure of what
/// owns the data.
///
/// ```
/// use ad::{Real, differentiable};
///
/// #[differentiable]
/// fn rosenbrock<S: Real>(x: S, y: S) -> S {
///     let a = S::ONE - x;
///     let b = y - x * x;
///     a * a + S::from_f64(100.0) * b * b
/// }
///
/// let (gradient, product) = ad::hvp(rosenbrock::grad, (1.0, 1.0), (1.0, 0.0));
/// assert_eq!((gradient, product), ((0.0, 0.0), (802.0, -400.0)));
/// ```
pub fn hvp<P, G>(
    gradient: impl Function<P::Lifted, Output = G>,
    point: P,
    direction: P,
) -> (G::Part, G::Part)
where
    P: Lift,
    G: Split,
{
    let direction = direction.coordinates();
    gradient.at(point.lift(&mut direction.into_iter())).split()
}

/// The Hessian at `point`, a tuple: a row for each coordinate, by one [`hvp`] each.
///
/// ```
/// use ad::{Real, differentiable};
///
/// #[differentiable]
/// fn product<S: Real>(x: [S; 2], y: S) -> S {
///     x[0] * x[1] * y
/// }
///
/// let hessian = ad::hessian(product::grad, ([1.0, 2.0], 3.0));
/// assert_eq!(hessian, [[0.0, 3.0, 2.0], [3.0, 0.0, 1.0], [2.0, 1.0, 0.0]]);
/// ```
pub fn hessian<P, G>(gradient: impl Function<P::Lifted, Output = G>, point: P) -> Vec<Vec<f64>>
where
    P: Lift,
    G: Split<Part: Coordinates>,
{
    let count = point.coordinates().len();
    let row = |row| {
        let lifted = point.lift(&mut crate::jacobian::unit(row, count));
        gradient.at(lifted).split().1.coordinates()
    };
    (0..count).map(row).collect()
}
