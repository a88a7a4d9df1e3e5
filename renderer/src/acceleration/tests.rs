use glam::{Vec3, vec3};
use proptest::prelude::*;

use super::spheres::sphere_distance;
use super::*;

fn point(range: std::ops::Range<f32>) -> impl Strategy<Value = Vec3> {
    proptest::array::uniform3(range).prop_map(Vec3::from)
}

fn shape() -> impl Strategy<Value = Shape> {
    let triangle = (point(-5.0..5.0), proptest::array::uniform2(point(-1.0..1.0)))
        .prop_map(|(a, [b, c])| Shape::Triangle([a, a + b, a + c]));
    let sphere = (point(-5.0..5.0), 0.1..0.8_f32).prop_map(|(c, r)| Shape::Sphere(c, r));
    prop_oneof![4 => triangle, 1 => sphere]
}

/// The nearest hit by asking every primitive.
fn brute_force(shapes: &[Shape], origin: Vec3, direction: Vec3) -> Option<(usize, f32)> {
    let test = TriangleTest::new(origin, direction)?;
    let distance = |shape: &Shape| match *shape {
        Shape::Triangle(corners) => test.depth(corners) * test.scale,
        Shape::Sphere(center, radius) => sphere_distance(origin, direction, center, radius).0,
    };
    shapes
        .iter()
        .map(distance)
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
    ) {
        let tree = Acceleration::new(&shapes);
        for direction in directions {
            let Some(direction) = direction.try_normalize() else { continue };
            let expected = brute_force(&shapes, origin, direction);
            let found = tree.nearest(origin, direction);
            prop_assert_eq!(found.map(|hit| hit.distance), expected.map(|(_, distance)| distance));
            let blocked = expected.is_some_and(|(_, distance)| distance < limit);
            prop_assert_eq!(tree.is_occluded(origin, direction, limit, None), blocked);
        }
    }
}

#[test]
fn an_empty_scene_is_never_hit() {
    let tree = Acceleration::new(&[]);
    assert_eq!(tree.nearest(Vec3::ZERO, Vec3::X), None);
    assert!(!tree.is_occluded(Vec3::ZERO, Vec3::X, f32::INFINITY, None));
}

#[test]
fn a_ray_from_inside_a_sphere_leaves_it() {
    let tree = Acceleration::new(&[Shape::Sphere(Vec3::ZERO, 2.0)]);
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
    let tree = Acceleration::new(&[wall(1.0), wall(3.0)]);
    assert!(tree.is_occluded(Vec3::ZERO, Vec3::Z, 1.5, None));
    assert!(!tree.is_occluded(Vec3::ZERO, Vec3::Z, 1.5, Some(0)));
    assert!(tree.is_occluded(Vec3::ZERO, Vec3::Z, 3.5, Some(0)));
    assert!(!tree.is_occluded(Vec3::ZERO, Vec3::Z, 0.5, None));
}

/// A closed surface of triangles: an octahedron, each side subdivided and pushed to the sphere.
fn closed_surface(subdivisions: u32) -> Vec<[Vec3; 3]> {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z];
    let mut triangles = Vec::new();
    for signs in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|i| if signs >> i & 1 == 0 { axes[i] } else { -axes[i] });
        triangles.push([x, y, z]);
    }
    for _ in 0..subdivisions {
        triangles = triangles
            .into_iter()
            .flat_map(|[a, b, c]| {
                let middle = |p: Vec3, q: Vec3| (p + q).normalize();
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    triangles
}

#[test]
fn no_ray_slips_through_an_edge_or_a_vertex() {
    for (scale, offset) in [(1.0, Vec3::ZERO), (1e-3, vec3(1.0, 2.0, 3.0)), (1e4, Vec3::ONE)] {
        let triangles: Vec<[Vec3; 3]> = closed_surface(4)
            .into_iter()
            .map(|corners| corners.map(|corner| corner * scale + offset))
            .collect();
        let shapes: Vec<_> = triangles.iter().map(|&t| Shape::Triangle(t)).collect();
        let tree = Acceleration::new(&shapes);
        let inside = offset + vec3(0.11, -0.07, 0.05) * scale;
        for &[a, b, c] in &triangles {
            let on_edges = [a, b, c, a.midpoint(b), b.midpoint(c), a.lerp(c, 0.3)];
            for target in on_edges {
                let direction = (target - inside).normalize();
                assert!(tree.nearest(inside, direction).is_some(), "{target} from {inside}");
            }
        }
    }
}
