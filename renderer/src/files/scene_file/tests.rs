use std::fs;

use super::*;
use crate::Image;
use crate::demo::demo_experiment;
use crate::experiment::{OptimizeSection, Target, TunedParameter};
use crate::files::images::save_png;
use crate::loss::LossKind;
use crate::optimize::{Optimizer, Scale, Schedule, Sgd};
use crate::scene::{
    Bsdf, DistantLight, Light, LightSource, MaterialObject, Normals, Scene, Slot, SphereObject,
    Texture, Wrap,
};
use glam::DVec3;

const MESH: &str = "o one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n\
    o two\nv 0 0 1\nv 1 0 1\nv 0 1 1\nusemtl blue\nf 4 5 6\n";
pub(super) const LIBRARY: &str = "newmtl red\nKd 1 0 0\nNs 7\nnewmtl blue\nKd 0 0 1\n";
pub(super) const CAMERA: &str =
    "[camera]\nlook_from = [0, 0, 5]\nlook_at = [0, 0, 0]\nwidth = 8\nheight = 4\n";
pub(super) const LIGHT: &str =
    "[[light]]\nname = \"key\"\ntype = \"point\"\nposition = [1, 2, 3]\nradiant_intensity = 4\n";

/// A folder with `a.obj` and its library.
pub(super) fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.obj"), format!("mtllib a.mtl\n{MESH}")).unwrap();
    fs::write(folder.path().join("a.mtl"), LIBRARY).unwrap();
    folder
}

fn material_names(scene: &Scene) -> Vec<&str> {
    scene.materials.iter().map(|material| material.name.as_str()).collect()
}

fn parse_text(text: &str) -> Result<Experiment, Error> {
    Experiment::parse(text, folder().path(), "s.toml")
}

/// The camera's five lines, then `rest`, whose first line is therefore line 6.
fn scene_of(rest: &str) -> Scene {
    parse_text(&format!("{CAMERA}{rest}")).unwrap().scene
}

fn refused(rest: &str) -> String {
    let error = parse_text(&format!("{CAMERA}{rest}")).unwrap_err().to_string();
    assert!(!error.contains('\n'), "{error}");
    error
}

#[test]
fn defaults_are_filled_in() {
    let scene = scene_of(LIGHT);
    let camera = &scene.camera;
    assert_eq!((camera.up, camera.vfov, camera.film_scale), (DVec3::Y, 45.0, 1.0));
    assert_eq!((scene.width, scene.height), (8, 4));
    let LightSource::Known(Light::Point(light)) = &scene.lights[0].source else {
        panic!("a point light")
    };
    assert_eq!((light.position, light.color), (DVec3::new(1.0, 2.0, 3.0), DVec3::ONE));
    assert_eq!(light.radiant_intensity, 4.0);
}

#[test]
fn materials_are_overridden_defined_and_shared() {
    let scene = scene_of(
        "[[mesh]]\npath = \"a.obj\"\n\
         [[mesh]]\npath = \"a.obj\"\nname = \"joined\"\n\
         [[mesh]]\npath = \"a.obj\"\nname = \"gold one\"\nmaterial = \"gold\"\n\
         [[sphere]]\nname = \"ball\"\ncenter = [1, 2, 3]\nradius = 0.5\nmaterial = \"blue\"\n\
         [material.red]\ndiffuse = [0.5, 0.5, 0.5]\n\
         [material.gold]\nspecular = [1, 1, 0]\nexponent = 20\n",
    );
    let names: Vec<&str> = scene.meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(names, ["one", "two", "joined", "gold one"]);
    // First those of the scene file, in its order, then what the meshes bring.
    assert_eq!(material_names(&scene), ["red", "gold", "blue"]);
    let [red, gold, blue] = [0, 1, 2].map(|index| scene.materials[index].values);
    assert_eq!((red.diffuse, red.exponent), (DVec3::splat(0.5), 7.0));
    assert_eq!((gold.diffuse, gold.exponent), (DVec3::splat(0.7), 20.0));
    assert_eq!(blue.diffuse, DVec3::Z);
    assert_eq!(scene.meshes[2].materials, [0, 2]);
    assert_eq!(scene.meshes[2].triangles, [[0, 1, 2], [3, 4, 5]]);
    assert_eq!(scene.meshes[3].materials, [1, 1]);
    assert_eq!(scene.spheres[0].material, 2);
}

/// Objects and groups of an OBJ file name the vertices of the file: a mesh of all of them tears nowhere.
#[test]
fn joined_objects_share_vertices() {
    for keyword in ["o", "g"] {
        let folder = folder();
        let text = format!(
            "v -1 0 0\nv 0 0 1\nv 0 1 1\nv 1 0 0\n{keyword} a\nf 1 2 3\n{keyword} b\nf 2 4 3\n"
        );
        fs::write(folder.path().join("roof.obj"), text).unwrap();
        let scene = format!(
            "{CAMERA}[[mesh]]\npath = \"roof.obj\"\n[[mesh]]\npath = \"roof.obj\"\nname = \"roof\"\n"
        );
        let scene = Experiment::parse(&scene, folder.path(), "s.toml").unwrap().scene;
        let counts = scene.meshes.iter().map(|mesh| (&*mesh.name, mesh.vertices.len()));
        assert_eq!(counts.collect::<Vec<_>>(), [("a", 3), ("b", 3), ("roof", 4)]);
        assert_eq!(scene.meshes[2].triangles, [[0, 1, 2], [1, 3, 2]]);
    }
}

