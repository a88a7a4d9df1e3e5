//! Silent errors known from other systems, and the traps of this one: where a source
//! transformation can give a wrong number without a word.

#![allow(
    clippy::assign_op_pattern,
    clippy::let_and_return,
    clippy::match_single_binding,
    clippy::needless_range_loop,
    clippy::needless_return,
    clippy::never_loop,
    clippy::single_match,
    clippy::useless_vec,
    reason = "these forms are what is tested"
)]

mod aliasing;
mod clones;
mod closures;
mod drops;
mod effects;
mod exclusive;
mod indices;
mod macro_rules;
mod name_spaces;
mod names;
mod neighbours;
mod numbers;
mod order;
mod recompute;
mod structure;
mod temporaries;
