//! Random programs against dual numbers, a tape and finite differences.
//!
//! The build script of this package writes [`programs`].

#![allow(unused, non_upper_case_globals, clippy::all, reason = "nobody wrote this")]

mod effects;
mod program;
mod programs {
    include!(concat!(env!("OUT_DIR"), "/programs.rs"));
}
mod types;

use ad::tape::Var;
use ad::{Dual, tape};
use program::Program;

/// No multiples of the programs' constants: at a kink central differences take the middle.
const POINTS: [(f64, f64); 4] =
    [(0.7013, -1.3037), (-0.4491, 0.8523), (1.9071, 0.3517), (-1.2039, -0.6067)];

/// The largest difference to dual numbers and to the tape, relative to the gradient.
const TOLERANCE: f64 = 1e-9;

fn anew<R>(run: impl FnOnce() -> R) -> R {
    effects::reset();
    run()
}

#[test]
fn gradients_are_those_of_the_oracles() {
    let (mut smooth, mut checked) = (0, 0);
    for program in programs::PROGRAMS {
        for (x, y) in POINTS {
            let Program { name, plain, gradient, forward, dual, taped } = program;
            // Each run draws the same numbers.
            let plain = |x, y| anew(|| plain(x, y));
            let gradient = |x, y| anew(|| gradient(x, y));
            let forward = |x, y, along_x, along_y| anew(|| forward(x, y, along_x, along_y));
            let dual = |x, y| anew(|| dual(x, y));
            let taped = |x, y| anew(|| taped(x, y));
            let (value, (by_x, by_y)) = gradient(x, y);
            assert_eq!(value.to_bits(), plain(x, y).to_bits(), "{name} at ({x}, {y})");
            if !value.is_finite() {
                continue;
            }
            checked += 1;
            let size = by_x.abs().max(by_y.abs()).max(1.0);
            let check = |oracle: &str, got: f64, expected: f64, tolerance: f64| {
                let error = (got - expected).abs() / size;
                assert!(error <= tolerance, "{name} at ({x}, {y}): {got}, {oracle}: {expected}");
            };

            let along_x = dual(Dual::new(x, 1.0), Dual::constant(y));
            let along_y = dual(Dual::constant(x), Dual::new(y, 1.0));
            assert_eq!(along_x.value.to_bits(), value.to_bits(), "{name} at ({x}, {y})");
            check("dual numbers", by_x, along_x.derivative, TOLERANCE);
            check("dual numbers", by_y, along_y.derivative, TOLERANCE);
            let (_, on_tape) = tape::gradient(|v| taped(v[0], v[1]), &[x, y]);
            check("tape", by_x, on_tape[0], TOLERANCE);
            check("tape", by_y, on_tape[1], TOLERANCE);

            for (along, expected) in [((1.0, 0.0), by_x), ((0.0, 1.0), by_y)] {
                let (pushed, slope) = forward(x, y, along.0, along.1);
                assert_eq!(pushed.to_bits(), value.to_bits(), "{name} at ({x}, {y})");
                check("reverse mode", slope, expected, TOLERANCE);
            }

            // Between two steps the program may take another path.
            for (got, estimate) in [
                (by_x, ad::check::derivative(|x| plain(x, y), x, 1e-5)),
                (by_y, ad::check::derivative(|y| plain(x, y), y, 1e-5)),
            ] {
                if estimate.error / size < 1e-5 {
                    smooth += 1;
                    check("finite differences", got, estimate.value, 1e-4);
                }
            }
        }
    }
    // Most programs are smooth at most points.
    assert!(2 * checked > programs::PROGRAMS.len() * POINTS.len());
    assert!(smooth > checked, "finite differences checked {smooth} of {} slopes", 2 * checked);
}
