//! The gradient of one image's loss on a tape that is recorded at run time, and by generated code: the
//! same generic function, the same numbers, what both cost.
//!
//! `cargo run --release --example tape`
//!
//! The loss of an image of 16 x 16 pixels by 43 parameters: camera, triangle, material, light.

mod experiment;

use std::alloc::System;
use std::hint::black_box;
use std::time::Instant;

use ad::tape;
use experiment::{INPUTS, image_loss};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// The width and the height of the image.
const SIZE: usize = 16;
const REPETITIONS: usize = 200;

fn main() {
    let value = cost(|| image_loss(&INPUTS, SIZE));
    let generated = cost(|| image_loss::value_and_grad::<f64>(&INPUTS, SIZE));
    let taped = cost(|| tape::gradient(|x| image_loss(x, SIZE), &INPUTS));

    println!(
        "{:>22}  {:>12}  {:>12}  {:>16}",
        "", "microseconds", "x the value", "allocated bytes"
    );
    let row = |name: &str, seconds: f64, bytes: usize| {
        println!(
            "{name:>22}  {:>12.1}  {:>12.1}  {bytes:>16}",
            1e6 * seconds,
            seconds / value.seconds
        );
    };
    row("value", value.seconds, value.bytes);
    row("gradient, generated", generated.seconds, generated.bytes);
    row("gradient, on a tape", taped.seconds, taped.bytes);

    let (by_code, by_tape) = (generated.result.1.0, taped.result.1);
    let scale = by_tape.iter().fold(0.0_f64, |scale, d| scale.max(d.abs()));
    let pairs = by_code.iter().zip(&by_tape);
    let error = pairs.fold(0.0_f64, |error, (a, b)| error.max((a - b).abs() / scale));
    println!("the two gradients differ by {error:.1e} of their largest number");
}

/// What a computation comes to, and what it costs.
struct Cost<R> {
    result: R,
    /// Of the fastest repetition.
    seconds: f64,
    /// Of the first one: a tape keeps its memory.
    bytes: usize,
}

fn cost<R>(compute: impl Fn() -> R) -> Cost<R> {
    let region = Region::new(ALLOCATOR);
    let result = compute();
    let bytes = region.change().bytes_allocated;
    let mut seconds = f64::INFINITY;
    for _ in 0..REPETITIONS {
        let clock = Instant::now();
        black_box(compute());
        seconds = seconds.min(clock.elapsed().as_secs_f64());
    }
    Cost { result, seconds, bytes }
}
