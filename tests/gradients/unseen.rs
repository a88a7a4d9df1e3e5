//! What no light comes to is black, its edges too, and what is not to be seen changes nothing: neither has a derivative.

use renderer::glam::DVec3;
use renderer::scene::MaterialObject;
use renderer::{
    Camera, DistantLight, Edges, Material, Mesh, PointLight, Scene, SphereObject, render,
};

use crate::curved_edges::add_facets;
use crate::differences::relative_error;
use crate::edges::{add_ball, add_wedge, gradient, paint, scene, settings};

/// A closed room around the camera and what it sees, and a sun outside.
fn add_room(scene: &mut Scene, towards_sun: DVec3) {
    let ends = [-6.0, 7.0];
    let corners = ends.map(|x| ends.map(|y| ends.map(|z| [x, y, z])));
    let faces =
        [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let triangles = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let corners = corners.as_flattened().as_flattened().to_vec();
    scene.add_mesh(Mesh::new("room", corners, triangles)).unwrap();
    let sun = DistantLight { direction: towards_sun, color: DVec3::ONE, irradiance: 2.0 };
    scene.add_light("sun", sun).unwrap();
}

/// A ball that pierces that of [`add_ball`].
fn add_balls(scene: &mut Scene) {
    add_ball(scene);
    scene.add_sphere(SphereObject::new("other", DVec3::new(0.6, 1.0, 0.3), 0.4)).unwrap();
}

/// Where surfaces turn from a light between samples and their silhouettes, or between two samples, samples say nothing
/// of what is in its way.
#[test]
fn no_sun_comes_into_a_closed_room() {
    type Object = (&'static str, &'static str, fn(&mut Scene));
    let objects: [Object; 5] = [
        ("a ball", "sphere.ball.center", add_ball),
        ("balls", "sphere.ball.center", add_balls),
        ("facets", "mesh.shape.translation", |scene| add_facets(scene, true)),
        ("smooth facets", "mesh.shape.translation", |scene| {
            add_facets(scene, true);
            scene.meshes[0] = scene.meshes[0].clone().smooth();
        }),
        ("a smooth wedge", "mesh.shape.translation", |scene| {
            add_wedge(scene);
            scene.meshes[0] = scene.meshes[0].clone().smooth();
        }),
    ];
    for (name, path, add) in objects {
        for direction in [[-1.0, 0.5, -1.5], [1.0, 1.0, 0.2], [0.1, 0.3, -1.0], [-0.5, 1.0, 1.0]] {
            let mut scene = scene();
            add(&mut scene);
            add_room(&mut scene, direction.into());
            for side in [1, 2] {
                let settings = settings(Edges::On, side);
                let image = render(&scene, &settings).unwrap();
                let brightest = image.pixels.as_flattened().iter().copied().fold(0.0, f32::max);
                let gradient = gradient(&scene, &settings, path);
                println!("{name} {direction:?} {side}: {brightest} {gradient:?}");
                assert!(brightest < 1e-6);
                assert!(gradient.iter().all(|part| part.abs() < 1e-6));
            }
        }
    }
}

/// A ball that is not to be seen is not to be seen at its silhouette, where rays touch it: what is behind shines through,
/// and moving the ball changes nothing.
#[test]
fn silhouettes_of_what_is_not_there() {
    for radius in [1.0, 2.0] {
        let camera = Camera::looking(DVec3::new(0.5, 1.5, 5.0), DVec3::new(0.0, 1.0, 0.0));
        let mut scene = Scene::new(32, 24, camera);
        let wall = paint(&mut scene, "wall", [0.7; 3], 0.0);
        let corners =
            vec![[-9.0, -9.0, -4.0], [9.0, -9.0, -4.0], [9.0, 9.0, -4.0], [-9.0, 9.0, -4.0]];
        let faces = vec![[0, 1, 2], [0, 2, 3]];
        scene.add_mesh(Mesh::new("wall", corners, faces).material(wall)).unwrap();
        let position = DVec3::new(0.3, 2.0, -2.9);
        let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 20.0 };
        scene.add_light("lamp", lamp).unwrap();
        for side in [1, 4] {
            let settings = settings(Edges::On, side);
            let alone = render(&scene, &settings).unwrap();
            let mut with_ball = scene.clone();
            let clear = MaterialObject::from(Material::lambertian(DVec3::ONE)).with_opacity(0.0);
            let clear = with_ball.add_material("clear", clear).unwrap();
            let ball = SphereObject::new("ball", DVec3::Y, radius).material(clear);
            with_ball.add_sphere(ball).unwrap();
            let image = render(&with_ball, &settings).unwrap();
            let difference = image.absolute_difference(&alone).unwrap();
            assert!(difference.pixels.as_flattened().iter().all(|&part| part < 1e-5));
            for path in ["sphere.ball.center", "sphere.ball.radius"] {
                let gradient = gradient(&with_ball, &settings, path);
                assert!(gradient.iter().all(|part| part.abs() < 1e-5), "{path}: {gradient:?}");
            }
        }
    }
}

/// What a black shade around a lamp lets through is a part of its light, everywhere: where shadows of others end, too.
#[test]
fn lamps_within_shades_are_dimmed() {
    let add_lamp = |scene: &mut Scene, position: DVec3, shade: Option<f64>| {
        let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 150.0 };
        scene.add_light("lamp", lamp).unwrap();
        if let Some(opacity) = shade {
            let black = MaterialObject::from(Material::lambertian(DVec3::ZERO));
            let black = scene.add_material("black", black.with_opacity(opacity)).unwrap();
            scene.add_sphere(SphereObject::new("shade", position, 0.3).material(black)).unwrap();
        }
    };
    for position in [DVec3::new(0.0, 4.0, -2.0), DVec3::new(2.35, 3.26, -0.44)] {
        let lit = |shade: Option<f64>| {
            let mut scene = scene();
            add_facets(&mut scene, true);
            scene.meshes[0] = scene.meshes[0].clone().smooth();
            for (name, center, radius) in [
                ("ball", DVec3::new(0.8, 0.8, 0.3), 0.5),
                ("other", DVec3::new(0.1, 0.2, 1.0), 0.4),
            ] {
                scene.add_sphere(SphereObject::new(name, center, radius)).unwrap();
            }
            add_lamp(&mut scene, position, shade);
            scene
        };
        let (open, shaded) = (lit(None), lit(Some(0.9)));
        for side in [1, 4] {
            let settings = settings(Edges::On, side);
            let [open_image, shaded_image] =
                [&open, &shaded].map(|scene| render(scene, &settings).unwrap());
            let parts = open_image.pixels.as_flattened().iter();
            for (open, shaded) in parts.zip(shaded_image.pixels.as_flattened()) {
                assert!((0.1 * open - shaded).abs() < 1e-4, "{side}: {open} {shaded}");
            }
            for path in ["sphere.other.center", "mesh.shape.translation"] {
                let [open, shaded] = [&open, &shaded].map(|scene| gradient(scene, &settings, path));
                let dimmed: Vec<f64> = open.iter().map(|part| 0.1 * part).collect();
                let error = relative_error(&shaded, &dimmed);
                assert!(error < 1e-3, "{path}, {side}: {error}");
            }
        }
    }
}
