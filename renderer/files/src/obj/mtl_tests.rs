//! Material libraries, good and bad.

use std::fs;

use glam::{DAffine2, DVec2, DVec3};
use renderer_core::scene::{Bsdf, Material, MaterialObject, Slot, Wrap};

use super::tests::{TRIANGLE, folder, refused};
use super::*;
use crate::Warning;
use crate::meshes::{Channel, TextureImage, TextureSource};

/// The model of `a.obj`, one of the given files.
fn load(files: &[(&str, &str)]) -> Model {
    load_obj(&folder(files).path().join("a.obj")).unwrap()
}

/// The material that a library defines as `m`, and what is said of the library from its line on.
fn defined(library: &str) -> (ModelMaterial, Vec<String>) {
    let obj = format!("mtllib a.mtl\n{TRIANGLE}usemtl m\nf 1 2 3\n");
    let mut model = load(&[("a.obj", &obj), ("a.mtl", &format!("newmtl m\n{library}"))]);
    let after_name = |warning: &Warning| {
        warning.to_string().split_once("a.mtl:").map(|(_, rest)| rest.to_owned()).unwrap()
    };
    (model.materials.remove(0), model.warnings.iter().map(after_name).collect())
}

#[test]
fn libraries_are_found_and_checked() {
    let obj = format!("mtllib\ta.mtl\n{TRIANGLE}usemtl red\nf 1 2 3\n");
    for (library, expected) in [
        ("newmtl red\nKd 1 2\n", "a.mtl:2: Kd is a colour of 3 numbers"),
        ("newmtl red\nKs nan 0 0\n", "a.mtl:2: Ks: `nan` is not a finite number"),
        ("newmtl red\nKd 0 -1 0\n", "a.mtl:2: Kd must not be negative, is -1"),
        ("newmtl red\nd 1.5\n", "a.mtl:2: d must be at most 1, is 1.5"),
        ("newmtl red\nNs\n", "a.mtl:2: Ns: `` is not a number"),
        ("newmtl\n", "a.mtl:1: newmtl names no material"),
        ("Kd 1 1 1\n", "a.mtl:1: Kd stands before the first newmtl"),
        ("newmtl red\nillum 11\n", "a.mtl:2: illum is a number from 0 to 10, not `11`"),
        ("newmtl red\nmap_Kd -s 2\n", "a.mtl:2: map_Kd names no image"),
        ("newmtl red\nmap_Kd -s a.png\n", "a.mtl:2: map_Kd: -s: is followed by no number"),
        ("newmtl red\nmap_Kd -o inf a.png\n", "a.mtl:2: map_Kd: -o: `inf` is not a finite"),
    ] {
        let error = refused(&[("a.obj", &obj), ("a.mtl", library)]);
        assert!(error.starts_with(expected), "{library:?}: {error}");
    }
    // A library that is missing leaves its materials to the scene file.
    let model = load(&[("a.obj", &obj)]);
    assert_eq!(model.warnings, []);
    let missing = model.materials[0].material.as_ref().unwrap_err();
    assert!(missing.place.ends_with("a.obj:1"), "{missing}");
    assert!(missing.problem.starts_with("the material library"), "{missing}");
    assert!(
        missing.problem.ends_with("a.mtl is missing; its materials are shown grey"),
        "{missing}"
    );

    // No face has a material of the missing library.
    let plain = format!("mtllib a.mtl\n{TRIANGLE}f 1 2 3\n");
    let model = load(&[("a.obj", &plain)]);
    assert_eq!(model.materials[0].material, Ok(Material::default().into()));
    assert_eq!(model.warnings, []);

    // Two libraries in one line; a material that is in neither is left to the scene file.
    let two = format!("mtllib a.mtl b.mtl\n{TRIANGLE}usemtl red\nf 1 2 3\nusemtl no\nf 1 2 3\n");
    let files = [("a.obj", &two[..]), ("a.mtl", ""), ("b.mtl", "newmtl red\r\nKd 1 0 0\r\n")];
    let model = load(&files);
    assert_eq!(model.materials[0].material.as_ref().unwrap().values.diffuse, DVec3::X);
    let undefined = model.materials[1].material.as_ref().unwrap_err();
    assert!(undefined.place.ends_with("a.obj:8"), "{undefined}");
    assert_eq!(undefined.problem, "no library defines the material `no`; it is shown grey");
}

