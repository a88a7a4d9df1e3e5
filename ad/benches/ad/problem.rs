//! What is measured of each function, and how.

use std::hint::black_box;

use ad::dual::{AT_ONCE, Directions};
use ad::tape::{Recording, Var};
use ad::{Dual, Real};

use crate::peers::Peers;
use crate::timing::medians;

const ROUNDS: usize = 31;
/// The shortest time that is measured, in seconds.
const SAMPLE: f64 = 5e-4;
/// The largest difference between two gradients, relative to the largest element.
const TOLERANCE: f64 = 1e-10;

/// A function of numbers to numbers, and its Jacobian in two ways. A Jacobian is a list of rows, one
/// for each output.
pub trait Problem {
    const NAME: &'static str;
    const OUTPUTS: usize;

    /// Where it is measured.
    fn point(&self) -> Vec<f64>;

    /// The function.
    fn value<S: Real<Mask = bool>>(&self, x: &[S], outputs: &mut [S]);

    /// The Jacobian that `#[differentiable]` writes.
    fn generated(&self, x: &[f64], jacobian: &mut [f64]);

    /// The derivatives of the outputs along a direction, by the forward mode that
    /// `#[differentiable]` writes.
    fn forward(&self, x: &[f64], direction: &[f64], tangents: &mut [f64]);

    /// The Jacobian by hand.
    fn by_hand(&self, x: &[f64], jacobian: &mut [f64]);

    /// What other crates do, where it is measured.
    fn peers(&self) -> Option<&dyn Peers> {
        None
    }
}

/// Checks the Jacobians against each other, measures, and prints a line of ratios to the primal.
pub fn run<P: Problem>(problem: &P) {
    let x = problem.point();
    let size = P::OUTPUTS * x.len();
    let (mut generated, mut by_hand) = (vec![0.0; size], vec![0.0; size]);
    problem.generated(&x, &mut generated);
    problem.by_hand(&x, &mut by_hand);
    let largest = by_hand.iter().fold(0.0, |largest: f64, g| largest.max(g.abs()));
    let compare = |what: &str, at: usize, got: f64, tolerance: f64| {
        let error = (got - by_hand[at]).abs() / largest;
        assert!(
            error <= tolerance,
            "{}: {what}, element {at}: {got} is not {}",
            P::NAME,
            by_hand[at]
        );
    };
    for (at, &got) in generated.iter().enumerate() {
        compare("generated", at, got, TOLERANCE);
    }
    let mut moving: Vec<Dual<f64>> = x.iter().map(|&x| Dual::constant(x)).collect();
    let mut duals = vec![Dual::constant(0.0); P::OUTPUTS];
    let (mut direction, mut tangents) = (vec![0.0; x.len()], vec![0.0; P::OUTPUTS]);
    // Some directions of many: the oracles go over the whole function for each.
    for i in (0..x.len()).step_by(x.len().div_ceil(20)) {
        moving[i].derivative = 1.0;
        problem.value(&moving, &mut duals);
        moving[i].derivative = 0.0;
        direction[i] = 1.0;
        problem.forward(&x, &direction, &mut tangents);
        direction[i] = 0.0;
        for (row, &tangent) in tangents.iter().enumerate() {
            compare("forward mode", row * x.len() + i, tangent, TOLERANCE);
        }
        for (row, dual) in duals.iter().enumerate() {
            let at = row * x.len() + i;
            compare("dual numbers", at, dual.derivative, TOLERANCE);
            let estimate = difference(problem, &x, i, row);
            compare("finite differences", at, estimate.value, 1e-6 + estimate.error / largest);
        }
    }

    let mut taped = vec![0.0; size];
    by_tape(problem, &x, &mut taped);
    for (at, &got) in taped.iter().enumerate() {
        compare("tape", at, got, TOLERANCE);
    }

    let unit = |i: usize| Directions(std::array::from_fn(|k| if i == k { 1.0 } else { 0.0 }));
    let in_several: Vec<Dual<f64, Directions<f64, AT_ONCE>>> =
        x.iter().enumerate().map(|(i, &x)| Dual::new(x, unit(i))).collect();
    let mut at_once = vec![Dual::constant(0.0); P::OUTPUTS];
    problem.value(&in_several, &mut at_once);
    for (row, dual) in at_once.iter().enumerate() {
        for (k, &derivative) in dual.derivative.0.iter().enumerate().take(x.len()) {
            let at = row * x.len() + k;
            compare("several dual numbers at once", at, derivative, TOLERANCE);
        }
    }

    let mut outputs = vec![0.0; P::OUTPUTS];
    let mut jacobians = [generated, by_hand];
    let [first, second] = &mut jacobians;
    moving[0].derivative = 1.0;
    direction[0] = 1.0;
    let times = medians(
        ROUNDS,
        SAMPLE,
        &mut [
            &mut || {
                problem.value(black_box(&x), &mut outputs);
                black_box(&outputs);
            },
            &mut || {
                problem.generated(black_box(&x), first);
                black_box(&first);
            },
            &mut || {
                problem.by_hand(black_box(&x), second);
                black_box(&second);
            },
            &mut || {
                by_tape(problem, black_box(&x), &mut taped);
                black_box(&taped);
            },
            &mut || {
                problem.value(black_box(&moving), &mut duals);
                black_box(&duals);
            },
            &mut || {
                problem.forward(black_box(&x), black_box(&direction), &mut tangents);
                black_box(&tangents);
            },
            &mut || {
                problem.value(black_box(&in_several), &mut at_once);
                black_box(&at_once);
            },
        ],
    );
    let [primal, generated, by_hand, tape, dual, forward, several] = times[..] else {
        unreachable!("seven cases")
    };
    let directions = x.len() as f64;
    println!(
        "{:<28} {:>8.2} us | generated {:>5.2}  by hand {:>5.2}  generated / by hand {:>4.2} | tape {:>6.2}  tape / generated {:>5.1} | one direction: forward {:>5.2}  dual numbers {:>5.2} | reverse is faster from {:>3.1} inputs on | all: forward {:>7.1}  dual numbers {:>7.1}, {AT_ONCE} at once {:>7.1}  finite differences {:>4}",
        P::NAME,
        primal * 1e6,
        generated / primal,
        by_hand / primal,
        generated / by_hand,
        tape / primal,
        tape / generated,
        forward / primal,
        dual / primal,
        generated / forward,
        directions * forward / primal,
        directions * dual / primal,
        (directions / AT_ONCE as f64).ceil() * several / primal,
        2 * x.len(),
    );
    if let Some(peers) = problem.peers() {
        run_peers(peers, &x, primal, &jacobians[1]);
    }
}

