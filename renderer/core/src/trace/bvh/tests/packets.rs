use std::collections::BTreeMap;

use glam::{Vec3, vec3};
use proptest::prelude::*;

use super::super::packet::Packet;
use super::*;

const ALL: u64 = u64::MAX;

fn packet(directions: &[Vec3]) -> PacketVectors {
    let mut packet = PacketVectors::ZERO;
    directions.iter().enumerate().for_each(|(ray, &direction)| packet.set(ray, direction));
    packet
}

/// A tile of rays around a direction, jittered.
fn tile(toward: Vec3, spread: f32, jitter: &[Vec3]) -> Vec<Vec3> {
    let (right, up) = toward.any_orthonormal_pair();
    (0..PACKET_RAYS)
        .map(|ray| {
            let (x, y) = ((ray % 8) as f32 - 3.5, (ray / 8) as f32 - 3.5);
            let jitter = jitter[ray % jitter.len()];
            let offset = (right * (x + 0.3 * jitter.x) + up * (y + 0.3 * jitter.y)) * spread;
            (toward + offset) * (1.0 + 0.5 * jitter.z)
        })
        .collect()
}

/// Whether a packet and its single rays find the same: the same primitive, or two of about equal
/// distance.
fn check(tree: &Bvh, origin: Vec3, rays: &[Vec3], active: u64) -> Result<(), String> {
    let hits = tree.nearest_packet(origin, &packet(rays), active);
    for (ray, &direction) in rays.iter().enumerate() {
        let single = tree.nearest(origin, direction).filter(|_| active >> ray & 1 != 0);
        let agree = match (hits.get(ray), single) {
            (None, None) => true,
            (Some(a), Some(b)) => {
                (a.distance - b.distance).abs() <= 1e-3 * b.distance && a.leaves == b.leaves
            }
            _ => false,
        };
        if !agree {
            return Err(format!("ray {ray}: {:?} but alone {single:?}", hits.get(ray)));
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, ..ProptestConfig::default() })]

    #[test]
    fn packets_find_what_single_rays_find(
        shapes in proptest::collection::vec(shape(), 1..120),
        exponent in -9..10,
        origin in point(-9.0..9.0),
        target in point(-3.0..3.0),
        jitter in proptest::collection::vec(point(-1.0..1.0), 64),
        spread in (-4.0..-0.7_f32).prop_map(|e| 10.0_f32.powf(e)),
        active in prop_oneof![Just(ALL), any::<u64>()],
        limit in 0.0..15.0_f32,
        from in 0..120_u32,
    ) {
        let scale = 10.0_f32.powi(exponent);
        let shapes: Vec<_> = shapes.iter().map(|shape| scaled(shape, scale)).collect();
        let origin = origin * scale;
        let Some(toward) = (target * scale - origin).try_normalize() else { return Ok(()) };
        let tree = Bvh::new(&shapes);
        let rays = tile(toward, spread, &jitter);
        if let Err(problem) = check(&tree, origin, &rays, active) {
            prop_assert!(false, "{}", problem);
        }

        let mut own = [NO_PRIMITIVE; PACKET_RAYS];
        own[..40].fill(from);
        let limit = limit * scale;
        let occluded = tree.occluded_packet(origin, &packet(&rays), limit, &own, active);
        for (ray, &direction) in rays.iter().enumerate() {
            let from = (ray < 40).then_some(from);
            let single =
                active >> ray & 1 != 0 && tree.is_occluded(origin, direction, limit, from);
            // Single rays decide whether the limit falls between the two roundings.
            let near_limit = tree.nearest(origin, direction).is_some_and(|hit| {
                (hit.distance - limit).abs() <= 1e-3 * limit
            });
            prop_assert!(near_limit || single == (occluded >> ray & 1 != 0), "ray {}", ray);
        }
    }

    #[test]
    fn packets_of_any_directions_find_what_single_rays_find(
        shapes in proptest::collection::vec(shape(), 1..60),
        origin in point(-2.0..2.0),
        rays in proptest::collection::vec(point(-1.0..1.0), 64),
    ) {
        if let Err(problem) = check(&Bvh::new(&shapes), origin, &rays, ALL) {
            prop_assert!(false, "{}", problem);
        }
    }
}

#[test]
fn rays_along_the_axes_and_through_corners_of_boxes() {
    let shapes: Vec<_> = (0..400)
        .map(|i| {
            let corner = vec3((i % 20) as f32, (i / 20) as f32, 0.0);
            Shape::Triangle([corner, corner + Vec3::X, corner + Vec3::Y])
        })
        .collect();
    let tree = Bvh::new(&shapes);
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        for sign in [-1.0, 1.0] {
            let direction = axis * sign;
            let origin = vec3(3.0, 4.0, 0.0) - direction * 2.0;
            let rays = [direction; PACKET_RAYS];
            check(&tree, origin, &rays, ALL).unwrap();
            let hits = tree.nearest_packet(origin, &packet(&rays), ALL);
            assert_eq!(hits.get(0).is_some(), axis == Vec3::Z);
        }
    }
}

