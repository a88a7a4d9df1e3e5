//! Each construct of the language, on both sides of each branch.

mod data;
mod exits;
mod flow;
mod statements;
