//! Edges of smooth meshes, of facets as small as pixels, of spheres and of custom shapes.

use renderer::glam::{DMat3, DVec3};
use renderer::scene::MaterialObject;
use renderer::{
    Camera, DistantLight, Edges, Image, Material, Mesh, PointLight, Scene, SphereObject, render,
};

use crate::custom;
use crate::differences::relative_error;
use crate::edges::{
    add_ball, add_floor, add_lamp, add_sun, add_wedge, check, check_pixels, gradient, paint, scene,
    settings, veil, weighted_jvp,
};

/// A ball of facets that are about as large as a pixel; each facet has vertices of its own, or they share
/// them.
pub fn add_facets(scene: &mut Scene, are_shared: bool) {
    let paint = paint(scene, "facets", [0.8, 0.3, 0.2], 0.0);
    let (rows, columns) = (14_u32, 25_u32);
    let corner = |index: u32| {
        let [polar, azimuth] = [
            std::f64::consts::PI * f64::from(index / columns) / f64::from(rows),
            std::f64::consts::TAU * f64::from(index % columns) / f64::from(columns),
        ];
        let (out, up) = polar.sin_cos();
        let direction = DVec3::new(out * azimuth.sin(), up, out * azimuth.cos());
        (DVec3::new(0.1, 0.7, 0.0) + 0.6 * direction).to_array()
    };
    let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    let facets: Vec<[u32; 3]> = cells
        .flat_map(|(row, column)| {
            let next = (column + 1) % columns;
            let [a, b] = [column, next].map(|column| row * columns + column);
            let [c, d] = [a, b].map(|corner| corner + columns);
            [[a, c, b], [b, c, d]]
        })
        .collect();
    let (vertices, triangles) = match are_shared {
        true => ((0..(rows + 1) * columns).map(corner).collect(), facets),
        false => {
            let own = |index: usize| [0, 1, 2].map(|at| 3 * index as u32 + at);
            let vertices = facets.as_flattened().iter().map(|&index| corner(index)).collect();
            (vertices, (0..facets.len()).map(own).collect())
        }
    };
    scene.add_mesh(Mesh::new("shape", vertices, triangles).material(paint)).unwrap();
}

/// Where facets share vertices, the search walks from one to the next; where they do not, it traces rays,
/// which may miss a facet that is crossed in a corner.
#[test]
fn walks_over_meshes_find_what_rays_find() {
    let [walked, traced] = [true, false].map(|are_shared| {
        let mut scene = scene();
        add_facets(&mut scene, are_shared);
        add_sun(&mut scene);
        let paths = ["camera.look_from", "mesh.shape.translation", "light.sun.direction"];
        let gradients = paths.map(|path| gradient(&scene, &settings(Edges::On, 1), path)).concat();
        let image = render(&scene, &settings(Edges::On, 1)).unwrap();
        (gradients, image)
    });
    let error = relative_error(&walked.0, &traced.0);
    assert!(error < 1e-2, "{error:.1e}: {:?} {:?}", walked.0, traced.0);
    let pixels = walked.1.pixels.as_flattened().iter().zip(traced.1.pixels.as_flattened());
    let off = pixels.map(|(a, b)| (a - b).abs()).max_by(f32::total_cmp);
    assert!(off.is_some_and(|off| off < 0.02), "{off:?}");
}

/// Facets at a smooth silhouette are seen nearly edge-on.
#[test]
fn silhouettes_of_smooth_meshes() {
    let mut scene = scene();
    add_facets(&mut scene, true);
    scene.meshes[0] = scene.meshes[0].clone().smooth();
    add_sun(&mut scene);
    for path in ["camera.look_from", "mesh.shape.translation"] {
        check(&scene, path, [(1, 0.1), (4, 0.1)]);
    }
    // Forward and reverse mode have the same rays.
    let (path, settings) = ("mesh.shape.translation", settings(Edges::On, 1));
    let forward = weighted_jvp(&scene, &settings, path, vec![0.3, -0.2, 0.5]);
    let moved = gradient(&scene, &settings, path);
    let along = 0.3 * moved[0] - 0.2 * moved[1] + 0.5 * moved[2];
    assert!((forward - along).abs() < 1e-5 * along.abs(), "{forward} {along}");
}

