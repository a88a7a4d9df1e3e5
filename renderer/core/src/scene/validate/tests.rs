use super::*;
use crate::scene::example::tree;
use crate::scene::{DistantLight, SphereObject, SpotLight};

/// A scene with one of everything.
fn scene() -> Scene {
    let mut scene = tree();
    let (direction, color) = (DVec3::Y, DVec3::ONE);
    scene.add_light("sun", DistantLight { direction, color, irradiance: 1.0 }).unwrap();
    scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0)).unwrap();
    let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let normals = vec![[0.0, 0.0, 1.0], [0.0, 1e-9, 1e-9]];
    let sail = Mesh::new("sail", corners, vec![[0, 1, 2]]).normals(normals, vec![[0, 1, 1]]);
    scene.add_mesh(sail).unwrap();
    scene
}

/// What is said of a scene that `change` has broken.
fn refused(change: impl FnOnce(&mut Scene)) -> String {
    let mut scene = scene();
    change(&mut scene);
    scene.validate("a.toml").unwrap_err().to_string()
}

/// What is said of a scene in which the first number of `path` is `value`.
fn refused_value(path: &str, value: f64) -> String {
    let id = scene().parameter(path).unwrap();
    let error = refused(|scene| {
        let mut numbers = scene.get(id).into_owned();
        numbers[0] = value;
        scene.assign(id, &numbers);
    });
    assert!(error.starts_with(&format!("a.toml: {path}")), "{error}");
    error
}

#[test]
fn a_whole_scene_is_valid() {
    assert_eq!(scene().validate("a.toml"), Ok(()));
}

#[test]
fn no_parameter_may_be_infinite_or_not_a_number_or_huge() {
    let scene = scene();
    for id in scene.parameters() {
        let path = scene.path(id).to_string();
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let error = refused_value(&path, value);
            assert!(error.contains("not a finite number"), "{error}");
        }
        let expected = match path.as_str() {
            "camera.vfov" => "must lie between",
            path if path.ends_with(".roughness") => "must be at most 1",
            _ => "beyond",
        };
        assert!(refused_value(&path, 1e39).contains(expected), "{path}");
    }
}

#[test]
fn the_message_names_the_vertex() {
    let error = refused(|scene| scene.meshes[0].vertices[7][2] = f64::NAN);
    assert!(error.starts_with("a.toml: mesh.tree.vertices[7]: NaN"), "{error}");
}

#[test]
fn ranges_hold() {
    for (path, value) in [
        ("camera.vfov", 0.0),
        ("camera.vfov", 180.0),
        ("camera.film_scale", 0.0),
        ("camera.film_scale", -1.0),
        ("sphere.ball.radius", 0.0),
        ("sphere.ball.radius", -1.0),
        ("light.key.color", -0.1),
        ("light.sun.irradiance", -1.0),
        ("material.bark.emission", -1.0),
        ("material.bark.diffuse", -1.0),
        ("material.bark.specular", -1.0),
        ("material.bark.exponent", -1.0),
        ("material.bark.mirror", -1.0),
    ] {
        let error = refused_value(path, value);
        assert!(error.contains("must"), "{error}");
    }
}

#[test]
fn cones_have_no_sharp_edge() {
    let angles = |[inner_angle, outer_angle]: [f64; 2]| {
        let mut scene = scene();
        let (position, direction, color) = (DVec3::Y, DVec3::NEG_Y, DVec3::ONE);
        let radiant_intensity = 1.0;
        let spot =
            SpotLight { position, direction, color, radiant_intensity, inner_angle, outer_angle };
        scene.add_light("spot", spot)
    };
    assert!(angles([14.999, 15.0]).is_ok());
    for wrong in [[15.0, 15.0], [25.0, 15.0]] {
        let error = angles(wrong).unwrap_err().to_string();
        assert!(error.contains("light.spot.inner_angle: "), "{error}");
        assert!(error.contains("must be below `outer_angle`, 15"), "{error}");
    }
}

