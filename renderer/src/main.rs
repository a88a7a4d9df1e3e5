//! The command line of the renderer.

use std::alloc::System;
use std::process::ExitCode;

use peakmem_alloc::{INSTRUMENTED_SYSTEM, PeakMemAlloc};

/// Counts what is on the heap, for `renderer tradeoff`: two additions for each allocation, of which
/// the loops over pixels make none.
#[global_allocator]
static ALLOCATOR: &PeakMemAlloc<System> = &INSTRUMENTED_SYSTEM;

fn main() -> ExitCode {
    renderer::cli::main()
}
