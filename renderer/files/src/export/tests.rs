//! What is written, read back.

use std::fs;
use std::path::Path;

use glam::DVec3;
use renderer_core::scene::{
    Bsdf, Camera, Integrator, Material, MaterialObject, Mesh, Normals, PathTracing, Scene, Slot,
    SphereObject, Texture, Transform, Wrap,
};
use serde_json::Value;
use tempfile::TempDir;

use super::save_meshes;
use crate::images::srgb_encode;
use renderer::experiment::Experiment;

/// Two meshes of several materials, one of them turned and stretched; as other programs can hold them.
fn scene() -> Scene {
    let mut scene = Scene::new(8, 8, Camera::looking(DVec3::new(0.0, 0.0, 9.0), DVec3::ZERO));
    scene.integrator = Integrator::Path(PathTracing::default());
    let texture = |name: &str, wrap, level: fn(usize, usize) -> f64| {
        let texels: Vec<[f64; 3]> = (0..12).map(|i| [0, 1, 2].map(|k| level(i, k))).collect();
        Texture { name: name.to_owned(), width: 4, height: 3, wrap, texels: texels.into() }
    };
    let paint = texture("paint", Wrap::Clamp, |i, k| ((3 * i + k) as f64 / 35.0).powi(2));
    let paint = scene.add_texture(paint).unwrap();
    let glow = texture("glow", Wrap::Repeat, |i, k| (i + k) as f64 / 13.0);
    let glow = scene.add_texture(glow).unwrap();
    let brushed = MaterialObject {
        bsdf: Bsdf::MetallicRoughness,
        ..Material {
            metallic: 0.75,
            roughness: 0.3,
            ior: 1.25,
            ..Material::lambertian(DVec3::new(0.8, 0.5, 0.25))
        }
        .into()
    };
    scene.add_material("brushed", brushed.with_texture(Slot::Diffuse, paint)).unwrap();
    let lamp = Material { emission: DVec3::new(8.0, 4.0, 2.0), ..Material::lambertian(DVec3::ONE) };
    let lamp = MaterialObject::from(lamp).with_texture(Slot::Emission, glow);
    let lamp = lamp.with_texture(Slot::Normal, paint);
    scene.add_material("lamp", lamp).unwrap();
    let veil = Material::lambertian(DVec3::new(0.1, 0.2, 0.3));
    scene.add_material("a veil", MaterialObject::from(veil).with_opacity(0.5)).unwrap();
    scene.add_material("glass", MaterialObject::dielectric(1.75)).unwrap();

    let corners =
        [[0.0, 0.0, 0.1], [1.0, 0.0, 0.0], [1.0, 1.0, 0.3], [0.0, 1.0, 0.0], [0.5, 0.5, 2.0]];
    let fan = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let places = [[0.0, 0.25], [1.0, 0.0], [0.125, 0.75], [1.5, -0.5]];
    let mut painted = Mesh::new("painted", corners.to_vec(), fan.clone())
        .texture_coordinates(places.to_vec(), vec![[0, 1, 2], [1, 2, 3], [3, 0, 1], [2, 1, 0]])
        .normals(vec![[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, -1.0, 0.0]], vec![[0, 1, 2]; 4]);
    painted.materials = vec![0, 0, 1, 1];
    painted.transform = Transform {
        translation: DVec3::new(1.0, -2.0, 0.5),
        rotation: DVec3::new(20.0, 50.0, -30.0),
        scale: DVec3::new(1.0, 2.0, 0.5),
    };
    scene.add_mesh(painted).unwrap();
    let mut smooth =
        Mesh::new("smooth", corners.map(|[x, y, z]| [x, y - 3.0, z]).to_vec(), fan).smooth();
    smooth.materials = vec![2, 2, 3, 3];
    scene.add_mesh(smooth).unwrap();
    scene
}

