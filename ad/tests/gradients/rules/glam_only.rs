//! The operators and constructors that glam's vectors have beyond the trait `Vector`.

use ad::rules::*;
use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec3A, Vec4};

use super::case::{Case, anywhere, functions, not_small, operators, positive};

macro_rules! glam_vectors {
    ($($name:ident $vector:ident $scalar:ident ($($x:ident),*);)*) => {$(
        pub fn $name() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $vector;
            let mut cases = functions! {
                [V] new($($x: S),*) -> V, anywhere;
                element_product(a: V) -> S, anywhere;
                midpoint(a: V, b: V) -> V, anywhere;
                mul_add(a: V, b: V, c: V) -> V, anywhere;
                project_onto(a: V, b: V) -> V, not_small;
                reject_from(a: V, b: V) -> V, not_small;
                project_onto_normalized(a: V, b: V) -> V, anywhere;
                reject_from_normalized(a: V, b: V) -> V, anywhere;
                normalize_or(a: V, b: V) -> V, not_small;
                normalize_and_length(a: V) -> (V, S), not_small;
                saturate(a: V) -> V, off_integers;
                step(a: V, b: V) -> V, between_integers;
                sin(a: V) -> V, anywhere;
                cos(a: V) -> V, anywhere;
                sin_cos(a: V) -> (V, V), anywhere;
                ln(a: V) -> V, positive;
                log2(a: V) -> V, positive;
                exp2(a: V) -> V, anywhere;
                copysign(a: V, b: V) -> V, off_integers;
                rem_euclid(a: V, b: V) -> V, off_multiples;
                div_euclid(a: V, b: V) -> V, off_multiples;
                dot_into_vec(a: V, b: V) -> V, anywhere;
                lerp_monotonic(a: V, b: V, s: S) -> V, anywhere;
                smoothstep(a: V, b: V, c: V) -> V, between_edges;
                clamp_length_min(a: V, b: S) -> V, long;
                clamp_length_max(a: V, b: S) -> V, long;
                move_towards(a: V, b: V, s: S) -> V, on_the_way;
                signum(a: V) -> V, off_integers;
                floor(a: V) -> V, off_integers;
                ceil(a: V) -> V, off_integers;
                round(a: V) -> V, off_integers;
                trunc(a: V) -> V, off_integers;
                fract(a: V) -> V, off_integers;
                fract_gl(a: V) -> V, off_integers;
            };
            cases.extend(operators! {
                S * V -> V, anywhere;
                V / V -> V, not_small;
                S / V -> V, not_small;
                V + S -> V, anywhere;
                S + V -> V, anywhere;
                V - S -> V, anywhere;
                S - V -> V, anywhere;
                V % V -> V, positive_off_multiples;
                V % S -> V, off_multiples_of_one;
            });
            cases
        }
    )*};
}

glam_vectors! {
    single2 Vec2 f32 (x, y);
    single3 Vec3 f32 (x, y, z);
    aligned3 Vec3A f32 (x, y, z);
    single4 Vec4 f32 (x, y, z, w);
    double2 DVec2 f64 (x, y);
    double3 DVec3 f64 (x, y, z);
    double4 DVec4 f64 (x, y, z, w);
}

fn off_integers(x: &mut [f64]) -> bool {
    x.iter_mut().for_each(|x| *x = x.floor() + 0.25);
    true
}

/// The same, and the second numbers are not near to the first ones.
fn between_integers(x: &mut [f64]) -> bool {
    let n = x.len() / 2;
    off_integers(x);
    x[n..].iter_mut().for_each(|x| *x += 0.5);
    true
}

/// The first numbers are not near to multiples of the other ones.
fn off_multiples(x: &mut [f64]) -> bool {
    let n = x.len() / 2;
    (0..n).for_each(|i| x[i] = (x[i].floor() + 0.3) * x[n + i]);
    x[n..].iter().all(|x| x.abs() > 0.05)
}

/// The magnitudes of the first two numbers differ.
fn elements_apart(x: &mut [f64]) -> bool {
    (x[0].abs() - x[1].abs()).abs() > 0.1
}

/// The same, and none is negative: for these glam's `%` takes the quotient to the lower integer where a vector
/// is a register, else to that nearer to 0.
fn positive_off_multiples(x: &mut [f64]) -> bool {
    let is_off = off_multiples(x);
    x.iter_mut().for_each(|x| *x = x.abs());
    is_off
}

/// The same for multiples of the last number.
fn off_multiples_of_one(x: &mut [f64]) -> bool {
    let (by, x) = x.split_last_mut().unwrap();
    *by = by.abs();
    x.iter_mut().for_each(|x| *x = (x.floor().abs() + 0.3) * *by);
    *by > 0.3
}

/// The first edges are below the other ones, and the numbers are not near to either.
fn between_edges(x: &mut [f64]) -> bool {
    let n = x.len() / 3;
    (0..n).for_each(|i| x[2 * n + i] = x[n + i] + 0.5 + x[2 * n + i].abs());
    (0..n).all(|i| (x[i] - x[n + i]).abs() > 0.05 && (x[i] - x[2 * n + i]).abs() > 0.05)
}

