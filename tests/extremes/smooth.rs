//! Normals that cancel, that oppose the flat triangle, and that look away from the viewer.

use glam::{DVec3, dvec3};
use renderer::Transform;
use renderer::transport::camera::Ray;
use renderer::transport::smooth::{
    SmoothPoint, curved_point, next_ray_outward, place_normal, smooth_point,
};
use renderer::transport::surface::SurfacePoint;
use renderer::transport::triangle::Triangle;

use crate::kernels::{OnSmooth, PlacedNormal, SmoothMirrored};
use crate::oracle::{Case, check};

const TRIANGLE: Triangle<f64> =
    Triangle { a: dvec3(-1.0, -1.0, 0.0), b: dvec3(1.0, -1.0, 0.0), c: dvec3(0.0, 1.0, 0.0) };

/// The point of the triangle straight above or below which a viewer stands.
fn seen(normals: [DVec3; 3], from: f64) -> SmoothPoint<f64> {
    let ray = Ray { origin: dvec3(0.0, 0.0, from), direction: DVec3::NEG_Z * from.signum() };
    smooth_point::<f64>(TRIANGLE, normals, ray)
}

#[test]
fn normals_that_cancel_leave_that_of_the_flat_triangle() {
    for normals in [
        [DVec3::ZERO; 3],
        [dvec3(0.6, 0.0, 0.8), dvec3(0.6, 0.0, 0.8), dvec3(-0.6, 0.0, -0.8)],
        [DVec3::X, DVec3::X, DVec3::NEG_X],
    ] {
        for from in [2.0, -2.0] {
            let point = seen(normals, from);
            let outward = DVec3::Z * from.signum();
            assert_eq!((point.surface.normal, point.outward), (outward, outward));
        }
    }
}

/// On whichever side normals are given, it is the side of the viewer that is shaded.
#[test]
fn the_flat_triangle_decides_the_side() {
    let normals = [dvec3(0.6, 0.0, 0.8), dvec3(0.0, -0.6, 0.8), dvec3(0.0, 0.8, 0.6)];
    let above = seen(normals, 2.0).surface.normal;
    assert!(above.z > 0.8 && above.is_normalized());
    assert_eq!(seen(normals.map(|n| -n), 2.0).surface.normal, above);
    assert_eq!(seen(normals, -2.0).surface.normal, -above);
}

fn mirrored(normal: DVec3, view: DVec3) -> DVec3 {
    let surface = SurfacePoint { point: DVec3::ZERO, normal, view };
    let point = SmoothPoint { surface, outward: DVec3::Z };
    next_ray_outward::<f64>(point, false).direction
}

/// Mirrors send no ray into the flat triangle, and bend only those that would go there.
#[test]
fn mirrored_rays_stay_outside() {
    let view = dvec3(0.8, 0.0, 0.6);
    assert!(mirrored(DVec3::Z, view).distance(dvec3(-0.8, 0.0, 0.6)) < 1e-15);
    for degrees in -89..=89 {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let direction = mirrored(dvec3(sine, 0.0, cosine), view);
        assert!(direction.is_normalized() && direction.z > 0.0, "{degrees}: {direction}");
        let next = f64::from(degrees + 1).to_radians().sin_cos();
        let next = mirrored(dvec3(next.0, 0.0, next.1), view);
        // Where the shading normal looks far away from the viewer, directions turn fast.
        assert!(degrees < -40 || next.distance(direction) < 0.04, "{degrees}: {direction}, {next}");
    }
    // Straight down is the one direction without a way out.
    assert_eq!(mirrored(DVec3::X, DVec3::Z), DVec3::Z);
}

/// Above the middle of a sphere's triangle the curved point is near the sphere, and at corners it is
/// the corner. Where normals lean together, it is the point.
#[test]
fn shadow_rays_start_on_a_curved_surface() {
    let corners = [dvec3(0.1, 0.0, 1.0), dvec3(-0.1, 0.1, 1.0), dvec3(-0.1, -0.1, 1.0)];
    let [a, b, c] = corners.map(DVec3::normalize);
    let triangle = Triangle { a, b, c };
    let middle = (a + b + c) / 3.0;
    let above = curved_point::<f64>(triangle, [a, b, c], middle, DVec3::Z);
    assert!(middle.length() < 0.993 && above.length() > 1.0 && above.length() < 1.01);
    assert!(curved_point::<f64>(triangle, [a, b, c], a, DVec3::Z).distance(a) < 1e-15);
    let together = [a, b, c].map(|n| dvec3(-n.x, -n.y, n.z));
    assert_eq!(curved_point::<f64>(triangle, together, middle, DVec3::Z), middle);
}

