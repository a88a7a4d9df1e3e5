//! Checks forward mode against finite differences.

use super::coordinates::Coordinates;
use super::derivative;
use super::rule::{Component, Function, Settings};
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
    let bits = |value: &[f64]| value.iter().map(|x| x.to_bits()).collect::<Vec<_>>();

    let mut worst: Option<Component> = None;
    for parameter in 0..point.len() {
        let tangents = tangent_like(&arguments, unit(parameter, point.len()));
        let (returned, tangent) = jvp.at(copy(&point), tangents);
        let returned = returned.coordinates();
        assert!(
            bits(&returned) == bits(&value),
            "forward mode returns the value {returned:?}, the function {value:?}"
        );
        let tangent = tangent.coordinates();
        assert_eq!(tangent.len(), value.len(), "the coordinates of the tangent");
        for (result, &found) in tangent.iter().enumerate() {
            let mut moved = point.clone();
            let along = |x| {
                moved[parameter] = x;
                function.at(copy(&moved)).coordinates().get(result).copied().unwrap_or(f64::NAN)
            };
            let estimate = derivative(along, point[parameter], settings.step);
            let component = Component { result, parameter, found, estimate };
            if worst.is_none_or(|worst| worst.error() < component.error()) {
                worst = Some(component);
            }
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