/// Writes a scene, and reads it into one where light takes all paths.
fn written(scene: &Scene, file: &str) -> (TempDir, Scene) {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(save_meshes(scene, &folder.path().join(file)).unwrap(), []);
    let read = format!(
        "[integrator]\ntype = \"path\"\n[camera]\nlook_from = [0, 0, 9]\nlook_at = [0, 0, 0]\nwidth = 8\n\
         height = 8\n[[mesh]]\npath = \"{file}\"\nnormals = \"file\"\n"
    );
    let path = folder.path().join("read.toml");
    fs::write(&path, read).unwrap();
    let scene = Experiment::load(&path).unwrap().scene;
    (folder, scene)
}

/// Position, normal, place on textures and material of every corner, in the world.
fn corners(scene: &Scene, mesh: &Mesh) -> Vec<(DVec3, DVec3, Option<[f64; 2]>, String)> {
    let mesh = super::with_directions(mesh);
    let Normals::Given { directions, triangles } = &mesh.normals else { panic!("normals") };
    let vertices: Vec<DVec3> = mesh.world_vertices().collect();
    let place = |normal: [f64; 3]| {
        renderer_core::transport::smooth::place_normal::<f64>(mesh.transform, normal.into())
            .normalize()
    };
    let corner = |triangle: usize, i: usize| {
        let texture = mesh.texture_triangles.get(triangle).copied().flatten();
        (
            vertices[mesh.triangles[triangle][i] as usize],
            place(directions[triangles[triangle].unwrap()[i] as usize]),
            texture.map(|indices| mesh.texture_coordinates[indices[i] as usize]),
            scene.materials[mesh.materials[triangle] as usize].name.clone(),
        )
    };
    (0..mesh.triangles.len()).flat_map(|t| [0, 1, 2].map(|i| corner(t, i))).collect()
}

/// The volume that the triangles of a mesh go round counterclockwise, seen from outside before it is placed.
fn volume(mesh: &Mesh) -> f64 {
    let vertices: Vec<DVec3> = mesh.world_vertices().collect();
    let corners = mesh.triangles.iter().map(|corners| corners.map(|i| vertices[i as usize]));
    let six_times: f64 = corners.map(|[a, b, c]| a.dot(b.cross(c))).sum();
    mesh.transform.scale.element_product().signum() * six_times / 6.0
}

#[test]
fn mirrored_meshes_keep_their_outside() {
    let mut scene = Scene::new(8, 8, Camera::looking(DVec3::Z, DVec3::ZERO));
    let texels = vec![[0.5; 3]; 4].into();
    let grey = Texture { name: "grey".into(), width: 2, height: 2, wrap: Wrap::Repeat, texels };
    let grey = scene.add_texture(grey).unwrap();
    let matt = MaterialObject::from(Material::lambertian(DVec3::ONE));
    scene.add_material("matt", matt.with_texture(Slot::Diffuse, grey)).unwrap();
    let vertices = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]].to_vec();
    let triangles = vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let places = vertices.iter().map(|&[x, y, z]| [x, y - z]).collect();
    let mesh = Mesh::new("wedge", vertices, triangles.clone())
        .texture_coordinates(places, triangles.clone())
        .normals(
            vec![[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]],
            triangles,
        )
        .transform(Transform { scale: DVec3::new(-1.0, 2.0, 0.5), ..Transform::IDENTITY });
    assert!((volume(&mesh) - 1.0).abs() < 1e-12);
    scene.add_mesh(mesh.clone()).unwrap();
    for file in ["mirrored.glb", "mirrored.obj"] {
        let (_folder, read) = written(&scene, file);
        assert!((volume(&read.meshes[0]) - 1.0).abs() < 1e-6, "{file}");
        // The corners of a triangle go round another way, and are the same; normals point outside.
        let sets = |scene: &Scene, mesh: &Mesh| {
            let corners = corners(scene, mesh);
            let sets = corners.chunks_exact(3).map(|corners| {
                let mut corners: Vec<_> = corners
                    .iter()
                    .map(|&(place, normal, texture, _)| {
                        let outside = normal * mesh.transform.scale.element_product().signum();
                        format!("{place:.4} {outside:.4} {texture:?}").replace("-0.0000", "0.0000")
                    })
                    .collect();
                corners.sort();
                corners
            });
            sets.collect::<Vec<_>>()
        };
        assert_eq!(sets(&read, &read.meshes[0]), sets(&scene, &mesh), "{file}");
    }
}

