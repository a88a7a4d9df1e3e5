//! Iterators: each chain of adapters is a loop.

pub mod array;
pub mod attempts;
pub mod chain;
pub mod consume;
pub mod item;
pub mod several;
pub mod source;
pub mod stage;
pub mod steps;