#[test]
fn one_name_for_two_materials_is_told_apart() {
    let folder = folder();
    fs::write(folder.path().join("b.obj"), format!("mtllib b.mtl\n{MESH}")).unwrap();
    fs::write(folder.path().join("b.mtl"), "newmtl red\nKd 0 1 0\nnewmtl blue\nKd 0 0 1\n")
        .unwrap();
    let text = format!("{CAMERA}[[mesh]]\npath = \"a.obj\"\n[[mesh]]\npath = \"b.obj\"\n");
    let scene = Experiment::parse(&text, folder.path(), "s.toml").unwrap().scene;
    assert_eq!(material_names(&scene), ["red", "blue", "red_2"]);
    let materials: Vec<u32> = scene.meshes.iter().map(|mesh| mesh.materials[0]).collect();
    assert_eq!(materials, [0, 1, 2, 1]);
    assert_eq!(scene.meshes[2].name, "one_2");
    // An override holds for both.
    let text = format!("{text}[material.red]\nexponent = 3\n");
    let scene = Experiment::parse(&text, folder.path(), "s.toml").unwrap().scene;
    assert_eq!(material_names(&scene), ["red", "blue", "red_2"]);
    let [red, _, other] = [0, 1, 2].map(|index| scene.materials[index].values);
    assert_eq!((red.diffuse, red.exponent), (DVec3::X, 3.0));
    assert_eq!((other.diffuse, other.exponent), (DVec3::Y, 3.0));
}

#[test]
fn the_optimise_section_is_read() {
    let text = format!(
        "{CAMERA}{LIGHT}[optimize]\nloss = \"l1\"\nlearning_rate = 0.1\niterations = 7\n\
         tolerance = 0\ngradient_tolerance = 1e-9\n\
         optimizer = {{ type = \"sgd\", momentum = 0.5 }}\nschedule = \"cosine\"\n\
         [optimize.target_values]\n\"light.key.position\" = [3, 2, 1]\n\
         \"light.key.radiant_intensity\" = 9\n\
         [[optimize.parameter]]\npath = \"light.key.position\"\nmin = -5\nmax = [1, inf, 3]\n\
         [[optimize.parameter]]\npath = \"camera.vfov\"\nscale = \"log\"\nlearning_rate = 2\n"
    );
    let id = |path: &str| scene_of(LIGHT).parameter(path).unwrap();
    let expected = OptimizeSection {
        target: Some(Target::Values(vec![
            (id("light.key.position"), vec![3.0, 2.0, 1.0]),
            (id("light.key.radiant_intensity"), vec![9.0]),
        ])),
        parameters: vec![
            TunedParameter {
                min: Some(vec![-5.0; 3]),
                max: Some(vec![1.0, f64::INFINITY, 3.0]),
                ..TunedParameter::new(id("light.key.position"))
            },
            TunedParameter {
                scale: Scale::Log,
                learning_rate: Some(2.0),
                ..TunedParameter::new(id("camera.vfov"))
            },
        ],
        loss: Some(LossKind::L1),
        optimizer: Some(Optimizer::Sgd(Sgd { momentum: 0.5 })),
        schedule: Some(Schedule::named("cosine").unwrap()),
        learning_rate: Some(0.1),
        iterations: Some(7),
        tolerance: Some(0.0),
        gradient_tolerance: Some(1e-9),
        ..OptimizeSection::default()
    };
    assert_eq!(parse_text(&text).unwrap().optimize, Some(expected));
    let image = parse_text(&format!("{CAMERA}[optimize]\ntarget = \"t.png\"\n")).unwrap();
    let Some(Target::Image(path)) = image.optimize.unwrap().target else { panic!("an image") };
    assert!(path.is_absolute() && path.ends_with("t.png"));
}