/// Normals stay perpendicular to what they were perpendicular to, whatever the scale, and zero without
/// any.
#[test]
fn placed_normals_are_perpendicular() {
    for scale in [dvec3(2.0, 0.5, 1.0), dvec3(-1e9, 3.0, 1e-9), dvec3(1.0, 0.0, 2.0)] {
        let rotation = dvec3(20.0, -50.0, 80.0);
        let transform = Transform { rotation, scale, ..Transform::IDENTITY };
        let (normal, along) = (dvec3(1.0, 2.0, 3.0), dvec3(3.0, 0.0, -1.0));
        let place = |v| renderer::transport::transform::place::<f64>(transform, v);
        let (placed, along) = (place_normal::<f64>(transform, normal), place(along));
        assert!(placed.is_normalized(), "{scale}: {placed}");
        assert!(placed.dot(along).abs() < 1e-9 * along.length(), "{scale}");
    }
    let flat = Transform { scale: DVec3::ZERO, ..Transform::IDENTITY };
    assert_eq!(place_normal::<f64>(flat, DVec3::X), DVec3::ZERO);
}

fn on_smooth(name: &str, normals: [f64; 9], bounds: (f64, f64)) {
    let single = |x: f64| f64::from(x as f32);
    let ray = [0.125, 0.0625, 2.0, 0.0, 0.0, -1.0];
    let corners = [-1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 0.0, 1.0, 0.0];
    let (value, gradient) = bounds;
    check::<OnSmooth>(&Case {
        name,
        x: &[&ray[..], &corners, &normals.map(single)].concat(),
        lengths: &[1.0, 0.1, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
        value,
        gradient,
    });
}

#[test]
fn normals_that_almost_cancel() {
    for exponent in [-1, -2] {
        let sine = 10.0_f64.powi(exponent);
        let normals = [0.6, sine, 0.8, 0.6, sine, 0.8, -0.6, sine, -0.8];
        let name = format!("normals at 1e{exponent} rad from opposite ones");
        on_smooth(&name, normals, (10.0 / sine, 30.0 / sine));
    }
    on_smooth(
        "a corner without a normal",
        [0.0, 0.0, 0.0, 0.6, 0.0, 0.8, 0.0, 0.6, 0.8],
        (20.0, 30.0),
    );
}

#[test]
fn mirrors_at_grazing_angles() {
    for (name, normal) in [
        ("mirrored outwards", [0.28, 0.0, 0.96]),
        ("mirrored into the triangle", [-0.6, 0.48, 0.64]),
        ("shading normal away from the viewer", [-0.96, 0.0, 0.28]),
    ] {
        let single = |x: f64| f64::from(x as f32);
        let x = [0.0, 0.0, 0.0, normal[0], normal[1], normal[2], 0.96, 0.0, 0.28, 0.0, 0.0, 1.0];
        check::<SmoothMirrored>(&Case {
            name,
            x: &x.map(single),
            lengths: &[1.0, 0.1, 0.1, 0.1],
            value: 20.0,
            gradient: 50.0,
        });
    }
}

#[test]
fn normals_under_extreme_scales() {
    for scale in [[1.0, 2.0, 0.5], [-1e6, 1.0, 1e6], [1e-6, 1e-6, 1e-6], [1e9, 1e9, 1e9]] {
        let single = |x: f64| f64::from(x as f32);
        let [x, y, z]: [f64; 3] = scale;
        let numbers = [0.0, 0.0, 0.0, 10.0, -30.0, 70.0, x, y, z, 1.0, 2.0, 3.0];
        let least = x.abs().min(y.abs()).min(z.abs());
        check::<PlacedNormal>(&Case {
            name: &format!("normal under the scale {scale:?}"),
            x: &numbers.map(single),
            lengths: &[1.0, 30.0, least, 1.0],
            value: 50.0,
            gradient: 100.0,
        });
    }
}
