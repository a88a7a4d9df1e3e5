//! The operators and constructors that glam's vectors have beyond the trait `Vector`.

use ad::rules::*;
use glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec4};

use super::case::{Case, anywhere, call, not_small, rule};

macro_rules! operators {
    ($($name:ident $vector:ident $scalar:ident ($($x:ident),*);)*) => {$(
        pub fn $name() -> Vec<Case<$scalar>> {
            type S = $scalar;
            type V = $vector;
            vec![
                rule!("scalar * vector" anywhere, (a: S, b: V) -> V,
                    a * b, |g| (a * b, a.mul_pullback(b, g))),
                rule!("vector / vector" not_small, (a: V, b: V) -> V,
                    a / b, |g| (a / b, a.div_pullback(b, g))),
                rule!("scalar / vector" not_small, (a: S, b: V) -> V,
                    a / b, |g| (a / b, a.div_pullback(b, g))),
                rule!("vector + scalar" anywhere, (a: V, b: S) -> V,
                    a + b, |g| (a + b, <V as AddPullback<S>>::add_pullback(g))),
                rule!("scalar + vector" anywhere, (a: S, b: V) -> V,
                    a + b, |g| (a + b, <S as AddPullback<V>>::add_pullback(g))),
                rule!("vector - scalar" anywhere, (a: V, b: S) -> V,
                    a - b, |g| (a - b, <V as SubPullback<S>>::sub_pullback(g))),
                rule!("scalar - vector" anywhere, (a: S, b: V) -> V,
                    a - b, |g| (a - b, <S as SubPullback<V>>::sub_pullback(g))),
                operators!(@new $scalar $vector ($($x),*)),
            ]
        }
    )*};
    (@new $scalar:ident $vector:ident ($($x:ident),*)) => {
        rule!("new" anywhere, ($($x: $scalar),*) -> $vector,
            $vector::new($($x),*), |g| call!(<$vector>::new_vjp($($x),*), g))
    };
}

operators! {
    single2 Vec2 f32 (x, y);
    single3 Vec3 f32 (x, y, z);
    single4 Vec4 f32 (x, y, z, w);
    double2 DVec2 f64 (x, y);
    double3 DVec3 f64 (x, y, z);
    double4 DVec4 f64 (x, y, z, w);
}