#[test]
fn mistakes_in_the_file_are_placed() {
    for (rest, expected) in [
        (
            "film_scale = 1\n[[light]]\nname = \"k\"\ntype = \"point\"\nradiant_intensity = \"much\"\n",
            "s.toml:10: invalid type: string \"much\", expected a number or an array of numbers in \
             `light.radiant_intensity`",
        ),
        (
            "[optimize]\niterations = -3\n",
            "s.toml:7: invalid value: integer `-3`, expected a whole",
        ),
        (
            "[optimize]\niterations = 99999999999999999999\n",
            "s.toml:7: invalid type: integer `99999999999999999999`, expected a whole number, 0 or",
        ),
        (
            "[integrator]\ntype = \"path\"\nmax_depth = -1\n",
            "s.toml:8: invalid value: integer `-1`, expected a whole number from 0 to 4294967295 in \
             `integrator.max_depth`",
        ),
        ("[integrator]\nmax_depth = 3\n", "s.toml:6: missing field `type` in `integrator`"),
        ("[camera]\n", "s.toml:6: `camera` is given twice"),
        ("vfov = 99999999999999999999\n", "s.toml:6: camera.vfov: must lie between"),
        (
            "[optimize]\niterations = 2.5\n",
            "s.toml:7: invalid type: floating point `2.5`, expected a w",
        ),
        ("focuss = 1\n", "s.toml:6: unknown field `focuss`, expected one of `look_from`"),
        (
            "vfov = \"wide\"\n",
            "s.toml:6: invalid type: string \"wide\", expected a number or an array of numbers in \
             `camera.vfov`",
        ),
        ("vfov = 45\nvfov = 46\n", "s.toml:7: `vfov` is given twice"),
        ("up = [0, 1]\n", "s.toml:6: camera.up: needs 3 numbers, has 2"),
        ("up = 1\n", "s.toml:6: camera.up: needs 3 numbers, has 1"),
        ("vfov = [45]\n", "s.toml:6: camera.vfov: is a number, not an array"),
        ("focus = 1\n", "s.toml:6: camera.focus: is called film_scale now"),
        ("vfov = 1_\n", "s.toml:6: "),
        ("vfov = nan\n", "s.toml:6: camera.vfov: NaN is not a finite number"),
        ("vfov = 1e400\n", "s.toml:6: "),
        ("vfov = 180\n", "s.toml:6: camera.vfov: must lie between 0.001 and 179.999, is 180"),
        ("\nup = [0, 0, 2]\n", "s.toml:7: camera.up: must not be parallel"),
        (
            "[lights]\n",
            "s.toml:6: unknown field `lights`, expected one of `bounces`, `light_samples`, `integrator`",
        ),
        (
            "[[light]]\nname = \"k\"\ntype = \"laser\"\n",
            "s.toml:8: light.k.type: `laser` is no type of light; there are point, distant, spot, \
             rectangle, disc",
        ),
        (
            "[[light]]\nname = \"k\"\n",
            "s.toml:6: light.k.type: is missing; the types of lights are point, distant",
        ),
        ("[[light]]\ntype = \"point\"\n", "s.toml:6: light: number 1 has no name"),
        (
            "[[light]]\nname = \"k\"\ntype = \"point\"\nposition = [1, 2, 3]\nintensity = 1\n",
            "s.toml:10: light.k.intensity: is radiant_intensity (W/sr) of a point light now",
        ),
        (
            "[[light]]\nname = \"k\"\ntype = \"point\"\nposition = [1, 2, 3]\npower = 1\n\
             radiant_intensity = 1\n",
            "s.toml:10: light.k.power: give either power or radiant_intensity",
        ),
        (
            "[[light]]\nname = \"k\"\ntypo = \"point\"\n",
            "s.toml:8: unknown field `typo`, expected one of `position`, `direction`, `center`, \
             `right`, `up`, `color`, `radiant_intensity`, `irradiance`, `radiance`, `inner_angle`, \
             `outer_angle`, `name`, `type`, `power`",
        ),
        (
            "[[light]]\nname = \"k\"\ntype = \"point\"\nradiant_intensity = 1\n",
            "s.toml:6: light.k.position: is missing; a light needs one",
        ),
        (
            "[[light]]\nname = \"k\"\ntype = \"distant\"\nposition = [1, 2, 3]\n\
             direction = [0, 1, 0]\nirradiance = 1\n",
            "s.toml:9: light.k.position: this light has none; its numbers are direction, color",
        ),
        (
            "[[light]]\nname = \"k\"\ntype = \"distant\"\ndirection = [0, 0, 0]\nirradiance = 1\n",
            "s.toml:9: light.k.direction: must be a direction",
        ),
        (
            "[[sphere]]\nname = \"b\"\ncenter = [0, 0, 0]\nradius = -1\nmaterial = \"m\"\n[material.m]\n",
            "s.toml:9: sphere.b.radius: must be above 0, is -1",
        ),
        (
            "[[sphere]]\nname = \"b\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n",
            "s.toml:10: sphere.b.material: no material `m`; the scene has none",
        ),
        ("[material.m]\nexponent = -1\n", "s.toml:7: material.m.exponent: must not be negative"),
        ("[material.m]\nshiny = 1\n", "s.toml:7: unknown field `shiny`"),
        (
            "[material.m]\nbase_color = [1, 1, 1]\n",
            "s.toml:7: material.m.base_color: is called diffuse",
        ),
        (
            "[material.m]\nbase_color_texture = \"a\"\n",
            "s.toml:7: unknown field `base_color_texture`, expected one of",
        ),
        (
            "[[mesh]]\npath = \"a.obj\"\nmaterial = \"gold\"\n",
            "s.toml:8: mesh.a.obj.material: no material `gold`; the scene has none",
        ),
        (
            "[[mesh]]\npath = \"a.obj\"\nname = \"m\"\n[[mesh]]\npath = \"a.obj\"\nname = \"m\"\n",
            "s.toml:11: mesh.m.name: another mesh has this name",
        ),
        ("[optimize]\nloss = \"l2\"\n", "s.toml:7: unknown variant `l2`"),
        (
            "[optimize]\noptimizer = \"adan\"\n",
            "s.toml:7: unknown variant `adan`, expected one of `adam`",
        ),
        (
            "[optimize]\noptimizer = 3\n",
            "s.toml:7: invalid type: integer `3`, expected a name or a table",
        ),
        (
            "[optimize]\noptimizer = { type = \"sgd\", beta1 = 0.5 }\n",
            "s.toml:7: unknown field `beta1`, expected `momentum`",
        ),
        (
            "[optimize]\nloss = { type = \"l1\", delta = 0.1 }\n",
            "s.toml:7: unknown field `delta` of \"l1\", which has none",
        ),
        (
            "[optimize]\n[optimize.schedule]\ntype = \"constant\"\nend = 0.1\n",
            "s.toml:7: unknown field `end` of \"constant\", which has none in `optimize.schedule`",
        ),
        (
            "[optimize]\noptimizer = { type = \"sgd\", momentum = 2 }\n",
            "s.toml:7: optimize.optimizer.momentum: is 2; it must be at least 0 and below 1",
        ),
        (
            "[optimize]\n[optimize.schedule]\ntype = \"step\"\nstages = 0\n",
            "s.toml:9: optimize.schedule.stages: is 0; it must be at least 1",
        ),
        ("[optimize]\niterations = -1\n", "s.toml:7: invalid value: integer `-1`"),
        ("[optimize]\ntolerance = nan\n", "s.toml:7: optimize.tolerance: must not be negative"),
        ("[optimize]\nlearning_rate = 0\n", "s.toml:7: optimize.learning_rate: must be above 0"),
        (
            "[optimize]\ntarget = \"a.png\"\n[optimize.target_values]\n\"camera.vfov\" = 3\n",
            "s.toml:7: optimize.target: give either target",
        ),
        (
            "[optimize.target_values]\n\"camera.vfow\" = 3\n",
            "s.toml:7: optimize.target_values.camera.vfow: no parameter `camera.vfow`; closest: camera.vfov",
        ),
        (
            "[optimize.target_values]\n\"camera.vfov\" = 3\n\"camera.up\" = [1, 2]\n",
            "s.toml:8: optimize.target_values.camera.up: needs 3 numbers, has 2",
        ),
        (
            "[optimize.target_values]\n\"camera.vfov\" = -3\n",
            "s.toml:7: optimize.target_values.camera.vfov: must lie between",
        ),
        (
            "[[optimize.parameter]]\npath = \"camera.vfov\"\nmin = 2\nmax = 1\n",
            "s.toml:8: optimize.parameter.camera.vfov.min: 2 is above max 1",
        ),
        (
            "[[optimize.parameter]]\npath = \"camera.fov\"\n",
            "s.toml:7: optimize.parameter.camera.fov.path: no parameter `camera.fov`; closest: camera.vfov",
        ),
        (
            "[material.m]\ndiffuse_texture = \"w\"\n",
            "s.toml:7: material.m.diffuse_texture: no texture",
        ),
        ("[texture.w]\nsize = [0, 4]\n", "s.toml:7: texture.w.size: must be at least"),
        ("[texture.w]\ncolor = [0, 4, 1]\n", "s.toml:6: texture.w.path: is missing"),
        ("[texture.w]\nsize = [1, 1]\ncolor = [0, -1, 0]\n", "s.toml:6: texture.w.texels"),
        ("[texture.w]\npath = \"a\"\nsize = [4, 4]\n", "s.toml:8: texture.w.size: a texture from"),
        (
            "[[optimize.parameter]]\npath = \"camera.vfov\"\nmin = nan\n",
            "s.toml:8: optimize.parameter.camera.vfov.min: is not a number",
        ),
        (
            "[[optimize.parameter]]\npath = \"camera.vfov\"\nlearning_rate = -1\n",
            "s.toml:8: optimize.parameter.camera.vfov.learning_rate: must be above 0",
        ),
        (
            "[[optimize.parameter]]\npath = \"camera.vfov\"\n\
             [[optimize.parameter]]\npath = \"camera.vfov\"\n",
            "s.toml:9: optimize.parameter.camera.vfov.path: is given twice",
        ),
    ] {
        let error = refused(rest);
        assert!(error.starts_with(expected), "{rest:?}:\n{error}\n{expected}");
    }
    let error = parse_text("").unwrap_err().to_string();
    assert!(error.starts_with("s.toml: camera: is missing"), "{error}");
}

