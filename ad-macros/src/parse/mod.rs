//! The annotated item as syntax, and what it says of itself before a body is looked into.

pub mod borrowing;
pub mod callable;
pub mod conditional;
pub mod elision;
pub mod function;
pub mod groups;
pub mod item;
pub mod itself;
pub mod options;
pub mod recursion;
pub mod refused;
pub mod signature;
