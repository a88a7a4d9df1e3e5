//! Kernels and traversal on numbers of every bit pattern: denormals, infinities, NaN. Whatever comes
//! out, they return; in a debug build, which traps overflow, as in a release build.

use ad::lanes::{Lanes, f32x16};
use ad::{Real, Scalar};
use glam::{Vec3, vec3};
use renderer::trace::bvh::{Bvh, Shape};

use crate::images::{ARITHMETICS, settings};
use crate::kernels::{
    Added, Attenuated, ByDistant, ByPoint, BySpot, Covered, DistantLit, Kernel, Mirrored, OnSmooth,
    Placed, PlacedNormal, PointLit, PrimaryRay, SmoothMirrored, SphereEntered, SphereLeft,
    SphereUv, Straight, Textured, TrianglePoint, TriangleUv, Unplaced, Weighted,
};
use crate::meshes::Random;
use crate::scenes::textured_scene;

/// Ordinary numbers among those of any bit pattern: where all are extreme, most of a kernel is NaN.
fn number(random: &mut Random) -> f32 {
    match random.bits() % 4 {
        0 => (random.number() * 4.0 - 2.0) as f32,
        1 => [0.0, -0.0, 1.0, -1.0, f32::MIN_POSITIVE, f32::MAX, 1e-20, 1e15]
            [random.bits() as usize % 8],
        _ => f32::from_bits(random.bits() as u32),
    }
}

fn run<K: Kernel, L: Lanes>(random: &mut Random) {
    let count: usize = K::INPUTS.iter().map(|(_, size)| size).sum();
    let mut numbers = |count: usize| -> Vec<L> {
        let mut lane = |_| L::Element::from_f64(f64::from(number(random)));
        (0..count).map(|_| L::from_lanes(&mut lane)).collect()
    };
    let x = numbers(count);
    let values = K::value::<L>(&x);
    let cotangents = numbers(values.len());
    let gradient = K::pull_back::<L>(&x, &cotangents);
    assert_eq!(gradient.len(), count);

    // A cotangent of zero meets no infinity and no NaN.
    let zeros = vec![L::ZERO; values.len()];
    for derivative in K::pull_back::<L>(&x, &zeros) {
        let zero = derivative.lanes().as_ref().iter().all(|lane| lane.to_f64() == 0.0);
        assert!(zero, "{derivative:?} at {x:?}");
    }
}

fn run_all(points: usize) {
    let mut random = Random(11);
    for _ in 0..points {
        macro_rules! each {
            ($($kernel:ident)*) => {$(
                run::<$kernel, f32>(&mut random);
                run::<$kernel, f32x16>(&mut random);
                run::<$kernel, f64>(&mut random);
            )*};
        }
        each!(
            PrimaryRay TrianglePoint OnSmooth SmoothMirrored Weighted PlacedNormal SphereEntered SphereLeft TriangleUv SphereUv PointLit
            DistantLit Mirrored Straight Textured Covered Added Attenuated ByPoint ByDistant BySpot Placed
            Unplaced
        );
    }
}

#[test]
fn kernels_are_total() {
    run_all(3_000);
}

#[test]
#[ignore = "a minute"]
fn kernels_are_total_on_many_numbers() {
    run_all(1_000_000);
}

/// Rays of any numbers through shapes whose coordinates are finite, as traversal wants them.
#[test]
fn traversal_is_total() {
    let mut random = Random(5);
    for _ in 0..300 {
        let mut vector = |finite: bool| loop {
            let v = vec3(number(&mut random), number(&mut random), number(&mut random));
            if !finite || (v.is_finite() && v.abs().max_element() <= 1e18) {
                break v;
            }
        };
        let mut shapes: Vec<Shape> =
            (0..20).map(|_| Shape::Triangle([vector(true), vector(true), vector(true)])).collect();
        shapes.extend((0..10).map(|_| Shape::Sphere(vector(true), vector(true).x.abs())));
        let tree = Bvh::new(&shapes);
        for _ in 0..30 {
            let (origin, direction): (Vec3, Vec3) = (vector(false), vector(false));
            let hit = tree.nearest(origin, direction);
            assert!(hit.is_none_or(|hit| (hit.primitive as usize) < shapes.len()));
            tree.is_occluded(origin, direction, 1.0, None);
        }
    }
}

/// Scenes of any numbers are refused in one line, or rendered.
#[test]
fn scenes_of_any_numbers_are_refused_or_rendered() {
    let mut random = Random(1);
    let (mut refused, mut rendered) = (0, 0);
    for round in 0..2_000 {
        let mut scene = textured_scene(8);
        let ids = scene.parameters();
        let mut change = || {
            for _ in 0..=random.bits() % 3 {
                let id = ids[random.bits() as usize % ids.len()];
                let mut values = scene.get(id).into_owned();
                let element = random.bits() as usize % values.len();
                values[element] = f64::from(number(&mut random));
                scene.set(id, &values)?;
            }
            renderer::render(&scene, &settings(ARITHMETICS[round % ARITHMETICS.len()]))
        };
        match change() {
            Err(error) => {
                refused += 1;
                assert!(!error.to_string().contains('\n'));
            }
            Ok(_) => rendered += 1,
        }
    }
    assert!(refused > 100 && rendered > 100, "{refused} refused, {rendered} rendered");
}