#[test]
fn mistakes_in_a_mesh_are_placed_there() {
    let folder = folder();
    fs::write(folder.path().join("a.obj"), "v 0 0 x\n").unwrap();
    let text = format!("{CAMERA}[[mesh]]\npath = \"a.obj\"\n");
    let error = Experiment::parse(&text, folder.path(), "s.toml").unwrap_err();
    assert!(error.place.ends_with("a.obj:1"), "{error}");
    let text = format!("{CAMERA}[[mesh]]\npath = \"b.obj\"\n");
    let error = Experiment::parse(&text, folder.path(), "s.toml").unwrap_err();
    assert_eq!(error.place, "s.toml:7: mesh.b.obj.path");
    assert!(error.problem.ends_with("b.obj: no such file"), "{error}");
    assert_eq!(error.kind, ErrorKind::Io);
}

#[test]
fn meshes_are_shaded_as_the_file_says() {
    let folder = folder();
    let mesh = format!("vn 0 0 2\n{MESH}").replace("f 1 2 3", "f 1//1 2//1 3//-1");
    fs::write(folder.path().join("n.obj"), mesh).unwrap();
    let meshes = |rest: &str| {
        let text = format!("{CAMERA}[[mesh]]\npath = \"n.obj\"\n{rest}");
        Experiment::parse(&text, folder.path(), "s.toml").map(|experiment| experiment.scene.meshes)
    };
    for (rest, expected) in [
        ("", Normals::Flat),
        ("normals = \"flat\"", Normals::Flat),
        ("normals = \"smooth\"", Normals::Smooth),
    ] {
        for mesh in meshes(rest).unwrap() {
            assert_eq!(mesh.normals, expected, "{rest}");
        }
    }
    // Triangles of objects that have none are flat within a mesh that has some.
    let [all] = &meshes("name = \"all\"\nnormals = \"file\"").unwrap()[..] else { panic!("one") };
    let directions = vec![[0.0, 0.0, 2.0]];
    let triangles = vec![Some([0; 3]), None];
    assert_eq!(all.normals, Normals::Given { directions, triangles });
    // So are objects that have none beside some that do.
    let found = meshes("normals = \"file\"").unwrap();
    assert!(matches!(found[0].normals, Normals::Given { .. }) && found[1].normals == Normals::Flat);
    fs::write(folder.path().join("n.obj"), MESH).unwrap();
    for (rest, expected) in [
        (
            "normals = \"file\"",
            "s.toml:8: mesh.n.obj.normals: n.obj holds no normals; \"smooth\" computes them",
        ),
        ("normals = \"soft\"", "s.toml:8: unknown variant `soft`, expected one of"),
        ("normals = [0, 0, 1]", "s.toml:8: "),
    ] {
        let error = meshes(rest).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{error}");
    }
}