/// Normals are turned to the viewer triangle by triangle. Those of a ridge that are behind one of its faces leave
/// shading continuous where the others of the face are not, and else make it jump at the ridge.
#[test]
fn normals_behind_a_face() {
    let to_the_left = [-0.9, 0.1, 0.3];
    for on_the_right in [[0.5, 0.0, 0.9], [-0.7, 0.0, 0.2]] {
        let mut scene = scene();
        let cloth = paint(&mut scene, "cloth", [0.8, 0.3, 0.2], 0.0);
        let columns = [[-0.8, 0.0], [0.05, 0.3], [0.8, -0.1]];
        let corners = columns.into_iter().flat_map(|[x, z]| [[x, -0.1, z], [x + 0.1, 1.3, z]]);
        let faces = vec![[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]];
        let of_columns = [[-0.3, 0.1, 0.9], to_the_left, on_the_right];
        let normals = of_columns.into_iter().flat_map(|normal| [normal, normal]).collect();
        let mesh = Mesh::new("shape", corners.collect(), faces.clone()).normals(normals, faces);
        scene.add_mesh(mesh.material(cloth)).unwrap();
        let direction = DVec3::new(-0.2, 0.3, 1.0);
        let sun = DistantLight { direction, color: DVec3::ONE, irradiance: 2.0 };
        scene.add_light("sun", sun).unwrap();
        for path in ["camera.look_at", "mesh.shape.vertices"] {
            check(&scene, path, [(1, 0.02)]);
        }
    }
}

/// A sail whose last facet before the silhouette is seen edge-on: in a twentieth of a pixel, where hardly a sample meets
/// it, the sail goes from light to dark.
fn add_sail(scene: &mut Scene, towards_sun: DVec3) {
    let cloth = paint(scene, "cloth", [0.8, 0.3, 0.2], 0.0);
    let columns = [[-0.8, 0.0], [0.5, 0.3], [0.57, -0.5]];
    let corners = columns.into_iter().flat_map(|[x, z]| [[x, -0.4, z], [x + 0.1, 1.3, z]]);
    let faces = vec![[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]];
    scene.add_mesh(Mesh::new("shape", corners.collect(), faces).material(cloth).smooth()).unwrap();
    let sun = DistantLight { direction: towards_sun, color: DVec3::ONE, irradiance: 2.0 };
    scene.add_light("sun", sun).unwrap();
}

/// A pane through which the camera sees all of the scene.
fn add_pane(scene: &mut Scene) {
    let corners = vec![[-3.0, -2.0, 2.5], [3.0, -2.0, 2.5], [3.0, 4.0, 2.5], [-3.0, 4.0, 2.5]];
    let pane = Mesh::new("pane", corners, vec![[0, 1, 2], [0, 2, 3]]).material(veil(scene));
    scene.add_mesh(pane).unwrap();
}

#[test]
fn pixels_at_silhouettes_of_smooth_meshes() {
    let mut scene = scene();
    add_sail(&mut scene, DVec3::Z);
    for is_behind_pane in [false, true] {
        if is_behind_pane {
            add_pane(&mut scene);
        }
        check_pixels(&scene, "mesh.shape.translation", &[1.0, 0.0, 0.0], [0.2, 0.2]);
    }
}

/// The last facet has turned its back to the light, which its normals still face, so that it is in its own shadow.
#[test]
fn own_shadows_next_to_silhouettes_of_smooth_meshes() {
    for x in [-0.6, -1.0] {
        let mut scene = scene();
        add_sail(&mut scene, DVec3::new(x, 0.1, 1.0));
        check(&scene, "mesh.shape.translation", [(1, 0.1), (4, 0.1)]);
        check_pixels(&scene, "mesh.shape.translation", &[1.0, 0.0, 0.0], [0.15, 0.15]);
    }
}

/// What is behind a pane or in a mirror has strips and own shadows as what is seen directly.
#[test]
fn own_shadows_behind_a_pane_and_in_a_mirror() {
    let [mut behind_pane, mut in_mirror] = [scene(), scene()];
    add_pane(&mut behind_pane);
    add_floor(&mut in_mirror, 0.8);
    for (mut scene, most) in [(behind_pane, 0.15), (in_mirror, 0.25)] {
        add_sail(&mut scene, DVec3::new(-0.6, 0.1, 1.0));
        check_pixels(&scene, "mesh.shape.translation", &[1.0, 0.0, 0.0], [most; 2]);
    }
}

/// The shadow of a wall on a smooth ball ends just within the silhouette.
#[test]
fn shadows_next_to_silhouettes_of_smooth_meshes() {
    for end in [0.1, 0.15] {
        let mut scene = scene();
        add_facets(&mut scene, true);
        scene.meshes[0] = scene.meshes[0].clone().smooth();
        let corners = [[-2.0, -3.0], [3.0, -3.0], [3.0, end], [-2.0, end]];
        let corners = corners.into_iter().map(|[y, z]| [1.5, y, z]).collect();
        scene.add_mesh(Mesh::new("wall", corners, vec![[0, 1, 2], [0, 2, 3]])).unwrap();
        let direction = DVec3::new(1.0, 0.1, 0.05);
        let sun = DistantLight { direction, color: DVec3::ONE, irradiance: 2.0 };
        scene.add_light("sun", sun).unwrap();
        check(&scene, "mesh.shape.translation", [(1, 0.1), (4, 0.1)]);
    }
}

