//! Textures that scene files and the materials of meshes bring along.

use std::fs;

use glam::DVec3;

use super::tests::{CAMERA, LIBRARY, LIGHT, folder};
use super::*;
use crate::Image;
use crate::files::images::save_exr;
use crate::scene::{Material, Slot};

#[test]
fn textures_are_read_once_and_named() {
    let folder = folder();
    let image = Image { width: 1, height: 1, pixels: vec![[1.0, 0.5, 0.25]] };
    save_exr(&image, &folder.path().join("my wood.exr")).unwrap();
    let mesh = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5\nvt 1 0 0\n\
        usemtl red\nf 1/1 2/2 3/-1\nusemtl blue\nf 1 2 3\n";
    fs::write(folder.path().join("a.obj"), mesh).unwrap();
    let library = "newmtl red\nmap_Kd -s 2 2 -clamp off my wood.exr\n\
        map_Ks -s 2 2 -mm 0 1 my wood.exr\nillum 3\nKs 0.5 0.4 0.3\nnewmtl blue\n";
    fs::write(folder.path().join("a.mtl"), library).unwrap();
    let text = format!("{CAMERA}[[mesh]]\npath = \"a.obj\"\n");
    let scene = Experiment::parse(&text, folder.path(), "s.toml").unwrap().scene;
    assert_eq!(scene.textures.len(), 1);
    assert_eq!(scene.textures[0].name, "my wood");
    assert_eq!(scene.textures[0].image().pixels, [[1.0, 0.5, 0.25]]);
    let red = scene.materials.iter().position(|material| material.name == "red").unwrap();
    let textures = scene.materials[red].textures;
    assert_eq!(textures.0, [None, Some(0), Some(0), None, None, None]);
    assert_eq!(scene.materials[red].values.mirror, DVec3::new(0.5, 0.4, 0.3));
    assert_eq!(scene.meshes[0].texture_triangles, [Some([0, 1, 1]), None]);
    // As both `map_Kd` and `map_Ks` say, twice as large.
    assert_eq!(scene.meshes[0].texture_coordinates, [[1.0, 0.0], [2.0, 0.0]]);

    // The material may get, or change, its texture in the scene file.
    let text =
        format!("{text}[material.blue]\ndiffuse_texture = \"new\"\n[texture.new]\nsize = [2, 3]\n");
    let Experiment { scene, warnings, .. } =
        Experiment::parse(&text, folder.path(), "s.toml").unwrap();
    let expected = "s.toml: mesh.a: triangle 1 has the material `blue`, which has a texture, but \
                    has no texture coordinates; it is shown without it";
    assert!(warnings.iter().any(|warning| warning.to_string() == expected), "{warnings:?}");
    let blue = scene.materials.iter().find(|material| material.name == "blue").unwrap();
    assert!(!blue.textures.any());

    // Where other triangles show the texture, a material of another name is without it.
    let ball = "[[sphere]]\nname = \"ball\"\ncenter = [9, 9, 9]\nradius = 1\nmaterial = \"blue\"\n";
    let scene = Experiment::parse(&format!("{text}{ball}"), folder.path(), "s.toml").unwrap().scene;
    let assigned = |index: u32| &scene.materials[index as usize];
    let ball = assigned(scene.spheres[0].material);
    assert!((ball.name.as_str(), ball.textures.any()) == ("blue", true));
    let bare = assigned(scene.meshes[0].materials[1]);
    assert!((bare.name.as_str(), bare.textures.any()) == ("blue_2", false));

    // A picture that is broken is told where it is named.
    fs::write(folder.path().join("broken.png"), "x").unwrap();
    let text = format!("{CAMERA}[texture.new]\npath = \"broken.png\"\n");
    let error = Experiment::parse(&text, folder.path(), "s.toml").unwrap_err().to_string();
    assert!(error.starts_with("s.toml:") && error.contains("texture.new.path: "), "{error}");
    assert!(error.contains("broken.png: is not a PNG"), "{error}");

    fs::remove_file(folder.path().join("my wood.exr")).unwrap();
    let Experiment { scene, warnings, .. } =
        Experiment::load(&folder.path().join("a.obj")).unwrap();
    assert!(scene.textures.is_empty() && !scene.meshes[0].texture_coordinates.is_empty());
    assert_eq!(scene.materials[red].values.diffuse, DVec3::ONE);
    let problems: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert!(problems[1].contains("a.mtl:2: the texture "), "{problems:?}");
    assert!(problems[1].ends_with("my wood.exr is missing; white stands for it"), "{problems:?}");
    assert!(problems[2].contains("a.mtl:3: the texture ") && problems.len() == 3, "{problems:?}");
}

