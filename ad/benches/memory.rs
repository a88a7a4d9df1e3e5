//! What a gradient keeps for the way back, and what `checkpoint` saves of it.
//!
//! `cargo bench -p ad --bench memory` prints, for the predator-prey equations by 10,000 and
//! 1,000,000 steps of the classical Runge-Kutta method, how many times as long as the function its
//! value and gradient take, and the bytes that the pullback holds on the heap: with what the
//! iterations need stored, and with the loop run again in segments. (The reverse sweep of the latter
//! needs, besides, what one segment stores.)

use std::alloc::System;
use std::hint::black_box;

use ad::differentiable;
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[path = "ad/timing.rs"]
mod timing;

#[global_allocator]
static GLOBAL: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

const ROUNDS: usize = 11;
/// The shortest time that is measured, in seconds.
const SAMPLE: f64 = 5e-3;

/// How fast prey and predators grow.
#[differentiable]
fn slope(p: [f64; 4], x: f64, y: f64) -> (f64, f64) {
    (p[0] * x - p[1] * x * y, p[2] * x * y - p[3] * y)
}

macro_rules! simulate {
    ($name:ident, $(#[$attribute:meta])*) => {
        /// The prey after so many steps of 0.01.
        #[differentiable]
        fn $name(p: [f64; 4], start: [f64; 2], steps: usize) -> f64 {
            let [mut x, mut y] = start;
            let h = 0.01;
            $(#[$attribute])*
            for _ in 0..steps {
                let (k1, l1) = slope(p, x, y);
                let (k2, l2) = slope(p, x + 0.5 * h * k1, y + 0.5 * h * l1);
                let (k3, l3) = slope(p, x + 0.5 * h * k2, y + 0.5 * h * l2);
                let (k4, l4) = slope(p, x + h * k3, y + h * l3);
                x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
                y += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
            }
            x
        }
    };
}

simulate!(stored,);
simulate!(checkpointed, #[differentiable(checkpoint)]);

/// The bytes that `f`, which gives nothing back, takes from the heap.
fn bytes<R>(f: impl FnOnce() -> R) -> usize {
    let region = Region::new(GLOBAL);
    black_box(f());
    region.change().bytes_allocated
}

fn main() {
    let (p, start) = ([1.1, 0.4, 0.1, 0.4], [10.0, 5.0]);
    for steps in [10_000, 1_000_000] {
        let [with, without] = [checkpointed::grad(p, start, steps), stored::grad(p, start, steps)];
        assert_eq!(with, without, "both are the same computation");
        let times = timing::medians(
            ROUNDS,
            SAMPLE,
            &mut [
                &mut || {
                    black_box(stored(black_box(p), start, steps));
                },
                &mut || {
                    black_box(stored::value_and_grad(black_box(p), start, steps));
                },
                &mut || {
                    black_box(checkpointed::value_and_grad(black_box(p), start, steps));
                },
            ],
        );
        let held =
            [bytes(|| stored::vjp(p, start, steps)), bytes(|| checkpointed::vjp(p, start, steps))];
        println!(
            "{steps:>9} steps: stored {:.2} times the value, {} kB | checkpoints {:.2} times, {} kB",
            times[1] / times[0],
            held[0] / 1000,
            times[2] / times[0],
            held[1] / 1000,
        );
    }
}
