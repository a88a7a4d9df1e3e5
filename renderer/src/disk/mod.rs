//! Whole files: read with a clear error, written such that they are never seen half-written.

mod read;
mod write;

pub(crate) use read::{read, read_text};
pub(crate) use write::{check_writable, create_folder, write_atomically, write_together};