/// A mesh without its library is seen; the scene file may say what its materials are.
#[test]
fn materials_that_nothing_defines_are_grey() {
    let folder = folder();
    fs::remove_file(folder.path().join("a.mtl")).unwrap();
    let text = format!("{CAMERA}{LIGHT}[[mesh]]\npath = \"a.obj\"\n");
    let load =
        |rest: &str| Experiment::parse(&format!("{text}{rest}"), folder.path(), "s.toml").unwrap();
    let Experiment { scene, warnings, .. } = load("");
    let names: Vec<&str> = scene.materials.iter().map(|material| &*material.name).collect();
    assert_eq!(names, ["red", "blue"]);
    let values: Vec<Material<f64>> = scene.materials.iter().map(|object| object.values).collect();
    assert_eq!(values, [Material::default(); 2]);
    let [missing] = &warnings[..] else { panic!("{warnings:?}") };
    assert!(missing.place.ends_with("a.obj:1"), "{missing}");
    assert!(
        missing.problem.ends_with("a.mtl is missing; its materials are shown grey"),
        "{missing}"
    );

    let red = "[material.red]\ndiffuse = [1, 0, 0]\n";
    let blue = "[material.blue]\ndiffuse = [0, 0, 1]\n";
    assert_eq!(load(red).scene.materials[0].values.diffuse, DVec3::X);
    assert_eq!(load(red).warnings, warnings);
    assert_eq!(load(&format!("{red}{blue}")).warnings, []);

    fs::write(folder.path().join("a.mtl"), "newmtl blue\n").unwrap();
    let warnings = load("").warnings;
    let [undefined] = &warnings[..] else { panic!("{warnings:?}") };
    assert!(undefined.place.ends_with("a.obj:7"), "{undefined}");
    assert_eq!(undefined.problem, "no library defines the material `red`; it is shown grey");
}

/// Materials that share texture coordinates may place their textures in different ways.
#[test]
fn each_material_places_its_textures() {
    let folder = folder();
    let image = Image { width: 1, height: 1, pixels: vec![[1.0; 3]] };
    save_exr(&image, &folder.path().join("w.exr")).unwrap();
    let mesh = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n\
        usemtl red\nf 1/1 2/2 3/3\nusemtl blue\nf 1/1 2/2 3/3\nusemtl green\nf 1/1 2/2 3/3\n";
    fs::write(folder.path().join("a.obj"), mesh).unwrap();
    let library = "newmtl red\nmap_Kd w.exr\nnewmtl blue\nmap_Kd -s 2 3 -o 0.5 0.25 w.exr\n\
        newmtl green\nmap_Kd w.exr\n";
    fs::write(folder.path().join("a.mtl"), library).unwrap();
    let text = format!("{CAMERA}{LIGHT}[[mesh]]\npath = \"a.obj\"\n");
    let load = |rest: &str| {
        Experiment::parse(&format!("{text}{rest}"), folder.path(), "s.toml").unwrap().scene
    };
    let scene = load("");
    let plain = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let placed = [[0.5, 0.25], [2.5, 0.25], [0.5, 3.25]];
    assert_eq!(scene.meshes[0].texture_coordinates, [plain, placed].concat());
    let corners = [[0, 1, 2], [3, 4, 5], [0, 1, 2]].map(Some);
    assert_eq!(scene.meshes[0].texture_triangles, corners);
    // Saved and read again, the coordinates are what they are.
    let saved = tempfile::tempdir().unwrap();
    let again = Experiment::load(&save_scene(&scene, saved.path()).unwrap()).unwrap();
    assert_eq!(again.scene, scene);
    // Options say where the texture of the library lies, not where another one does.
    let other = "[material.blue]\ndiffuse_texture = \"x\"\n[texture.x]\nsize = [1, 1]\n";
    assert_eq!(load(other).meshes[0].texture_coordinates, plain);
    // A mesh whose materials are replaced needs no library, and keeps its coordinates without a texture.
    fs::remove_file(folder.path().join("a.mtl")).unwrap();
    let paint = "material = \"p\"\n[material.p]\ndiffuse = [1, 0, 0]\n";
    assert_eq!(load(paint).meshes[0].texture_coordinates, plain);
}

