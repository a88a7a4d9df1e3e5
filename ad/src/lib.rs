//! Exact gradients of ordinary Rust functions, written at compile time.
//!
//! ```
//! use ad::differentiable;
//!
//! #[differentiable]
//! fn spring(stiffness: f64, stretch: f64) -> f64 {
//!     0.5 * stiffness * stretch * stretch
//! }
//!
//! let (energy, (by_stiffness, by_stretch)) = spring::value_and_grad(3.0, 0.5);
//! assert_eq!((energy, by_stiffness, by_stretch), (0.375, 0.125, 1.5));
//! ```
//!
//! The function stays as it is. Beside it stands a type of the same name with four functions
//! (types and functions have separate name spaces, and `use` imports both):
//!
//! | | |
//! |---|---|
//! | `f::vjp(x, y)` | the value, and the *pullback*: a closure from the cotangent of the value to those of the parameters |
//! | `f::value_and_grad(x, y)` | the value and the gradient, for a scalar result |
//! | `f::grad(x, y)` | the gradient alone |
//! | `f::jvp(x, y, x_dot, y_dot)` | the value, and its derivative along a direction ([forward mode](#forward-mode)) |
//!
//! With one parameter the gradient is bare, with several it is a tuple in their order. In an `impl`
//! block under `#[differentiable]` each method `m` gets the siblings `m_vjp`, `m_value_and_grad`,
//! `m_grad` and `m_jvp`; the receiver is the first parameter.
#![doc = include_str!("guide/language.md")]
#![cfg_attr(feature = "glam", doc = include_str!("guide/glam.md"))]
#![doc = include_str!("guide/trusted.md")]
#![doc = include_str!("guide/methods.md")]
#![doc = include_str!("guide/operators.md")]
#![doc = include_str!("guide/functions.md")]
#![doc = include_str!("guide/rules.md")]
#![doc = include_str!("guide/options.md")]
#![doc = include_str!("guide/in_place.md")]
#![doc = include_str!("guide/generated.md")]
#![doc = include_str!("guide/forward.md")]
#![doc = include_str!("guide/second_order.md")]
#![doc = include_str!("guide/memory.md")]
#![doc = include_str!("guide/scalars.md")]
#![doc = include_str!("guide/comparison.md")]
#![doc = include_str!("guide/checking.md")]
#![doc = include_str!("guide/coming_from.md")]

extern crate self as ad;

mod assigning;
mod boxed;
pub mod check;
mod containers;
mod deque;
mod differentiable;
pub mod dual;
pub mod fields;
pub mod function;
#[cfg(feature = "glam")]
mod glam;
mod jacobian;
#[cfg(feature = "lanes")]
pub mod lanes;
mod real;
#[doc(hidden)]
pub mod rt;
pub mod rules;
mod second_order;
pub mod tape;
pub mod vector;

pub use ad_macros::{Differentiable, Fields, differentiable};
pub use boxed::Boxed;
pub use differentiable::{Additive, Differentiable, NoDerivative, NoTangent, Shape, Tangent};
pub use dual::Dual;
pub use fields::{Field, Fields};
pub use function::{DifferentiableFn, ForwardFn};
pub use jacobian::{Pushforward, jacobian, jacobian_forward, jacobian_reverse};
pub use real::{Mask, Real, Scalar, Select};
pub use rules::{no_diff, select, stop_gradient};
pub use second_order::{hessian, hvp};

/// The first gradient of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The vector of three scalars `S`.
pub type Vec3<S> = <S as Real>::Vec3;
