//! Whole Jacobians, column by column or row by row.

use crate::check::{Coordinates, Function, Rule};
use crate::dual::{AT_ONCE, Lift, Split, along_each_coordinate};
use crate::{Additive, Differentiable, Shape, Tangent};

/// The forward mode of a function of several arguments: what `f::jvp` is, for arguments by value.
pub trait Pushforward<Arguments: Differentiable, Result: Differentiable> {
    /// The value and its tangent.
    fn at(&self, arguments: Arguments, tangents: Tangent<Arguments>) -> (Result, Tangent<Result>);
}

macro_rules! functions {
    ($(($($name:ident $index:tt),*))*) => {$(
        impl<Fun, R, D, $($name: Differentiable),*> Pushforward<($($name,)*), R> for Fun
        where
            Fun: Fn($($name,)* $(Tangent<$name>),*) -> (R, D),
            R: Differentiable<Tangent = D>,
        {
            fn at(&self, arguments: ($($name,)*), tangents: ($(Tangent<$name>,)*)) -> (R, D) {
                self($(arguments.$index,)* $(tangents.$index),*)
            }
        }
    )*};
}

functions! {
    (A 0)
    (A 0, B 1)
    (A 0, B 1, C 2)
    (A 0, B 1, C 2, D1 3)
    (A 0, B 1, C 2, D1 3, E 4)
    (A 0, B 1, C 2, D1 3, E 4, F 5)
}

/// The tangent (or cotangent) of `value` with these coordinates.
pub(crate) fn tangent_like<T>(value: &T, coordinates: impl IntoIterator<Item = f64>) -> Tangent<T>
where
    T: Differentiable<Tangent: Coordinates>,
{
    let mut tangent = Tangent::<T>::zero();
    value.shape().fit(&mut tangent);
    tangent.read(&mut coordinates.into_iter())
}

/// The unit vector number `i` of `count` dimensions.
pub(crate) fn unit(i: usize, count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |k| if k == i { 1.0 } else { 0.0 })
}

/// The Jacobian of a function at `arguments`, a tuple, by its forward mode: a row for each
/// coordinate of the result, with an element for each coordinate of the arguments.
///
/// The function runs once for each coordinate of the arguments, so this is for functions of few
/// numbers; for few results use [`jacobian_reverse`]. Functions of references are passed as closures
/// of what owns the data. Parameters without derivative have no coordinates.
///
/// ```
/// use ad::differentiable;
///
/// #[differentiable]
/// fn polar(radius: f64, angle: f64) -> [f64; 2] {
///     [radius * angle.cos(), radius * angle.sin()]
/// }
///
/// let jacobian = ad::jacobian_forward(polar::jvp, (2.0, 0.0));
/// assert_eq!(jacobian, [[1.0, 0.0], [0.0, 2.0]]);
/// assert_eq!(jacobian, ad::jacobian_reverse(polar::vjp, (2.0, 0.0)));
/// ```
pub fn jacobian_forward<Arguments, R>(
    jvp: impl Pushforward<Arguments, R>,
    arguments: Arguments,
) -> Vec<Vec<f64>>
where
    Arguments: Coordinates + Differentiable<Tangent: Coordinates>,
    R: Coordinates + Differentiable<Tangent: Coordinates>,
{
    let point = arguments.coordinates();
    let columns = (0..point.len()).map(|column| {
        let tangents = tangent_like(&arguments, unit(column, point.len()));
        let (_, tangent) = jvp.at(arguments.read(&mut point.iter().copied()), tangents);
        tangent.coordinates()
    });
    rows(&columns.collect::<Vec<_>>())
}

/// The Jacobian at `point`, a tuple, of a function that is generic over its scalar: as
/// [`jacobian_forward`], but by dual numbers, which follow several coordinates at once and so share
/// what the values cost.
///
/// ```
/// use ad::Real;
///
/// fn polar<S: Real>(radius: S, angle: S) -> [S; 2] {
///     [radius * angle.cos(), radius * angle.sin()]
/// }
///
/// let jacobian = ad::jacobian(polar, (2.0, 0.0));
/// assert_eq!(jacobian, [[1.0, 0.0], [0.0, 2.0]]);
/// ```
pub fn jacobian<P, R>(
    function: impl Function<P::Lifted<AT_ONCE>, Output = R>,
    point: P,
) -> Vec<Vec<f64>>
where
    P: Lift,
    R: Split<Part: Coordinates>,
{
    rows(&along_each_coordinate(function, &point))
}

/// The rows of a matrix from its columns.
fn rows(columns: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let count = columns.first().map_or(0, Vec::len);
    (0..count).map(|row| columns.iter().map(|column| column[row]).collect()).collect()
}

/// The Jacobian of a function at `arguments`, a tuple, by its reverse mode: as
/// [`jacobian_forward`], but with one run and one pullback for each coordinate of the result.
pub fn jacobian_reverse<Arguments, R, G>(
    vjp: impl Rule<Arguments, R, G>,
    arguments: Arguments,
) -> Vec<Vec<f64>>
where
    Arguments: Coordinates,
    R: Coordinates + Differentiable<Tangent: Coordinates>,
    G: Coordinates,
{
    let point = arguments.coordinates();
    let copy = || arguments.read(&mut point.iter().copied());
    let (value, _) = vjp.at(copy(), Additive::zero());
    let count = value.coordinates().len();
    let row = |row| vjp.at(copy(), tangent_like(&value, unit(row, count))).1.coordinates();
    (0..count).map(row).collect()
}
