//! Second derivatives, forward over reverse: a generated gradient on dual numbers.

use crate::check::{Coordinates, Function};
use crate::dual::{AT_ONCE, Lift, Split, along_each_coordinate};

/// The gradient at `point`, and the Hessian there times `direction`, both exact.
///
/// `gradient` is `f::grad` of a function generic over its scalar, which dual numbers take the place
/// of: forward mode over reverse mode, at two to three times the cost of the gradient. Point and
/// direction are tuples of the arguments. A function of references is passed as a closure of what
/// owns the data (or as a generic function of it, where the same goes to [`hessian`]).
///
/// # Panics
///
/// If the direction has another number of coordinates than the point.
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
    gradient: impl Function<P::Lifted<1>, Output = G>,
    point: P,
    direction: P,
) -> (G::Part, G::Part)
where
    P: Lift,
    G: Split,
{
    let direction = direction.coordinates();
    let (given, asked) = (direction.len(), point.coordinates().len());
    assert_eq!(given, asked, "the direction has as many coordinates as the point");
    let product = gradient.at(point.lift(&mut direction.into_iter().map(|along| [along])));
    (product.part(None), product.part(Some(0)))
}

/// The Hessian at `point`, a tuple: a row for each coordinate, several at once.
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
pub fn hessian<P, G>(
    gradient: impl Function<P::Lifted<AT_ONCE>, Output = G>,
    point: P,
) -> Vec<Vec<f64>>
where
    P: Lift,
    G: Split<Part: Coordinates>,
{
    along_each_coordinate(gradient, &point)
}
