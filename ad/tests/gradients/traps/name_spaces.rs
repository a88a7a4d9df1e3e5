//! One name for several functions: those of modules, of traits, of types, of a function's own items.

use ad::{Differentiable, Real, differentiable, no_diff, stop_gradient};

use crate::oracle::check;

mod plain {
    pub fn power(x: f64) -> f64 {
        x * x * x
    }

    pub fn scaled<S>(x: S, _: &[S]) -> S {
        x
    }
}

mod derived {
    use ad::{Real, differentiable};

    #[differentiable]
    pub fn power(x: f64) -> f64 {
        x * x
    }

    #[differentiable]
    pub fn scaled<S: Real>(x: S, by: &[S]) -> S {
        x * by[0]
    }
}

mod of_derived {
    use ad::differentiable;

    use super::derived::*;

    #[differentiable]
    pub fn found(x: f64, y: f64) -> f64 {
        power(x) * scaled(y, &[x]) * scaled::<f64>(x, &[y, x])
    }
}

#[differentiable]
fn imports_itself(x: f64, y: f64) -> f64 {
    use derived::power;
    use derived::{self as d, scaled as times};
    power(x) * times(y, &[x]) + d::power(y)
}

#[differentiable]
fn power(x: f64, y: f64) -> f64 {
    x * y
}

#[differentiable]
fn declares_itself(x: f64, y: f64) -> f64 {
    #[differentiable]
    fn power(x: f64) -> f64 {
        x.sin()
    }

    fn half() -> f64 {
        0.5
    }

    power(x) * y * half() + no_diff(|| half() + 1.0)
}

#[differentiable]
fn beside_it(x: f64, y: f64) -> f64 {
    power(x, y) * self::power(y, y) + derived::power(x)
}

#[test]
fn functions_have_their_own_derivatives() {
    use of_derived::found;

    check!(found(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(imports_itself(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(declares_itself(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(beside_it(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// Functions without the attribute that hide those with it, but not their derivatives.
mod hiding {
    #[allow(unused_imports)]
    use super::derived::*;
    use super::plain::{power, scaled};
    use ad::differentiable;

    #[differentiable]
    pub fn of_numbers(x: f64) -> f64 {
        power(x)
    }

    #[differentiable]
    pub fn of_scalars(x: f64) -> f64 {
        scaled(x, &[x])
    }

    #[differentiable]
    fn twice<F: Fn(f64) -> f64>(f: F, x: f64) -> f64 {
        f(f(x))
    }

    #[differentiable]
    pub fn by_name(x: f64) -> f64 {
        twice(power, x)
    }
}

#[test]
#[should_panic = "plain::power` has no derivative"]
fn a_hidden_derivative_is_not_taken() {
    hiding::of_numbers::grad(1.3);
}

#[test]
#[should_panic = "has no derivative"]
fn a_hidden_derivative_is_not_taken_of_a_generic_function() {
    hiding::of_scalars::grad(1.3);
}

#[test]
#[should_panic = "plain::power` has no derivative"]
fn a_hidden_derivative_is_not_taken_in_forward_mode() {
    hiding::of_numbers::jvp(1.3, 1.0);
}

#[test]
#[should_panic = "plain::power` has no derivative"]
fn a_hidden_derivative_is_not_passed() {
    hiding::by_name::grad(1.3);
}

#[derive(Clone, Copy, Differentiable)]
struct Spring {
    stiffness: f64,
}

#[differentiable]
trait Linear {
    fn energy(&self, x: f64) -> f64;
    fn of(x: f64) -> Self;
}

#[differentiable]
trait Quadratic {
    fn energy(&self, x: f64) -> f64;
}

#[differentiable]
impl Linear for Spring {
    fn energy(&self, x: f64) -> f64 {
        self.stiffness * x
    }

    fn of(x: f64) -> Self {
        Self { stiffness: x * x }
    }
}

#[differentiable]
impl Quadratic for Spring {
    fn energy(&self, x: f64) -> f64 {
        self.stiffness * x * x
    }
}

#[differentiable]
impl Spring {
    fn energy(&self, x: f64) -> f64 {
        self.stiffness * self.stiffness * x
    }
}

#[differentiable]
fn of_traits(x: f64, y: f64) -> f64 {
    let spring = <Spring as Linear>::of(x);
    <Spring as Linear>::energy(&spring, y)
        + <Spring as self::Quadratic>::energy(&spring, y) * spring.energy(y)
        + Spring::energy(&spring, x) * <Spring>::energy(&spring, y)
        + Quadratic::energy(&spring, y)
}

#[differentiable]
fn of_a_type_parameter<T: Linear + Quadratic + Differentiable>(x: f64, y: f64) -> f64 {
    let spring = <T as Linear>::of(x);
    <T as Linear>::energy(&spring, y) * Quadratic::energy(&spring, y)
}

#[differentiable]
fn of_parameters(x: f64, y: f64) -> f64 {
    of_a_type_parameter::<Spring>(x, y)
}

#[differentiable]
fn of_other_crates(x: f64, y: f64) -> f64 {
    <f64 as Real>::sin(x) * <f64 as From<f32>>::from(0.5) + f64::from(3_u8) * y
}

#[test]
fn traits_have_their_own_derivatives() {
    check!(of_traits(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(of_parameters(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(of_other_crates(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// Macros of the user's that are called like those of the standard library.
mod own_macros {
    use std::cell::Cell;

    use ad::differentiable;

    thread_local! {
        pub static ASSERTED: Cell<usize> = const { Cell::new(0) };
    }

    macro_rules! assert {
        ($condition:expr, $times:expr) => {
            ASSERTED.set(ASSERTED.get() + usize::from($condition) * $times)
        };
    }

    macro_rules! matches {
        ($value:expr, $pattern:pat) => {
            !std::matches!($value, $pattern)
        };
    }

    #[differentiable]
    pub fn calls_them(x: f64, y: f64) -> f64 {
        assert!(x > 0.0, 3);
        if matches!(Some(x > y), Some(true)) { x * y } else { x + y }
    }
}

#[test]
fn macros_are_the_users() {
    use own_macros::{ASSERTED, calls_them};

    ASSERTED.set(0);
    calls_them::grad(1.0, 2.0);
    assert_eq!(ASSERTED.get(), 3);
    check!(calls_them(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// What merely ends in a name of `ad`'s.
mod own_functions {
    use ad::differentiable;

    #[differentiable]
    pub fn stop_gradient(x: f64, times: f64) -> f64 {
        x * times
    }

    #[differentiable]
    pub fn no_diff<F: Fn(f64) -> f64>(f: F) -> f64 {
        f(2.0)
    }

    #[differentiable]
    pub fn calls_them(x: f64, y: f64) -> f64 {
        stop_gradient(x, y) * no_diff(|t| t * x)
    }
}

#[differentiable]
fn calls_those_of_ad(x: f64, y: f64) -> f64 {
    let k = stop_gradient(4.0 * y * y) as usize;
    stop_gradient(3.0) * x * ad::stop_gradient(2.0) * y + (k / 1000) as f64
}

#[test]
fn functions_are_the_users() {
    use own_functions::calls_them;

    check!(calls_them(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(calls_those_of_ad(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}
