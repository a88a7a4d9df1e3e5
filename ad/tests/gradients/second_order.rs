//! Forward over reverse: dual numbers through a generated derivative give Hessian-vector products.

use ad::vector::{Vector, Vector3, Xyz};
use ad::{Differentiable, Dual, Mask, Real, Vec3, differentiable};
use glam::DVec3;

use crate::oracle::assert_close;

#[differentiable]
fn rosenbrock<S: Real, const N: usize>(x: [S; N]) -> S {
    let mut sum = S::ZERO;
    for i in 0..N - 1 {
        let valley = x[i + 1] - x[i] * x[i];
        let offset = S::ONE - x[i];
        sum = sum + valley * valley * S::from_f64(100.0) + offset * offset;
    }
    sum
}

#[differentiable]
fn branching<S: Real, const N: usize>(x: [S; N]) -> S {
    let mut a = x[0];
    for i in 0..4 {
        if a.cmpgt(x[1]).all() {
            a = a * x[1] + x[2].sin();
        } else {
            a = a.exp() * x[0];
        }
        if a.cmpgt(S::from_f64(40.0)).all() {
            return a.ln() * x[i % 3];
        }
    }
    a.atan2(x[2]) + a.powf(x[1] * x[1])
}

#[derive(Clone, Copy, Differentiable)]
struct Sphere<S: Real> {
    centre: Vec3<S>,
    radius: S,
}

#[differentiable]
impl<S: Real> Sphere<S> {
    fn hit(&self, origin: Vec3<S>, direction: Vec3<S>) -> Option<S> {
        let to_centre = self.centre - origin;
        let along = to_centre.dot(direction);
        let discriminant = along * along - to_centre.length_squared() + self.radius * self.radius;
        if discriminant.cmplt(S::ZERO).all() {
            return None;
        }
        Some(along - discriminant.sqrt())
    }
}

#[differentiable]
fn shade<S: Real, const N: usize>(x: [S; N]) -> S {
    let sphere = Sphere { centre: Vec3::<S>::new(x[0], x[1], S::TWO), radius: x[2] };
    let direction = Vec3::<S>::new(x[1], x[0], S::ONE).normalize();
    let Some(distance) = sphere.hit(Vec3::<S>::ZERO, direction) else {
        return x[0] * x[1] * x[2];
    };
    let normal = (direction * distance - sphere.centre) / sphere.radius;
    normal.dot(Vec3::<S>::new(x[2], S::ONE, -S::ONE).normalize()).max(S::ZERO) * distance
}

/// Checks the Hessian of a function of three numbers, column by column, against finite differences
/// of its gradient, and its symmetry.
macro_rules! check_hessian {
    ($f:ident at $($x:expr),+ $(,)?) => {
        for x in [$($x),+] {
            let name = stringify!($f);
            let column = |j: usize| {
                let mut point = x.map(Dual::constant);
                point[j].derivative = 1.0;
                $f::grad::<Dual<f64>, 3>(point)
            };
            let hessian = [column(0), column(1), column(2)];
            for j in 0..3 {
                for i in 0..3 {
                    let what = format!("{name} at {x:?}, Hessian[{i}][{j}]");
                    assert_close(&what, hessian[j][i].value, $f::grad::<f64, 3>(x)[i], 1e-12);
                    let moved = |t| {
                        let mut point = x;
                        point[j] = t;
                        $f::grad::<f64, 3>(point)[i]
                    };
                    let expected = ad::check::derivative(moved, x[j], 1e-3).value;
                    assert_close(&what, hessian[j][i].derivative, expected, 1e-7);
                    let mirrored = hessian[i][j].derivative;
                    assert_close(&what, hessian[j][i].derivative, mirrored, 1e-11);
                }
            }
        }
    };
}

#[test]
fn hessians() {
    check_hessian!(rosenbrock at [-1.2, 1.0, 0.7], [0.3, 0.9, -0.4]);
    check_hessian!(branching at [1.3, 0.7, 0.4], [0.4, 1.1, 0.3], [2.1, 1.9, -0.5]);
    check_hessian!(shade at [0.1, -0.2, 0.7], [0.1, 0.1, 1.1], [1.5, -0.9, 0.2]);
}

#[test]
fn product_with_a_vector() {
    let (x, v) = ([-1.2, 1.0, 0.7, 0.2], [0.3, -0.8, 0.5, 1.1]);
    let point = std::array::from_fn(|i| Dual::new(x[i], v[i]));
    let product = rosenbrock::grad::<Dual<f64>, 4>(point).map(|g| g.derivative);
    for (i, &product) in product.iter().enumerate() {
        let moved =
            |t: f64| rosenbrock::grad::<f64, 4>(std::array::from_fn(|k| x[k] + t * v[k]))[i];
        let expected = ad::check::derivative(moved, 0.0, 1e-3).value;
        assert_close("Hessian times vector", product, expected, 1e-7);
    }
}

/// Duals of duals: the third derivative of one number.
#[test]
fn third_derivative() {
    let x = 0.8_f64;
    let inner = Dual::new(x, 1.0);
    let outer = Dual::new(inner, Dual::constant(1.0));
    let slope = cubic::grad(outer);
    assert_close("first", slope.value.value, 4.0 * x * x * x + x.cos(), 1e-14);
    assert_close("second", slope.derivative.value, 12.0 * x * x - x.sin(), 1e-14);
    assert_close("third", slope.derivative.derivative, 24.0 * x - x.cos(), 1e-14);
}

#[differentiable]
fn cubic<S: Real>(x: S) -> S {
    x.powi(4) + x.sin()
}

/// The vectors of dual numbers are structs of their own: one field at a time they are vectors of
/// plain numbers.
#[test]
fn vectors_of_duals() {
    let v = Xyz { x: Dual::new(1.0, 1.0), y: Dual::constant(2.0), z: Dual::constant(-1.0) };
    let (_, pullback) = unit::vjp::<Dual<f64>>(v);
    let one = Dual::constant(1.0);
    let pulled = pullback(Xyz { x: one, y: one, z: one });
    let gradient = |x: f64| unit::vjp::<f64>(DVec3::new(x, 2.0, -1.0)).1(DVec3::ONE);
    for (i, pulled) in [pulled.x, pulled.y, pulled.z].into_iter().enumerate() {
        assert_close("value", pulled.value, gradient(1.0)[i], 1e-13);
        let expected = ad::check::derivative(|x| gradient(x)[i], 1.0, 1e-2).value;
        assert_close("derivative", pulled.derivative, expected, 1e-7);
    }
}

#[differentiable]
fn unit<S: Real>(v: Vec3<S>) -> Vec3<S> {
    v.normalize() * v.length_recip()
}

#[differentiable]
fn powers<S: Real>(x: S) -> S {
    x.powf(S::TWO) + x.powi(2) * S::TWO
}

/// Cotangents that are zero here but not nearby still have derivatives of their own.
#[test]
fn zero_cotangents_move() {
    let hessian_vector = |x: [f64; 2], v: [f64; 2]| {
        let (value, pullback) = rosenbrock::vjp([Dual::new(x[0], v[0]), Dual::new(x[1], v[1])]);
        assert_eq!(value.value, 0.0);
        pullback(Dual::constant(1.0)).map(|g| g.derivative)
    };
    assert_eq!(hessian_vector([1.0, 1.0], [1.0, 0.0]), [802.0, -400.0]);
    assert_eq!(hessian_vector([1.0, 1.0], [0.0, 1.0]), [-400.0, 200.0]);
    assert_eq!(powers::grad(Dual::new(0.0, 1.0)).derivative, 6.0);
}