#[test]
fn scenes_are_read_back_as_they_were() {
    let scene = scene();
    for (file, precision) in [("object.glb", 1e-6), ("my object.obj", 1e-14)] {
        let (_folder, read) = written(&scene, file);
        for (mesh, other) in scene.meshes.iter().zip(&read.meshes) {
            assert_eq!(mesh.name, other.name);
            let (corners, others) = (corners(&scene, mesh), corners(&read, other));
            assert_eq!(corners.len(), others.len());
            for (corner, other) in corners.iter().zip(&others) {
                assert!(corner.0.distance(other.0) < precision, "{file}: {corner:?} {other:?}");
                assert!(corner.1.distance(other.1) < precision, "{file}: {corner:?} {other:?}");
                assert_eq!((&corner.2, &corner.3), (&other.2, &other.3), "{file}");
            }
        }
        let transforms = scene.meshes.iter().zip(&read.meshes);
        let is_kept = transforms.map(|(a, b)| {
            a.transform.rotation.distance(b.transform.rotation) < 1e-9
                && a.transform.scale.distance(b.transform.scale) < 1e-12
        });
        assert_eq!(is_kept.collect::<Vec<_>>(), [file.ends_with("glb"), true]);
        assert_eq!(read.meshes.len(), 2);

        for material in &scene.materials {
            let other = read.materials.iter().find(|other| other.name == material.name).unwrap();
            // Of a file's material that is matt light shows a gloss where it takes all paths.
            if material.bsdf != Bsdf::BlinnPhong || file.ends_with("obj") {
                assert_eq!((material.bsdf, material.values), (other.bsdf, other.values), "{file}");
            }
            assert_eq!(material.values.diffuse, other.values.diffuse);
            assert_eq!(material.values.emission, other.values.emission);
            assert_eq!(
                (material.transparent, material.values.opacity),
                (other.transparent, other.values.opacity)
            );
            assert_eq!(material.normal_scale, other.normal_scale);
            for slot in Slot::ALL {
                let texture = |scene: &Scene, material: &MaterialObject| {
                    Some(scene.textures[material.textures.get(slot)? as usize].clone())
                };
                let (texture, other) = (texture(&scene, material), texture(&read, other));
                assert_eq!(texture.is_some(), other.is_some(), "{file} {slot:?}");
                let Some((texture, other)) = texture.zip(other) else { continue };
                assert_eq!(
                    (texture.width, texture.height, texture.wrap),
                    (other.width, other.height, other.wrap)
                );
                let (image, other) = (texture.image(), other.image());
                for (a, b) in image.pixels.as_flattened().iter().zip(other.pixels.as_flattened()) {
                    let encode = |value: f32| match slot {
                        Slot::Normal => f64::from(value),
                        _ => srgb_encode(value),
                    };
                    assert!((encode(*a) - encode(*b)).abs() < 0.51 / 255.0, "{slot:?} {a} {b}");
                }
            }
        }
    }
}

