//! Silent errors known from other systems, and the traps of this one.
