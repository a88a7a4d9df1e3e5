//! Checks a derivative, written by hand or generated, against finite differences.

use core::fmt;

use super::coordinates::Coordinates;
use super::{Estimate, derivative};
use crate::{Additive, Differentiable, Shape, Tangent};

/// How a derivative is checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The first and largest step of the finite differences; see [`derivative`].
    pub step: f64,
    /// The largest error, relative to the derivative, and absolute below 1. What finite differences
    /// themselves may be off by comes on top.
    pub tolerance: f64,
}

/// For functions of `f64` that change noticeably over a length of about 1.
impl Default for Settings {
    fn default() -> Self {
        Self { step: 1e-2, tolerance: 1e-6 }
    }
}

/// The derivative of one coordinate of the result by one of the parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Component {
    /// The number of the coordinate of the result.
    pub result: usize,
    /// The number of the coordinate, of all those of the parameters in their order.
    pub parameter: usize,
    /// What the derivative under test says.
    pub found: f64,
    /// What finite differences of the function give.
    pub estimate: Estimate,
}

impl Component {
    /// The difference, beyond the error of the finite differences, relative to the derivative where
    /// that is greater than 1. Infinite where one of the two is no number.
    pub fn error(&self) -> f64 {
        let Estimate { value, error } = self.estimate;
        let difference = ((self.found - value).abs() - error).max(0.0);
        match difference.is_nan() || !self.found.is_finite() || !value.is_finite() {
            true => f64::INFINITY,
            false => difference / value.abs().max(1.0),
        }
    }

    /// The one with the greater error, of two the earlier one.
    pub(super) fn or_worse(self, earlier: Option<Self>) -> Option<Self> {
        match earlier {
            Some(earlier) if earlier.error() >= self.error() => Some(earlier),
            _ => Some(self),
        }
    }
}

/// Compares `found`, said to be the derivative of coordinate `result` of the function `at` by
/// coordinate `parameter` of its point, with finite differences.
pub(super) fn compare(
    at: impl Fn(&[f64]) -> Vec<f64>,
    point: &[f64],
    (result, parameter): (usize, usize),
    found: f64,
    settings: Settings,
) -> Component {
    let mut moved = point.to_vec();
    let along = |x| {
        moved[parameter] = x;
        at(&moved).get(result).copied().unwrap_or(f64::NAN)
    };
    let estimate = derivative(along, point[parameter], settings.step);
    Component { result, parameter, found, estimate }
}

/// Whether two values have the same coordinates, bit for bit.
pub(super) fn are_same(left: &[f64], right: &[f64]) -> bool {
    left.iter().map(|x| x.to_bits()).eq(right.iter().map(|x| x.to_bits()))
}

impl fmt::Display for Component {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { result, parameter, found, estimate } = self;
        write!(
            f,
            "coordinate {result} of the result by coordinate {parameter} of the parameters: \
             found {found:e}, finite differences {:e} ± {:e}",
            estimate.value, estimate.error
        )
    }
}

/// A function of several arguments, as one of their tuple.
pub trait Function<Arguments> {
    /// What it returns.
    type Output;

    /// Its value.
    fn at(&self, arguments: Arguments) -> Self::Output;
}

/// The derivative of a function of several arguments.
pub trait Rule<Arguments, Result: Differentiable, Gradient> {
    /// The value, and the gradient for a cotangent of it.
    fn at(&self, arguments: Arguments, cotangent: Tangent<Result>) -> (Result, Gradient);
}

macro_rules! functions {
    ($(($($name:ident $index:tt),*))*) => {$(
        impl<Fun, R, $($name),*> Function<($($name,)*)> for Fun
        where
            Fun: Fn($($name),*) -> R,
        {
            type Output = R;

            fn at(&self, arguments: ($($name,)*)) -> R {
                self($(arguments.$index),*)
            }
        }

        impl<Fun, Back, R, G, $($name),*> Rule<($($name,)*), R, G> for Fun
        where
            Fun: Fn($($name),*) -> (R, Back),
            Back: FnOnce(Tangent<R>) -> G,
            R: Differentiable,
        {
            fn at(&self, arguments: ($($name,)*), cotangent: Tangent<R>) -> (R, G) {
                let (value, pullback) = self($(arguments.$index),*);
                (value, pullback(cotangent))
            }
        }
    )*};
}

functions! {
    (A 0)
    (A 0, B 1)
    (A 0, B 1, C 2)
    (A 0, B 1, C 2, D 3)
    (A 0, B 1, C 2, D 3, E 4)
    (A 0, B 1, C 2, D 3, E 4, F 5)
}

/// Compares the derivative `rule` of `function` at `arguments`, a tuple, with finite differences:
/// every coordinate of the result by every one of the parameters. Returns the component with the
/// greatest error; `None` where there are none.
///
/// Functions of references are passed as closures of what owns the data.
///
/// # Panics
///
/// If the value that `rule` returns is not that of `function`, bit for bit, or if a cotangent has
/// another number of coordinates than what it belongs to.
#[track_caller]
pub fn worst<Arguments, R, G>(
    function: impl Function<Arguments, Output = R>,
    rule: impl Rule<Arguments, R, G>,
    arguments: Arguments,
    settings: Settings,
) -> Option<Component>
where
    Arguments: Coordinates,
    R: Coordinates + Differentiable<Tangent: Coordinates>,
    G: Coordinates,
{
    let point = arguments.coordinates();
    let copy = |point: &[f64]| arguments.read(&mut point.iter().copied());
    let expected = function.at(copy(&point));
    let value = expected.coordinates();

    let mut cotangent = Tangent::<R>::zero();
    expected.shape().fit(&mut cotangent);
    let count = cotangent.coordinates().len();
    assert_eq!(count, value.len(), "the coordinates of the cotangent of the result");

    let mut worst: Option<Component> = None;
    for result in 0..count {
        let unit = (0..count).map(|k| if k == result { 1.0 } else { 0.0 });
        let (returned, gradient) = rule.at(copy(&point), cotangent.read(&mut unit.into_iter()));
        let returned = returned.coordinates();
        assert!(
            are_same(&returned, &value),
            "the rule returns the value {returned:?}, the function {value:?}"
        );
        let gradient = gradient.coordinates();
        assert_eq!(gradient.len(), point.len(), "the coordinates of the gradient");
        for (parameter, &found) in gradient.iter().enumerate() {
            let at = |point: &[f64]| function.at(copy(point)).coordinates();
            let component = compare(at, &point, (result, parameter), found, settings);
            worst = component.or_worse(worst);
        }
    }
    worst
}

/// Asserts that `rule` is the derivative of `function` at `arguments`, with the default
/// [`Settings`]. See [`worst`].
///
/// ```
/// fn cube(x: f64, by: f64) -> f64 {
///     x * x * x * by
/// }
///
/// fn cube_vjp(x: f64, by: f64) -> (f64, impl FnOnce(f64) -> (f64, f64)) {
///     (cube(x, by), move |bar| (3.0 * x * x * by * bar, x * x * x * bar))
/// }
///
/// ad::check::assert_rule(cube, cube_vjp, (1.5, 2.0));
/// ```
#[track_caller]
pub fn assert_rule<Arguments, R, G>(
    function: impl Function<Arguments, Output = R>,
    rule: impl Rule<Arguments, R, G>,
    arguments: Arguments,
) where
    Arguments: Coordinates,
    R: Coordinates + Differentiable<Tangent: Coordinates>,
    G: Coordinates,
{
    let settings = Settings::default();
    if let Some(worst) = worst(function, rule, arguments, settings) {
        assert!(worst.error() <= settings.tolerance, "{worst}");
    }
}
