//! Triangles that are thin, tiny, huge, or seen along their plane.

use glam::dvec3;
use renderer::Scene;

use crate::images::{ARITHMETICS, check_agreement, difference, evaluate, render};
use crate::kernels::{OnSmooth, TrianglePoint, TriangleUv, Weighted};
use crate::oracle::{Case, check};
use crate::scenes::{small_parts, small_scene};

/// A ray from the given origin to the point of the triangle with the barycentric coordinates 0.3, 0.5,
/// 0.2.
fn case(name: &str, origin: [f64; 3], corners: [[f64; 3]; 3], length: f64, bounds: (f64, f64)) {
    let single = |x: f64| f64::from(x as f32);
    let [a, b, c] = corners.map(|corner| corner.map(single));
    let origin = origin.map(single);
    let point = [0, 1, 2].map(|i| single(0.3 * a[i] + 0.5 * b[i] + 0.2 * c[i]));
    let to_point = [0, 1, 2].map(|i| point[i] - origin[i]);
    let distance = to_point.iter().fold(0.0_f64, |d, x| d.hypot(*x));
    let direction = to_point.map(|x| single(x / distance));
    let corners = [a, b, c].concat();
    let (value, gradient) = bounds;
    check::<TrianglePoint>(&Case {
        name,
        x: &[&origin[..], &direction, &corners].concat(),
        lengths: &[distance, length / distance, length, length, length],
        value,
        gradient,
    });
    let normals = [0.6, 0.0, 0.8, 0.0, -0.28, 0.96, -0.48, 0.6, 0.64].map(single);
    check::<OnSmooth>(&Case {
        name: &format!("{name}: smooth"),
        x: &[&origin[..], &direction, &corners, &normals].concat(),
        lengths: &[length, length / distance, length, length, length, 1.0, 1.0, 1.0],
        value,
        gradient,
    });
    if length > 1e-18 && length < 1e18 {
        check::<Weighted>(&Case {
            name: &format!("{name}: weight of its normal"),
            x: &corners,
            lengths: &[length; 3],
            value,
            gradient,
        });
    }
    check::<TriangleUv>(&Case {
        name: &format!("{name}: place on a texture"),
        x: &[&point[..], &corners, &[0.0, 0.25, 1.0, 0.5, 0.125, 2.0]].concat(),
        lengths: &[length, length, length, length, 1.0],
        value,
        gradient,
    });
}

const ORIGIN: [f64; 3] = [0.3, 0.4, 2.0];
const CORNERS: [[f64; 3]; 3] = [[-1.0, -0.5, 0.1], [1.2, -0.4, -0.2], [0.1, 1.1, 0.3]];

#[test]
fn ordinary_and_tiny_and_huge() {
    for exponent in [0, -3, -6, -12, -18, -20, 3, 6, 12, 15, 18] {
        let scale = 10.0_f64.powi(exponent);
        let corners = CORNERS.map(|corner| corner.map(|x| x * scale));
        let name = format!("triangle of size 1e{exponent}");
        case(&name, ORIGIN.map(|x| x * scale), corners, scale, (20.0, 30.0));
    }
}

#[test]
fn needles() {
    for exponent in [-3, -6] {
        let width = 10.0_f64.powi(exponent);
        let corners = [[-1.0, -0.5, 0.1], [1.0, 0.5, 0.1], [1.0, 0.5 + width, 0.1 + width]];
        // Rounding the corners to single precision does as much.
        let bounds = (1.0 / width, 20.0 / width);
        case(&format!("needle of aspect 1e{}", -exponent), ORIGIN, corners, width, bounds);
    }
}

#[test]
fn edge_on() {
    for exponent in [-3, -5, -7] {
        let sine = 10.0_f64.powi(exponent);
        let corners = [[-1.0, 0.0, -3.0], [1.0, 0.0, -3.0], [0.1, 0.0, -5.0]];
        let name = format!("triangle seen at 1e{exponent} rad from its plane");
        case(&name, [0.0, 4.0 * sine, 0.0], corners, sine, (10.0, 20.0));
    }
}