/// Where the light stands behind one face of a smooth ridge and before the other, the shadow of the mesh on itself
/// ends beside the ridge, where rays that start above the surface come to the light, or at the ridge.
#[test]
fn shadows_of_smooth_meshes_on_themselves() {
    let mut beside = scene();
    add_wedge(&mut beside);
    let mut at_ridge = scene();
    let paint = paint(&mut at_ridge, "roof", [0.8, 0.3, 0.2], 0.0);
    let corners = [[-0.9, 0.0], [0.0, 0.6], [0.7, -0.3]];
    let corners = corners.into_iter().flat_map(|[x, z]| [[x, -0.5, z], [x, 1.3, z]]).collect();
    let faces = vec![[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]];
    at_ridge.add_mesh(Mesh::new("shape", corners, faces).material(paint)).unwrap();
    for (mut scene, direction) in [(beside, [1.0, 0.25, 0.2]), (at_ridge, [1.0, 0.0, -0.25])] {
        scene.meshes[0] = scene.meshes[0].clone().smooth();
        let sun = DistantLight { direction: direction.into(), color: DVec3::ONE, irradiance: 2.0 };
        scene.add_light("sun", sun).unwrap();
        check(&scene, "mesh.shape.translation", [(4, 5e-3)]);
        check(&scene, "mesh.shape.rotation", [(4, 3e-2)]);
        check(&scene, "light.sun.direction", [(4, 5e-3)]);
    }
}

/// Where a coarse smooth mesh pierces a floor or a ball, shadow rays start above it and come out beyond the other
/// surface, which then is in the way of the light or no longer is.
#[test]
fn shadow_rays_that_start_beyond_another_surface() {
    let [mut in_floor, mut in_ball] = [scene(), scene()];
    add_floor(&mut in_floor, 0.0);
    let hill = paint(&mut in_ball, "hill", [0.3, 0.7, 0.4], 0.0);
    let ball = SphereObject::new("ball", DVec3::new(0.1, -3.0, 0.3), 3.0).material(hill);
    in_ball.add_sphere(ball).unwrap();
    let center = DVec3::new(0.1, 0.35, 0.3);
    for (mut scene, of_other) in
        [(in_floor, "mesh.floor.translation"), (in_ball, "sphere.ball.center")]
    {
        let paint = paint(&mut scene, "gem", [0.4, 0.5, 0.8], 0.0);
        let turned = DMat3::from_rotation_z(0.2) * DMat3::from_rotation_x(0.3);
        let corners = turned.to_cols_array_2d().into_iter().map(DVec3::from);
        let corners = corners.flat_map(|axis| [axis, -axis]);
        let corners = corners.map(|corner| (center + 0.6 * corner).to_array()).collect();
        let side = |signs: u32| {
            let [x, y, z] = [0, 1, 2].map(|axis| 2 * axis + (signs >> axis & 1));
            if signs.count_ones().is_multiple_of(2) { [x, y, z] } else { [y, x, z] }
        };
        let gem = Mesh::new("gem", corners, (0..8).map(side).collect()).material(paint).smooth();
        scene.add_mesh(gem).unwrap();
        let position = DVec3::new(1.1, 0.4, 2.5);
        let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 12.0 };
        scene.add_light("lamp", lamp).unwrap();
        for path in ["mesh.gem.translation", "mesh.gem.vertices", of_other, "light.lamp.position"] {
            check(&scene, path, [(4, 0.05)]);
        }
    }
}

/// A coarse cloth, whose folds hide each other from the light, and one triangle the next from the camera: neighbours that
/// show different sides are no one surface.
#[test]
fn folds_of_a_smooth_cloth() {
    let mut scene = scene();
    let cloth = paint(&mut scene, "cloth", [0.8, 0.3, 0.2], 0.0);
    let (rows, columns) = (9, 11);
    let corner = |index: u32| {
        let (row, column) = (f64::from(index / columns), f64::from(index % columns));
        let height = 0.5 * (1.3 * column).sin() * (0.9 * row).cos();
        [0.2 * column - 1.0, 0.5 + height, 0.2 * row - 0.8]
    };
    let cells = (0..rows - 1).flat_map(|row| (0..columns - 1).map(move |column| (row, column)));
    let faces = cells.flat_map(|(row, column)| {
        let [a, b] = [row * columns + column, (row + 1) * columns + column];
        [[a, b, b + 1], [a, b + 1, a + 1]]
    });
    let corners = (0..rows * columns).map(corner).collect();
    let mesh = Mesh::new("shape", corners, faces.collect()).material(cloth).smooth();
    scene.add_mesh(mesh).unwrap();
    let direction = DVec3::new(1.0, 0.3, 0.5);
    let sun = DistantLight { direction, color: DVec3::ONE, irradiance: 2.0 };
    scene.add_light("sun", sun).unwrap();
    for path in ["mesh.shape.translation", "camera.look_at", "light.sun.direction"] {
        check(&scene, path, [(4, 0.2)]);
    }
}

