//! The cost of the attribute at compile time.
//!
//! `cargo bench -p ad --bench compile [-- OPERATIONS ..]` writes a package with a function of so many
//! operations (100 and 1,000 if none are given), builds it optimised with and without the attribute,
//! and prints the seconds that the function takes beyond an empty package, and their ratio. With the attribute that is the function
//! and its gradient. The best of several builds.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

const BUILDS: usize = 3;

fn main() {
    let folder = std::env::temp_dir().join(format!("ad-compile-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("src")).expect("a folder for the package");
    let manifest = format!(
        "[package]\nname = \"subject\"\nedition = \"2024\"\n\n[dependencies]\nad = {{ path = {:?} }}\n\n[workspace]\n",
        env!("CARGO_MANIFEST_DIR")
    );
    std::fs::write(folder.join("Cargo.toml"), manifest).expect("a manifest");

    let empty = seconds(&folder, "");
    println!("an empty package: {empty:.2} s");
    let sizes = std::env::args().skip(1).filter_map(|argument| argument.parse().ok());
    let mut sizes: Vec<usize> = sizes.collect();
    if sizes.is_empty() {
        sizes = vec![100, 1000];
    }
    for operations in sizes {
        let function = function(operations);
        let plain = seconds(&folder, &function) - empty;
        let attribute = "#[ad::differentiable]\n";
        let gradient = "pub fn gradient(x: [f64; 8]) -> [f64; 8] { f::grad(x) }\n";
        let differentiable = seconds(&folder, &format!("{attribute}{function}{gradient}")) - empty;
        println!(
            "{operations:>5} operations: plain {plain:.2} s, differentiable {differentiable:.2} s, ratio {:.1}",
            differentiable / plain
        );
    }
    std::fs::remove_dir_all(&folder).expect("the package is ours");
}

/// A function without loops, of so many operations.
fn function(operations: usize) -> String {
    let mut source = String::from("pub fn f(x: [f64; 8]) -> f64 {\n    let v0 = x[0] * x[1];\n");
    for i in 1..operations {
        let (last, other, element) = (i - 1, i * 7 / 11, i % 8);
        let value = match i % 5 {
            0 => format!("v{last} * x[{element}]"),
            1 => format!("v{last} + v{other}"),
            2 => format!("(v{last} * 0.5).sin()"),
            3 => format!("v{last} - x[{element}]"),
            _ => format!("v{last} / (v{other} * v{other} + 2.0)"),
        };
        writeln!(source, "    let v{i} = {value};").expect("a string takes all");
    }
    writeln!(source, "    v{}\n}}", operations - 1).expect("a string takes all");
    source
}

/// The time that cargo takes to build the package with this source, its dependencies being built.
fn seconds(folder: &Path, source: &str) -> f64 {
    let builds = (0..=BUILDS).map(|build| {
        // Each build differs, or there would be nothing to build; the first one is for the
        // dependencies.
        let source = format!("pub const BUILD: usize = {build};\n{source}");
        std::fs::write(folder.join("src/lib.rs"), source).expect("a source file");
        let start = Instant::now();
        let status = Command::new(env!("CARGO"))
            .args(["build", "--release", "--quiet", "--offline"])
            .current_dir(folder)
            .env("CARGO_TARGET_DIR", folder.join("target"))
            .status()
            .expect("cargo runs");
        assert!(status.success(), "the package does not build");
        start.elapsed().as_secs_f64()
    });
    builds.skip(1).fold(f64::INFINITY, f64::min)
}
