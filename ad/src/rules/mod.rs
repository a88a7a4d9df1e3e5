//! The derivative of every operation that generated code may meet.
//!
//! Two shapes. Operators have a *pullback trait* each ([`MulPullback`] for `*`): operands and the
//! cotangent of the result go in, the cotangents of the operands come out; the operands are
//! captured by the generated closure, once each. Methods and functions have two *siblings*, for
//! each mode one. `x.sqrt()` has [`sqrt_vjp`](RealRules::sqrt_vjp), which returns the value, bit for
//! bit that of the plain method, and the pullback: a closure from the cotangent of the result to those of
//! the receiver and the arguments, so that what both need is computed once. And it has
//! [`sqrt_jvp`](RealRules::sqrt_jvp), which takes the tangents of receiver and arguments after the
//! arguments, and returns the value and its tangent. `#[differentiable]` methods get the same
//! siblings, which is why generated code need not know whose method it calls.
//!
//! # Adding a rule
//!
//! A rule is one row of a table, in the file of what it is a function of, and both siblings come from
//! it: `sqrt(x) = root => Times(unless(root.cmpeq(Self::ZERO), Self::HALF / root));`. The documentation of
//! `row.rs` tells what a row may say, `linear.rs` has the linear maps that partial derivatives are, and
//! `in_place.rs` the rows of methods that change a sequence. The rule's test is one row, too, in
//! `tests/gradients/rules`: `sqrt(a: S) -> S, positive;`.
//!
//! # Singular points
//!
//! Where mathematics has no derivative, or an infinite one, the rules return a finite
//! subgradient, never a NaN:
//!
//! | function | where | cotangent |
//! |---|---|---|
//! | `sqrt` | 0 | 0 |
//! | `cbrt` | 0 | 0 |
//! | `abs` | 0 | 0 |
//! | `ln`, `log2`, `log10`, `recip` | 0 | 0 |
//! | `ln_1p` | -1 | 0 |
//! | `log(x, b)` | `x = 0`, `b = 0`, `b = 1` | 0 to both |
//! | `a / b` | `b = 0` | 0 to both |
//! | `asin`, `acos`, `atanh` | -1 and 1 | 0 |
//! | `acosh` | 1 | 0 |
//! | `atan2`, `hypot` | (0, 0) | 0 to both |
//! | `powf(x, y)` | `x = 0` | to `x`: the derivative where it is finite (`y >= 1`), else 0; to `y`: 0 |
//! | `powf(x, y)` | `x < 0` | to `x`: the derivative where `y` is an integer; to `y`: 0 |
//! | `powi(x, n)` | `x = 0` | 1 if `n = 1`, else 0 |
//! | `min`, `max` | a tie | all to the receiver |
//! | `clamp` | on a bound | all to the receiver |
//! | `min_element`, `max_element` | a tie | all to the first |
//! | `signum`, `floor`, `ceil`, `round`, `round_ties_even`, `trunc`, `div_euclid`, `copysign` to the sign | everywhere | 0 |
//! | `%`, `rem_euclid`, `fract` | a jump | as beside it |
//! | `length`, `distance`, `length_recip`, `normalize`, `normalize_or_zero`, `project_onto` | zero vector | 0 |
//! | `inverse` of a matrix or an affine motion | determinant 0 | 0 |
//! | `Quat::normalize`, `Quat::length` | 0 | 0 |
//! | `Quat::angle_between` | equal or opposite | 0 |
//! | `Quat::from_rotation_arc` | opposite directions | 0 |
//! | `Quat::slerp` | ends that coincide or are opposite | as `Quat::lerp` |
//! | `Quat::from_scaled_axis`, `Quat::to_scaled_axis` | no rotation | the limit |
//! | `Quat::to_axis_angle` | no rotation | 0 |
//! | `normalize_or` | zero vector | all to the fallback |
//! | `atan2` | an infinite coordinate | 0 to both |
//! | any | the cotangent of the result is 0 | 0, even if the partial derivative is infinite or NaN |
//! | any of numbers | the partial derivative is 0 | 0 along a tangent that is infinite or NaN |
//!
//! The last row but one keeps the arm that [`select`](fn@crate::select) did not take from poisoning
//! the gradient of the one it took; the last one says the same of forward mode, as in `(-x.exp()).exp()`
//! where `x.exp()` overflows. Within a function whose own value is not finite it need not hold:
//! a gradient of that value may hold a NaN.

#![allow(
    clippy::type_complexity,
    clippy::too_many_arguments,
    reason = "a rule takes arguments and tangents, and returns a value and a closure"
)]

#[doc(hidden)]
pub mod arranged;
#[doc(hidden)]
pub mod attempt;
mod cast;
mod choose;
pub(crate) mod conversion;
mod deque;
mod dropping;
mod edit;
mod in_place;
mod integer;
pub(crate) mod linear;
pub(crate) mod operators;
mod outcome;
mod owned;
mod part;
#[doc(hidden)]
pub mod replace;
pub(crate) mod row;
pub(crate) mod scalar;
mod scale;
pub(crate) mod scale_vector;
mod sequence;
mod twin;
pub(crate) mod vector;

pub use cast::CastPullback;
#[doc(hidden)]
pub use cast::castable;
pub use choose::{no_diff, select, stop_gradient};
pub use conversion::{FromRules, IntoRules};
pub use deque::DequeRules;
#[doc(hidden)]
pub use dropping::drop;
pub use edit::VecRules;
#[doc(hidden)]
pub use edit::drained;
pub use integer::{IntegerRules, SignedRules};
#[doc(hidden)]
pub use operators::borrowed;
pub(crate) use operators::quotient_pullback_of_finite;
pub use operators::{
    AddAssignPullback, AddPullback, Arithmetic, AttributeOnOneForm, BorrowedAssignment,
    BorrowedOperator, DivAssignPullback, DivPullback, Kept, MulAssignPullback, MulPullback,
    NegPullback, Nothing, OfReferences, OfValues, Operands, RemAssignPullback, RemPullback,
    SubAssignPullback, SubPullback, operation,
};
pub use outcome::{CopiedRules, DerefRules, FlattenRules, OptionRules, ResultRules};
pub use owned::{OwnedRules, TryIntoRules};
pub use part::PartRules;
pub use scalar::{FloatRules, RealRules};
#[doc(hidden)]
pub use scale::scale;
pub(crate) use scale::{chain, is_infinite};
#[doc(hidden)]
pub use sequence::copied_within;
pub use sequence::{CloneRules, Elements, SequenceRules};
pub use vector::{Vector3Rules, VectorRules};

#[cfg(feature = "glam")]
pub use crate::glam::*;
/// Without glam there are no swizzles of its vectors.
#[cfg(not(feature = "glam"))]
#[doc(hidden)]
#[macro_export]
macro_rules! swizzle {
    ($($_:tt)*) => {};
}

/// Without glam its functions that make vectors are as any others.
#[cfg(not(feature = "glam"))]
#[doc(hidden)]
pub use crate::rt::{
    FunctionWithoutDerivative as dvec2, FunctionWithoutDerivative as dvec3,
    FunctionWithoutDerivative as dvec4, FunctionWithoutDerivative as vec2,
    FunctionWithoutDerivative as vec3, FunctionWithoutDerivative as vec4,
};