/// Checks and measures what other crates do, and prints the ratios to `primal` seconds.
fn run_peers(peers: &dyn Peers, x: &[f64], primal: f64, by_hand: &[f64]) {
    let tape = reverse::Tape::new();
    let gradient = peers.by_reverse(&tape, x);
    let largest = by_hand.iter().fold(0.0, |largest: f64, g| largest.max(g.abs()));
    for (got, expected) in gradient.iter().zip(by_hand) {
        assert!((got - expected).abs() <= TOLERANCE * largest, "{got} is not {expected}");
    }
    let slope = peers.by_num_dual(x);
    assert!((slope - by_hand[0]).abs() <= TOLERANCE * largest, "{slope} is not {}", by_hand[0]);
    let times = medians(
        ROUNDS,
        SAMPLE,
        &mut [
            &mut || {
                black_box(peers.by_reverse(&tape, black_box(x)));
            },
            &mut || {
                black_box(peers.by_num_dual(black_box(x)));
            },
        ],
    );
    println!(
        "{:<28} `reverse` {:.2}, `num-dual` {:.1}",
        "",
        times[0] / primal,
        x.len() as f64 * times[1] / primal
    );
}

/// The Jacobian by a tape: one recording, one reverse sweep for each row.
fn by_tape<P: Problem>(problem: &P, x: &[f64], jacobian: &mut [f64]) {
    let recording = Recording::start();
    let variables: Vec<_> = x.iter().map(|&x| recording.variable(x)).collect();
    let mut outputs = vec![Var::constant(0.0); P::OUTPUTS];
    problem.value(&variables, &mut outputs);
    for (row, &output) in jacobian.chunks_exact_mut(x.len()).zip(&outputs) {
        let cotangents = recording.cotangents(output);
        for (derivative, &variable) in row.iter_mut().zip(&variables) {
            *derivative = cotangents.by(variable);
        }
    }
}

/// The derivative of an output by an input, from values alone.
fn difference<P: Problem>(
    problem: &P,
    x: &[f64],
    input: usize,
    output: usize,
) -> ad::check::Estimate {
    let mut point = x.to_vec();
    let mut outputs = vec![0.0; P::OUTPUTS];
    ad::check::derivative(
        |value| {
            point[input] = value;
            problem.value(&point, &mut outputs);
            outputs[output]
        },
        x[input],
        1e-3,
    )
}
