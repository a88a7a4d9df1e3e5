use std::collections::{BTreeMap, HashSet};
use std::f64::consts::TAU;

use proptest::prelude::*;

use super::surface::{LEAST_WIDTH, width};
use super::*;

/// A closed surface over a grid that meets itself on both sides: with `pole` a ball, else a ring.
fn ring(around: u32, across: u32, place: impl Fn(f64, f64) -> DVec3) -> Mesh {
    let vertex = |i: u32, j: u32| (i % around) * across + j % across;
    let angle = |i: u32, n: u32| TAU * f64::from(i) / f64::from(n);
    let vertices = (0..around).flat_map(|i| (0..across).map(move |j| (i, j)));
    let vertices = vertices.map(|(i, j)| place(angle(i, around), angle(j, across)).to_array());
    let squares = (0..around).flat_map(|i| (0..across).map(move |j| (i, j)));
    let triangles = squares.flat_map(|(i, j)| {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    Mesh::new("ring", vertices.collect(), triangles.collect())
}

/// A ball of eight triangles, each cut into four so often, with bumps.
fn ball(level: u32, bumps: [f64; 3]) -> Mesh {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
    let mut points = axes.to_vec();
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 1, 2],
        [1, 3, 2],
        [3, 4, 2],
        [4, 0, 2],
        [1, 0, 5],
        [3, 1, 5],
        [4, 3, 5],
        [0, 4, 5],
    ];
    for _ in 0..level {
        let mut middles = BTreeMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                points.push((points[a as usize] + points[b as usize]).normalize());
                points.len() as u32 - 1
            })
        };
        let finer = triangles.iter().flat_map(|&[a, b, c]| {
            let [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, x, z], [b, y, x], [c, z, y], [x, y, z]]
        });
        triangles = finer.collect();
    }
    let place = |p: &DVec3| {
        let bump: f64 =
            p.to_array().iter().zip(bumps).map(|(x, bump)| bump * (3.0 * x).sin()).sum();
        (*p * (1.0 + bump)).to_array()
    };
    Mesh::new("ball", points.iter().map(place).collect(), triangles)
}

/// How often each pair of corners follows each other.
fn half_edges(mesh: &Mesh) -> BTreeMap<[u32; 2], usize> {
    let mut counts = BTreeMap::new();
    for &[a, b, c] in &mesh.triangles {
        for pair in [[a, b], [b, c], [c, a]] {
            *counts.entry(pair).or_insert(0) += 1;
        }
    }
    counts
}

/// The number of vertices less that of edges, and that of triangles.
fn euler(mesh: &Mesh) -> i64 {
    let edges: HashSet<[u32; 2]> =
        half_edges(mesh).keys().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
    mesh.vertices.len() as i64 - edges.len() as i64 + mesh.triangles.len() as i64
}

/// Whether two triangles that face the same way meet at each edge, and those around each vertex are one fan.
fn is_closed_surface(mesh: &Mesh) -> bool {
    let edges = half_edges(mesh);
    let is_paired = |(&[a, b], &count): (&[u32; 2], &usize)| {
        count == 1 && a != b && edges.contains_key(&[b, a])
    };
    let surface = Surface::new(mesh);
    edges.iter().all(is_paired) && surface.is_fixed.iter().all(|is_fixed| !is_fixed)
}

fn lengths(mesh: &Mesh) -> Vec<f64> {
    let at = |index: u32| DVec3::from(mesh.vertices[index as usize]);
    half_edges(mesh).keys().map(|&[a, b]| at(a).distance(at(b))).collect()
}

/// The width of the narrowest triangle.
fn narrowest(mesh: &Mesh) -> f64 {
    let surface = Surface::new(mesh);
    let widths = mesh.triangles.iter().map(|&corners| width(surface.places(corners)));
    widths.fold(f64::INFINITY, |least, width| if width >= least { least } else { width })
}

/// Area and volume.
fn measures(mesh: &Mesh) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|corner| DVec3::from(mesh.vertices[corner as usize]));
        sums[0] += 0.5 * (b - a).cross(c - a).length();
        sums[1] += a.dot(b.cross(c)) / 6.0;
    }
    sums
}

