//! No ray passes between the triangles of a closed surface: rays at its vertices and along its edges.
//!
//! `RAYTRACER_MESH=bunny.obj cargo test --test extremes -- --ignored watertight` takes another
//! mesh, of which it counts the rays that hit what a ray from its other side hits too.

use glam::{DVec3, Vec3};
use renderer::acceleration::{
    Acceleration, NO_PRIMITIVE, PACKET_RAYS, PacketVectors, Shape,
};

use crate::meshes::{Mesh, Random};

/// A closed mesh, placed; traversal takes single precision.
fn shapes(mesh: &Mesh, scale: f64, offset: DVec3) -> Vec<[Vec3; 3]> {
    mesh.corners().map(|corners| corners.map(|v| (v * scale + offset).as_vec3())).collect()
}

/// Points of edges: the ends, and between them.
fn targets(corners: [Vec3; 3], random: &mut Random) -> [Vec3; 4] {
    let [a, b, _] = corners;
    let s = random.number() as f32;
    [a, b, a.midpoint(b), a + (b - a) * s]
}

/// Sends `count` rays from points inside to vertices and edges; every one has to be stopped.
fn check(name: &str, triangles: &[[Vec3; 3]], inside: &[Vec3], count: usize) {
    let shapes: Vec<Shape> = triangles.iter().copied().map(Shape::Triangle).collect();
    let tree = Acceleration::new(&shapes);
    let mut random = Random(3);
    let mut leaked = [0; 4];
    let mut sent = 0;
    while sent < count {
        for &origin in inside {
            let mut directions = PacketVectors::ZERO;
            let first = random.bits() as usize % triangles.len();
            let rays = (0..PACKET_RAYS / 4).flat_map(|i| {
                targets(triangles[(first + i) % triangles.len()], &mut random)
            });
            let rays: Vec<Vec3> = rays.map(|target| target - origin).collect();
            for (ray, &direction) in rays.iter().enumerate() {
                directions.set(ray, direction);
                leaked[0] += usize::from(tree.nearest(origin, direction.normalize()).is_none());
                leaked[1] += usize::from(!tree.is_occluded(origin, direction, 9.0, None));
            }
            let hits = tree.nearest_packet(origin, &directions, u64::MAX);
            leaked[2] += PACKET_RAYS - hits.met().count_ones() as usize;
            let from = [NO_PRIMITIVE; PACKET_RAYS];
            let occluded = tree.occluded_packet(origin, &directions, 9.0, &from, u64::MAX);
            leaked[3] += occluded.count_zeros() as usize;
            sent += PACKET_RAYS;
        }
    }
    println!("| {name}, {} triangles | {sent} rays of each kind | {leaked:?} pass |", triangles.len());
    assert_eq!(leaked, [0; 4], "{name}: single rays, shadow rays, packets, packets of shadow rays");
}

fn check_everywhere(subdivisions: u32, count: usize) {
    let mesh = Mesh::bumpy(subdivisions);
    for exponent in [-8, -3, 0, 3, 8] {
        let scale = 10.0_f64.powi(exponent);
        for offset in [DVec3::ZERO, DVec3::new(3.0, -20.0, 7.0)] {
            let offset = offset * scale;
            let inside = [[0.1, 0.2, -0.1], [-0.3, 0.05, 0.2], [0.0, 0.0, 0.0]]
                .map(|v| (DVec3::from(v) * scale + offset).as_vec3());
            let triangles = shapes(&mesh, scale, offset);
            let name = format!("size 1e{exponent}, moved by {:e}", offset.length());
            check(&name, &triangles, &inside, count);
        }
    }
}

#[test]
fn no_ray_passes_a_vertex_or_an_edge() {
    check_everywhere(3, 2_000);
}

#[test]
#[ignore = "half a minute"]
fn a_million_rays() {
    check_everywhere(6, 100_000);
}
