//! Checks forward mode against finite differences.

use super::coordinates::Coordinates;
use super::rule::{Component, Function, Settings, are_same, compare};
use crate::Differentiable;
use crate::jacobian::{Pushforward, tangent_like, unit};

/// Compares the forward mode `jvp` of `function` at `arguments`, a tuple, with finite differences:
/// every coordinate of the result by every one of the parameters. Returns the component with the
/// greatest error; `None` where there are none. See [`worst`](super::worst).
///
/// # Panics
///
/// If the value that `jvp` returns is not that of `function`, bit for bit, or if its tangent has
/// another number of coordinates.
#[track_caller]
pub fn worst_forward<Arguments, R>(
    function: impl Function<Arguments, Output = R>,
    jvp: impl Pushforward<Arguments, R>,
    arguments: Arguments,
    settings: Settings,
) -> Option<Component>
where
    Arguments: Coordinates + Differentiable<Tangent: Coordinates>,
    R: Coordinates + Differentiable<Tangent: Coordinates>,
{
    let point = arguments.coordinates();
    let copy = |point: &[f64]| arguments.read(&mut point.iter().copied());
    let value = function.at(copy(&point)).coordinates();

    let mut worst: Option<Component> = None;
    for parameter in 0..point.len() {
        let tangents = tangent_like(&arguments, unit(parameter, point.len()));
        let (returned, tangent) = jvp.at(copy(&point), tangents);
        let returned = returned.coordinates();
        assert!(
            are_same(&returned, &value),
            "forward mode returns the value {returned:?}, the function {value:?}"
        );
        let tangent = tangent.coordinates();
        assert_eq!(tangent.len(), value.len(), "the coordinates of the tangent");
        for (result, &found) in tangent.iter().enumerate() {
            let at = |point: &[f64]| function.at(copy(point)).coordinates();
            let component = compare(at, &point, (result, parameter), found, settings);
            worst = component.or_worse(worst);
        }
    }
    worst
}

/// Asserts that `jvp` is the forward mode of `function` at `arguments`, with the default
/// [`Settings`]. See [`worst_forward`].
///
/// ```
/// #[ad::differentiable]
/// fn cube(x: f64, by: f64) -> f64 {
///     x * x * x * by
/// }
///
/// ad::check::assert_forward(cube, cube::jvp, (1.5, 2.0));
/// ```
#[track_caller]
pub fn assert_forward<Arguments, R>(
    function: impl Function<Arguments, Output = R>,
    jvp: impl Pushforward<Arguments, R>,
    arguments: Arguments,
) where
    Arguments: Coordinates + Differentiable<Tangent: Coordinates>,
    R: Coordinates + Differentiable<Tangent: Coordinates>,
{
    let settings = Settings::default();
    if let Some(worst) = worst_forward(function, jvp, arguments, settings) {
        assert!(worst.error() <= settings.tolerance, "{worst}");
    }
}
