//! A program in its forms.

use ad::Dual;
use ad::tape::Var;

/// A function of two numbers.
pub struct Program {
    pub name: &'static str,
    pub plain: fn(f64, f64) -> f64,
    pub gradient: fn(f64, f64) -> (f64, (f64, f64)),
    pub forward: fn(f64, f64, f64, f64) -> (f64, f64),
    /// The oracles: the same function, written without the attribute.
    pub dual: fn(Dual<f64>, Dual<f64>) -> Dual<f64>,
    pub taped: fn(Var, Var) -> Var,
}

macro_rules! program {
    ($name:ident, $generic:ident) => {
        Program {
            name: stringify!($name),
            plain: $name,
            gradient: $name::value_and_grad,
            forward: $name::jvp,
            dual: $generic,
            taped: $generic,
        }
    };
}

pub(crate) use program;
