//! The rules of vectors.

use ad::Dual;
use ad::rules::*;
use ad::vector::{Vector, Vector3, Xyz};
use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec3A, Vec4};

use super::case::{
    Case, anywhere, apart, distinct, functions, negative, not_small, operators, positive,
};

/// The rules of every vector. The bounds of a generic function could not say that `V` times its
/// scalar is defined, so a macro writes one function for each type.
macro_rules! every_vector {
    ($($name:ident $vector:ty, $scalar:ty;)*) => {$(
        pub fn $name() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $vector;
            let mut cases = functions! {
                [V] splat(a: S) -> V, anywhere;
                element_sum(a: V) -> S, anywhere;
                min_element(a: V) -> S, distinct;
                max_element(a: V) -> S, distinct;
                dot(a: V, b: V) -> S, anywhere;
                length(a: V) -> S, not_small;
                length_squared(a: V) -> S, anywhere;
                length_recip(a: V) -> S, not_small;
                distance(a: V, b: V) -> S, apart;
                distance_squared(a: V, b: V) -> S, anywhere;
                normalize(a: V) -> V, not_small;
                normalize_or_zero(a: V) -> V, not_small;
                min(a: V, b: V) -> V, apart;
                max(a: V, b: V) -> V, apart;
                clamp(a: V, low: V, high: V) -> V, ordered_bounds;
                abs(a: V) -> V, not_small;
                recip(a: V) -> V, not_small;
                exp(a: V) -> V, anywhere;
                sqrt(a: V) -> V, positive;
                powf(a: V, b: S) -> V, positive;
                lerp(a: V, b: V, s: S) -> V, anywhere;
                reflect(a: V, n: V) -> V, anywhere;
            };
            cases.extend(operators! {
                V + V -> V, anywhere;
                V - V -> V, anywhere;
                V * V -> V, anywhere;
                V * S -> V, anywhere;
                V / S -> V, not_small;
            });
            cases.push(negative::<S, V>());
            cases
        }
    )*};
}

every_vector! {
    vec2 Vec2, f32;
    vec3 Vec3, f32;
    vec3a Vec3A, f32;
    vec4 Vec4, f32;
    dvec2 DVec2, f64;
    dvec3 DVec3, f64;
    dvec4 DVec4, f64;
    xyz Xyz<f64>, f64;
    xyz_of_duals Xyz<Dual<f64>>, Dual<f64>;
}

/// The rules of vectors in space.
macro_rules! vectors_in_space {
    ($($name:ident $vector:ty, $scalar:ty;)*) => {$(
        pub fn $name() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $vector;
            functions! {
                [V] new(x: S, y: S, z: S) -> V, anywhere;
                x(a: V) -> S, anywhere;
                y(a: V) -> S, anywhere;
                z(a: V) -> S, anywhere;
                cross(a: V, b: V) -> V, anywhere;
            }
        }
    )*};
}

vectors_in_space! {
    vec3_in_space Vec3, f32;
    vec3a_in_space Vec3A, f32;
    dvec3_in_space DVec3, f64;
    xyz_in_space Xyz<f64>, f64;
    xyz_of_duals_in_space Xyz<Dual<f64>>, Dual<f64>;
}

/// Three vectors: the second and third become lower and upper bounds of the first, off the kinks.
fn ordered_bounds(x: &mut [f64]) -> bool {
    let n = x.len() / 3;
    for i in 0..n {
        let (a, b) = (x[n + i], x[2 * n + i]);
        (x[n + i], x[2 * n + i]) = (a.min(b) - 0.2, a.max(b) + 0.2);
        for bound in [x[n + i], x[2 * n + i]] {
            if (x[i] - bound).abs() < 0.1 {
                x[i] += 0.3;
            }
        }
    }
    (0..n).all(|i| [n, 2 * n].iter().all(|at| (x[i] - x[at + i]).abs() >= 0.1))
}