#[test]
fn colours_are_read() {
    let (material, warnings) = defined(
        "Ka 0 0 0\nkd 0.5 0.25 0.125\nKs 0.1 0.2 0.3\nKe 4\nNs 10\nNi 1.0\nTf 1 1 1\nd 1.0\n\
         Tr 0\nillum 2\n",
    );
    assert_eq!(warnings, [""; 0]);
    let expected = Material {
        emission: DVec3::splat(4.0),
        specular: DVec3::new(0.1, 0.2, 0.3),
        exponent: 10.0,
        ..Material::lambertian(DVec3::new(0.5, 0.25, 0.125))
    };
    assert_eq!(material.material, Ok(expected.into()));
    // What is not said is as in the default material.
    assert_eq!(defined("").0.material, Ok(Material::default().into()));
}

#[test]
fn illumination_models_are_told_apart() {
    let reflectances = |model: &str| {
        let (material, warnings) = defined(&format!("Ks 0.5\n{model}\n"));
        let material = material.material.unwrap().values;
        (material.specular.x, material.mirror.x, warnings)
    };
    assert_eq!(reflectances(""), (0.5, 0.0, vec![]));
    assert_eq!(reflectances("illum 1"), (0.0, 0.0, vec![]));
    assert_eq!(reflectances("illum 2"), (0.5, 0.0, vec![]));
    for mirror in ["illum 3", "illum 5 # Fresnel", "illum 8"] {
        assert_eq!(reflectances(mirror), (0.5, 0.5, vec![]));
    }
    let unlit = "3: illum 0 is a colour without light; it is lit as by `illum 1`".to_owned();
    assert_eq!(reflectances("illum 0"), (0.0, 0.0, vec![unlit]));
    assert_eq!(reflectances("illum 7"), (0.5, 0.0, vec![]));
}

#[test]
fn what_is_left_out_is_told_once() {
    let (material, warnings) = defined(
        "Ka 1 1 1\nKd 1 0 0\nNi 1.45\nTf 0 1 0\nmap_Ka a.png\nmap_refl b.png\nbump c.png\n\
         sharpness 60\nnewmtl n\nKa 1 1 1\nNi 1.1\nbump d.png\n",
    );
    assert_eq!(material.material.unwrap().values.emission, DVec3::ZERO);
    assert_eq!(material.maps, ModelMaps::default());
    let ambient = "there is no ambient light; `emission` in a scene file is what a surface emits";
    let expected = [
        format!("2: Ka is left out: {ambient}"),
        format!("6: map_Ka is left out: {ambient}"),
        "7: `map_refl` is left out: nothing here stands for it".to_owned(),
        "8: bump is left out: it is a map of heights, or nobody knows; `norm` is one of normals"
            .to_owned(),
        "9: `sharpness` is left out: nothing here stands for it".to_owned(),
        "4: Ni is left out: rays go straight on behind transparent surfaces".to_owned(),
        "5: Tf is left out: opacity has no colour".to_owned(),
    ];
    assert_eq!(warnings, expected);
}

