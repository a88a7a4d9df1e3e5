use glam::{Vec3, vec3};
use proptest::prelude::*;

use super::*;

/// The nearest hit by asking every primitive.
fn brute_force(shapes: &[Shape], origin: Vec3, direction: Vec3) -> Option<(usize, f32)> {
    let test = ShapeTest::new(origin, direction)?;
    shapes
        .iter()
        .map(|shape| test.distance(shape).0)
        .enumerate()
        .filter(|(_, distance)| distance.is_finite())
        .min_by(|a, b| a.1.total_cmp(&b.1))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn the_tree_finds_what_asking_every_primitive_finds(
        shapes in proptest::collection::vec(shape(), 1..80),
        origin in point(-9.0..9.0),
        directions in proptest::collection::vec(point(-1.0..1.0), 20),
        limit in 0.0..12.0_f32,
        exponent in -9..10,
    ) {
        let scale = 10.0_f32.powi(exponent);
        let shapes: Vec<_> = shapes.iter().map(|shape| scaled(shape, scale)).collect();
        let (origin, limit) = (origin * scale, limit * scale);
        let trees = BuildQuality::ALL.map(|quality| Bvh::with_quality(&shapes, quality));
        for direction in directions {
            let Some(direction) = direction.try_normalize() else { continue };
            let expected = brute_force(&shapes, origin, direction).map(|(_, distance)| distance);
            let blocked = expected.is_some_and(|distance| distance < limit);
            for tree in &trees {
                let found = tree.nearest(origin, direction);
                prop_assert_eq!(found.map(|hit| hit.distance), expected);
                prop_assert_eq!(tree.is_occluded(origin, direction, limit, None), blocked);
            }
        }
    }
}

#[test]
fn an_empty_scene_is_never_hit() {
    let tree = Bvh::new(&[]);
    assert_eq!(tree.nearest(Vec3::ZERO, Vec3::X), None);
    assert!(!tree.is_occluded(Vec3::ZERO, Vec3::X, f32::INFINITY, None));
}

#[test]
fn a_ray_from_inside_a_sphere_leaves_it() {
    let tree = Bvh::new(&[Shape::Sphere(Vec3::ZERO, 2.0)]);
    let inside = tree.nearest(vec3(0.5, 0.0, 0.0), Vec3::X).unwrap();
    assert_eq!((inside.distance, inside.leaves), (1.5, true));
    let outside = tree.nearest(vec3(-5.0, 0.0, 0.0), Vec3::X).unwrap();
    assert_eq!((outside.distance, outside.leaves), (3.0, false));
    assert_eq!(tree.nearest(vec3(5.0, 0.0, 0.0), Vec3::X), None);
}

#[test]
fn occlusion_respects_the_limit_and_the_primitive_it_starts_on() {
    let wall =
        |z: f32| Shape::Triangle([vec3(-9.0, -9.0, z), vec3(9.0, -9.0, z), vec3(0.0, 9.0, z)]);
    let tree = Bvh::new(&[wall(1.0), wall(3.0)]);
    assert!(tree.is_occluded(Vec3::ZERO, Vec3::Z, 1.5, None));
    assert!(!tree.is_occluded(Vec3::ZERO, Vec3::Z, 1.5, Some(0)));
    assert!(tree.is_occluded(Vec3::ZERO, Vec3::Z, 3.5, Some(0)));
    assert!(!tree.is_occluded(Vec3::ZERO, Vec3::Z, 0.5, None));
}

#[test]
fn no_ray_slips_through_an_edge_or_a_vertex() {
    for (scale, offset) in [(1.0, Vec3::ZERO), (1e-3, vec3(1.0, 2.0, 3.0)), (1e4, Vec3::ONE)] {
        let triangles = placed(&closed_surface(4), scale, offset);
        let shapes: Vec<_> = triangles.iter().map(|&t| Shape::Triangle(t)).collect();
        let tree = Bvh::new(&shapes);
        let inside = offset + vec3(0.11, -0.07, 0.05) * scale;
        for &triangle in &triangles {
            for target in edge_points(triangle) {
                let direction = (target - inside).normalize();
                assert!(tree.nearest(inside, direction).is_some(), "{target} from {inside}");
            }
        }
    }
}
