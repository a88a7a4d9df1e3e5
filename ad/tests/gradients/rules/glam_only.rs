//! The operators and constructors that glam's vectors have beyond the trait `Vector`.

use ad::rules::*;
use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use super::case::{Case, anywhere, functions, not_small, operators};

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
                normalize_or(a: V, b: V) -> V, not_small;
                signum(a: V) -> V, off_integers;
                floor(a: V) -> V, off_integers;
                ceil(a: V) -> V, off_integers;
                round(a: V) -> V, off_integers;
                trunc(a: V) -> V, off_integers;
                fract(a: V) -> V, off_integers;
            };
            cases.extend(operators! {
                S * V -> V, anywhere;
                V / V -> V, not_small;
                S / V -> V, not_small;
                V + S -> V, anywhere;
                S + V -> V, anywhere;
                V - S -> V, anywhere;
                S - V -> V, anywhere;
            });
            cases
        }
    )*};
}

glam_vectors! {
    single2 Vec2 f32 (x, y);
    single3 Vec3 f32 (x, y, z);
    single4 Vec4 f32 (x, y, z, w);
    double2 DVec2 f64 (x, y);
    double3 DVec3 f64 (x, y, z);
    double4 DVec4 f64 (x, y, z, w);
}

fn off_integers(x: &mut [f64]) -> bool {
    x.iter_mut().for_each(|x| *x = x.floor() + 0.25);
    true
}