/// Covers of the same size go into the alpha of the colours.
#[test]
fn opacities_are_kept() {
    let mut scene = scene();
    // What has texture coordinates.
    scene.meshes.truncate(1);
    scene.meshes[0].materials.fill(2);
    let texels: Vec<[f64; 3]> = (0..12).map(|i| [f64::from(i) / 255.0; 3]).collect();
    let holes =
        Texture { name: "holes".to_owned(), texels: texels.into(), ..scene.textures[0].clone() };
    let holes = scene.add_texture(holes).unwrap();
    let leaf =
        MaterialObject::from(Material::lambertian(DVec3::ONE)).with_texture(Slot::Opacity, holes);
    for (index, material) in
        [leaf.clone(), leaf.with_texture(Slot::Diffuse, 0)].into_iter().enumerate()
    {
        let name = scene.materials[2].name.clone();
        scene.materials[2] = MaterialObject { name, ..material };
        for file in ["object.glb", "object.obj"] {
            let (_folder, read) = written(&scene, file);
            let leaf = read.materials.iter().find(|material| material.name == "a veil").unwrap();
            let slot = |slot| leaf.textures.get(slot).map(|index| &read.textures[index as usize]);
            let opacity = slot(Slot::Opacity).unwrap().texels.iter().flatten();
            let levels: Vec<i32> = opacity.map(|value| (255.0 * value).round() as i32).collect();
            assert_eq!(levels, (0..12).flat_map(|i| [i; 3]).collect::<Vec<_>>(), "{file}");
            assert_eq!(leaf.values.opacity, 1.0);
            assert!(index == 0 || slot(Slot::Diffuse).is_some());
        }
    }
}

fn u32_at(bytes: &[u8], at: usize) -> usize {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize
}

