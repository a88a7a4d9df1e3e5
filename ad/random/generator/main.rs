//! Writes random differentiable programs, for the tests of this package.
//!
//! Each is written twice, from one syntax tree: as a person would write it for `f64`, with the
//! attribute, and without it for any scalar, which is the oracle on dual numbers and on a tape. How
//! many there are and which, `RANDOM_COUNT` and `RANDOM_SEED` say: `RANDOM_COUNT=1000 RANDOM_SEED=9
//! cargo test -p ad-random`.

mod data;
mod effects;
mod expression;
mod function;
mod list;
mod random;
mod statement;
mod text;
mod writer;

use std::fmt::Write;

use random::Random;
use writer::Writer;

/// How many programs a run of the tests takes, and from which seed.
const COUNT: u64 = 60;
const SEED: u64 = 8;

fn main() {
    let (count, seed) = (asked("RANDOM_COUNT", COUNT), asked("RANDOM_SEED", SEED));
    let directory = std::env::var("OUT_DIR").expect("cargo sets it");
    let path = std::path::Path::new(&directory).join("programs.rs");
    std::fs::write(path, programs(seed, count)).expect("cargo's own directory can be written");
}

/// A number that the environment gives.
fn asked(name: &str, otherwise: u64) -> u64 {
    println!("cargo::rerun-if-env-changed={name}");
    match std::env::var(name) {
        Ok(text) => text.parse().unwrap_or_else(|_| panic!("{name} is no number: {text}")),
        Err(_) => otherwise,
    }
}

fn programs(seed: u64, count: u64) -> String {
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
    format!(
        "use ad::{{Real, differentiable}};

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
    )
}
