//! Bundle adjustment: where cameras see points.

use std::path::Path;

use ad::{Differentiable, differentiable};
use glam::{DVec2, DVec3};

use crate::Comparison;
use crate::read::{Numbers, reference};

#[derive(Clone, Copy, Differentiable)]
struct Camera {
    rotation: DVec3,
    center: DVec3,
    focal: f64,
    principal: DVec2,
    distortion: [f64; 2],
}

/// Turns a point about an axis, by its length as an angle.
#[differentiable]
fn rotated(axis: DVec3, point: DVec3) -> DVec3 {
    let square = axis.length_squared();
    if square == 0.0 {
        return point + axis.cross(point);
    }
    let angle = square.sqrt();
    let (sin, cos) = angle.sin_cos();
    let unit = axis / angle;
    point * cos + unit.cross(point) * sin + unit * (unit.dot(point) * (1.0 - cos))
}

#[differentiable]
fn error(camera: Camera, point: DVec3, weight: f64, seen: DVec2) -> DVec2 {
    let p = rotated(camera.rotation, point - camera.center);
    let flat = p.truncate() / p.z;
    let square = flat.length_squared();
    let [k1, k2] = camera.distortion;
    let distorted = flat * (1.0 + k1 * square + k2 * square * square);
    (distorted * camera.focal + camera.principal - seen) * weight
}

#[differentiable]
fn weight_error(weight: f64) -> f64 {
    1.0 - weight * weight
}

pub fn compare(input: &Path) -> Comparison {
    let mut numbers = Numbers::of_file(input);
    // All cameras are the same one, and so are points, weights and what is seen.
    let [_, _, observations] = numbers.sizes();
    let (c, x) = (numbers.take(11), numbers.take(3));
    let (w, seen) = (numbers.take(1)[0], numbers.take(2));
    let camera = Camera {
        rotation: DVec3::from_slice(&c),
        center: DVec3::from_slice(&c[3..]),
        focal: c[6],
        principal: DVec2::from_slice(&c[7..]),
        distortion: [c[9], c[10]],
    };
    let (point, seen) = (DVec3::from_slice(&x), DVec2::from_slice(&seen));
    let mut derivatives = Vec::new();
    for _ in 0..observations {
        for row in [DVec2::X, DVec2::Y] {
            let (_, pullback) = error::vjp(camera, point, w, seen);
            let (by_camera, by_point, by_weight, _) = pullback(row);
            derivatives.extend(by_camera.rotation.to_array());
            derivatives.extend(by_camera.center.to_array());
            derivatives.push(by_camera.focal);
            derivatives.extend(by_camera.principal.to_array());
            derivatives.extend(by_camera.distortion);
            derivatives.extend(by_point.to_array());
            derivatives.push(by_weight);
        }
    }
    derivatives.extend((0..observations).map(|_| weight_error::grad(w)));
    Comparison {
        value: error(camera, point, w, seen).x,
        derivatives,
        expected_value: reference(input, "reproj_err")[0],
        expected: reference(input, "vals"),
    }
}
