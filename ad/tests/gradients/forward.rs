//! Forward mode, where the checks of gradients do not reach: singular points, the forms of parameters and
//! results, and what is built on it.

mod higher;
mod parameters;
mod singular;