#[test]
fn opacity_is_read() {
    let opacity_of = |material: Result<MaterialObject, Warning>| {
        let material = material.unwrap();
        material.transparent.then_some(material.values.opacity)
    };
    for (library, opacity) in [
        ("d 0.25\n", Some(0.25)),
        ("Tr 0.25\n", Some(0.75)),
        ("d -halo 0.5\n", Some(0.5)),
        // Some programs write both, and mean by `Tr` what `d` is.
        ("Tr 1\nd 1\n", None),
        ("d 0.25\nTr 0.25\n", Some(0.25)),
    ] {
        let (material, warnings) = defined(library);
        assert_eq!((opacity_of(material.material), warnings), (opacity, Vec::new()), "{library}");
    }
    let (invisible, warnings) = defined("Tr 1\n");
    assert_eq!(opacity_of(invisible.material), Some(0.0));
    assert!(warnings[0].contains("is 0, so it is invisible"), "{warnings:?}");
    let (mirror, warnings) = defined("Ks 0.5\nd 0.5\nillum 3\n");
    assert_eq!(opacity_of(mirror.material), None);
    assert_eq!(warnings, ["4: a mirror is shown opaque"]);
    let (mirror, warnings) = defined("illum 3\nmap_d a.png\n");
    assert_eq!((opacity_of(mirror.material), mirror.maps), (None, ModelMaps::default()));
    assert_eq!(warnings, ["3: a mirror is shown opaque"]);
    let obj = format!("mtllib a.mtl\n{TRIANGLE}usemtl m\nf 1 2 3\n");
    let model = load(&[("a.obj", &obj), ("a.mtl", "newmtl m\nmap_Kn a.png\nillum 3\n")]);
    assert_eq!(model.materials[0].maps, ModelMaps::default());
    let problems: Vec<_> = model.warnings.iter().map(|warning| &*warning.problem).collect();
    assert_eq!(problems, ["norm of m is left out: a mirror has none"]);
}

#[test]
fn textures_and_their_options_are_read() {
    let obj = format!("mtllib a.mtl\n{TRIANGLE}usemtl m\nf 1 2 3\n");
    let library = "newmtl m\nKd 0.5 0.5 0.5\nmap_Kd -s 2 3 1 -o 0.25 -clamp on a b#1.png\n\
        map_Ks -o 0.25 0 -s 2 3 -mm 0 1 tex\\c.png\nmap_Ke -s 2 3 -o 0.25 d.png\n\
        MAP_D -s 2 3 -o 0.25 a b#1.png\nnorm -s 2 3 -o 0.25 e.png\n";
    let folder = folder(&[("a.obj", &obj), ("a.mtl", library)]);
    let model = load_obj(&folder.path().join("a.obj")).unwrap();
    assert_eq!(model.warnings, []);
    let source = |name: &str, channel, wrap, line| {
        let place = format!("{}:{line}", folder.path().join("a.mtl").display());
        let image = TextureImage::File(folder.path().join(name));
        Some(TextureSource { image, channel, wrap, place })
    };
    let expected = ModelMaps {
        sources: [
            source("d.png", Channel::Color, Wrap::Repeat, 5),
            source("a b#1.png", Channel::Color, Wrap::Clamp, 3),
            source("tex/c.png", Channel::Color, Wrap::Repeat, 4),
            source("a b#1.png", Channel::Mask, Wrap::Repeat, 6),
            None,
            source("e.png", Channel::Data, Wrap::Repeat, 7),
        ],
        placement: DAffine2::from_scale_angle_translation(
            DVec2::new(2.0, 3.0),
            0.0,
            DVec2::new(0.25, 0.0),
        ),
    };
    assert_eq!(model.materials[0].maps, expected);
    let material = model.materials[0].material.as_ref().unwrap().values;
    // A colour that only a texture gives is white.
    assert_eq!(material.diffuse, DVec3::splat(0.5));
    assert_eq!((material.specular, material.emission), (DVec3::ONE, DVec3::ONE));
}

