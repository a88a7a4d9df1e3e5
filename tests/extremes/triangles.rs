//! Triangles that are thin, tiny, huge, or seen along their plane.

use crate::kernels::{TriangleSurface, TriangleUv};
use crate::oracle::{Case, check};

/// A ray from the given origin to the point of the triangle with the barycentric coordinates 0.3, 0.5,
/// 0.2.
fn case(
    name: &str,
    origin: [f64; 3],
    corners: [[f64; 3]; 3],
    length: f64,
    bounds: (f64, f64),
) {
    let single = |x: f64| f64::from(x as f32);
    let [a, b, c] = corners.map(|corner| corner.map(single));
    let origin = origin.map(single);
    let point = [0, 1, 2].map(|i| single(0.3 * a[i] + 0.5 * b[i] + 0.2 * c[i]));
    let to_point = [0, 1, 2].map(|i| point[i] - origin[i]);
    let distance = to_point.iter().fold(0.0_f64, |d, x| d.hypot(*x));
    let direction = to_point.map(|x| single(x / distance));
    let corners = [a, b, c].concat();
    let (value, gradient) = bounds;
    check::<TriangleSurface>(&Case {
        name,
        x: &[&origin[..], &direction, &corners].concat(),
        lengths: &[distance, length / distance, length, length, length],
        value,
        gradient,
    });
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