/// The length of the vector, the first inputs, is not near to the last input, which is positive.
fn long(x: &mut [f64]) -> bool {
    let (bound, vector) = x.split_last_mut().unwrap();
    *bound = bound.abs() + 0.2;
    let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    length > 0.2 && (length - *bound).abs() > 0.1
}

/// The two points are farther apart than the last input, which is positive.
fn on_the_way(x: &mut [f64]) -> bool {
    let (way, points) = x.split_last_mut().unwrap();
    *way = way.abs() + 0.1;
    let (a, b) = points.split_at(points.len() / 2);
    let apart = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
    apart > *way + 0.2
}

macro_rules! plane_and_four {
    ($($plane:ident $four:ident $scalar:ident $v2:ident $v3:ident $v4:ident;)*) => {$(
        pub fn $plane() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $v2;
            type W = $v3;
            functions! {
                [V] from_angle(a: S) -> V, anywhere;
                to_angle(a: V) -> S, not_small;
                angle_to(a: V, b: V) -> S, off_the_cut;
                perp(a: V) -> V, anywhere;
                perp_dot(a: V, b: V) -> S, anywhere;
                rotate(a: V, b: V) -> V, anywhere;
                rotate_angle(a: V, b: S) -> V, anywhere;
                rotate_towards(a: V, b: V, s: S) -> V, by_a_tenth;
                extend(a: V, z: S) -> W, anywhere;
                with_y(a: V, y: S) -> V, anywhere;
            }
        }

        pub fn $four() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $v3;
            type W = $v4;
            functions! {
                truncate(a: W) -> V, anywhere;
                with_w(a: W, w: S) -> W, anywhere;
                project(a: W) -> V, not_small;
            }
        }
    )*};
}

plane_and_four! {
    single_plane single_four f32 Vec2 Vec3 Vec4;
    double_plane double_four f64 DVec2 DVec3 DVec4;
}

macro_rules! space {
    ($($space:ident $scalar:ident $v2:ident $v3:ident $v4:ident;)*) => {$(
        pub fn $space() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type U = $v2;
            type V = $v3;
            type W = $v4;
            functions! {
                angle_between(a: V, b: V) -> S, not_small;
                any_orthogonal_vector(a: V) -> V, elements_apart;
                any_orthonormal_vector(a: V) -> V, not_small;
                any_orthonormal_pair(a: V) -> (V, V), not_small;
                [V] from_homogeneous(a: W) -> V, not_small;
                to_homogeneous(a: V) -> W, anywhere;
                rotate_x(a: V, b: S) -> V, anywhere;
                rotate_y(a: V, b: S) -> V, anywhere;
                rotate_z(a: V, b: S) -> V, anywhere;
                rotate_axis(a: V, b: V, c: S) -> V, about_an_axis;
                angle_to(a: V, b: V, c: V) -> S, around_an_axis;
                rotate_towards(a: V, b: V, s: S) -> V, by_a_tenth;
                slerp(a: V, b: V, s: S) -> V, apart;
                extend(a: V, w: S) -> W, anywhere;
                truncate(a: V) -> U, anywhere;
                with_z(a: V, z: S) -> V, anywhere;
            }
        }
    )*};
}

space! {
    single_space f32 Vec2 Vec3 Vec4;
    aligned_space f32 Vec2 Vec3A Vec4;
    double_space f64 DVec2 DVec3 DVec4;
}

/// The angle from the first vector to the second is not near to a half turn.
fn off_the_cut(x: &mut [f64]) -> bool {
    not_small(x) && (x[0] * x[2] + x[1] * x[3] > 0.1 || (x[0] * x[3] - x[1] * x[2]).abs() > 0.3)
}

/// The second vector, an axis, has length 1.
fn about_an_axis(x: &mut [f64]) -> bool {
    let length = x[3..6].iter().map(|x| x * x).sum::<f64>().sqrt();
    x[3..6].iter_mut().for_each(|x| *x /= length);
    length > 0.1
}

/// The same for the third vector, with the angle about it far from a half turn.
fn around_an_axis(x: &mut [f64]) -> bool {
    let length = x[6..].iter().map(|x| x * x).sum::<f64>().sqrt();
    x[6..].iter_mut().for_each(|x| *x /= length);
    length > 0.1 && (0..3).map(|i| x[i] * x[3 + i]).sum::<f64>() > 0.1
}

/// The two vectors are neither short nor near to one line.
fn apart(x: &mut [f64]) -> bool {
    let n = x.len() / 2;
    let dot = |i: usize, j: usize| (0..n).map(|k| x[i * n + k] * x[j * n + k]).sum::<f64>();
    let (a, b) = (dot(0, 0), dot(1, 1));
    a.min(b) > 0.1 && dot(0, 1).powi(2) < 0.8 * a * b
}

/// The same, and the angle is short, in either direction.
fn by_a_tenth(x: &mut [f64]) -> bool {
    let (angle, vectors) = x.split_last_mut().unwrap();
    *angle = 0.1_f64.copysign(*angle) + 0.01 * *angle;
    apart(vectors)
}