#[test]
fn texture_options_that_are_left_out_are_told() {
    let (material, warnings) = defined(
        "map_Kd -blendu on -blendv off -t 0 0 0 -boost 2 -bm 1 -imfchan m -texres 512 a.png\n\
         map_Ks -s 2 -t 1 b.png\nillum 3\n",
    );
    let image = &material.maps.get(Slot::Diffuse).unwrap().image;
    assert!(matches!(image, TextureImage::File(path) if path.ends_with("a.png")));
    assert_eq!(material.maps.placement, DAffine2::IDENTITY);
    let expected = [
        "2: -blendv of map_Kd is left out",
        "2: -boost of map_Kd is left out",
        "3: -t of map_Ks is left out",
        "3: -s and -o are those of the first of map_Kd, map_Ke, map_Ks, map_d, norm, for all of them",
        "4: map_Ks varies the highlight alone, not the mirror",
    ];
    assert_eq!(warnings, expected);
}

/// A file that names itself, and a link that leads to itself.
#[test]
fn circles_end() {
    let own = format!("mtllib a.obj\n{TRIANGLE}usemtl m\nf 1 2 3\n");
    let model = load(&[("a.obj", &own)]);
    let undefined = model.materials[0].material.as_ref().unwrap_err();
    assert!(undefined.problem.starts_with("no library defines the material `m`"), "{undefined}");
    #[cfg(unix)]
    {
        let obj = format!("mtllib a.mtl\n{TRIANGLE}usemtl m\nf 1 2 3\n");
        let folder = folder(&[("a.obj", &obj)]);
        let link = folder.path().join("a.mtl");
        std::os::unix::fs::symlink(&link, &link).unwrap();
        let model = load_obj(&folder.path().join("a.obj")).unwrap();
        let missing = model.materials[0].material.as_ref().unwrap_err();
        assert!(missing.problem.contains("a.mtl is missing"), "{missing}");
        fs::remove_file(link).unwrap();
    }
}

/// Metals and glass are kept for light that takes all paths.
#[test]
fn facets_and_glass_are_read() {
    let (metal, warnings) = defined("Kd 0.9 0.6 0.2\nPr 0.3\nPm 1\nNi 1.7\n");
    assert_eq!(warnings, Vec::<String>::new());
    let full = metal.full.unwrap();
    let numbers = full.material.values;
    assert_eq!(full.material.bsdf, Bsdf::MetallicRoughness);
    assert_eq!((numbers.metallic, numbers.roughness, numbers.ior), (1.0, 0.3, 1.7));
    assert_eq!(numbers.diffuse, DVec3::new(0.9, 0.6, 0.2));
    assert!(full.left_out.unwrap().to_string().contains("a.mtl:4: Pm is left out"));
    assert_eq!(metal.material.unwrap().bsdf, Bsdf::BlinnPhong);

    let (glass, _) = defined("Kd 0 0 0\nillum 7\nNi 1.33\nTf 0.9 1 0.8\n");
    let full = glass.full.unwrap();
    assert_eq!(full.material.bsdf, Bsdf::Dielectric);
    assert_eq!((full.material.values.ior, full.material.values.diffuse.z), (1.33, 0.8));
    let (plain, warnings) = defined("Kd 0 0 0\nNi 1.33\n");
    assert_eq!(plain.full, None);
    assert!(warnings[0].contains("3: Ni is left out"), "{warnings:?}");
    // Whatever comes first.
    let (turned, warnings) = defined("Tf 0.9 1 0.8\nNi 1.33\nillum 7\nKd 0 0 0\n");
    assert_eq!((turned.full.unwrap().material, warnings), (full.material, vec![]));
    assert_eq!(defined("Ni 1.33\nPr 0.4\n").1, Vec::<String>::new());
    let obj = format!("mtllib a.mtl\n{TRIANGLE}usemtl m\nf 1 2 3\n");
    let error = refused(&[("a.obj", &obj), ("a.mtl", "newmtl m\nPr 1.5\n")]);
    assert!(error.starts_with("a.mtl:2: Pr must be at most 1, is 1.5"), "{error}");
}