/// A shadow ends on facets that are about as large as a pixel: most links with its edge have a ridge, too.
#[test]
fn shadows_on_facets() {
    let mut scene = scene();
    add_facets(&mut scene, true);
    let corners = vec![[0.1, 1.0, 1.4], [0.8, 1.4, 0.6], [0.0, 1.6, 0.7]];
    scene.add_mesh(Mesh::new("leaf", corners, vec![[0, 1, 2]])).unwrap();
    add_lamp(&mut scene);
    for path in ["light.lamp.position", "mesh.leaf.translation"] {
        check(&scene, path, [(1, 0.1), (4, 0.03)]);
    }
}

#[test]
fn spheres() {
    let mut scene = scene();
    add_floor(&mut scene, 0.0);
    add_ball(&mut scene);
    add_lamp(&mut scene);
    for path in ["sphere.ball.center", "sphere.ball.radius", "light.lamp.position"] {
        check(&scene, path, [(4, 0.1)]);
    }
}

/// Where a ball pierces another one, it keeps the light off a strip of that which no sample may be in.
#[test]
fn creases_of_balls() {
    let camera = Camera::looking(DVec3::new(0.5, 1.5, 5.0), DVec3::ZERO);
    let mut scene = Scene::new(48, 36, Camera { vfov: 30.0, ..camera });
    paint(&mut scene, "balls", [0.7; 3], 0.0);
    scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0)).unwrap();
    scene.add_sphere(SphereObject::new("other", DVec3::new(0.8, 0.5, 0.5), 0.7)).unwrap();
    let position = DVec3::new(3.0, 5.0, 4.0);
    let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 100.0 };
    scene.add_light("lamp", lamp).unwrap();
    let truth = render(&scene, &settings(Edges::Off, 48)).unwrap();
    for (side, most) in [(1, 0.1), (2, 0.03), (4, 0.01)] {
        let image = render(&scene, &settings(Edges::On, side)).unwrap();
        let largest =
            |image: &Image| image.pixels.as_flattened().iter().copied().fold(0.0, f32::max);
        let error = largest(&image.absolute_difference(&truth).unwrap()) / largest(&truth);
        assert!(error < most, "{side}: {error}");
    }
}

/// Next to the silhouette of a curved surface the derivative grows without bound; terminators are near it where the
/// light is next to the camera, and where it comes from the side.
#[test]
fn pixels_at_silhouettes_of_curved_surfaces() {
    for direction in [DVec3::new(0.3, 0.4, 1.0), DVec3::new(1.0, 0.5, 0.1)] {
        let sun = DistantLight { direction, color: DVec3::ONE, irradiance: 2.0 };
        let [mut ball, mut egg] = [scene(), scene()];
        add_ball(&mut ball);
        ball.add_light("sun", sun).unwrap();
        check_pixels(&ball, "sphere.ball.radius", &[1.0], [0.1, 0.05]);
        check_pixels(&ball, "sphere.ball.center", &[0.6, 0.5, 0.3], [0.1, 0.05]);
        add_pane(&mut ball);
        check_pixels(&ball, "sphere.ball.center", &[0.6, 0.5, 0.3], [0.1, 0.05]);
        let paint = paint(&mut egg, "egg", [0.8, 0.3, 0.2], 0.0);
        custom::add_egg(&mut egg, paint);
        egg.add_light("sun", sun).unwrap();
        check_pixels(&egg, "shape.egg.translation", &[0.6, 0.5, 0.3], [0.15, 0.08]);
    }
}

/// A light at the camera grazes facets and rough surfaces where the viewer grazes them, and the derivative by its
/// position grows without bound there.
#[test]
fn a_light_at_the_camera_moves() {
    let metal = MaterialObject::metallic_roughness(DVec3::splat(0.8), 0.7, 0.5);
    let rough = Material { roughness: 0.6, ..Material::lambertian(DVec3::splat(0.8)) };
    for material in [metal, rough.into()] {
        let mut scene = scene();
        let material = scene.add_material("ball", material).unwrap();
        let ball = SphereObject::new("ball", DVec3::new(0.1, 0.7, 0.0), 0.55).material(material);
        scene.add_sphere(ball).unwrap();
        let position = scene.camera.look_from;
        let lamp = PointLight { position, color: DVec3::ONE, radiant_intensity: 30.0 };
        scene.add_light("lamp", lamp).unwrap();
        check_pixels(&scene, "light.lamp.position", &[0.6, 0.5, 0.3], [0.15, 0.1]);
    }
}
