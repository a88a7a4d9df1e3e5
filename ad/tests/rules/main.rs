use ad::vector::Vector;
use ad::{Differentiable, Real, Vec3, differentiable, select};

#[differentiable]
pub fn lambert<S: Real>(n: Vec3<S>, l: Vec3<S>, albedo: Vec3<S>) -> Vec3<S> {
    albedo * n.dot(l).max(S::ZERO)
}

#[differentiable]
fn poly(x: f64, y: f64) -> f64 {
    let a = x * y + 2.0 * x;
    let x = a * a;
    -x / y
}

#[differentiable]
fn branchy(x: f64, y: f64) -> f64 {
    let mut acc = x;
    if x > y {
        acc *= y;
    } else if y > 3.0 {
        acc = acc - y * y;
    }
    for i in 0..4 {
        acc += x * (i as f64);
        acc = acc.sin();
    }
    acc
}

#[differentiable]
fn early(x: f64, y: f64) -> f64 {
    if x < 0.0 {
        return y * x;
    }
    let z = match y > 1.0 {
        true => x * y,
        false => return x,
    };
    if z > 10.0 {
        if y > 5.0 {
            return z.sqrt();
        }
    }
    z * z
}

#[differentiable]
fn safe_sqrt(x: f64) -> Option<f64> {
    if x < 0.0 { None } else { Some(x.sqrt()) }
}

#[differentiable]
fn opt(x: f64, y: f64) -> Option<f64> {
    let a = safe_sqrt(x)? + y * safe_sqrt(y)?;
    Some(a * x)
}

#[derive(Clone, Copy, Differentiable)]
pub struct Ray<S: Real> {
    pub origin: Vec3<S>,
    pub direction: Vec3<S>,
    #[constant]
    pub id: f64,
}

#[differentiable]
impl<S: Real> Ray<S> {
    pub fn at(&self, t: S) -> Vec3<S> {
        self.origin + self.direction * t
    }
    pub fn moved(self, t: S) -> Self {
        let origin = self.at(t);
        Ray { origin, ..self }
    }
}

#[differentiable]
fn use_ray(o: glam::DVec3, d: glam::DVec3, t: f64) -> f64 {
    let ray = Ray { origin: o, direction: d, id: 3.0 };
    let p = ray.moved(t).at(t);
    p.dot(p) * ray.id + p.x
}

#[differentiable]
fn loop_exit(x: f64, n: usize) -> f64 {
    let mut p = 1.0;
    for i in 0..n {
        p *= x + (i as f64);
        if p > 10.0 {
            return p * x;
        }
    }
    let arr = [p, x, p * x];
    let mut s = 0.0;
    for i in 0..3 {
        s += arr[i] * arr[2 - i];
    }
    s
}

fn fd(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let h = 1e-6;
    (f(x + h) - f(x - h)) / (2.0 * h)
}

macro_rules! check2 {
    ($f:ident, $($x:expr, $y:expr);*) => {$(
        let (x, y) = ($x, $y);
        let (v, (gx, gy)) = $f::value_and_grad(x, y);
        assert_eq!(v, $f(x, y));
        let ex = fd(|x| $f(x, y), x);
        let ey = fd(|y| $f(x, y), y);
        assert!((gx - ex).abs() < 1e-5 * (1.0 + ex.abs()), "{} {x} {y}: {gx} {ex}", stringify!($f));
        assert!((gy - ey).abs() < 1e-5 * (1.0 + ey.abs()), "{} {x} {y}: {gy} {ey}", stringify!($f));
    )*};
}

#[test]
fn works() {
    check2!(poly, 1.3, 0.7; -2.0, 4.0);
    check2!(branchy, 1.3, 0.7; 1.0, 4.0; 1.0, 2.0);
    check2!(early, -1.3, 0.7; 1.0, 4.0; 1.0, 0.5; 4.0, 3.0; 4.0, 6.0);
    for n in [0, 3, 10] {
        let (v, (g, ())) = loop_exit::value_and_grad(1.7, n);
        assert_eq!(v, loop_exit(1.7, n));
        let e = fd(|x| loop_exit(x, n), 1.7);
        assert!((g - e).abs() < 1e-5 * (1.0 + e.abs()), "{n} {g} {e}");
    }
    let (v, pb) = opt::vjp(2.0, 3.0);
    assert_eq!(v, opt(2.0, 3.0));
    let (gx, gy) = pb(1.0);
    let ex = fd(|x| opt(x, 3.0).unwrap(), 2.0);
    let ey = fd(|y| opt(2.0, y).unwrap(), 3.0);
    assert!((gx - ex).abs() < 1e-6 && (gy - ey).abs() < 1e-6);
    let (_, pb) = opt::vjp(-2.0, 3.0);
    assert_eq!(pb(1.0), (0.0, 0.0));
    let o = glam::dvec3(1.0, 2.0, 3.0);
    let d = glam::dvec3(0.3, -0.2, 0.9);
    let (go, gd, gt) = use_ray::grad(o, d, 0.7);
    let et = fd(|t| use_ray(o, d, t), 0.7);
    assert!((gt - et).abs() < 1e-6);
    let e = fd(|x| use_ray(glam::dvec3(x, 2.0, 3.0), d, 0.7), 1.0);
    assert!((go.x - e).abs() < 1e-6);
    let e = fd(|x| use_ray(o, glam::dvec3(0.3, -0.2, x), 0.7), 0.9);
    assert!((gd.z - e).abs() < 1e-6);
    let _ = select(true, 1.0, 2.0);
    let (v, pb) = lambert::vjp::<f32>(
        glam::vec3(0., 0., 1.),
        glam::vec3(0., 0.6, 0.8),
        glam::vec3(1., 1., 1.),
    );
    println!("{v} {:?}", pb(glam::Vec3::ONE));
}
