//! No ray passes between the triangles of a closed surface: rays at its vertices and along its edges.
//!
//! `RAYTRACER_MESH=bunny.obj cargo test --release --test extremes -- --ignored any_mesh` takes a mesh
//! of yours. It may have holes: rays go to edges with a triangle on both sides.

use std::collections::HashMap;

use glam::{DVec3, Vec3};
use renderer::trace::bvh::{Bvh, NO_PRIMITIVE, PACKET_RAYS, PacketVectors, Shape};

use crate::meshes::{Mesh, Random};

/// A closed mesh, placed; traversal takes single precision.
fn shapes(mesh: &Mesh, scale: f64, offset: DVec3) -> Vec<[Vec3; 3]> {
    mesh.corners().map(|corners| corners.map(|v| (v * scale + offset).as_vec3())).collect()
}

/// Points of an edge: the ends, and between them.
fn targets([a, b]: [Vec3; 2], random: &mut Random) -> [Vec3; 4] {
    let s = random.number() as f32;
    [a, b, a.midpoint(b), a + (b - a) * s]
}

/// The edges that several triangles share and that have no end at a hole.
fn inner_edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let mut sides = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            *sides.entry([from.min(to), from.max(to)]).or_insert(0) += 1;
        }
    }
    let open = sides.iter().filter(|(_, sides)| **sides == 1);
    let at_hole: HashMap<u32, ()> = open.flat_map(|(edge, _)| edge.map(|v| (v, ()))).collect();
    let mut inner: Vec<_> = sides.into_keys().collect();
    inner.retain(|edge| edge.iter().all(|vertex| !at_hole.contains_key(vertex)));
    inner.sort_unstable();
    inner
}

/// Those of the edges whose ends are surrounded by triangles that all face a point, or all face away
/// from it. Whatever rounding does to a ray from there, it meets one of them; at other edges a mesh that
/// is seen from outside, or has holes, ends in its silhouette, and a ray may go past it.
fn surrounded(mesh: &Mesh, edges: &[[u32; 2]], point: Vec3) -> Vec<[u32; 2]> {
    let mut sides = vec![[false; 2]; mesh.vertices.len()];
    for (triangle, [a, b, c]) in mesh.triangles.iter().zip(mesh.corners()) {
        let slope = (b - a).cross(c - a).normalize().dot((point.as_dvec3() - a).normalize());
        for &vertex in triangle {
            let [front, back] = &mut sides[vertex as usize];
            // What is seen edge-on, or has no area, counts as both.
            let is_unclear = slope.is_nan() || slope.abs() < 1e-4;
            *front |= is_unclear || slope > 0.0;
            *back |= is_unclear || slope < 0.0;
        }
    }
    let has_one_side = |&vertex: &u32| sides[vertex as usize] != [true; 2];
    edges.iter().copied().filter(|edge| edge.iter().all(has_one_side)).collect()
}

/// A closed mesh, seen from inside, or any other.
#[derive(Clone, Copy, PartialEq)]
enum Seen {
    FromInside,
    FromAnywhere,
}

/// Sends `count` rays from points to vertices and edges; every one has to be stopped.
fn check(
    name: &str,
    (mesh, seen): (&Mesh, Seen),
    scale: f64,
    offset: DVec3,
    from: &[Vec3],
    count: usize,
) {
    let triangles = &shapes(mesh, scale, offset);
    let vertex = |v: u32| (mesh.vertices[v as usize] * scale + offset).as_vec3();
    let edges = inner_edges(mesh);
    let edges_from = from.iter().map(|&origin| match seen {
        Seen::FromInside => edges.clone(),
        Seen::FromAnywhere => surrounded(mesh, &edges, origin),
    });
    let edges_from: Vec<_> = edges_from.collect();
    assert!(edges_from.iter().all(|edges| edges.len() > 100), "{name}: hardly an edge to aim at");
    let shapes: Vec<Shape> = triangles.iter().copied().map(Shape::Triangle).collect();
    let tree = Bvh::new(&shapes);
    let mut random = Random(3);
    let mut leaked = [0; 4];
    let mut sent = 0;
    while sent < count {
        for (&origin, edges) in from.iter().zip(&edges_from) {
            let mut directions = PacketVectors::ZERO;
            let first = random.bits() as usize % edges.len();
            let rays = (0..PACKET_RAYS / 4)
                .flat_map(|i| targets(edges[(first + i) % edges.len()].map(vertex), &mut random));
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
    println!(
        "| {name}, {} triangles | {sent} rays of each kind | {leaked:?} pass |",
        triangles.len()
    );
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
            let name = format!("size 1e{exponent}, moved by {:e}", offset.length());
            check(&name, (&mesh, Seen::FromInside), scale, offset, &inside, count);
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

/// The vertices and triangles of an OBJ file, whose faces have to be triangles.
fn read_obj(text: &str) -> Mesh {
    let mut mesh = Mesh { vertices: Vec::new(), triangles: Vec::new() };
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let numbers: Vec<f64> = words.map(|word| word.parse().unwrap()).collect();
                mesh.vertices.push(DVec3::from_slice(&numbers));
            }
            Some("f") => {
                let index =
                    |word: &str| word.split('/').next().unwrap().parse::<u32>().unwrap() - 1;
                let corners: Vec<u32> = words.map(index).collect();
                mesh.triangles.push([corners[0], corners[1], corners[2]]);
            }
            _ => {}
        }
    }
    mesh
}

#[test]
#[ignore = "wants a mesh"]
fn any_mesh() {
    let Ok(path) = std::env::var("RAYTRACER_MESH") else { return };
    let mesh = read_obj(&std::fs::read_to_string(&path).unwrap());
    let sum: DVec3 = mesh.vertices.iter().sum();
    let middle = sum / mesh.vertices.len() as f64;
    let size = mesh.vertices.iter().fold(0.0_f64, |size, v| size.max(v.distance(middle)));
    let from: Vec<Vec3> = [[0.0, 0.0, 0.0], [0.1, 0.05, -0.1], [2.0, 1.0, -1.5]]
        .map(|v| (middle + DVec3::from(v) * size).as_vec3())
        .to_vec();
    check(&path, (&mesh, Seen::FromAnywhere), 1.0, DVec3::ZERO, &from, 1_000_000);
}
