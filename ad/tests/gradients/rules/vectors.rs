//! The rules of vectors.

use ad::Dual;
use ad::rules::*;
use ad::vector::{Vector, Vector3, Xyz};
use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use super::case::{Case, anywhere, apart, call, distinct, not_small, positive, rule};

/// The rules of every vector. The bounds of a generic function could not say that `V` times its
/// scalar is defined, so a macro writes one function for each type.
macro_rules! every_vector {
    ($($name:ident $vector:ty, $scalar:ty;)*) => {$(
        pub fn $name() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $vector;
            vec![
                rule!("neg" anywhere, (a: V) -> V, -a, |g| (-a, V::neg_pullback(&Default::default(), g))),
                rule!("add" anywhere, (a: V, b: V) -> V,
                    a + b, |g| (a + b, <V as AddPullback>::add_pullback(&Default::default(), g))),
                rule!("sub" anywhere, (a: V, b: V) -> V,
                    a - b, |g| (a - b, <V as SubPullback>::sub_pullback(&Default::default(), g))),
                rule!("mul" anywhere, (a: V, b: V) -> V,
                    a * b, |g| (a * b, MulPullback::<V>::mul_pullback(a, b, g))),
                rule!("mul by scalar" anywhere, (a: V, b: S) -> V,
                    a * b, |g| (a * b, MulPullback::<S>::mul_pullback(a, b, g))),
                rule!("div by scalar" not_small, (a: V, b: S) -> V,
                    a / b, |g| (a / b, DivPullback::<S>::div_pullback(a, b, g))),
                rule!("splat" anywhere, (a: S) -> V, V::splat(a), |g| call!(V::splat_vjp(a), g)),
                rule!("element_sum" anywhere, (a: V) -> S,
                    a.element_sum(), |g| call!(a.element_sum_vjp(), g)),
                rule!("min_element" distinct, (a: V) -> S,
                    a.min_element(), |g| call!(a.min_element_vjp(), g)),
                rule!("max_element" distinct, (a: V) -> S,
                    a.max_element(), |g| call!(a.max_element_vjp(), g)),
                rule!("dot" anywhere, (a: V, b: V) -> S, a.dot(b), |g| call!(a.dot_vjp(b), g)),
                rule!("length" not_small, (a: V) -> S, a.length(), |g| call!(a.length_vjp(), g)),
                rule!("length_squared" anywhere, (a: V) -> S,
                    a.length_squared(), |g| call!(a.length_squared_vjp(), g)),
                rule!("length_recip" not_small, (a: V) -> S,
                    a.length_recip(), |g| call!(a.length_recip_vjp(), g)),
                rule!("distance" apart, (a: V, b: V) -> S,
                    a.distance(b), |g| call!(a.distance_vjp(b), g)),
                rule!("distance_squared" anywhere, (a: V, b: V) -> S,
                    a.distance_squared(b), |g| call!(a.distance_squared_vjp(b), g)),
                rule!("normalize" not_small, (a: V) -> V,
                    a.normalize(), |g| call!(a.normalize_vjp(), g)),
                rule!("normalize_or_zero" not_small, (a: V) -> V,
                    a.normalize_or_zero(), |g| call!(a.normalize_or_zero_vjp(), g)),
                rule!("min" apart, (a: V, b: V) -> V, a.min(b), |g| call!(a.min_vjp(b), g)),
                rule!("max" apart, (a: V, b: V) -> V, a.max(b), |g| call!(a.max_vjp(b), g)),
                rule!("clamp" ordered_bounds, (a: V, low: V, high: V) -> V,
                    a.clamp(low, high), |g| call!(a.clamp_vjp(low, high), g)),
                rule!("abs" not_small, (a: V) -> V, a.abs(), |g| call!(a.abs_vjp(), g)),
                rule!("recip" not_small, (a: V) -> V, a.recip(), |g| call!(a.recip_vjp(), g)),
                rule!("exp" anywhere, (a: V) -> V, a.exp(), |g| call!(a.exp_vjp(), g)),
                rule!("sqrt" positive, (a: V) -> V, a.sqrt(), |g| call!(a.sqrt_vjp(), g)),
                rule!("powf" positive, (a: V, b: S) -> V, a.powf(b), |g| call!(a.powf_vjp(b), g)),
                rule!("lerp" anywhere, (a: V, b: V, s: S) -> V,
                    a.lerp(b, s), |g| call!(a.lerp_vjp(b, s), g)),
                rule!("reflect" anywhere, (a: V, n: V) -> V,
                    a.reflect(n), |g| call!(a.reflect_vjp(n), g)),
            ]
        }
    )*};
}

every_vector! {
    vec2 Vec2, f32;
    vec3 Vec3, f32;
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
            vec![
                rule!("new" anywhere, (x: S, y: S, z: S) -> V,
                    V::new(x, y, z), |g| call!(V::new_vjp(x, y, z), g)),
                rule!("x" anywhere, (a: V) -> S, a.x(), |g| call!(a.x_vjp(), g)),
                rule!("y" anywhere, (a: V) -> S, a.y(), |g| call!(a.y_vjp(), g)),
                rule!("z" anywhere, (a: V) -> S, a.z(), |g| call!(a.z_vjp(), g)),
                rule!("cross" anywhere, (a: V, b: V) -> V, a.cross(b), |g| call!(a.cross_vjp(b), g)),
            ]
        }
    )*};
}

vectors_in_space! {
    vec3_in_space Vec3, f32;
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
