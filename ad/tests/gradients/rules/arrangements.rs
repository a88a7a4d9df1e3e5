//! Swizzles, arrays of vectors and matrices, functions that make vectors.

use ad::differentiable;
use glam::{DMat3, DVec3, Vec2Swizzles, Vec3Swizzles, Vec4Swizzles, dvec2, dvec3, dvec4};

use crate::oracle::check;

#[differentiable]
fn to_arrays(x: f64, y: f64) -> f64 {
    let v = DVec3::new(x, y, x * y);
    let a = v.to_array();
    let b = <[f64; 3]>::from(v * x);
    a[0] * a[2] + b[1] * a[1]
}

#[differentiable]
fn from_arrays(x: f64, y: f64) -> f64 {
    let v = DVec3::from_array([x, y, x * y]);
    let w = DVec3::from([y, x, 1.0]);
    v.dot(w) * v.x
}

#[differentiable]
fn functions(x: f64, y: f64) -> f64 {
    let v = dvec3(x, y, x * y);
    let w = dvec2(x, 2.0);
    let u = glam::dvec4(1.0, x, y, x * x);
    v.z * w.length() + u.z * u.w
}

#[differentiable]
fn swizzled(x: f64, y: f64) -> f64 {
    let v = dvec3(x, y, x * y);
    let w = v.zyx();
    let u = v.xy();
    w.x * u.y
        + w.dot(v) * v.yz().x
        + v.xz().element_sum()
        + dvec4(x, y, 1.0, x).xyw().length_squared() * dvec2(x, y).yx().x
}

#[differentiable]
fn replaced(x: f64, y: f64) -> f64 {
    let v = dvec3(x, y, x * y).with_x(y * y);
    let u = v.with_z(1.0);
    v.x * v.y + v.z * u.x
}

#[differentiable]
fn columns(x: f64, y: f64) -> f64 {
    let m = DMat3::from_cols_array(&[x, y, 1.0, y, x, x * y, 0.0, 2.0, x]);
    let a = m.to_cols_array();
    m.determinant() * a[5] + a[0]
}

#[test]
fn arrangements() {
    check!(to_arrays(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(from_arrays(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(functions(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(swizzled(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(replaced(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(columns(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
}
