//! Gradients of what names no type of glam: all of it holds without the feature `glam`, too.

use ad::check::{assert_forward, assert_rule};
use ad::vector::{Vector, Vector3, Xyz};
use ad::{Differentiable, Dual, Fields, Real, Vec3, differentiable, tape};

#[derive(Clone, Copy, Debug, Differentiable, Fields)]
struct Ball<S: Real> {
    center: Vec3<S>,
    radius: S,
}

/// The light that a ball sends back, of a source at `light`.
#[differentiable]
fn shading<S: Real>(ball: Ball<S>, light: Vec3<S>, weights: [S; 2]) -> S {
    let towards = light - ball.center;
    let normal = towards.cross(ball.center).normalize();
    let distance = towards.length() - ball.radius;
    let shine = normal.dot(light.reflect(normal)).max(S::ZERO) + normal.x() * normal.z();
    weights[0] * shine / (distance * distance) + weights[1] * distance.sin()
}

fn of_numbers<S: Real>(x: &[S]) -> S {
    let ball = Ball { center: Vector3::new(x[0], x[1], x[2]), radius: x[3] };
    shading::<S>(ball, Vector3::new(x[4], x[5], x[6]), [x[7], x[8]])
}

const POINT: [f64; 9] = [0.3, -0.7, 0.2, 0.5, 1.5, 0.4, 2.5, 0.8, 1.3];

#[test]
fn structs_and_vectors_of_a_generic_scalar() {
    let [_, _, _, radius, .., first, second] = POINT;
    let center = <f64 as Real>::Vec3::new(POINT[0], POINT[1], POINT[2]);
    let light = <f64 as Real>::Vec3::new(POINT[4], POINT[5], POINT[6]);
    let (to_ball, to_light, to_weights) =
        shading::grad(Ball { center, radius }, light, [first, second]);
    let found = [
        to_ball.center.x(),
        to_ball.center.y(),
        to_ball.center.z(),
        to_ball.radius,
        to_light.x(),
        to_light.y(),
        to_light.z(),
        to_weights[0],
        to_weights[1],
    ];

    let differences = ad::check::gradient(of_numbers, &POINT, 1e-3);
    let (_, taped) = tape::gradient(of_numbers, &POINT);
    for (i, found) in found.into_iter().enumerate() {
        let along = |k: usize, x: f64| Dual::new(x, f64::from(u8::from(i == k)));
        let point: [Dual<f64>; 9] = std::array::from_fn(|k| along(k, POINT[k]));
        let is_close = |expected: f64, tolerance: f64| (found - expected).abs() <= tolerance;
        assert!(is_close(differences[i].value, 1e-7), "{i}: {found}, {:?}", differences[i]);
        assert!(is_close(taped[i], 1e-12), "{i}: {found}, by the tape {}", taped[i]);
        let dual = of_numbers(&point).derivative;
        assert!(is_close(dual, 1e-12), "{i}: {found}, by dual numbers {dual}");
    }
}

/// A spring between two points, of which one stays.
#[derive(Clone, Copy, Debug, Differentiable)]
struct Spring {
    #[constant]
    fixed: Xyz<f64>,
    free: Xyz<f64>,
    stiffness: f64,
}

#[differentiable]
impl Spring {
    fn energy(&self) -> f64 {
        let stretch = self.free - self.fixed;
        self.stiffness * stretch.length_squared() * 0.5 + self.fixed.y * self.free.y
    }
}

/// Names the elements of a vector, and changes them in place.
#[differentiable]
fn settle(free: Xyz<f64>, stiffness: f64, steps: usize) -> Xyz<f64> {
    let mut spring = Spring { fixed: Xyz { x: 1.0, y: 2.0, z: -1.0 }, free, stiffness };
    for _ in 0..steps {
        let force = (spring.fixed - spring.free) * spring.stiffness;
        spring.free += force * 0.1;
        spring.free.y -= 0.01 * spring.energy();
    }
    Xyz { x: spring.free.z, y: spring.free.x, z: -spring.free.y }
}

#[test]
fn vectors_of_floats() {
    let free = Xyz { x: 0.3, y: 0.9, z: 0.5 };
    assert_rule(settle, settle::vjp, (free, 1.3, 3));
    assert_forward(settle, settle::jvp, (free, 1.3, 3));
}

/// A function of a name that one of glam's has.
#[differentiable]
fn dvec3(x: f64) -> f64 {
    x * x
}

#[differentiable]
fn rows(xs: &[f64], pairs: [[f64; 2]; 2]) -> f64 {
    let mut sum = 0.0;
    for (i, x) in xs.iter().enumerate() {
        sum += x.exp() * pairs[i % 2][0] + dvec3(pairs[1][1]);
    }
    sum
}

#[test]
fn slices_and_arrays() {
    assert_rule(
        |xs: Vec<f64>, pairs| rows(&xs, pairs),
        |xs: Vec<f64>, pairs| rows::vjp(&xs, pairs),
        (vec![0.2, -0.4, 1.1], [[0.5, 1.5], [-0.7, 0.9]]),
    );
    let along = rows::jvp(&[0.2], [[0.5, 1.5], [-0.7, 0.9]], &[1.0], [[0.0; 2]; 2]).1;
    assert!((along - 0.5 * 0.2_f64.exp()).abs() < 1e-15);
}