#[test]
fn what_files_leave_out_is_told() {
    let folder = folder();
    fs::write(folder.path().join("a.mtl"), format!("{LIBRARY}Ni 1.5\nNi 1.4\n")).unwrap();
    let text = format!("{CAMERA}{LIGHT}[[mesh]]\npath = \"a.obj\"\n");
    let warnings = Experiment::parse(&text, folder.path(), "s.toml").unwrap().warnings;
    assert_eq!(warnings, Experiment::load(&folder.path().join("a.obj")).unwrap().warnings);
    let [warning] = &warnings[..] else { panic!("one warning") };
    assert!(warning.place.ends_with("a.mtl:6"), "{warning}");
    assert_eq!(warning.problem, "Ni is left out: rays go straight on behind transparent surfaces");
}

/// A scene without light is black: of that is warned unless something shows by itself, or nothing is
/// there.
#[test]
fn scenes_without_light_are_told() {
    let folder = folder();
    let warnings = |rest: &str| {
        let text = format!("{CAMERA}[[mesh]]\npath = \"a.obj\"\n{rest}");
        Experiment::parse(&text, folder.path(), "s.toml").unwrap().warnings
    };
    let [dark] = &warnings("")[..] else { panic!("one warning") };
    assert!(dark.to_string().starts_with("s.toml: has no light: add a [[light]]"), "{dark}");
    assert_eq!(warnings(LIGHT), []);
    assert_eq!(warnings("[material.red]\nemission = [1, 0, 0]\n"), []);
    let empty = Experiment::parse(CAMERA, folder.path(), "s.toml").unwrap();
    assert_eq!(empty.warnings, []);
}

/// Opacity makes a material transparent, whatever its value; a mirror cannot be.
#[test]
fn opacity_is_of_the_scene_file_or_the_library() {
    let folder = folder();
    fs::write(folder.path().join("a.mtl"), format!("{LIBRARY}d 0.5\n")).unwrap();
    let parse = |rest: &str| {
        let text = format!("{CAMERA}{LIGHT}[[mesh]]\npath = \"a.obj\"\n{rest}");
        Experiment::parse(&text, folder.path(), "s.toml").map(|experiment| experiment.scene)
    };
    let opacities = |rest: &str| {
        let scene = parse(rest).unwrap();
        let of = |name: &str| {
            let id = scene.parameter(&format!("material.{name}.opacity")).ok()?;
            Some(scene.get(id)[0])
        };
        (of("red"), of("blue"))
    };
    assert_eq!(opacities(""), (None, Some(0.5)));
    assert_eq!(opacities("[material.red]\nopacity = 1\n"), (Some(1.0), Some(0.5)));
    assert_eq!(opacities("[material.blue]\nopacity = 0.25\n"), (None, Some(0.25)));
    let refused = |rest: &str| parse(rest).unwrap_err().to_string();
    let error = refused("[material.red]\nopacity = 1.5\n");
    assert_eq!(error, "s.toml:14: material.red.opacity: must be at most 1, is 1.5");
    let error = refused("[material.red]\nopacity = -1\n");
    assert_eq!(error, "s.toml:14: material.red.opacity: must not be negative, is -1");
    let error = refused("[material.red]\nopacity = 0.5\nmirror = [0.1, 0, 0]\n");
    assert_eq!(
        error,
        "s.toml:14: material.red.opacity: a mirror is opaque; leave out either opacity or mirror"
    );
    let error = parse("").unwrap().find_parameter("material.blue.mirror").unwrap_err();
    assert!(error.starts_with("no parameter `material.blue.mirror`"), "{error}");
}