#[test]
fn windows_line_ends_tabs_and_a_byte_order_mark_are_read() {
    let plain = scene_of(LIGHT);
    let text = format!("\u{feff}{CAMERA}{LIGHT}").replace('\n', "\r\n").replace(" = ", "\t=\t");
    assert_eq!(parse_text(&text).unwrap().scene, plain);
}

#[test]
fn files_that_are_no_scene_are_refused() {
    let folder = folder();
    let refused = |path: &Path| Experiment::load(path).unwrap_err().to_string();
    assert!(refused(folder.path()).ends_with("is a directory, not a file"));
    assert!(refused(&folder.path().join("none.toml")).ends_with("no such file"));
    let binary = folder.path().join("b.toml");
    fs::write(&binary, [0x66, 0xff, 0x00]).unwrap();
    let kinds = "is neither a scene file (TOML) nor a mesh (.obj, .ply, .stl, .gltf, .glb)";
    for (name, expected) in [("a.fbx", kinds), ("a.toml", "a.toml:1: "), ("a", "a:1: ")] {
        let path = folder.path().join(name);
        fs::write(&path, "; FBX 7.4.0 project file\n").unwrap();
        let error = refused(&path);
        assert!(
            error.contains(expected) && error.ends_with(kinds) == (expected == kinds),
            "{error}"
        );
    }
    let scene = folder.path().join("scene.txt");
    fs::write(&scene, "[camera]\nzoom = 1\n").unwrap();
    assert!(refused(&scene).contains("scene.txt:2: "), "{}", refused(&scene));
    assert!(
        refused(&binary)
            .contains("b.toml: is neither a scene file (TOML) nor a mesh (.obj, .ply, .stl, .gltf, .glb): byte 1 is not UTF-8")
    );
}

