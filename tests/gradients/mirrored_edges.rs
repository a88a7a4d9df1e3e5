//! Edges in mirrors, and where surfaces go into mirrors.

use std::f64::consts::{PI, TAU};

use renderer::glam::DVec3;
use renderer::{Camera, DistantLight, Edges, Mesh, PointLight, Scene, Settings, Transform, render};

use crate::edges::{
    add_floor, add_lamp, add_sun, add_triangle, check, check_pixels, check_pixels_by, paint, scene,
};
use crate::fine_images::add_round;

#[test]
fn edges_in_a_mirror() {
    let mut scene = scene();
    add_floor(&mut scene, 0.6);
    add_triangle(&mut scene);
    add_lamp(&mut scene);
    for path in ["mesh.shape.vertices", "camera.look_at", "light.lamp.position"] {
        check(&scene, path, [(4, 2e-2)]);
    }
}

/// Smooth cubes that mirror each other: next to an edge of what one shows, paths part before they come to it.
#[test]
fn edges_in_mirrors_of_mirrors() {
    let placed = |translation: [f64; 3], rotation: [f64; 3], scale: f64| Transform {
        translation: translation.into(),
        rotation: rotation.into(),
        scale: DVec3::splat(scale),
    };
    let scenes = [
        (
            [1.87, 3.6, 4.42],
            placed([0.48, 0.84, -0.94], [-4.2, 53.4, 18.0], 0.87),
            placed([-0.77, -0.06, -0.51], [5.4, 9.0, -58.2], 0.85),
        ),
        (
            [-4.66, -3.12, -2.14],
            placed([-0.01, 0.44, -0.8], [1.2, 41.4, 3.0], 0.85),
            placed([0.76, -0.26, -1.0], [30.6, -45.0, -58.8], 0.87),
        ),
    ];
    let (vertices, triangles) = cube();
    for (from, one, other) in scenes {
        let camera = Camera { vfov: 35.0, ..Camera::looking(from.into(), DVec3::ZERO) };
        let mut scene = Scene::new(48, 40, camera);
        scene.bounces = 7;
        let chrome = paint(&mut scene, "chrome", [0.5; 3], 0.6);
        for (name, transform) in [("one", one), ("other", other)] {
            let cube =
                Mesh::new(name, vertices.clone(), triangles.clone()).material(chrome).smooth();
            scene.add_mesh(Mesh { transform, ..cube }).unwrap();
        }
        add_sun(&mut scene);
        let settings = Settings { edges: Edges::On, ..Settings::default() };
        assert!(render(&scene, &settings).unwrap().is_finite());
    }
}

/// Next to where an icosahedron goes into a cube that mirrors it, rays that start at the mirror are not within it.
#[test]
fn surfaces_that_pierce_a_mirror() {
    let (from, at) = (DVec3::new(-1.25, 2.94, 4.711), DVec3::new(-0.194, -0.118, 0.144));
    let camera = Camera { vfov: 41.44, ..Camera::looking(from, at) };
    let mut scene = Scene::new(48, 48, camera);
    let chrome = paint(&mut scene, "chrome", [0.2, 0.5, 0.6], 0.6);
    let matt = paint(&mut scene, "matt", [0.8, 0.3, 0.2], 0.0);
    let transform = Transform {
        translation: DVec3::new(0.058, -0.53, 0.394),
        rotation: DVec3::new(31.663, 86.674, -34.188),
        scale: DVec3::splat(0.4355),
    };
    let (vertices, triangles) = cube();
    let cube = Mesh::new("cube", vertices, triangles).material(chrome);
    scene.add_mesh(Mesh { transform, ..cube }).unwrap();
    let transform = Transform {
        translation: DVec3::new(-0.452, 0.118, 0.416),
        rotation: DVec3::new(36.451, -85.191, -19.006),
        scale: DVec3::splat(0.2565),
    };
    let (vertices, triangles) = icosahedron();
    let shape = Mesh::new("shape", vertices, triangles).material(matt);
    scene.add_mesh(Mesh { transform, ..shape }).unwrap();
    let direction = DVec3::new(0.008, 3.308, 1.153);
    let sun = DistantLight { direction, color: DVec3::ONE, irradiance: 2.5 };
    scene.add_light("sun", sun).unwrap();
    check_pixels(&scene, "mesh.shape.translation", &[0.5, -0.6, 0.6], [0.2, 0.05]);
}

/// A cube from -1 to 1 along each axis.
fn cube() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let corner = |index: u32| [4, 2, 1].map(|bit| if index & bit == 0 { -1.0 } else { 1.0 });
    let sides =
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let triangles = sides.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    ((0..8).map(corner).collect(), triangles.collect())
}

/// An icosahedron with edges of length 2.
fn icosahedron() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let rectangle = [[-1.0, golden], [1.0, golden], [-1.0, -golden], [1.0, -golden]];
    let corners = [[0, 1, 2], [2, 0, 1], [1, 2, 0]]
        .into_iter()
        .flat_map(|axes| rectangle.map(|[short, long]| axes.map(|axis| [short, long, 0.0][axis])));
    let triangles = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    (corners.collect(), triangles)
}

/// Near the silhouette of a coarse smooth mirror, mirrored rays are lifted off the triangle that they would enter, and
/// jump from one triangle to the next, here over the edge of a shadow.
#[test]
fn triangles_that_lift_what_they_mirror() {
    let (from, at) = (DVec3::new(0.0, 1.5, 5.0), DVec3::new(0.0, 0.3, 0.0));
    let mut scene = Scene::new(32, 32, Camera::looking(from, at));
    let (grey, chrome) =
        (paint(&mut scene, "grey", [0.6; 3], 0.0), paint(&mut scene, "chrome", [0.1; 3], 0.8));
    let floor = [[-4.0, 4.0], [4.0, 4.0], [4.0, -4.0], [-4.0, -4.0]].map(|[x, z]| [x, -0.9, z]);
    let floor = Mesh::new("floor", floor.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
    scene.add_mesh(floor.material(grey)).unwrap();
    add_round(&mut scene, [6, 4], false, chrome, |u, v| {
        let ((out, y), (z, x)) = ((PI * (0.02 + 0.96 * v)).sin_cos(), (TAU * u).sin_cos());
        DVec3::new(0.8 * out * x, y, 0.9 * out * z)
    });
    let ball = scene.meshes.pop().unwrap();
    let normals = ball.vertices.iter().map(|&at| DVec3::from(at).normalize().to_array()).collect();
    let triangles = ball.triangles.clone();
    let place = Transform { translation: DVec3::new(-0.4, 0.2, -0.4), ..Transform::IDENTITY };
    scene.add_mesh(ball.normals(normals, triangles).transform(place)).unwrap();
    let position = DVec3::new(2.3, 4.1, 2.7);
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 60.0 };
    scene.add_light("lamp", lamp).unwrap();
    let along = [1.0, 0.4, -0.3];
    check_pixels_by(&scene, "mesh.round.translation", &along, [(8, 0.25)]);
}