#[test]
fn rays_without_a_direction_meet_nothing() {
    let wall = Shape::Triangle([vec3(-9.0, -9.0, 1.0), vec3(9.0, -9.0, 1.0), vec3(0.0, 9.0, 1.0)]);
    let tree = Bvh::new(&[wall, Shape::Sphere(Vec3::Z, 0.3)]);
    let mut rays = [Vec3::Z; PACKET_RAYS];
    rays[0] = Vec3::ZERO;
    rays[7] = Vec3::NAN;
    rays[20] = Vec3::INFINITY;
    let hits = tree.nearest_packet(Vec3::ZERO, &packet(&rays), ALL);
    let occluded =
        tree.occluded_packet(Vec3::ZERO, &packet(&rays), 2.0, &[NO_PRIMITIVE; PACKET_RAYS], ALL);
    for ray in 0..PACKET_RAYS {
        let valid = ![0, 7, 20].contains(&ray);
        assert_eq!(hits.get(ray).is_some(), valid);
        assert_eq!(occluded >> ray & 1 != 0, valid);
    }
}

/// Rays by the signed axis that they advance on most: packets that need no fallback.
fn coherent(rays: impl Iterator<Item = Vec3>) -> Vec<Vec<Vec3>> {
    let mut groups: BTreeMap<_, Vec<Vec3>> = BTreeMap::new();
    for ray in rays {
        let axis = ray.abs().max_position();
        groups.entry((axis, ray[axis] < 0.0)).or_default().push(ray);
    }
    groups.values().flat_map(|rays| rays.chunks(PACKET_RAYS).map(<[Vec3]>::to_vec)).collect()
}

#[test]
fn no_packet_slips_through_an_edge_or_a_vertex() {
    let placements =
        [(1.0, Vec3::ZERO), (1e-3, vec3(1.0, 2.0, 3.0)), (1e4, Vec3::ONE), (1e-9, Vec3::ZERO)];
    for ((scale, offset), subdivisions) in placements.into_iter().flat_map(|p| [(p, 3), (p, 6)]) {
        let triangles = placed(&closed_surface(subdivisions), scale, offset);
        let shapes: Vec<_> = triangles.iter().map(|&t| Shape::Triangle(t)).collect();
        let tree = Bvh::new(&shapes);
        for from in [vec3(0.11, -0.07, 0.05), vec3(-0.5, 0.6, 0.4)] {
            let inside = offset + from * scale;
            let rays = triangles
                .iter()
                .flat_map(|&triangle| edge_points(triangle).map(|target| target - inside));
            for rays in coherent(rays) {
                let active = ALL >> (PACKET_RAYS - rays.len());
                let packet = packet(&rays);
                assert!(Packet::new(inside, &packet, active, 1.0).is_some());
                let hits = tree.nearest_packet(inside, &packet, active);
                let missed = (0..rays.len()).filter(|&ray| hits.get(ray).is_none()).count();
                assert_eq!(missed, 0, "of {} at scale {scale}", rays.len());
                let from = [NO_PRIMITIVE; PACKET_RAYS];
                assert_eq!(tree.occluded_packet(inside, &packet, 9.0, &from, active), active);
            }
        }
    }
}

/// Triangles of every kind of badness around a plane through the origin of the rays.
#[test]
fn needles_and_triangles_without_area_are_hit_as_by_single_rays() {
    let mut shapes = Vec::new();
    for i in 0..200 {
        let x = i as f32 / 50.0 - 2.0;
        let near = vec3(x, -2.0, 3.0 + x);
        shapes.push(Shape::Triangle([
            near,
            near + vec3(1e-6, 4.0, 0.0),
            near + vec3(0.0, 4.0, 0.0),
        ]));
        shapes.push(Shape::Triangle([near, near + Vec3::Y, near + Vec3::Y]));
        shapes.push(Shape::Triangle([near, near, near]));
        shapes.push(Shape::Triangle([near, near + Vec3::Y, near + 3.0 * Vec3::Y]));
        // Seen edge-on from the origin.
        shapes.push(Shape::Triangle([near, near * 2.0, near * 1.5 + vec3(0.0, 1e-7, 0.0)]));
    }
    let tree = Bvh::new(&shapes);
    for tilt in 0..40 {
        let toward = vec3(tilt as f32 / 20.0 - 1.0, 0.0, 3.0).normalize();
        let rays = tile(toward, 0.004, &[Vec3::ZERO]);
        let hits = tree.nearest_packet(Vec3::ZERO, &packet(&rays), ALL);
        for (ray, &direction) in rays.iter().enumerate() {
            let single = tree.nearest(Vec3::ZERO, direction);
            assert_eq!(hits.get(ray).is_some(), single.is_some(), "{direction}");
        }
    }
}