/// The demo with a light, a sphere and a mesh more, and awkward names and numbers.
fn rich_experiment() -> Experiment {
    let mut experiment = demo_experiment().unwrap();
    let scene = &mut experiment.scene;
    let direction = DVec3::new(-0.0, 1.0 / 3.0, 1e-17);
    let sun = DistantLight { direction, color: DVec3::new(0.1, 0.2, 0.3), irradiance: 1e30 };
    scene.add_light("sun \"1\".b", sun).unwrap();
    let mut ball = SphereObject::new("ball", DVec3::splat(1e-300), 0.1 + 0.2).material(1);
    ball.values.rotation = DVec3::new(0.1, 1.0 / 3.0, -0.0);
    scene.add_sphere(ball).unwrap();
    for name in ["Tree", "a/b", "a_b", "../x"] {
        let mut mesh = scene.meshes[0].clone();
        mesh.name = name.to_owned();
        mesh.vertices.as_flattened_mut().iter_mut().for_each(|x| *x /= 3.0);
        mesh.transform.rotation.y = 1.0 / 3.0;
        mesh.transform.scale.z = 0.1 + 0.2;
        scene.add_mesh(mesh).unwrap();
    }
    add_texture(scene);
    let count = scene.meshes[2].triangles.len();
    scene.meshes[2].normals = Normals::Given {
        directions: vec![[0.1, 1.0 / 3.0, -0.0], [0.0, 0.0, 7.0]],
        triangles: (0..count).map(|index| (index % 3 != 0).then_some([0, 1, 0])).collect(),
    };
    scene.meshes[3].normals = Normals::Smooth;
    scene.materials[1].name = "Leaves.001 [x]".to_owned();
    experiment
}

/// Textures on the mesh `Tree`.
fn add_texture(scene: &mut Scene) {
    let texture = |name: &str, wrap, texels: &[[f64; 3]]| Texture {
        name: name.to_owned(),
        width: texels.len() as u32,
        height: 1,
        wrap,
        texels: texels.to_vec().into(),
    };
    let wood = [[0.25, 0.5, 1.0], [0.0, f64::from(0.1_f32), 7.0]];
    let wood = scene.add_texture(texture("Wood/2", Wrap::Mirror, &wood)).unwrap();
    let holes = texture("Holes", Wrap::Repeat, &[[0.25, 0.5, 1.0]]);
    let holes = scene.add_texture(holes).unwrap();
    let planks = MaterialObject::from(scene.materials[0].values).with_opacity(0.1 + 0.2);
    let planks = planks.with_texture(Slot::Specular, wood).with_texture(Slot::Opacity, holes);
    let planks = planks.with_texture(Slot::Normal, holes);
    let planks = MaterialObject { normal_scale: 1.0 / 3.0, ..planks };
    let planks = scene.add_material("planks", planks).unwrap();
    let mesh = &mut scene.meshes[1];
    mesh.materials.fill(planks);
    mesh.texture_triangles = vec![Some([0, 1, 2]); mesh.triangles.len()];
    mesh.texture_coordinates = vec![[0.1, 1.0 / 3.0], [-2.0, 1e5], [1e-300, -0.0]];
}

#[test]
fn a_saved_experiment_is_read_back_bit_for_bit() {
    let folder = tempfile::tempdir().unwrap();
    let experiment = rich_experiment();
    let path = save_experiment(&experiment, &folder.path().join("new/saved")).unwrap();
    let loaded = Experiment { files: Vec::new(), ..Experiment::load(&path).unwrap() };
    assert_eq!(loaded, experiment);
    // Equality does not tell the zeros apart.
    for id in experiment.scene.parameters() {
        let bits =
            |scene: &Scene| -> Vec<u64> { scene.get(id).iter().map(|v| v.to_bits()).collect() };
        assert_eq!(bits(&loaded.scene), bits(&experiment.scene), "{}", loaded.scene.path(id));
    }
    // A second time, over the first.
    assert_eq!(save_scene(&loaded.scene, path.parent().unwrap()).unwrap(), path);
    let again = Experiment::load(&path).unwrap();
    assert_eq!((again.scene, again.optimize), (experiment.scene, None));
}

#[test]
fn a_target_image_is_taken_along() {
    let (source, saved) = (folder(), tempfile::tempdir().unwrap());
    fs::write(source.path().join("t.png"), b"an image").unwrap();
    let text = format!("{CAMERA}[optimize]\ntarget = \"t.png\"\n");
    let experiment = Experiment::parse(&text, source.path(), "s.toml").unwrap();
    let path = save_experiment(&experiment, saved.path()).unwrap();
    drop(source);
    let optimize = Experiment::load(&path).unwrap().optimize.unwrap();
    let Some(Target::Image(image)) = optimize.target else { panic!("an image") };
    assert_eq!(fs::read(image).unwrap(), b"an image");
}

