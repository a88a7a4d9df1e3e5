//! Derivatives of derivatives, which are refused.

use syn::{Ident, Path};

const INSTEAD: &str = "a derivative within a differentiable function is not supported: for second derivatives make the function generic over `S: Real` and call `ad::hvp(f::grad, ..)` from outside";

/// Why a call of the function at `path` is refused, where it is a generated derivative: `f::grad`.
pub(super) fn refused_function(path: &Path) -> Option<String> {
    let mut segments = path.segments.iter().rev();
    let name = &segments.next()?.ident;
    segments.next()?;
    match () {
        () if name == "grad" => Some(format!(
            "{INSTEAD}; a function of your own of this name is imported and called as `grad(..)`"
        )),
        () if ["vjp", "jvp", "value_and_grad"].iter().any(|other| name == other) => {
            Some(INSTEAD.to_owned())
        }
        () => None,
    }
}

/// The same for a method.
pub(super) fn refused_method(method: &Ident) -> Option<String> {
    let name = method.to_string();
    let is_derivative = ["_vjp", "_jvp", "_value_and_grad"].iter().any(|end| name.ends_with(end));
    is_derivative.then(|| INSTEAD.to_owned())
}
