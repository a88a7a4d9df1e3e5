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
                    a + b, |g| (a + b, <V as AddPullback<S>>::add_pullback(&Default::default(), g))),
                rule!("scalar + vector" anywhere, (a: S, b: V) -> V,
                    a + b, |g| (a + b, <S as AddPullback<V>>::add_pullback(&Default::default(), g))),
                rule!("vector - scalar" anywhere, (a: V, b: S) -> V,
                    a - b, |g| (a - b, <V as SubPullback<S>>::sub_pullback(&Default::default(), g))),
                rule!("scalar - vector" anywhere, (a: S, b: V) -> V,
                    a - b, |g| (a - b, <S as SubPullback<V>>::sub_pullback(&Default::default(), g))),
                rule!("element_product" anywhere, (a: V) -> S,
                    a.element_product(), |g| call!(a.element_product_vjp(), g)),
                rule!("midpoint" anywhere, (a: V, b: V) -> V,
                    a.midpoint(b), |g| call!(a.midpoint_vjp(b), g)),
                rule!("mul_add" anywhere, (a: V, b: V, c: V) -> V,
                    a.mul_add(b, c), |g| call!(a.mul_add_vjp(b, c), g)),
                rule!("project_onto" not_small, (a: V, b: V) -> V,
                    a.project_onto(b), |g| call!(a.project_onto_vjp(b), g)),
                rule!("signum" off_integers, (a: V) -> V, a.signum(), |g| call!(a.signum_vjp(), g)),
                rule!("floor" off_integers, (a: V) -> V, a.floor(), |g| call!(a.floor_vjp(), g)),
                rule!("ceil" off_integers, (a: V) -> V, a.ceil(), |g| call!(a.ceil_vjp(), g)),
                rule!("round" off_integers, (a: V) -> V, a.round(), |g| call!(a.round_vjp(), g)),
                rule!("trunc" off_integers, (a: V) -> V, a.trunc(), |g| call!(a.trunc_vjp(), g)),
                rule!("fract" off_integers, (a: V) -> V, a.fract(), |g| call!(a.fract_vjp(), g)),
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

fn off_integers(x: &mut [f64]) -> bool {
    x.iter_mut().for_each(|x| *x = x.floor() + 0.25);
    true
}
