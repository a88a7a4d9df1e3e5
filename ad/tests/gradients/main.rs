//! Gradients written at compile time against two oracles that share no code with them: finite
//! differences with step control, and dual numbers.

mod forward;
#[cfg(feature = "lanes")]
mod lanes;
mod oracle;
mod programs;
mod rules;
mod second_order;
mod singular;
mod tape;
mod traps;
