//! What no light comes to is black, its edges too, and has no derivative.

use renderer::glam::DVec3;
use renderer::{DistantLight, Edges, Mesh, Scene, SphereObject, render};

use crate::curved_edges::add_facets;
use crate::edges::{add_ball, add_wedge, gradient, scene, settings};

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
    let objects: [(&str, &str, fn(&mut Scene)); 5] = [
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
