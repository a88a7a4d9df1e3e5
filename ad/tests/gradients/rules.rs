//! Every rule over random inputs, against finite differences, dual numbers, and itself at another
//! precision.
//!
//! [`scalars`], [`vectors`], [`glam_only`] and [`matrices`] list the rules, generic over the scalar; this file
//! runs the lists.

mod arrangements;
mod case;
mod formulas;
mod glam_only;
mod matrices;
mod scalars;
mod vectors;

use std::cell::RefCell;

use ad::{Dual, Real};
use proptest::test_runner::{Config, RngSeed, TestRunner};

use crate::oracle::assert_close;
use case::Case;

/// Upper bounds of the number of elements that a rule takes and gives.
const MOST: usize = 32;
/// Lower bound of the number of inputs that a rule is checked at.
const LEAST: usize = 8;

/// Runs `check` on every case of `cases` with random inputs, cotangents and directions. The seed
/// is fixed: the suite is the same on every run.
fn run<S: Real>(cases: &[Case<S>], check: impl Fn(&Case<S>, &[f64], &[f64], &[f64])) {
    let seed = RngSeed::Fixed(20_240_229);
    let config =
        Config { cases: 64, rng_seed: seed, failure_persistence: None, ..Config::default() };
    let numbers = || proptest::collection::vec(-2.0..2.0_f64, MOST);
    let checked = RefCell::new(vec![0; cases.len()]);
    TestRunner::new(config)
        .run(&(numbers(), numbers(), numbers()), |(x, g, direction)| {
            for (case, checked) in cases.iter().zip(&mut *checked.borrow_mut()) {
                let mut x = x[..case.inputs].to_vec();
                if (case.domain)(&mut x) {
                    check(case, &x, &g[..case.outputs], &direction[..case.inputs]);
                    *checked += 1;
                }
            }
            Ok(())
        })
        .unwrap();
    for (case, checked) in cases.iter().zip(checked.into_inner()) {
        assert!(checked >= LEAST, "{}: its domain leaves {checked} inputs", case.name);
    }
}

fn convert<S: Real>(x: &[f64]) -> Vec<S> {
    x.iter().map(|&x| S::from_f64(x)).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The value of both siblings bit for bit, each cotangent against finite differences, and the tangent along a
/// direction against the cotangents: `<g, J v> = <J^T g, v>`.
fn against_differences(cases: &[Case<f64>]) {
    run(cases, |case, x, g, direction| {
        let (value, pulled) = (case.vjp)(x, g);
        let (moving, along) = (case.jvp)(x, direction);
        let bits = |v: &[f64]| v.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&value), bits(&(case.primal)(x)), "{} at {x:?}", case.name);
        assert_eq!(bits(&moving), bits(&value), "{} at {x:?}", case.name);
        let what = format!("{} at {x:?} along {direction:?}, cotangent {g:?}", case.name);
        assert_close(&what, dot(&along, g), dot(&pulled, direction), 1e-10);
        assert_eq!(pulled.len(), x.len(), "{}", case.name);
        let expected = ad::check::gradient(|x| dot(&(case.primal)(x), g), x, 0.02);
        for (i, expected) in expected.iter().enumerate() {
            let what = format!("{} at {x:?}, by input {i}, cotangent {g:?}", case.name);
            assert_close(&what, pulled[i], expected.value, 1e-7);
        }
    });
}

/// The cotangents along a direction against the derivative of dual numbers in that direction.
fn against_duals(cases: &[Case<f64>], duals: &[Case<Dual<f64>>]) {
    assert_eq!(cases.len(), duals.len());
    run(cases, |case, x, g, direction| {
        let dual = duals.iter().find(|dual| dual.name == case.name).expect("the lists are one");
        let moving: Vec<_> = x.iter().zip(direction).map(|(&x, &d)| Dual::new(x, d)).collect();
        let value = (dual.primal)(&moving);
        let along: Vec<_> = value.iter().map(|value| value.derivative).collect();
        let what = format!("{} at {x:?} along {direction:?}, cotangent {g:?}", case.name);
        assert_close(&what, dot(&(case.vjp)(x, g).1, direction), dot(&along, g), 1e-11);
    });
}

/// The rules on dual numbers: their values are those of `f64`, their derivatives the derivatives
/// of the cotangents.
fn rules_on_duals(cases: &[Case<f64>], duals: &[Case<Dual<f64>>]) {
    run(cases, |case, x, g, direction| {
        let dual = duals.iter().find(|dual| dual.name == case.name).expect("the lists are one");
        let moving: Vec<_> = x.iter().zip(direction).map(|(&x, &d)| Dual::new(x, d)).collect();
        let constant: Vec<_> = g.iter().map(|&g| Dual::constant(g)).collect();
        let (_, pulled) = (dual.vjp)(&moving, &constant);
        for (i, pulled) in pulled.iter().enumerate() {
            let what = format!("{} at {x:?}, by input {i}, cotangent {g:?}", case.name);
            assert_close(&what, pulled.value, (case.vjp)(x, g).1[i], 1e-11);
            let moved = |t: f64| {
                let moved: Vec<_> = x.iter().zip(direction).map(|(x, d)| x + t * d).collect();
                (case.vjp)(&moved, g).1[i]
            };
            let expected = ad::check::derivative(moved, 0.0, 0.01).value;
            let what = format!("second derivative of {what} along {direction:?}");
            assert_close(&what, pulled.derivative, expected, 1e-7);
        }
    });
}