/// Whether a remeshed closed surface is what it should be.
fn check_closed(mesh: &Mesh, edge_length: f64, tolerance: f64) -> Result<(), TestCaseError> {
    let Remeshed { mesh: new, origins } = remesh(mesh, edge_length).unwrap();
    prop_assert!(is_closed_surface(&new));
    prop_assert_eq!(euler(&new), euler(mesh));
    prop_assert_eq!(turned_over(&new), 0);
    prop_assert!(narrowest(&new) >= LEAST_WIDTH, "{}", narrowest(&new));
    let lengths = lengths(&new);
    let fitting = lengths.iter().filter(|l| (0.5..=1.5).contains(&(**l / edge_length))).count();
    prop_assert!(fitting as f64 > 0.95 * lengths.len() as f64, "{} of {}", fitting, lengths.len());
    for (before, after) in measures(mesh).into_iter().zip(measures(&new)) {
        prop_assert!((after / before - 1.0).abs() < tolerance, "{} {}", before, after);
    }
    for (origin, vertex) in origins.iter().zip(&new.vertices) {
        let sum: f64 = origin.iter().map(|(_, weight)| weight).sum();
        prop_assert!((sum - 1.0).abs() < 1e-12 && origin.is_sorted_by(|a, b| a.0 < b.0));
        let mean: DVec3 =
            origin.iter().map(|&(i, w)| w * DVec3::from(mesh.vertices[i as usize])).sum();
        let length = lengths.iter().sum::<f64>() / lengths.len() as f64;
        prop_assert!(mean.distance(DVec3::from(*vertex)) < 3.0 * length.max(edge_length));
    }
    Ok(())
}

/// Middles of edges of flat faces lie on lines, where the normals of triangles between them are rounding.
#[test]
fn triangles_of_flat_faces_become_no_lines() {
    for level in 0..3 {
        for step in 0..40 {
            let length = 0.9 * 0.93_f64.powi(step);
            let mut mesh = ball(level, [0.0; 3]);
            // Lengths fall step by step, as in a recovery.
            for part in [2.0, 1.5, 1.2, 1.0] {
                mesh = remesh(&mesh, length * part).unwrap().mesh;
                assert!(narrowest(&mesh) >= LEAST_WIDTH, "{level} {length} {part}");
            }
        }
    }
}

/// A ring whose thickness comes and goes three times.
fn wavy_ring(around: u32, across: u32, wave: f64) -> Mesh {
    let mesh = ring(around, across, |u, v| {
        let r = 1.0 + (0.4 + wave * (3.0 * u).sin() * 0.5) * v.cos();
        DVec3::new(r * u.cos(), r * u.sin(), 0.4 * v.sin())
    });
    assert_eq!(euler(&mesh), 0);
    mesh
}

/// A collapse folded this one, and a flip beside that fold turned a triangle over, each by less than 60 degrees.
#[test]
fn small_turns_turn_no_triangle_over() -> Result<(), TestCaseError> {
    check_closed(&wavy_ring(17, 10, 0.17644514210353549), 0.17874221427767248, 0.08)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn balls_stay_balls(bumps in [-0.25..0.25, -0.25..0.25, -0.25..0.25], length in 0.07..0.3, level in 3_u32..5) {
        check_closed(&ball(level, bumps), length, 0.06)?;
    }

    #[test]
    fn rings_stay_rings(around in 8_u32..40, across in 6_u32..20, wave in 0.0..0.2, length in 0.08..0.18) {
        check_closed(&wavy_ring(around, across, wave), length, 0.08)?;
    }

    /// Any noise: what is folded may stay so, but no surface tears or grows together.
    #[test]
    fn noise_keeps_its_topology(seed in proptest::collection::vec(-0.4..0.4, 3 * 66), length in 0.02..2.0) {
        let mut mesh = ball(2, [0.0; 3]);
        mesh.vertices.as_flattened_mut().iter_mut().zip(&seed).for_each(|(x, noise)| *x += noise);
        let new = remesh(&mesh, length).unwrap().mesh;
        prop_assert!(is_closed_surface(&new));
        prop_assert_eq!(euler(&new), euler(&mesh));
        prop_assert!(new.vertices.as_flattened().iter().all(|x| x.is_finite()));
    }

    /// Any triangles at all.
    #[test]
    fn heaps_of_triangles_are_survived(
        corners in proptest::collection::vec([0_u32..12, 0..12, 0..12], 0..30),
        places in proptest::collection::vec([-2_i8..3, -2..3, -2..3], 12),
        length in 0.05..4.0,
    ) {
        let vertices = places.iter().map(|place| place.map(f64::from)).collect();
        let new = remesh(&Mesh::new("heap", vertices, corners), length).unwrap();
        prop_assert!(new.mesh.vertices.as_flattened().iter().all(|x| x.is_finite()));
        prop_assert!(new.mesh.triangles.as_flattened().iter().all(|&i| (i as usize) < new.mesh.vertices.len()));
        prop_assert_eq!(new.origins.len(), new.mesh.vertices.len());
        prop_assert_eq!(new.mesh.materials.len(), new.mesh.triangles.len());
    }
}

