use glam::{Vec3, vec3};
use proptest::prelude::*;

use super::*;

/// Whether two trees answer alike.
fn same(a: &Bvh, b: &Bvh, origin: Vec3, directions: &[Vec3]) -> bool {
    directions.iter().all(|&direction| {
        let (found, expected) = (a.nearest(origin, direction), b.nearest(origin, direction));
        found.map(|hit| hit.distance) == expected.map(|hit| hit.distance)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn an_updated_tree_finds_what_a_new_one_finds(
        shapes in proptest::collection::vec((shape(), point(-1.0..1.0)), 1..300),
        distance in prop_oneof![0.01..0.1_f32, 1.0..20.0_f32],
        origin in point(-9.0..9.0),
        directions in proptest::collection::vec(point(-1.0..1.0), 40),
    ) {
        let (before, after): (Vec<_>, Vec<_>) = shapes
            .iter()
            .map(|(shape, step)| (shape.clone(), moved(shape, *step * distance)))
            .unzip();
        let mut tree = Bvh::new(&before);
        tree.update(&after);
        prop_assert!(same(&tree, &Bvh::new(&after), origin, &directions));
        tree.update(&before);
        prop_assert!(same(&tree, &Bvh::new(&before), origin, &directions));
    }
}

#[test]
fn a_tree_takes_over_other_numbers_and_kinds_of_shapes() {
    let wall =
        |z: f32| Shape::Triangle([vec3(-9.0, -9.0, z), vec3(9.0, -9.0, z), vec3(0.0, 9.0, z)]);
    let ball = |z: f32| Shape::Sphere(vec3(0.0, 0.0, z), 0.5);
    let mut tree = Bvh::new(&[wall(3.0), ball(2.0)]);
    for (shapes, distance) in [
        (vec![ball(4.0), wall(5.0)], Some(3.5)),
        (vec![wall(7.0)], Some(7.0)),
        (vec![], None),
        (vec![wall(7.0), wall(6.0), ball(9.0)], Some(6.0)),
    ] {
        tree.update(&shapes);
        assert_eq!(tree.nearest(Vec3::ZERO, Vec3::Z).map(|hit| hit.distance), distance);
    }
}

#[test]
fn a_tree_that_has_become_bad_is_built_again() {
    let triangle = |corner: Vec3| Shape::Triangle([corner, corner + Vec3::X, corner + Vec3::Y]);
    let row: Vec<_> = (0..1000).map(|i| triangle(Vec3::X * i as f32)).collect();
    let mut tree = Bvh::new(&row);
    let shuffled: Vec<_> = (0..1000).map(|i| triangle(Vec3::X * (i * 387 % 1000) as f32)).collect();

    let mut refitted = Bvh::new(&row);
    assert!(refitted.triangles.refit(&shuffled));
    assert!(refitted.triangles.degradation() > REBUILD_ABOVE);
    tree.update(&shuffled);
    assert_eq!(tree.triangles.degradation(), 1.0);
}
