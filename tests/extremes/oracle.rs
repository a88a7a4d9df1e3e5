//! Kernels against extended precision.
//!
//! Values are compared with those of the same kernel in [`Extended`] precision, which leaves rounding
//! as the only difference. Gradients are compared with finite differences of these values: 12 digits
//! and more, from code that has no part in the adjoint.
//!
//! Errors are in units of the machine epsilon of the scalar: what a case is bounded by is the same for
//! single and for double precision. They are relative to the largest coordinate of the vector that
//! they are in; those of gradients at least to a tenth of what changes the result by itself over the
//! length that the case states, because some gradients are zero but for rounding.

use std::fmt;

use ad::lanes::{Lanes, f32x16, f64x8};
use ad::{Real, Scalar};

use crate::extended::Extended;
use crate::kernels::Kernel;

/// A kernel at one point.
pub struct Case<'a> {
    /// What is extreme.
    pub name: &'a str,
    /// What the kernel takes; every number has to be one of single precision.
    pub x: &'a [f64],
    /// For each of the kernel's inputs a length over which the results change.
    pub lengths: &'a [f64],
    /// The largest error of a value, in units of epsilon.
    pub value: f64,
    /// The largest error of a gradient, in units of epsilon.
    pub gradient: f64,
}

/// The largest errors, in units of epsilon.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    value: f64,
    gradient: f64,
}

impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.1e} | {:.1e}", self.value, self.gradient)
    }
}

/// Checks a kernel in every arithmetic that the renderer has, and prints a row of the table of
/// errors.
#[track_caller]
pub fn check<K: Kernel>(case: &Case<'_>) {
    for &x in case.x {
        assert_eq!(f64::from(x as f32), x, "{}: not of single precision", case.name);
    }
    let expected = Expected::new::<K>(case);
    let single = expected.errors::<K, f32>(case);
    let lanes = expected.errors::<K, f32x16>(case);
    let double = expected.errors::<K, f64>(case);
    let double_lanes = expected.errors::<K, f64x8>(case);
    let (value, gradient) = (case.value, case.gradient);
    println!(
        "| {} | {single} | {lanes} | {double} | {double_lanes} | {value:.0e} | {gradient:.0e} |",
        case.name
    );
    for (errors, scalar) in
        [(single, "f32"), (lanes, "f32x16"), (double, "f64"), (double_lanes, "f64x8")]
    {
        let name = case.name;
        assert!(errors.value <= value, "{name} in {scalar}: values are off by {:e}", errors.value);
        assert!(
            errors.gradient <= gradient,
            "{name} in {scalar}: gradients are off by {:e}",
            errors.gradient
        );
    }
}

/// What is right.
struct Expected {
    values: Vec<f64>,
    /// By result, then by input.
    gradients: Vec<Vec<f64>>,
}

impl Expected {
    fn new<K: Kernel>(case: &Case<'_>) -> Self {
        let value = |x: &[Extended]| K::value::<Extended>(x);
        let mut point: Vec<Extended> = case.x.iter().copied().map(Extended::new).collect();
        let values = value(&point);
        let mut gradients = vec![Vec::new(); values.len()];
        let steps = K::INPUTS.iter().zip(case.lengths);
        let steps: Vec<f64> = steps.flat_map(|(&(_, size), &l)| vec![1e-7 * l; size]).collect();
        assert_eq!((steps.len(), point.len()), (case.x.len(), case.x.len()), "{}", case.name);
        for (i, step) in steps.into_iter().enumerate() {
            let at = point[i];
            let mut difference = |step: Extended| -> Vec<Extended> {
                point[i] = at + step;
                let above = value(&point);
                point[i] = at - step;
                let below = value(&point);
                point[i] = at;
                let twice = step + step;
                above.into_iter().zip(below).map(|(a, b)| (a - b) / twice).collect()
            };
            let coarse = difference(Extended::new(step));
            let fine = difference(Extended::new(0.5 * step));
            for ((gradient, coarse), fine) in gradients.iter_mut().zip(coarse).zip(fine) {
                // Richardson's extrapolation.
                let extrapolated = fine + (fine - coarse) / Extended::new(3.0);
                gradient.push(extrapolated.to_f64());
            }
        }
        Self { values: values.iter().map(|value| value.to_f64()).collect(), gradients }
    }

    fn errors<K: Kernel, L: Lanes>(&self, case: &Case<'_>) -> Errors {
        let x: Vec<L> = case.x.iter().map(|&x| L::from_f64(x)).collect();
        let first = |x: &L| x.lanes().as_ref()[0].to_f64();
        let epsilon = L::Element::EPSILON.to_f64();
        let values: Vec<f64> = K::value::<L>(&x).iter().map(first).collect();
        let value = worst(&values, &self.values, K::OUTPUTS.iter().copied(), 0.0) / epsilon;

        let mut gradient = 0.0_f64;
        let mut start = 0;
        for &size in K::OUTPUTS {
            let results = start..start + size;
            start += size;
            let largest = self.values[results.clone()].iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            for result in results.clone() {
                let unit: Vec<L> =
                    (0..values.len()).map(|i| if i == result { L::ONE } else { L::ZERO }).collect();
                let found: Vec<f64> = K::pull_back::<L>(&x, &unit).iter().map(first).collect();
                let mut offset = 0;
                for (&(_, size), length) in K::INPUTS.iter().zip(case.lengths) {
                    let block = offset..offset + size;
                    offset += size;
                    let of_vector = self.gradients[results.clone()]
                        .iter()
                        .flat_map(|gradient| &gradient[block.clone()]);
                    let size = of_vector.fold(0.1 * largest / length, |size, g| size.max(g.abs()));
                    let expected = &self.gradients[result][block.clone()];
                    let error =
                        worst(&found[block.clone()], expected, [block.len()].into_iter(), size);
                    gradient = crate::larger(gradient, error / epsilon);
                }
            }
        }
        Errors { value, gradient }
    }
}

/// The largest error relative to the largest number of its block, or to `least` if that is larger.
/// Infinite where a number is not finite, or should be zero and is not.
fn worst(found: &[f64], expected: &[f64], blocks: impl Iterator<Item = usize>, least: f64) -> f64 {
    assert_eq!(found.len(), expected.len());
    let (mut worst, mut start) = (0.0_f64, 0);
    for size in blocks {
        let (found, expected) = (&found[start..start + size], &expected[start..start + size]);
        start += size;
        let size = expected.iter().fold(least, |size, x| size.max(x.abs()));
        for (found, expected) in found.iter().zip(expected) {
            let error = (found - expected).abs();
            let relative = if error == 0.0 { 0.0 } else { error / size };
            worst = if relative.is_finite() { worst.max(relative) } else { f64::INFINITY };
        }
    }
    worst
}
