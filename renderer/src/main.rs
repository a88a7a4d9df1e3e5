//! The command line of the renderer.

use std::process::ExitCode;

fn main() -> ExitCode {
    renderer::cli::main()
}