/// As the specification of glTF 2.0 asks for.
#[test]
fn the_file_keeps_to_the_format() {
    let (folder, _) = written(&scene(), "object.glb");
    let bytes = fs::read(folder.path().join("object.glb")).unwrap();
    assert_eq!((&bytes[..4], u32_at(&bytes, 4), u32_at(&bytes, 8)), (&b"glTF"[..], 2, bytes.len()));
    let json = u32_at(&bytes, 12);
    assert_eq!((&bytes[16..20], json % 4), (&b"JSON"[..], 0));
    let document: Value = serde_json::from_slice(&bytes[20..20 + json]).unwrap();
    let binary = &bytes[20 + json..];
    assert_eq!((u32_at(binary, 0) + 8, &binary[4..8]), (binary.len(), &b"BIN\0"[..]));
    let binary = &binary[8..];
    assert_eq!(
        (document["buffers"][0]["byteLength"].as_u64(), binary.len() % 4),
        (Some(binary.len() as u64), 0)
    );

    let number = |value: &Value| value.as_u64().unwrap() as usize;
    let view = |index: &Value| {
        let view = &document["bufferViews"][number(index)];
        let (offset, length) = (number(&view["byteOffset"]), number(&view["byteLength"]));
        assert_eq!(offset % 4, 0);
        (&binary[offset..offset + length], view["target"].as_u64())
    };
    for primitive in document["meshes"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(|mesh| mesh["primitives"].as_array().unwrap())
    {
        let accessor = |index: &Value| &document["accessors"][number(index)];
        let positions = accessor(&primitive["attributes"]["POSITION"]);
        let count = number(&positions["count"]);
        for (name, components) in [("POSITION", 3), ("NORMAL", 3), ("TEXCOORD_0", 2)] {
            let index = &primitive["attributes"][name];
            if index.is_null() {
                continue;
            }
            let accessor = accessor(index);
            let (bytes, target) = view(&accessor["bufferView"]);
            assert_eq!(
                (number(&accessor["componentType"]), number(&accessor["count"])),
                (5126, count)
            );
            assert_eq!(accessor["type"], format!("VEC{components}"));
            assert_eq!((bytes.len(), target), (4 * components * count, Some(34962)));
            let floats: Vec<f32> =
                bytes.as_chunks().0.iter().map(|x| f32::from_le_bytes(*x)).collect();
            for component in 0..components {
                let of = floats.iter().skip(component).step_by(components).copied();
                let limits = [of.clone().reduce(f32::min), of.reduce(f32::max)].map(|x| x.unwrap());
                let said =
                    ["min", "max"].map(|name| accessor[name][component].as_f64().unwrap() as f32);
                assert_eq!(said, limits, "{name}");
            }
        }
        let indices = accessor(&primitive["indices"]);
        let (bytes, target) = view(&indices["bufferView"]);
        assert_eq!(
            (number(&indices["componentType"]), &indices["type"]),
            (5123, &Value::from("SCALAR"))
        );
        assert_eq!((bytes.len(), target), (2 * number(&indices["count"]), Some(34963)));
        assert!(bytes.as_chunks().0.iter().all(|i| usize::from(u16::from_le_bytes(*i)) < count));
    }
    for image in document["images"].as_array().unwrap() {
        assert_eq!(&view(&image["bufferView"]).0[1..4], b"PNG");
    }
    for name in document["extensionsUsed"].as_array().unwrap() {
        assert!(document["materials"].to_string().contains(name.as_str().unwrap()), "{name}");
    }
}

/// More vertices than indices of two bytes can tell apart.
#[test]
fn large_meshes_have_wide_indices() {
    let mut scene = scene();
    let vertex = |i: u32| [f64::from(i), f64::from((i % 101).pow(2)), f64::from(i % 3)];
    let count = 65_538;
    let triangles: Vec<[u32; 3]> = (0..count / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let large = Mesh::new("large", (0..count).map(vertex).collect(), triangles);
    scene.meshes = vec![large.material(2).smooth()];
    let (_folder, read) = written(&scene, "object.glb");
    assert!(read.meshes[0].vertices == scene.meshes[0].vertices);
    assert!(read.meshes[0].triangles == scene.meshes[0].triangles);
}

#[test]
fn what_is_lost_is_said() {
    let mut scene = scene();
    let enamel = Material {
        specular: DVec3::splat(0.2),
        exponent: 60.0,
        mirror: DVec3::splat(0.1),
        roughness: 0.5,
        ..Material::lambertian(DVec3::splat(1.5))
    };
    scene.materials[2] = MaterialObject { name: "enamel".to_owned(), ..enamel.into() };
    scene.textures[1].wrap = Wrap::Mirror;
    let mut texels: Vec<[f64; 3]> = scene.textures[1].texels.iter().collect();
    texels[0] = [2.0; 3];
    scene.textures[1].texels = texels.into();
    scene.add_sphere(SphereObject::new("ball", DVec3::ZERO, 1.0)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let said = |file: &str| {
        let path = folder.path().join(file);
        let warnings = save_meshes(&scene, &path).unwrap();
        let place = format!("{}: ", path.display());
        warnings.iter().map(|warning| warning.to_string().replace(&place, "")).collect::<Vec<_>>()
    };
    let clipped = "texture.glow: texels above 1 are written as 1: the image has 8 bits";
    assert_eq!(
        said("object.glb"),
        [
            "spheres are left out (1 in the scene): only meshes are written",
            clipped,
            "material.enamel: a diffuse albedo above 1 is written as 1",
            "material.enamel: the highlight (specular, exponent) becomes that of a roughness: glTF has no Blinn-Phong",
            "material.enamel: mirror is left out: in glTF metals alone are mirrors",
            "material.enamel: the roughness of matt surfaces is left out of glTF",
        ]
    );
    assert_eq!(
        said("object.obj"),
        [
            "spheres are left out (1 in the scene): only meshes are written",
            "texture.glow: is repeated instead of mirrored: MTL has no mirrored textures",
            "material.enamel: its highlight gets the colour of its mirror: MTL has one for both",
            "material.enamel: the roughness of matt surfaces is left out: MTL has none",
            clipped,
        ]
    );
}

#[test]
fn what_cannot_be_written_is_refused() {
    let problem =
        |scene: &Scene, file: &str| save_meshes(scene, Path::new(file)).unwrap_err().to_string();
    for file in ["object.stl", "object", "object.gltf"] {
        let expected = "meshes are written as .glb (binary glTF) or .obj (with .mtl and .png)";
        assert_eq!(problem(&scene(), file), format!("{file}: {expected}"));
    }
    let none = Scene { meshes: Vec::new(), ..scene() };
    assert_eq!(problem(&none, "object.glb"), "object.glb: the scene has no triangle to write");
}