/// The rules at single precision against those at double precision.
fn against_double(singles: &[Case<f32>], doubles: &[Case<f64>]) {
    assert_eq!(singles.len(), doubles.len());
    run(singles, |single, x, g, direction| {
        let double = doubles.iter().find(|d| d.name == single.name).expect("the lists are one");
        let (value, pulled) = (single.vjp)(&convert(x), &convert(g));
        let (moving, along) = (single.jvp)(&convert(x), &convert(direction));
        let bits = |v: &[f32]| v.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        let primal = (single.primal)(&convert(x));
        assert_eq!(bits(&value), bits(&primal), "{} at {x:?}", single.name);
        assert_eq!(bits(&moving), bits(&primal), "{} at {x:?}", single.name);
        // The inputs that single precision sees.
        let round = |x: &[f64]| x.iter().map(|&x| f64::from(x as f32)).collect::<Vec<_>>();
        let (_, expected) = (double.vjp)(&round(x), &round(g));
        let size = expected.iter().fold(1.0, |size: f64, e| size.max(e.abs()));
        for (i, pulled) in pulled.iter().enumerate() {
            let what = format!("{} at {x:?}, by input {i}, cotangent {g:?}", single.name);
            assert!((f64::from(*pulled) - expected[i]).abs() <= 1e-5 * size, "{what}");
        }
        let (_, expected) = (double.jvp)(&round(x), &round(direction));
        let size = expected.iter().fold(1.0, |size: f64, e| size.max(e.abs()));
        for (along, expected) in along.iter().zip(expected) {
            let what = format!("{} at {x:?} along {direction:?}", single.name);
            assert!((f64::from(*along) - expected).abs() <= 1e-5 * size, "{what}");
        }
    });
}

#[test]
fn scalar_rules() {
    against_differences(&scalars::cases());
    against_duals(&scalars::cases(), &scalars::cases());
    rules_on_duals(&scalars::cases(), &scalars::cases());
    against_double(&scalars::cases(), &scalars::cases());
    against_differences(&scalars::double_float_cases());
    against_double(&scalars::single_float_cases(), &scalars::double_float_cases());
}

#[test]
fn vector_rules_of_glam() {
    against_differences(&vectors::dvec2());
    against_differences(&vectors::dvec3());
    against_differences(&vectors::dvec4());
    against_differences(&vectors::dvec3_in_space());
    against_double(&vectors::vec2(), &vectors::dvec2());
    against_double(&vectors::vec3(), &vectors::dvec3());
    against_double(&vectors::vec3a(), &vectors::dvec3());
    against_double(&vectors::vec4(), &vectors::dvec4());
    against_double(&vectors::vec3_in_space(), &vectors::dvec3_in_space());
    against_double(&vectors::vec3a_in_space(), &vectors::dvec3_in_space());
}

#[test]
fn functions_that_only_glam_has() {
    against_differences(&glam_only::double2());
    against_differences(&glam_only::double3());
    against_differences(&glam_only::double4());
    against_double(&glam_only::single2(), &glam_only::double2());
    against_double(&glam_only::single3(), &glam_only::double3());
    against_double(&glam_only::aligned3(), &glam_only::double3());
    against_double(&glam_only::aligned_space(), &glam_only::double_space());
    against_double(&glam_only::single4(), &glam_only::double4());
    against_differences(&glam_only::double_plane());
    against_differences(&glam_only::double_space());
    against_differences(&glam_only::double_four());
    against_double(&glam_only::single_plane(), &glam_only::double_plane());
    against_double(&glam_only::single_space(), &glam_only::double_space());
    against_double(&glam_only::single_four(), &glam_only::double_four());
}

#[test]
fn matrices_and_quaternions() {
    against_differences(&matrices::double2());
    against_differences(&matrices::double3());
    against_differences(&matrices::double4());
    against_differences(&matrices::double_motions());
    against_double(&matrices::single2(), &matrices::double2());
    against_double(&matrices::single3(), &matrices::double3());
    against_double(&matrices::single4(), &matrices::double4());
    against_double(&matrices::single_motions(), &matrices::double_motions());
}

#[test]
fn vector_rules_of_other_scalars() {
    against_differences(&vectors::xyz());
    against_differences(&vectors::xyz_in_space());
    against_duals(&vectors::dvec3(), &vectors::xyz_of_duals());
    against_duals(&vectors::dvec3_in_space(), &vectors::xyz_of_duals_in_space());
    rules_on_duals(&vectors::dvec3(), &vectors::xyz_of_duals());
    rules_on_duals(&vectors::dvec3_in_space(), &vectors::xyz_of_duals_in_space());
}
