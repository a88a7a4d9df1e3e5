//! The rules that forward mode has of its own, against the pullbacks: `<w, J v> = <J^T w, v>`.

use ad::check::Coordinates;
use ad::rules::*;
use ad::vector::{Vector3, Xyz};
use ad::{Additive, Differentiable};
use glam::{DVec2, DVec3, DVec4};

use crate::oracle::assert_close;

/// Numbers between -1.5 and 1.5, of which few are alike.
fn numbers(seed: usize) -> impl Iterator<Item = f64> {
    (0..).map(move |k: usize| 1.5 * ((k + 1) as f64 * 1.7 + seed as f64 * 0.61).sin())
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Compares both modes of a function at some points, along some directions.
#[track_caller]
fn compare<A, R>(
    name: &str,
    like: A,
    reverse: impl Fn(A, R) -> (R, A),
    forward: impl Fn(A, A) -> (R, R),
) where
    A: Coordinates + Copy,
    R: Coordinates + Copy,
{
    for seed in 0..8 {
        let at = |seed| like.read(&mut numbers(seed));
        let (x, direction) = (at(seed), at(seed + 100));
        let (value, tangent) = forward(x, direction);
        let cotangent = value.read(&mut numbers(seed + 200));
        let (returned, gradient) = reverse(x, cotangent);
        assert_eq!(value.coordinates(), returned.coordinates(), "{name}");
        let pushed = product(&tangent.coordinates(), &cotangent.coordinates());
        let pulled = product(&gradient.coordinates(), &direction.coordinates());
        assert_close(name, pushed, pulled, 1e-10);
    }
}

/// An operator between two types.
macro_rules! operators {
    ($($left:expr, $right:expr => $($trait:ident $operator:tt $pullback:ident $jvp:ident),*;)*) => {$(
        $({
            let like = ($left, $right);
            compare(
                stringify!($jvp $left, $right),
                like,
                |(a, b), g| (a $operator b, $trait::$pullback(a, b, g)),
                |(a, b), (a_dot, b_dot)| $trait::$jvp(a, b, a_dot, b_dot),
            );
        })*
    )*};
}

/// The same, of operators whose pullbacks need no operands.
macro_rules! linear_operators {
    ($($left:expr, $right:expr;)*) => {$(
        compare(
            stringify!($left + $right),
            ($left, $right),
            |(a, b), g| (a + b, of_sum(&a, &b, g)),
            |(a, b), (a_dot, b_dot)| a.add_jvp(b, a_dot, b_dot),
        );
        compare(
            stringify!($left - $right),
            ($left, $right),
            |(a, b), g| (a - b, of_difference(&a, &b, g)),
            |(a, b), (a_dot, b_dot)| a.sub_jvp(b, a_dot, b_dot),
        );
    )*};
}

fn of_sum<A: AddPullback<B>, B: Differentiable>(
    _: &A,
    _: &B,
    g: ad::Tangent<<A as core::ops::Add<B>>::Output>,
) -> (A::Tangent, B::Tangent) {
    A::add_pullback(&Default::default(), g)
}

fn of_difference<A: SubPullback<B>, B: Differentiable>(
    _: &A,
    _: &B,
    g: ad::Tangent<<A as core::ops::Sub<B>>::Output>,
) -> (A::Tangent, B::Tangent) {
    A::sub_pullback(&Default::default(), g)
}

#[test]
fn operators() {
    let v = DVec3::ONE;
    operators! {
        1.0, 1.0 => MulPullback * mul_pullback mul_jvp, DivPullback / div_pullback div_jvp,
            RemPullback % rem_pullback rem_jvp;
        v, 1.0 => MulPullback * mul_pullback mul_jvp, DivPullback / div_pullback div_jvp;
        1.0, v => MulPullback * mul_pullback mul_jvp, DivPullback / div_pullback div_jvp;
        v, v => MulPullback * mul_pullback mul_jvp, DivPullback / div_pullback div_jvp;
        DVec2::ONE, 1.0 => MulPullback * mul_pullback mul_jvp;
        DVec4::ONE, DVec4::ONE => DivPullback / div_pullback div_jvp;
    }
    linear_operators! {
        1.0, 1.0;
        v, v;
        v, 1.0;
        1.0, v;
    }
    compare(
        "-x",
        v,
        |a, g| (-a, DVec3::neg_pullback(&Default::default(), g)),
        |a, dot| a.neg_jvp(dot),
    );
}

/// A call of a `_vjp` and of a `_jvp`.
macro_rules! methods {
    ($($like:expr, |$($x:ident),+| $vjp:ident $jvp:ident;)*) => {$(
        compare(
            stringify!($jvp),
            $like,
            |methods!(@pattern $($x),+), g| {
                let (value, pullback) = methods!(@call $vjp $($x),+);
                (value, pullback(g))
            },
            |methods!(@pattern $($x),+), dots| methods!(@forward $jvp dots $($x),+),
        );
    )*};
    (@pattern $x:ident) => { $x };
    (@pattern $($x:ident),+) => { ($($x),+) };
    (@call $vjp:ident $x:ident) => { $x.$vjp() };
    (@call $vjp:ident $x:ident, $($y:ident),+) => { $x.$vjp($($y),+) };
    (@forward $jvp:ident $dots:ident $x:ident) => { $x.$jvp($dots) };
    (@forward $jvp:ident $dots:ident $x:ident, $y:ident) => { $x.$jvp($y, $dots.0, $dots.1) };
    (@forward $jvp:ident $dots:ident $x:ident, $y:ident, $z:ident) => {
        $x.$jvp($y, $z, $dots.0, $dots.1, $dots.2)
    };
}

#[test]
fn methods() {
    let v = DVec3::ONE;
    methods! {
        1.0_f64, |x| sin_vjp sin_jvp;
        1.0_f64, |x| sin_cos_vjp sin_cos_jvp;
        (1.0_f64, 1.0), |y, x| atan2_vjp atan2_jvp;
        (1.0_f64, 1.0), |x, y| hypot_vjp hypot_jvp;
        (1.0_f64, 1.0), |x, y| min_vjp min_jvp;
        (1.0_f64, 1.0, 1.0), |x, a, b| mul_add_vjp mul_add_jvp;
        (v, v), |a, b| dot_vjp dot_jvp;
        (v, v), |a, b| cross_vjp cross_jvp;
        (v, v), |a, b| distance_vjp distance_jvp;
        (v, v), |a, b| reflect_vjp reflect_jvp;
        (v, v), |a, b| project_onto_vjp project_onto_jvp;
        (v, v), |a, b| midpoint_vjp midpoint_jvp;
        (v, v), |a, b| max_vjp max_jvp;
        (v, v, 1.0), |a, b, s| lerp_vjp lerp_jvp;
        (v, v, v), |a, b, c| mul_add_vjp mul_add_jvp;
        v, |a| normalize_vjp normalize_jvp;
        v, |a| length_vjp length_jvp;
        v, |a| length_recip_vjp length_recip_jvp;
        v, |a| min_element_vjp min_element_jvp;
        v, |a| element_sum_vjp element_sum_jvp;
        v, |a| element_product_vjp element_product_jvp;
        v, |a| fract_vjp fract_jvp;
        v, |a| exp_vjp exp_jvp;
        v, |a| y_vjp y_jvp;
    }
    compare(
        "splat",
        1.0,
        |x, g| {
            let (value, pullback) = DVec3::splat_vjp(x);
            (value, pullback(g))
        },
        DVec3::splat_jvp,
    );
    compare(
        "powf of a vector",
        (v, 1.0),
        |(a, s), g| {
            let (value, pullback) = a.abs().powf_vjp(s);
            let (to_a, to_s) = pullback(g);
            (value, (to_a * a.signum(), to_s))
        },
        |(a, s), (a_dot, s_dot)| a.abs().powf_jvp(s, a_dot * a.signum(), s_dot),
    );
    compare(
        "difference of products",
        [1.0; 4],
        |[a, b, c, d], g| {
            let (value, pullback) = f64::difference_of_products_vjp(a, b, c, d);
            let (a, b, c, d) = pullback(g);
            (value, [a, b, c, d])
        },
        |[a, b, c, d], [e, f, g, h]| f64::difference_of_products_jvp(a, b, c, d, e, f, g, h),
    );
    let x = Xyz { x: 0.5, y: -2.0, z: 1.0 };
    let (value, dot) = x.cross_jvp(x, x, Xyz::zero());
    assert_eq!((value.x(), dot.x()), (0.0, 0.0));
}
