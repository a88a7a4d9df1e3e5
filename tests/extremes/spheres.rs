//! Spheres that are grazed, entered, stood on, tiny, huge, near and far.

use glam::{DVec3, dvec3};
use renderer::SphereObject;

use crate::images::check_agreement;
use crate::kernels::{Kernel, SphereEntered, SphereLeft, SphereUv};
use crate::oracle::{Case, check};
use crate::scenes::{Parts, set, small_parts, small_scene};

fn single(v: DVec3) -> DVec3 {
    v.as_vec3().as_dvec3()
}

/// A ray from `origin` that passes the centre at a distance of `pass` radii, if it starts outside.
struct Look {
    origin: DVec3,
    center: DVec3,
    radius: f64,
    pass: f64,
}

impl Look {
    fn numbers(&self) -> Vec<f64> {
        let Self { origin, center, radius, pass } = *self;
        let (origin, center) = (single(origin), single(center));
        let to_center = center - origin;
        let direction = match to_center.length() {
            0.0 => dvec3(0.48, 0.6, 0.64),
            _ => {
                let (distance, pass) = (to_center.length(), pass * radius);
                let stretch = (1.0 - (pass / distance).min(0.99).powi(2)).sqrt();
                (to_center + to_center.any_orthonormal_vector() * (pass / stretch)).normalize()
            }
        };
        let (origin, direction, center) =
            (origin.to_array(), single(direction).to_array(), center.to_array());
        [&origin[..], &direction, &center, &[f64::from(radius as f32)]].concat()
    }

    fn check<K: Kernel>(&self, name: &str, length: f64, value: f64, gradient: f64) {
        let angle = length / self.origin.distance(self.center).max(self.radius);
        let lengths = [length, angle, length, length];
        check::<K>(&Case { name, x: &self.numbers(), lengths: &lengths, value, gradient });
    }
}

#[test]
fn near_and_far_and_tiny_and_huge() {
    let towards = dvec3(0.6, -0.3, 0.74).normalize();
    for (radius, distance) in [
        (1.0, 3.0),
        (1e-6, 1e-5),
        (1e-6, 1.0),
        (1.0, 1e6),
        (1e6, 1e7),
        (1e6, 1e6 + 10.0),
        (1e-18, 1e-17),
        (1e17, 3e17),
    ] {
        let look = Look { origin: DVec3::ZERO, center: towards * distance, radius, pass: 0.4 };
        let name = format!("sphere of radius {radius:e} seen from {distance:e}");
        let bound = 20.0 * (distance / radius).max(radius / (distance - radius));
        look.check::<SphereEntered>(&name, radius, bound, 10.0 * bound);
    }
}

#[test]
fn from_inside_and_from_the_surface() {
    for exponent in [0, -6, 6, -18, 17] {
        let radius = 10.0_f64.powi(exponent);
        for (place, name) in [
            (0.0, "its centre"),
            (0.3, "inside"),
            (1.0 - 1e-6, "just inside"),
            (1.0, "the surface"),
        ] {
            let look = Look {
                origin: dvec3(0.48, 0.6, 0.64) * radius * place,
                center: DVec3::ZERO,
                radius,
                pass: 0.3,
            };
            let name = format!("sphere of radius 1e{exponent} left from {name}");
            look.check::<SphereLeft>(&name, radius, 50.0, 100.0);
        }
    }
}

#[test]
fn grazed() {
    for exponent in [-1, -3, -5] {
        let gap = 10.0_f64.powi(exponent);
        let look = Look {
            origin: DVec3::ZERO,
            center: dvec3(3.0, 0.5, 1.0),
            radius: 1.0,
            pass: 1.0 - gap,
        };
        let name = format!("sphere grazed at {gap:e} of its radius");
        look.check::<SphereEntered>(&name, gap.sqrt(), 10.0 / gap, 100.0 / gap);
    }
}

#[test]
fn places_on_textures() {
    for exponent in [0, -6, 6, -18, 17] {
        let radius = f64::from(10.0_f32.powi(exponent));
        for (outward, name) in [
            (dvec3(0.48, 0.6, 0.64), "its side"),
            (dvec3(0.01, 0.99995, 0.0), "near a pole"),
            (dvec3(1e-4, -1.0, -1e-5), "next to a pole"),
            (dvec3(1e-6, 0.1, -0.995), "its seam"),
        ] {
            let point = single(outward.normalize() * radius);
            check_place(&format!("{exponent} at {name}"), point, radius, DVec3::ZERO, outward);
        }
        let point = single(dvec3(0.48, 0.6, 0.64) * radius);
        let rotation = dvec3(20.0, -35.0, 50.0);
        check_place(&format!("{exponent}, turned"), point, radius, rotation, DVec3::ONE);
    }
}

/// The sphere stands at the origin; `outward` is where the point is on its texture.
fn check_place(name: &str, point: DVec3, radius: f64, rotation: DVec3, outward: DVec3) {
    let angle = outward.x.hypot(outward.z);
    let length = radius * angle;
    check::<SphereUv>(&Case {
        name: &format!("texture of a sphere of radius 1e{name}"),
        x: &[&point.to_array()[..], &[0.0; 3], &[radius], &rotation.to_array()].concat(),
        lengths: &[length, length, length, angle.to_degrees()],
        value: 10.0,
        gradient: 100.0,
    });
}

/// A camera in the middle of a sphere, inside, on its surface, and near and far ones of extreme radius.
#[test]
fn scenes_from_inside_and_from_the_surface_and_of_extreme_radius() {
    let outward = dvec3(0.48, 0.6, 0.64);
    for (place, distance) in [("the middle", 0.0), ("inside", 0.2), ("the surface", 0.5)] {
        let mut scene = small_scene(24);
        let center = scene.spheres()[0].values.center;
        scene.camera.look_from = center + outward * distance;
        scene.camera.look_at = center - outward + dvec3(0.1, 0.2, 0.0);
        // So that the inside is lit.
        set(&mut scene, "light.key.position", &[-0.7, 0.6, 0.3]);
        check_agreement(&format!("scene from {place} of a sphere"), &scene, 1e-3);
    }
    for (name, radius, distance, bound) in [
        ("tiny, near", 1e-6, 3e-6, 1e-4),
        ("tiny, far", 1e-6, 1e-3, 1e-3),
        ("huge, near", 1e6, 1e6 + 10.0, 2e-2),
        ("huge, far", 1e6, 1e7, 1e-4),
    ] {
        let parts = small_parts(24);
        let camera = parts.camera;
        let towards = (camera.look_at - camera.look_from).normalize();
        let center = camera.look_from + towards * distance;
        let spheres = vec![SphereObject::new("ball", center, radius).material(1)];
        let scene = Parts { spheres, meshes: Vec::new(), ..parts }.scene();
        check_agreement(&format!("scene with a sphere that is {name}"), &scene, bound);
    }
}