/// The picture of a leaf gives its colours and, by its alpha, where it is; a grey picture is a mask.
#[test]
fn opacity_may_vary() {
    let folder = folder();
    let save = |name: &str, bytes: &[u8], color| {
        let file = fs::File::create(folder.path().join(name)).unwrap();
        let mut encoder = png::Encoder::new(file, 2, 1);
        encoder.set_color(color);
        encoder.write_header().unwrap().write_image_data(bytes).unwrap();
    };
    save("leaf.png", &[255, 0, 0, 255, 0, 255, 0, 51], png::ColorType::Rgba);
    save("mask.png", &[51, 255], png::ColorType::Grayscale);
    save("white.png", &[255, 255], png::ColorType::Grayscale);
    let mesh = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl leaf\nf 1/1 2/1 3/1\n";
    fs::write(folder.path().join("a.obj"), mesh).unwrap();
    let scene = |library: &str, rest: &str| {
        fs::write(folder.path().join("a.mtl"), format!("newmtl leaf\n{library}")).unwrap();
        let text = format!("{CAMERA}{LIGHT}[[mesh]]\npath = \"a.obj\"\n{rest}");
        Experiment::parse(&text, folder.path(), "s.toml")
    };
    let varied = |library: &str, rest: &str| {
        let Experiment { scene, warnings, .. } = scene(library, rest).unwrap();
        let assigned = scene.materials[0].textures.get(Slot::Opacity).map(|index| index as usize);
        let name = assigned.map(|texture| scene.textures[texture].name.clone()).unwrap_or_default();
        let texels = assigned.map_or(Vec::new(), |texture| {
            scene.textures[texture].texels.iter().map(|t| (t[0] * 255.0).round()).collect()
        });
        let leaf = &scene.materials[0];
        (leaf.transparent.then_some(leaf.values.opacity), name, texels, warnings.len())
    };
    let own = |opacity: f64, name: &str, texels: [f64; 2]| {
        (Some(opacity), name.to_owned(), texels.to_vec(), 0)
    };
    let leaf = "map_Kd leaf.png\nmap_d leaf.png\n";
    assert_eq!(varied(leaf, ""), own(1.0, "leaf_opacity", [255.0, 51.0]));
    assert_eq!(varied("d 0.5\nmap_d mask.png\n", ""), own(0.5, "mask_opacity", [51.0, 255.0]));
    // What covers everything is opaque; a file that is missing counts as white.
    assert_eq!(varied("map_d white.png\n", ""), (None, String::new(), vec![], 0));
    assert_eq!(varied("map_d none.png\n", ""), (None, String::new(), vec![], 1));
    // Its alpha is left out where nothing asks for it.
    assert_eq!(varied("map_Kd leaf.png\n", ""), (None, String::new(), vec![], 1));

    let chosen = "[material.leaf]\nopacity_texture = \"holes\"\n[texture.holes]\npath = \"leaf.png\"\n\
        channel = \"opacity\"\n";
    assert_eq!(varied("", chosen), own(1.0, "holes", [255.0, 51.0]));
    let bright = "[material.leaf]\nopacity = 0.5\nopacity_texture = \"holes\"\n[texture.holes]\n\
        size = [1, 1]\ncolor = [0.5, 1.5, 0]\n";
    let error = scene("", bright).unwrap_err().to_string();
    let expected = "texture.holes.texels[0]: must be at most 1 where they vary opacity or roughness or bend normals, is 1.5";
    assert!(error.ends_with(expected), "{error}");
    let error = scene("", "[texture.holes]\nsize = [1, 1]\nchannel = \"opacity\"\n").unwrap_err();
    let expected = "texture.holes.channel: a texture of one colour has no channels to choose from";
    assert!(error.to_string().ends_with(expected), "{error}");
    let mirror = "[material.leaf]\nopacity_texture = \"t\"\nmirror = [1, 1, 1]\n\
        [texture.t]\nsize = [1, 1]\n";
    let error = scene("", mirror).unwrap_err().to_string();
    assert!(error.contains("material.leaf.opacity: a mirror is opaque"), "{error}");
}

/// Numbers that a picture holds are not those of colours.
#[test]
fn levels_that_are_read_as_colors_are_warned_of() {
    let folder = folder();
    for (file, channel, warns) in
        [("bumps.png", "color", true), ("bumps.png", "data", false), ("bumps.exr", "color", false)]
    {
        let image = Image { width: 1, height: 1, pixels: vec![[0.5, 0.5, 1.0]] };
        crate::files::save_image(&image, &folder.path().join(file)).unwrap();
        let text = format!(
            "{CAMERA}[[mesh]]\npath = \"a.obj\"\nmaterial = \"worn\"\n\
             [texture.bumps]\npath = \"{file}\"\nchannel = \"{channel}\"\n\
             [material.worn]\nnormal_texture = \"bumps\"\n"
        );
        let warnings = Experiment::parse(&text, folder.path(), "s.toml").unwrap().warnings;
        let expected = "s.toml: texture.bumps: is the normal_texture of material.worn, and its levels are \
                        read as colours; numbers are read as `channel = \"data\"`";
        let is_warned = warnings.iter().any(|warning| warning.to_string() == expected);
        assert_eq!(is_warned, warns, "{file} {channel}: {warnings:?}");
    }
}
