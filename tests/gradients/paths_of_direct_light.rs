//! Paths of two pieces bring direct light: their derivatives are those of direct light, edges included.

use std::f64::consts::TAU;

use renderer::glam::{DVec3, dvec3};
use renderer::scene::AreaLight;
use renderer::{Camera, Light, Mesh, PointLight, Scene, SphereObject};

use crate::edges::paint;
use crate::fine_images::{add_round, derivative, distance};
use crate::paths::{emitting, paths};

/// A smooth ring that a bent sheet and a ball pierce.
fn pierced() -> Scene {
    let mut scene = Scene::new(64, 64, Camera::looking(dvec3(-3.1, 1.9, -2.3), DVec3::Y * 0.1));
    scene.camera.vfov = 36.0;
    let ring = paint(&mut scene, "ring", [0.7, 0.4, 0.3], 0.0);
    add_round(&mut scene, [14, 9], true, ring, |u, v| {
        let ((sine, cosine), (z, x)) = ((TAU * v).sin_cos(), (TAU * u).sin_cos());
        dvec3((0.7 + 0.3 * cosine) * x, 0.3 * sine + 0.4 * z, (0.7 + 0.3 * cosine) * z)
    });
    let sheet = paint(&mut scene, "sheet", [0.4, 0.3, 0.8], 0.0);
    let corners = [[-0.9, -0.3, -0.6], [0.1, 0.2, -0.9], [0.8, 0.7, 0.1], [-0.2, 0.5, 0.7]];
    let sheet = Mesh::new("sheet", corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).material(sheet);
    scene.add_mesh(sheet).unwrap();
    let ball = paint(&mut scene, "ball", [0.3, 0.7, 0.4], 0.0);
    scene
        .add_sphere(SphereObject::new("ball", dvec3(-0.6, 0.3, 0.4), 0.35).material(ball))
        .unwrap();
    scene
}

/// Where a lamp stands.
const LAMP: DVec3 = DVec3::new(-1.6, 3.2, -2.0);
/// Where one grazes the ring, which is in the way of its light for less than a pixel next to where surfaces pierce it.
const GRAZING: DVec3 = DVec3::new(-0.1, 2.0, -3.0);

/// Derivatives by what moves along x, beside those of direct light, within these bounds.
#[track_caller]
fn check(direct: &Scene, by_paths: &Scene, most: [f64; 4]) {
    let paths = [
        "camera.look_at",
        "mesh.round.translation",
        "mesh.sheet.translation",
        "sphere.ball.center",
    ];
    for (path, most) in paths.into_iter().zip(most) {
        let [expected, found] = [direct, by_paths].map(|scene| derivative(scene, 256, path));
        let off = distance(&found, &expected);
        assert!(off < most, "{path}: {off}");
    }
}

#[test]
fn of_a_point_light() {
    let mut direct = pierced();
    let lamp = PointLight { position: GRAZING, color: DVec3::ONE, radiant_intensity: 30.0 };
    direct.add_light("lamp", lamp).unwrap();
    let by_paths = Scene { integrator: paths(2, 4), ..direct.clone() };
    check(&direct, &by_paths, [0.02, 0.025, 0.01, 0.06]);
}

/// A patch that shines is a light of the same size.
#[test]
fn of_a_patch_that_shines() {
    let (mut direct, mut by_paths) = (pierced(), pierced());
    let towards = -LAMP.normalize();
    let right = towards.cross(DVec3::Y).normalize() * 0.2;
    let up = towards.cross(right);
    let lamp = AreaLight { center: LAMP, right, up, radiance: 200.0, color: DVec3::ONE };
    direct.add_light("lamp", Light::Rectangle(lamp)).unwrap();
    direct.light_samples = 64;
    let lamp = by_paths.add_material("lamp", emitting(200.0, 0.0)).unwrap();
    let corners =
        [-right - up, right - up, right + up, up - right].map(|to| (LAMP + to).to_array());
    let patch = Mesh::new("patch", corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).material(lamp);
    by_paths.add_mesh(patch).unwrap();
    by_paths.integrator = paths(2, 4);
    check(&direct, &by_paths, [0.03, 0.03, 0.01, 0.06]);
}
