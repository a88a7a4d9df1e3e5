use glam::Vec3;
use proptest::prelude::*;

use super::*;

/// Rays from and to anywhere, some of them of no use.
fn batch(origins: &[Vec3], directions: &[Vec3], from: &[u32], active: u64) -> Batch {
    let mut batch = Batch { active, ..Batch::from(&PacketHits::NONE) };
    for ray in 0..PACKET_RAYS {
        batch.origins.set(ray, origins[ray % origins.len()]);
        batch.directions.set(ray, directions[ray % directions.len()]);
        batch.from[ray] = from[ray % from.len()];
    }
    batch
}

/// Checks that a batch finds exactly what each of its rays finds by itself, but for which primitive of
/// several that are equally near.
fn check(tree: &Bvh, batch: &Batch, limits: &[f32; PACKET_RAYS]) -> Result<(), String> {
    let mut hits = PacketHits::NONE;
    tree.nearest_batch(batch, &mut hits);
    let targets = std::array::from_fn(|ray| (ray % 7) as u32);
    let occluded = tree.occluded_batch(batch, limits, &targets);
    for ray in 0..PACKET_RAYS {
        let (origin, direction) = (batch.origins.get(ray), batch.directions.get(ray));
        let from = Some(batch.from[ray]).filter(|&from| from != NO_PRIMITIVE);
        let is_active = batch.active >> ray & 1 == 1;
        let alone = tree.nearest_but(from, origin, direction).filter(|_| is_active);
        let found = hits.get(ray);
        if found.map(|hit| hit.distance) != alone.map(|hit| hit.distance) {
            return Err(format!("ray {ray}: {found:?} but alone {alone:?}"));
        }
        let counts_not = |primitive| primitive == targets[ray] || primitive == batch.from[ray];
        let alone = is_active && tree.is_occluded_but(origin, direction, limits[ray], counts_not);
        if (occluded >> ray & 1 == 1) != alone {
            return Err(format!("ray {ray}: occluded alone: {alone}"));
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, ..ProptestConfig::default() })]

    #[test]
    fn batches_find_what_single_rays_find(
        triangles in proptest::collection::vec(
            (point(-5.0..5.0), proptest::array::uniform2(point(-1.0..1.0))),
            1..400,
        ),
        exponent in -9..10,
        origins in proptest::collection::vec(point(-6.0..6.0), 1..64),
        directions in proptest::collection::vec(point(-1.0..1.0), 1..64),
        from in proptest::collection::vec(0..400_u32, 1..9),
        active in prop_oneof![Just(u64::MAX), any::<u64>()],
        limit in 0.0..15.0_f32,
        more in proptest::collection::vec(shape(), 0..3),
    ) {
        let scale = 10.0_f32.powi(exponent);
        let triangles = triangles.into_iter().map(|(a, [b, c])| Shape::Triangle([a, a + b, a + c]));
        let shapes: Vec<_> = triangles.chain(more).map(|shape| scaled(&shape, scale)).collect();
        let origins: Vec<_> = origins.into_iter().map(|origin| origin * scale).collect();
        let batch = batch(&origins, &directions, &from, active);
        let limits = std::array::from_fn(|ray| limit * scale * (ray % 5) as f32);
        for tree in [Bvh::new(&shapes), Bvh::list(&shapes)] {
            if let Err(problem) = check(&tree, &batch, &limits) {
                prop_assert!(false, "{}", problem);
            }
        }
    }
}

#[test]
fn no_ray_of_a_batch_slips_through_an_edge_or_a_vertex() {
    let triangles = closed_surface(4);
    let shapes: Vec<_> = triangles.iter().map(|&t| Shape::Triangle(t)).collect();
    let tree = Bvh::new(&shapes);
    let inside = Vec3::new(0.11, -0.07, 0.05);
    let targets: Vec<_> = triangles.iter().flat_map(|&triangle| edge_points(triangle)).collect();
    for targets in targets.chunks_exact(PACKET_RAYS) {
        let directions: Vec<_> = targets.iter().map(|target| target - inside).collect();
        let batch = batch(&[inside], &directions, &[NO_PRIMITIVE], u64::MAX);
        let mut hits = PacketHits::NONE;
        tree.nearest_batch(&batch, &mut hits);
        assert_eq!(hits.met(), u64::MAX);
    }
}

#[test]
fn rays_without_a_direction_meet_nothing() {
    let shapes: Vec<_> = closed_surface(2).into_iter().map(Shape::Triangle).collect();
    let tree = Bvh::new(&shapes);
    let directions = [Vec3::ZERO, Vec3::NAN, Vec3::splat(f32::INFINITY), Vec3::X, -Vec3::Z];
    let batch = batch(&[Vec3::ZERO], &directions, &[NO_PRIMITIVE], u64::MAX);
    check(&tree, &batch, &[1.5; PACKET_RAYS]).unwrap();
}