#[test]
fn the_camera_looks_somewhere() {
    let error = refused(|s| s.camera.look_at = s.camera.look_from);
    assert_eq!(error, "a.toml: camera.look_from: must differ from camera.look_at");
    // Apart at f64, the same at f32.
    let error = refused(|s| {
        s.camera.look_from = DVec3::new(1e6, 0.0, 0.0);
        s.camera.look_at = DVec3::new(1e6 + 1e-6, 0.0, 0.0);
    });
    assert!(error.contains("must differ"), "{error}");
    let error = refused(|s| {
        let camera = &mut s.camera;
        camera.up = (camera.look_from - camera.look_at) * 3.0;
    });
    assert!(error.starts_with("a.toml: camera.up: must not be parallel"), "{error}");
    let error = refused(|s| s.camera.up = DVec3::ZERO);
    assert!(error.starts_with("a.toml: camera.up: must be a direction"), "{error}");
    let zero = |s: &mut Scene| {
        let id = s.parameter("light.sun.direction").unwrap();
        s.assign(id, &[0.0; 3]);
    };
    assert!(refused(zero).contains("light.sun.direction: must be a direction"));
}

#[test]
fn the_image_has_an_area() {
    assert!(refused(|s| s.width = 0).contains("camera.width: must be at least 1"));
    assert!(refused(|s| s.height = 0).contains("camera.height: must be at least 1"));
    assert!(refused(|s| (s.width, s.height) = (1 << 15, 1 << 14)).contains("pixels"));
}

#[test]
fn indices_are_in_range() {
    assert!(refused(|s| s.spheres[0].material = 2).contains("sphere.ball.material"));
    assert!(
        refused(|s| s.meshes[0].materials[3] = 2)
            .contains("mesh.tree.material: names material 2 of 2")
    );
    assert!(refused(|s| s.meshes[0].triangles[3][1] = 10_000).contains("names vertex 10000"));
    assert!(refused(|s| s.meshes[0].materials.truncate(1)).contains("1 materials for"));
}

#[test]
fn normals_are_directions_that_exist() {
    let with = |normals: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>| {
        refused(|s| s.meshes[1] = s.meshes[1].clone().normals(normals, triangles))
    };
    let up = [0.0, 0.0, 1.0];
    for (error, expected) in [
        (with(vec![up, up], vec![[0, 1, 2]]), "normals: names normal 2 of 2"),
        (with(vec![up], vec![]), "normals: 0 triangles of normals for 1"),
        (with(vec![up, [0.0; 3]], vec![[0; 3]]), "normals[1]: must be a direction, is the zero"),
        (with(vec![up, [1e-20; 3]], vec![[0; 3]]), "normals[1]: must be a direction, is the zero"),
        (with(vec![up, [0.0, f64::NAN, 1.0]], vec![[0; 3]]), "normals[1]: NaN is not a finite"),
        (with(vec![[1e30; 3]], vec![[0; 3]]), "normals[0]: 1e30 is beyond"),
    ] {
        assert!(error.starts_with(&format!("a.toml: mesh.sail.{expected}")), "{error}");
    }
}

#[test]
fn names_are_unique_and_readable() {
    assert!(refused(|s| s.lights[1].name = "key".to_owned()).contains("light.key: two light"));
    assert!(
        refused(|s| s.meshes[0].name.clear())
            .contains("mesh: an object of this kind has an empty name")
    );
    assert!(refused(|s| s.spheres[0].name = " a".to_owned()).contains("must not begin or end"));
    assert!(refused(|s| s.spheres[0].name = "a\nb".to_owned()).contains("sphere.a\\nb: "));
}

#[test]
fn a_name_with_dots_is_reached() {
    let mut scene = scene();
    scene.meshes[0].name = "Cube.001".to_owned();
    assert_eq!(scene.check(), Ok(()));
    assert_eq!(
        scene.parameter("mesh.Cube.001.vertices"),
        Ok(ParameterId::new(Object::Mesh(0), "vertices"))
    );
}
