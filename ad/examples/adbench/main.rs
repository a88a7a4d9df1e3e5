//! ADBench's objectives as ordinary Rust, with generated gradients, against its reference
//! derivatives.
//!
//! `cargo run --release -p ad --example adbench -- FOLDER` reads the published inputs from the
//! folders `gmm`, `ba`, `lstm` and `hand` in FOLDER: each `NAME.txt` beside `NAME.manual.json`, and
//! the hand model from `hand/model`.

#![allow(clippy::needless_range_loop, reason = "formulas with indices, as people write them")]

mod bundle;
mod gmm;
mod hand;
mod lstm;
mod read;

use std::path::Path;

/// The derivatives of an objective at a published input, and the published ones.
struct Comparison {
    value: f64,
    derivatives: Vec<f64>,
    expected_value: f64,
    expected: Vec<f64>,
}

/// Reads an input and differentiates its objective.
type Compare = fn(&Path) -> Comparison;

fn main() {
    let Some(folder) = std::env::args().nth(1) else {
        eprintln!("name the folder of the inputs");
        std::process::exit(2);
    };
    let problems: [(&str, Compare); 4] = [
        ("gmm", gmm::compare),
        ("ba", bundle::compare),
        ("lstm", lstm::compare),
        ("hand", hand::compare),
    ];
    println!("input | derivatives | value off by | worst derivative off by");
    for (name, compare) in problems {
        for input in read::inputs(&Path::new(&folder).join(name)) {
            let Comparison { value, derivatives, expected_value, expected } = compare(&input);
            assert_eq!(derivatives.len(), expected.len(), "{}", input.display());
            // Small derivatives against the largest: the references were summed in another order.
            let size = expected.iter().fold(0.0, |size: f64, e| size.max(e.abs()));
            let off = |(a, b): (&f64, &f64)| (a - b).abs() / b.abs().max(1e-6 * size);
            let worst = derivatives.iter().zip(&expected).map(off).fold(0.0, f64::max);
            let value_off = (value - expected_value).abs() / expected_value.abs();
            println!(
                "{} | {} | {value_off:.1e} | {worst:.1e}",
                input.file_stem().unwrap_or_default().to_string_lossy(),
                derivatives.len(),
            );
        }
    }
}