/// The small scene with more triangles in its tent.
fn with_triangles(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> Scene {
    let mut parts = small_parts(32);
    let tent = &mut parts.meshes[1];
    tent.vertices.extend(vertices);
    tent.triangles.extend(triangles);
    tent.materials.resize(tent.triangles.len(), 1);
    parts.scene()
}

/// Triangles without area, and those that others cover, change neither image nor gradient.
#[test]
fn triangles_that_show_nothing_change_nothing() {
    let plain = small_scene(32);
    let [a, b] = [0, 2].map(|vertex| plain.meshes()[1].vertices[vertex]);
    let middle = [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]));
    for (name, vertices, triangles) in [
        ("a repeated vertex", vec![], vec![[0, 0, 2], [1, 2, 2], [3, 3, 3]]),
        ("no area", vec![middle], vec![[0, 4, 2], [4, 0, 2]]),
        ("coinciding vertices", vec![a, a, a], vec![[4, 5, 6], [0, 4, 1]]),
    ] {
        let scene = with_triangles(&vertices, &triangles);
        for arithmetic in ARITHMETICS {
            let images = (render(&plain, arithmetic), render(&scene, arithmetic));
            assert_eq!(difference(&images.0, &images.1), 0.0, "{name}, {arithmetic:?}");
            let ((loss, gradient), (other_loss, other_gradient)) =
                (evaluate(&plain, arithmetic), evaluate(&scene, arithmetic));
            assert_eq!(loss, other_loss, "{name}, {arithmetic:?}");
            for ((_, block), (_, other)) in gradient.iter().zip(&other_gradient) {
                let (same, rest) = other.split_at(block.len());
                assert_eq!(block, same, "{name}, {arithmetic:?}");
                assert!(rest.iter().all(|derivative| *derivative == 0.0), "{name}, {arithmetic:?}");
            }
        }
    }
}

/// A fan of triangles at one edge: what others leave in view of it has gradients that agree in every
/// arithmetic.
#[test]
fn many_faces_at_an_edge() {
    let fan: Vec<[f64; 3]> = (0..5)
        .map(|i| (dvec3(0.4, 0.0, 0.6) + dvec3(0.3 * f64::from(i) - 0.8, 0.2, -0.5)).into())
        .collect();
    let triangles: Vec<[u32; 3]> = (0..5).map(|i| [0, 2, 4 + i]).collect();
    let scene = with_triangles(&fan, &triangles);
    check_agreement("five more triangles at an edge", &scene, 1e-4);
    let gradients = ARITHMETICS.map(|arithmetic| {
        let gradient = evaluate(&scene, arithmetic).1;
        let tent = scene.parameter("mesh.tent.vertices").unwrap();
        let vertices = gradient.into_iter().find(|(id, _)| *id == tent);
        vertices.unwrap().1
    });
    let largest = gradients[3].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    for gradient in &gradients {
        for (a, b) in gradient.iter().zip(&gradients[3]) {
            assert!((a - b).abs() <= 1e-4 * largest, "{a} {b}");
        }
        let tips = gradient[3 * 4..].chunks(3);
        let seen = tips.filter(|tip| tip.iter().any(|x| x.abs() > 1e-6 * largest)).count();
        assert!(seen >= 1);
    }
}

/// Triangles of 1e-20 and of 1e15, each alone before a camera that is as far as they are large.
#[test]
fn tiny_and_huge_triangles_are_seen_alike() {
    let plain = small_scene(32);
    for scale in [1e-17, 1e15] {
        let scene = crate::images::placed(&plain, scale, glam::DVec3::ZERO);
        for arithmetic in ARITHMETICS {
            let off_by = difference(&render(&plain, arithmetic), &render(&scene, arithmetic));
            println!("| scene of size {scale:e} | {arithmetic:?} | {off_by:.1e} |");
            assert!(off_by <= 1e-5, "{scale:e}, {arithmetic:?}: {off_by:e}");
        }
        check_agreement(&format!("scene of size {scale:e}"), &scene, 1e-4);
    }
}
