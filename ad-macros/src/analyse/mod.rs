//! What both modes need to know of a lowered function, and do not change: facts about its variables, where
//! values are used last, which pullbacks may be plain.

pub mod cheap;
pub mod cut;
pub mod facts;
pub mod kept;
pub mod numbers;
pub mod products;
pub mod uses;
