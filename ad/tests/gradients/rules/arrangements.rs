//! Swizzles, arrays of vectors and matrices, functions that make vectors.

use ad::{Differentiable, differentiable};
use glam::{
    DMat3, DMat4, DQuat, DVec2, DVec3, DVec4, EulerRot, Mat3, Quat, Vec2Swizzles, Vec3, Vec3A,
    Vec3Swizzles, Vec4Swizzles, dvec2, dvec3, dvec4,
};

use crate::oracle::{assert_gradient, check};

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

/// Elements more than once, and none; by name, and beside methods of a type of one's own that are called so.
#[differentiable]
fn swizzled_again(x: f64, y: f64) -> f64 {
    let v = dvec3(x, y, x * y);
    let u = DVec2::xyxx(v.yz());
    let doubled = [v, v.zzx() * y].map(DVec3::yyx);
    let own = Own { x, y };
    u.dot(v.xxzy()) + u.wwzx().yyw().dot(doubled[0].xxx() + doubled[1]) * own.xy() - own.yx()
}

#[derive(Clone, Copy, Differentiable)]
struct Own {
    x: f64,
    y: f64,
}

#[differentiable]
impl Own {
    fn xy(self) -> f64 {
        self.x * self.y * self.y
    }

    fn yx(&self) -> f64 {
        self.x - 3.0 * self.y
    }
}

/// What chooses between vectors, inverts where it can, and reads columns and rows.
#[differentiable]
fn chosen(x: f64, y: f64) -> f64 {
    let v = dvec3(x, y, x * y);
    let chosen = DVec3::select(v.cmplt(dvec3(y, x, 0.5)), v * x, v.yzx());
    let four = DVec4::select(v.extend(y).cmpgt(DVec4::ZERO), v.extend(x), DVec4::splat(y));
    let numbers = [x, y, 1.0, y * y, x, 2.0, 0.5, x * y, 3.0, y];
    let (columns, rows) = (DMat3::from_cols_slice(&numbers), DMat3::from_rows_slice(&numbers[1..]));
    let Some(inverse) = columns.try_inverse() else { return x };
    let none = DMat3::from_diagonal(dvec3(x, y, 0.0));
    let nothing = none.try_inverse().map_or(x * y, |inverse| inverse.x_axis.x);
    (inverse * rows * chosen).dot(four.truncate()) + none.inverse_or_zero().x_axis.x + nothing
}

/// Aligned vectors among others.
#[differentiable]
fn aligned(x: f32, y: f32) -> f32 {
    let mut v = Vec3A::new(x, y, x * y).with_z(2.0);
    v.x *= y;
    let turned = Quat::from_rotation_z(x) * v.zxy() + Mat3::from_diagonal(v.to_vec3()) * v;
    let read = Vec3A::from_slice(&[y, x, 1.0]) + Vec3A::from(Vec3::new(x, 1.0, y));
    let far = v.as_dvec3().as_vec3a() + turned.xyz().normalize().abs() % 4.0;
    let chosen = Vec3A::select(v.cmplt(read), v, read.cross(v));
    far.dot(chosen.map(|x| x * x))
        + Vec3A::from_vec4(turned.extend(x)).y
        + v[1] * turned.to_array()[2]
}

