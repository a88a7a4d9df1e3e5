//! From the user's syntax to plainer syntax, before anything is lowered.

pub mod chains;
pub mod deferred;
pub mod desugar;
pub mod exits;
pub mod fields;
pub mod leading;
pub mod told;
pub mod variants;
