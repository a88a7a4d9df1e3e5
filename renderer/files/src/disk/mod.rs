//! Whole files: read with a clear error, written such that they are never seen half-written.

mod read;
mod write;

pub use read::{read, read_text};
pub use write::{check_writable, create_folder, write_atomically, write_together};