/// To single precision and back, exactly.
#[differentiable]
fn rounded(x: f64, y: f64) -> f64 {
    let v = dvec3(x, y, 1.0).as_vec3();
    let turn = DMat3::from_cols(dvec3(x, 1.0, 0.5), v.as_dvec3(), DVec3::X).as_mat3();
    (turn * v).as_dvec3().dot(dvec3(1.0, 2.0, x))
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

/// Numbers of slices, and conversions of quaternions and to double precision.
#[differentiable]
fn read(x: f64, y: f64) -> f64 {
    let numbers = [x, y, x * y, 1.0, y * y];
    let v = DVec3::from_slice(&numbers[1..]);
    let q = DQuat::from_slice(&numbers);
    let single = Vec3::new(x as f32, 2.0, y as f32);
    let double = DVec3::from(single);
    v.dot(q * v) * DVec4::from(q).z + double.x * double.z
}

/// The references that a program takes.
#[differentiable]
fn turned(x: f64, y: f64) -> f64 {
    let turn = DMat3::from_euler(EulerRot::YXZ, x, y, x * y);
    let both =
        turn.mul_mat3(&DMat3::from_cols_array_2d(&[[x, 1.0, y], [0.0, y, 1.0], [2.0, 0.0, x]]));
    let q = DQuat::from_mat3(&turn);
    let (scale, again, _) = DMat4::from_quat(q).to_scale_rotation_translation();
    let same = DQuat::from_mat4(&DMat4::from_quat(again));
    both.row(1).dot(scale * x) + same.x * q.w + both.to_cols_array_2d()[2][0]
}

/// The same in double precision, for differences.
fn unaligned(x: &[f64]) -> f64 {
    let (x, y) = (x[0], x[1]);
    let v = dvec3(x * y, y, 2.0);
    let turned = DQuat::from_rotation_z(x) * v.zxy() + DMat3::from_diagonal(v) * v;
    let read = dvec3(y, x, 1.0) + dvec3(x, 1.0, y);
    let far = v + turned.normalize().abs() % 4.0;
    let chosen = DVec3::select(v.cmplt(read), v, read.cross(v));
    far.dot(chosen * chosen) + turned.y + v.y * turned.z
}

#[test]
fn aligned_vectors() {
    for [x, y] in [[1.25_f32, 0.5], [-0.75, 1.125], [0.5, -1.5]] {
        let (_, by_both) = aligned::value_and_grad(x, y);
        let expected = ad::check::gradient(unaligned, &[x.into(), y.into()], 0.02);
        let expected: Vec<_> = expected.iter().map(|estimate| estimate.value).collect();
        let [along_x, along_y] = [(1.0, 0.0), (0.0, 1.0)].map(|(u, v)| aligned::jvp(x, y, u, v).1);
        for (reverse, forward, expected) in
            [(by_both.0, along_x, expected[0]), (by_both.1, along_y, expected[1])]
        {
            let bound = 1e-4 * expected.abs().max(1.0);
            assert!((f64::from(reverse) - expected).abs() < bound, "{reverse} {expected}");
            assert!((f64::from(forward) - expected).abs() < bound, "{forward} {expected}");
        }
    }
}

#[test]
fn precisions() {
    let [x, y] = [1.25, -0.5];
    let (_, by_both) = rounded::value_and_grad(x, y);
    let in_double = |x: &[f64]| {
        let v = dvec3(x[0], x[1], 1.0);
        (DMat3::from_cols(dvec3(x[0], 1.0, 0.5), v, DVec3::X) * v).dot(dvec3(1.0, 2.0, x[0]))
    };
    assert_gradient("rounded", in_double, &[x, y], &[by_both.0, by_both.1]);
    assert_eq!(rounded::jvp(x, y, 1.0, 0.0).1, by_both.0);
}

#[test]
fn parts_of_slices_and_turns() {
    check!(turned(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    let x = [1.25, -0.5];
    let (_, (by_x, by_y)) = read::value_and_grad(x[0], x[1]);
    // What passes through single precision has no finite differences.
    let (_, by_x_forward) = read::jvp(x[0], x[1], 1.0, 0.0);
    let (_, by_y_forward) = read::jvp(x[0], x[1], 0.0, 1.0);
    assert!((by_x - by_x_forward).abs() < 1e-12 && (by_y - by_y_forward).abs() < 1e-12);
    let in_double = |x: &[f64]| {
        let v = DVec3::new(x[1], x[0] * x[1], 1.0);
        let q = DQuat::from_xyzw(x[0], x[1], x[0] * x[1], 1.0);
        v.dot(q * v) * q.z + x[0] * x[1]
    };
    assert_gradient("read", in_double, &x, &[by_x, by_y]);
}

#[test]
fn arrangements() {
    check!(to_arrays(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(from_arrays(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(functions(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(swizzled(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(swizzled_again(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(chosen(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(replaced(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(columns(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
}

/// Arrays of elements, mapped without a name; directions where there are any.
#[differentiable]
fn mapped(x: f64, y: f64) -> f64 {
    let v = DVec3::new(x, y, x * y);
    let squares = (v * y).to_array().map(|x| x * x);
    let Some(direction) = (v - DVec3::new(squares[1], 0.0, 0.5)).try_normalize() else {
        return squares[0];
    };
    DVec3::from(v.to_array().map(f64::sin)).dot(direction) * squares[2]
}

#[differentiable]
fn undirected(x: f64, y: f64) -> f64 {
    let v = DVec3::splat((x - y) * (y - x)) * 0.0;
    match v.try_normalize() {
        Some(direction) => direction.x,
        None => x * y,
    }
}

#[test]
fn arrays_and_directions() {
    check!(mapped(x, y) at [1.3, 0.4], [-0.7, 1.1], [0.6, -1.9]);
    check!(undirected(x, y) at [1.3, 0.4]);
}

/// Where both edges are one, too.
#[differentiable]
fn stepped(x: f64, y: f64) -> f64 {
    let v = DVec3::new(x, y, x * y);
    let steps = v.smoothstep(DVec3::ZERO, DVec3::new(2.0, 0.0, 1.0));
    steps.element_sum() * x + DVec3::new(x, 2.0, -y).saturate().element_sum()
}

#[test]
fn steps_beyond_their_edges() {
    check!(stepped(x, y) at [0.7, 0.4], [-0.7, 1.1], [1.6, -1.9]);
}