/// A plane of squares, half of each.
fn plane(side: u32) -> Mesh {
    let vertex = |i: u32, j: u32| i * (side + 1) + j;
    let vertices = (0..=side).flat_map(|i| (0..=side).map(move |j| [i.into(), j.into(), 0.0]));
    let squares = (0..side).flat_map(|i| (0..side).map(move |j| (i, j)));
    let triangles = squares.flat_map(|(i, j)| {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    Mesh::new("plane", vertices.collect(), triangles.collect())
}

#[test]
fn borders_and_lines_between_materials_stay() {
    let mut mesh = plane(6);
    let middle_of =
        |corners: &[u32; 3]| corners.iter().map(|&i| mesh.vertices[i as usize][0]).sum::<f64>();
    mesh.materials =
        mesh.triangles.iter().map(|corners| u32::from(middle_of(corners) > 9.0)).collect();
    for length in [0.4, 1.0, 3.0] {
        let Remeshed { mesh: new, .. } = remesh(&mesh, length).unwrap();
        for vertex in &mesh.vertices {
            let is_on_line = vertex[..2].iter().any(|x| [0.0, 6.0].contains(x)) || vertex[0] == 3.0;
            assert!(!is_on_line || new.vertices.contains(vertex), "{length}: {vertex:?}");
        }
        let area = |material: u32| -> f64 {
            let of = new.triangles.iter().zip(&new.materials).filter(|(_, of)| **of == material);
            let surface = Surface::new(&new);
            of.map(|(&corners, _)| 0.5 * surface.normal_of(corners).z).sum()
        };
        assert!((area(0) - 18.0).abs() < 1e-9 && (area(1) - 18.0).abs() < 1e-9, "{length}");
        assert_eq!(euler(&new), 1);
        assert_eq!(turned_over(&new), 0);
        let finest = lengths(&new).into_iter().fold(0.0, f64::max);
        assert!(finest < 1.6 * length.max(1.0), "{length}: {finest}");
    }
}

#[test]
fn what_is_no_surface_is_left() {
    // Three sheets at one edge, two that face different ways, a triangle twice, and one that is a line.
    let vertices = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [5.0, 0.0, 0.0],
        [6.0, 0.0, 0.0],
        [5.0, 1.0, 0.0],
        [5.0, -1.0, 0.0],
    ];
    let triangles =
        vec![[0, 1, 2], [0, 1, 3], [1, 0, 4], [5, 6, 7], [5, 6, 8], [5, 6, 8], [7, 7, 8]];
    let mesh = Mesh::new("sheets", vertices, triangles);
    for length in [0.2, 50.0] {
        let new = remesh(&mesh, length).unwrap().mesh;
        assert!(mesh.vertices.iter().all(|vertex| new.vertices.contains(vertex)), "{length}");
        let has = |from: usize, to: usize| {
            let at = |index: u32| new.vertices[index as usize];
            half_edges(&new)
                .keys()
                .any(|&[a, b]| at(a) == mesh.vertices[from] && at(b) == mesh.vertices[to])
        };
        assert!(has(0, 1) && has(5, 6), "{length}");
    }
}

#[test]
fn small_and_broken_surfaces_are_survived() {
    let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let tetrahedron = Mesh::new("t", corners, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    for length in [1e-1, 2.0, 1e6, 1e300] {
        let new = remesh(&tetrahedron, length).unwrap().mesh;
        assert!(is_closed_surface(&new) && euler(&new) == 2, "{length}");
        assert!(length < 1.0 || new.triangles.len() == 4, "{length}");
    }
    // A large ball becomes a small closed one.
    let crude = remesh(&ball(4, [0.1; 3]), 1e6).unwrap().mesh;
    assert!(is_closed_surface(&crude) && crude.triangles.len() < 100, "{}", crude.triangles.len());
    // All vertices at one place, and all on a line.
    for flat in [0.0, 1.0] {
        let mut mesh = ball(2, [0.0; 3]);
        mesh.vertices.iter_mut().for_each(|vertex| *vertex = [flat * vertex[0], 0.0, 0.0]);
        let new = remesh(&mesh, 0.3).unwrap().mesh;
        assert!(is_closed_surface(&new) && euler(&new) == 2);
        assert!(new.vertices.as_flattened().iter().all(|x| x.is_finite()));
    }
    // Extremes of scale change nothing but the scale.
    for scale in [1e-30, 1e30] {
        let mut mesh = ball(3, [0.1; 3]);
        let count = remesh(&mesh, 0.2).unwrap().mesh.triangles.len();
        mesh.vertices.as_flattened_mut().iter_mut().for_each(|x| *x *= scale);
        let scaled = remesh(&mesh, 0.2 * scale).unwrap().mesh.triangles.len();
        assert!((scaled as f64 / count as f64 - 1.0).abs() < 0.05, "{scale}: {scaled} {count}");
    }
    let nothing = remesh(&Mesh::new("nothing", vec![], vec![]), 1.0).unwrap().mesh;
    assert!(nothing.vertices.is_empty());
}

#[test]
fn what_cannot_be_remeshed_is_refused() {
    let refuse = |mesh: &Mesh, length: f64, part: &str| {
        let error = remesh(mesh, length).unwrap_err();
        assert!(error.place == "mesh.ball" && error.problem.contains(part), "{error:?}");
    };
    let mesh = ball(1, [0.0; 3]);
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refuse(&mesh, length, "above 0");
    }
    for length in [1e-6, 1e-300] {
        refuse(&mesh, length, "memory");
    }
    let mut broken = mesh.clone();
    broken.vertices[3][1] = f64::NAN;
    refuse(&broken, 1.0, "vertices[3]");
    let mut broken = mesh.clone();
    broken.triangles[2][1] = 77;
    refuse(&broken, 1.0, "77");
    let same = mesh.triangles.clone();
    let (coordinates, normals) = (vec![[0.0; 2]; 18], vec![[0.0, 0.0, 1.0]; 18]);
    refuse(
        &mesh.clone().texture_coordinates(coordinates, same.clone()),
        1.0,
        "texture coordinates",
    );
    refuse(&mesh.normals(normals, same), 1.0, "smooth");
}

/// Corners lose little by being made of finer triangles, or of as coarse ones.
#[test]
fn corners_stay() {
    for (level, scale) in [(0, 1.0), (1, 0.5), (2, 0.25)] {
        let mut mesh = ball(level, [0.0; 3]);
        // Back to the octahedron that the ball began as.
        for vertex in &mut mesh.vertices {
            let sum: f64 = vertex.iter().map(|x| x.abs()).sum();
            vertex.iter_mut().for_each(|x| *x /= sum);
        }
        for length in [1.1, 1.0, 0.8, 0.6, 0.4, 0.3, 0.1].map(|l| l * scale) {
            let new = remesh(&mesh, length).unwrap().mesh;
            let [before, after] = [measures(&mesh), measures(&new)].map(|[_, volume]| volume);
            assert!(after > 0.7 * before, "{level} {length}: {after} {before}");
        }
    }
}

/// The triangles of several meshes, as one.
fn together(meshes: &[&Mesh]) -> Mesh {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for mesh in meshes {
        let first = vertices.len() as u32;
        triangles.extend(mesh.triangles.iter().map(|corners| corners.map(|c| c + first)));
        vertices.extend(&mesh.vertices);
    }
    Mesh::new("all", vertices, triangles)
}

fn moved(mesh: &Mesh, by: DVec3) -> Mesh {
    let vertices = mesh.vertices.iter().map(|&vertex| (DVec3::from(vertex) + by).to_array());
    Mesh { vertices: vertices.collect(), ..mesh.clone() }
}

/// A ring around the y axis whose tube has a radius.
fn torus(tube: f64) -> Mesh {
    ring(40, 20, |around, across| {
        let reach = 1.0 + tube * across.cos();
        DVec3::new(reach * around.cos(), tube * across.sin(), reach * around.sin())
    })
}

#[test]
fn triangles_that_go_through_others_are_counted() {
    let ball = ball(2, [0.0; 3]);
    for mesh in [&ball, &torus(0.6)] {
        assert_eq!(self_intersecting(mesh), 0);
        // Far from the middle, too.
        assert_eq!(self_intersecting(&moved(mesh, DVec3::new(1e6, 0.0, -3e5))), 0);
    }
    // The tube is wider than the ring.
    assert!(self_intersecting(&torus(1.2)) > 40);
    // In by one triangle and out by another.
    let needle = Mesh::new(
        "needle",
        vec![[-2.0, 0.21, 0.17], [-2.0, 0.22, 0.17], [2.0, 0.21, 0.18]],
        vec![[0, 1, 2]],
    );
    assert_eq!(self_intersecting(&together(&[&ball, &needle])), 3);
    let within = moved(&needle, DVec3::X * 5.0);
    assert_eq!(self_intersecting(&together(&[&ball, &within])), 0);
    let apart = moved(&ball, DVec3::X * 2.001);
    assert_eq!(self_intersecting(&together(&[&ball, &apart])), 0);
    let closer = moved(&ball, DVec3::new(1.9, 0.01, 0.02));
    let both = self_intersecting(&together(&[&ball, &closer]));
    assert!(both > 4 && both < 60, "{both}");
}

/// Vertices that a mesh has twice, triangles upon triangles and such that only touch go through nothing.
#[test]
fn seams_and_contact_are_no_intersections() {
    let ball = ball(2, [0.1, 0.2, 0.0]);
    let corners = ball.triangles.as_flattened().iter().map(|&c| ball.vertices[c as usize]);
    let count = ball.triangles.len() as u32;
    let soup = Mesh::new(
        "soup",
        corners.collect(),
        (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
    );
    assert_eq!(self_intersecting(&soup), 0);
    assert_eq!(self_intersecting(&together(&[&soup, &soup])), 0);
    let floor = Mesh::new(
        "floor",
        vec![[-1.0, 0.0, -1.0], [3.0, 0.0, -1.0], [-1.0, 0.0, 3.0]],
        vec![[0, 1, 2]],
    );
    let standing = Mesh::new(
        "standing",
        vec![[0.0, 0.0, 0.0], [0.1, 1.0, 0.0], [0.0, 1.0, 0.1]],
        vec![[0, 1, 2]],
    );
    assert_eq!(self_intersecting(&together(&[&floor, &standing])), 0);
    // By a billionth it does.
    let sunken = moved(&standing, DVec3::NEG_Y * 1e-9);
    assert_eq!(self_intersecting(&together(&[&floor, &sunken])), 2);
    // Edge through edge, at one point of both.
    let [a, b, c] = [[0.5, -1.0, -1.0], [0.5, 1.0, -1.0], [0.5, 0.0, -2.0]];
    let crossing = Mesh::new("crossing", vec![a, b, c], vec![[0, 1, 2]]);
    assert_eq!(self_intersecting(&together(&[&floor, &crossing])), 2);
}

/// Where an edge meets a plane, by division, and whether that is within the triangle.
fn is_pierced([p, q]: [DVec3; 2], [a, b, c]: [DVec3; 3]) -> bool {
    let normal = (b - a).cross(c - a);
    let along = normal.dot(a - p) / normal.dot(q - p);
    let place = p + along * (q - p);
    let inside = |from: DVec3, to: DVec3| normal.dot((to - from).cross(place - from)) > 0.0;
    (0.0..1.0).contains(&along) && inside(a, b) && inside(b, c) && inside(c, a)
}

proptest! {
    #[test]
    fn intersections_are_those_of_all_pairs(
        corners in prop::collection::vec(prop::array::uniform3(-1.0_f64..1.0), 3..120),
    ) {
        let count = corners.len() as u32 / 3;
        let triangles: Vec<[u32; 3]> = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let mesh = Mesh::new("soup", corners, triangles);
        let places: Vec<[DVec3; 3]> =
            mesh.triangles.iter().map(|t| t.map(|c| mesh.vertices[c as usize].into())).collect();
        let cross = |one: [DVec3; 3], other: [DVec3; 3]| {
            let edges = |[a, b, c]: [DVec3; 3]| [[a, b], [b, c], [c, a]];
            edges(one).into_iter().any(|edge| is_pierced(edge, other))
                || edges(other).into_iter().any(|edge| is_pierced(edge, one))
        };
        let is_crossed = |&i: &usize| {
            (0..places.len()).any(|j| i != j && cross(places[i], places[j]))
        };
        prop_assert_eq!(self_intersecting(&mesh), (0..places.len()).filter(is_crossed).count());
    }
}