#[test]
fn saved_views_and_what_they_are_compared_with_are_read_back() {
    let (source, saved) = (folder(), tempfile::tempdir().unwrap());
    fs::write(source.path().join("t.png"), b"an image").unwrap();
    let text = format!(
        "{CAMERA}[[view]]\nname = \"a/b\"\ntarget = \"t.png\"\nweight = 3.0\n\
         [[view]]\nname = \"A/B\"\nvfov = 20\nwidth = 7\nheld_out = true\ncoverage = \"t.png\"\n\
         depth = {{ path = \"t.png\", weight = 0.1 }}\nnormals = \"t.png\"\n\
         [[mesh]]\npath = \"a.obj\"\nname = \"body\"\n\
         [optimize]\nbatch = 1\nseed = 5\ncoarse_to_fine = 2\nloss = {{ type = \"huber\", delta = 0.5 }}\n\
         [[optimize.parameter]]\npath = \"mesh.body.vertices\"\nlarge_steps = 9.0\n\
         laplacian = {{ weight = 0.5, weights = \"cotangent\" }}\nedge_length = 0.25\nnormal_consistency = 0.125\n\
         remesh = {{ edge_length = 0.01, every = 50 }}\n\
         [[optimize.parameter]]\npath = \"view.A/B.vfov\"\n"
    );
    // A side of 7 pixels cannot be halved.
    let refused = Experiment::parse(&text, source.path(), "s.toml").unwrap_err().to_string();
    assert!(refused.contains("optimize.coarse_to_fine") && refused.contains("7 x 4"), "{refused}");
    let text = text.replace("width = 7", "width = 16");
    let experiment = Experiment::parse(&text, source.path(), "s.toml").unwrap();
    let path = save_experiment(&experiment, saved.path()).unwrap();
    drop(source);
    let loaded = Experiment::load(&path).unwrap();
    assert_eq!(loaded.scene, experiment.scene);
    let (mut found, mut expected) = (loaded.optimize.unwrap(), experiment.optimize.unwrap());
    let images = found
        .views
        .iter()
        .flat_map(|view| view.image.iter().chain(view.passes.iter().map(|matched| &matched.file)));
    assert_eq!(images.clone().count(), 4);
    images.for_each(|image| assert_eq!(fs::read(image).unwrap(), b"an image"));
    for view in found.views.iter_mut().chain(&mut expected.views) {
        view.image = None;
        view.passes.iter_mut().for_each(|matched| matched.file.clear());
    }
    assert_eq!(found, expected);
}

#[test]
fn an_invalid_scene_is_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = rich_experiment().scene;
    scene.camera.vfov = f64::NAN;
    let error = save_scene(&scene, &folder.path().join("saved")).unwrap_err();
    assert!(error.to_string().contains("camera.vfov: NaN"), "{error}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn the_documented_scene_file_is_read() {
    let text = include_str!("../../../docs/scene.md");
    let blocks: Vec<&str> =
        text.split("```toml").skip(1).filter_map(|b| b.split("```").next()).collect();
    let [whole, tables, values] = blocks[..] else { panic!("three blocks") };

    let folder = folder();
    // The mesh of the documentation has a texture, so it needs texture coordinates.
    let mesh =
        MESH.replace("usemtl", "vt 0 0\nvt 1 0\nvt 0 1\nusemtl").replace("1 2 3", "1/1 2/2 3/3");
    let mesh = mesh.replace("4 5 6", "4/4 5/5 6/6");
    fs::write(folder.path().join("tree.obj"), mesh).unwrap();
    for texture in ["wood.png", "finish.png"] {
        save_png(&Image::black(3, 2), &folder.path().join(texture)).unwrap();
    }
    let experiment = Experiment::parse(whole, folder.path(), "s.toml").unwrap();
    assert_eq!(experiment.scene.spheres.len(), 1);
    assert_eq!(experiment.optimize.unwrap().parameters[0].min, Some(vec![-20.0; 3]));
    let text = format!("{}{tables}", whole.split("[optimize]").next().unwrap());
    let section = Experiment::parse(&text, folder.path(), "s.toml").unwrap().optimize.unwrap();
    assert_eq!(section.optimizer, Some(Optimizer::Sgd(Sgd { momentum: 0.5 })));
    let values = whole.replace("target = ", "# ") + values;
    let experiment = Experiment::parse(&values, folder.path(), "s.toml").unwrap();
    assert!(matches!(experiment.optimize.unwrap().target, Some(Target::Values(v)) if v.len() == 2));
}

#[test]
fn the_scene_file_of_the_readme_is_read() {
    let readme = include_str!("../../../../README.md");
    let scene = readme.split("```toml").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let folder = folder();
    fs::write(folder.path().join("object.obj"), MESH.replace("mtllib", "# mtllib")).unwrap();
    let experiment = Experiment::parse(scene, folder.path(), "photo.toml").unwrap();
    assert_eq!(experiment.optimize.unwrap().parameters.len(), 2);
}

#[test]
fn normal_maps_are_of_meshes() {
    let map = "normal_texture = \"map\"\n[texture.map]\nsize = [2, 2]\ncolor = [0.5, 0.5, 1]\n";
    let bumpy = format!("[material.bumpy]\nnormal_scale = -0.5\n{map}");
    let material = &scene_of(&bumpy).materials[0];
    assert_eq!((material.textures.get(Slot::Normal), material.normal_scale), (Some(0), -0.5));
    let ball =
        "[[sphere]]\nname = \"ball\"\nradius = 1\ncenter = [0, 0, 0]\nmaterial = \"bumpy\"\n";
    for (rest, expected) in [
        (
            format!("{ball}{bumpy}"),
            "sphere.ball.material: has a normal_texture, which bends the normals of meshes alone",
        ),
        (
            format!("[material.bumpy]\nmirror = [1, 1, 1]\n{map}"),
            "material.bumpy.normal_texture: a mirror has none",
        ),
        (
            format!("[integrator]\ntype = \"path\"\n[material.a]\ntype = \"dielectric\"\n{map}"),
            "material.a.normal_texture: varies nothing that a material of this type has",
        ),
        (
            format!("[material.a]\nnormal_scale = nan\n{map}"),
            "material.a.normal_scale: NaN is not a finite number",
        ),
        (
            "[material.a]\nnormal_texture = \"none\"\n".to_owned(),
            "material.a.normal_texture: no texture `none`",
        ),
    ] {
        let error = refused(&rest);
        assert!(error.contains(expected), "{rest}: {error}");
    }
}

