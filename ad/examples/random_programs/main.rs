//! Writes random differentiable programs, for `ad/tests/random`.
//!
//! `cargo run -p ad --example random_programs -- SEED COUNT > ad/tests/random/programs.rs` writes
//! COUNT functions. Each is written twice, from one syntax tree: as a person would write it for
//! `f64`, with the attribute, and without it for any scalar, which is the oracle on dual numbers and
//! on a tape.

mod data;
mod effects;
mod expression;
mod function;
mod list;
mod random;
mod statement;

use std::fmt::Write;

use random::Random;
use statement::Writer;

fn main() {
    let mut arguments = std::env::args().skip(1).map(|a| a.parse::<u64>());
    let (Some(Ok(seed)), Some(Ok(count))) = (arguments.next(), arguments.next()) else {
        eprintln!("usage: random_programs SEED COUNT");
        std::process::exit(2);
    };

    let mut programs = String::new();
    let mut table = String::new();
    for index in 0..count {
        let mut writer = Writer::new(Random::new(seed.wrapping_mul(1_000_003) + index), index);
        let name = format!("program_{index}");
        writeln!(table, "    program!({name}, {name}_of),").expect("a string takes all");
        if writer.random.chance(10) {
            programs += &writer.by_a_macro(&name);
            continue;
        }
        writer.body();
        let (plain, generic) = writer.finish();
        write!(
            programs,
            "
#[differentiable]
fn {name}(x: f64, y: f64) -> f64 {{
{plain}}}

fn {name}_of<S: Real<Mask = bool>>(x: S, y: S) -> S {{
{generic}}}
"
        )
        .expect("a string takes all");
    }
    print!(
        "//! Random programs, written by `cargo run -p ad --example random_programs -- {seed} {count}`.

use ad::{{Real, differentiable}};

use crate::effects::{{
    Ball, Guard, Hard, Soft, curved, draw, left, of_parts, raised, raises, right, scale, two,
}};
use crate::program::{{Program, program}};
use crate::types::Shape::{{Disc, Point}};
use crate::types::{{
    List, Pair, Shape, bent, folded, mixed, root, roots, shape, shifted, summed,
}};

/// Every program.
pub const PROGRAMS: &[Program] = &[
{table}];
{programs}"
    );
}
