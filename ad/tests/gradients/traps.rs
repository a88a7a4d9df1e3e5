//! Silent errors known from other systems, and the traps of this one: where a source
//! transformation can give a wrong number without a word.

mod aliasing;
mod names;
mod order;
mod structure;