#[test]
fn materials_have_types() {
    let typed = "[integrator]\ntype = \"path\"\n\
        [material.copper]\ntype = \"metallic_roughness\"\nmetallic = 1.0\nroughness = 0.25\n\
        metallic_roughness_texture = \"finish\"\n\
        [material.glass]\ntype = \"dielectric\"\nior = 1.4\n[texture.finish]\nsize = [2, 2]\n";
    let scene = scene_of(typed);
    let [copper, glass] = &scene.materials[..] else { panic!("two materials") };
    assert_eq!((copper.bsdf, glass.bsdf), (Bsdf::MetallicRoughness, Bsdf::Dielectric));
    assert_eq!((copper.values.metallic, copper.values.roughness), (1.0, 0.25));
    assert_eq!(copper.textures.get(Slot::MetallicRoughness), Some(0));
    assert_eq!((glass.values.ior, glass.values.diffuse), (1.4, DVec3::ONE));
    let folder = tempfile::tempdir().unwrap();
    let read = Experiment::load(&save_scene(&scene, folder.path()).unwrap()).unwrap().scene;
    assert_eq!(read.materials, scene.materials);
    for (rest, expected) in [
        (
            "[material.a]\nmetallic = 1\n",
            "material.a.metallic: is of materials of the type metallic_roughness",
        ),
        (
            "[material.a]\ntype = \"glass\"\n",
            "material.a.type: `glass` is no type of material; there are blinn_phong",
        ),
        (
            "[material.a]\ntype = \"dielectric\"\nmirror = [1, 1, 1]\n",
            "material.a.mirror: is of materials of the type blinn_phong",
        ),
        (
            "[material.a]\ntype = \"dielectric\"\n",
            "material.a.type: a dielectric refracts light that takes all paths",
        ),
        ("[material.a]\ntype = \"dielectric\"\nior = 0.5\n", "material.a.ior: must lie between 1"),
    ] {
        let error = refused(rest);
        assert!(error.contains(expected), "{rest}: {error}");
    }
}

/// What a library says of metal counts where light takes all paths, and is said to be left out elsewhere.
#[test]
fn metals_of_libraries_show_where_light_takes_all_paths() {
    let folder = folder();
    fs::write(folder.path().join("a.mtl"), format!("{LIBRARY}Pm 1\nPr 0.2\n")).unwrap();
    let mesh = "[[mesh]]\npath = \"a.obj\"\n";
    let load = |rest: &str| {
        let text = format!("{CAMERA}{rest}{mesh}");
        Experiment::parse(&text, folder.path(), "s.toml").unwrap()
    };
    let direct = load(LIGHT);
    assert!(direct.scene.materials.iter().all(|material| material.bsdf == Bsdf::BlinnPhong));
    assert!(direct.warnings.iter().any(|warning| warning.to_string().contains("Pm is left out")));
    let path = load(&format!("{LIGHT}[integrator]\ntype = \"path\"\n"));
    let kinds: Vec<Bsdf> = path.scene.materials.iter().map(|material| material.bsdf).collect();
    assert_eq!(kinds, [Bsdf::BlinnPhong, Bsdf::MetallicRoughness]);
    assert_eq!(path.warnings, []);
    // Another type begins with what the library says without facets.
    let matt = "[material.blue]\ntype = \"blinn_phong\"\n";
    let matt = load(&format!("{LIGHT}[integrator]\ntype = \"path\"\n{matt}"));
    let blue = &matt.scene.materials[0];
    let numbers = (blue.values.diffuse, blue.values.roughness);
    assert_eq!((blue.bsdf, numbers), (Bsdf::BlinnPhong, (DVec3::Z, 0.0)));
}

/// The name of a mesh's material may be misspelt.
#[test]
fn materials_that_nothing_has_are_warned_of() {
    let folder = folder();
    fs::write(folder.path().join("a.mtl"), LIBRARY).unwrap();
    let text = format!(
        "{CAMERA}{LIGHT}[[mesh]]\npath = \"a.obj\"\n[material.blue]\n[material.bleu]\nemission = [1, 1, 1]\n"
    );
    let warnings = Experiment::parse(&text, folder.path(), "s.toml").unwrap().warnings;
    let lines: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(lines, ["s.toml: material.bleu: no mesh and no sphere has this material"]);
}
