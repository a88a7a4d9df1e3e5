//! glTF files, good and bad.

use std::f64::consts::{FRAC_1_SQRT_2, PI};
use std::fs;

use glam::{DMat4, DVec3};
use renderer_core::scene::{Bsdf, Material, Normals};
use renderer_core::transport::area_light::Place;
use renderer_core::transport::direct::direct;
use renderer_core::transport::light::illuminate;
use renderer_core::transport::surface::SurfacePoint;
use serde_json::{Value, json};

use super::document::LightDefinition;
use super::*;

/// Four positions and six indices of two bytes: a square.
const BUFFER: &str =
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAABAAIAAAACAAMA";

pub(super) fn square() -> Value {
    json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": { "KHR_lights_punctual": { "lights": [
            { "type": "point", "intensity": 5.0, "name": "lamp" },
            { "type": "directional", "color": [1.0, 0.5, 0.25], "intensity": 2.0 },
        ] } },
        "scene": 0,
        "scenes": [{ "nodes": [0, 2, 3, 4] }],
        "nodes": [
            { "name": "parent", "translation": [0.0, 0.0, -1.0], "children": [1] },
            { "name": "square", "mesh": 0, "scale": [2.0, 2.0, 2.0] },
            { "camera": 0, "translation": [0.5, 0.5, 3.0] },
            { "translation": [1.0, 2.0, 3.0],
              "extensions": { "KHR_lights_punctual": { "light": 0 } } },
            // A quarter turn about x: it shines along +y.
            { "name": "sun", "rotation": [FRAC_1_SQRT_2, 0.0, 0.0, FRAC_1_SQRT_2],
              "extensions": { "KHR_lights_punctual": { "light": 1 } } },
        ],
        "meshes": [{ "name": "quad", "primitives": [
            { "attributes": { "POSITION": 0 }, "indices": 1, "material": 1 },
        ] }],
        "materials": [
            { "name": "unused" },
            { "name": "red", "pbrMetallicRoughness": { "baseColorFactor": [0.5, 0.25, 0.125, 1.0] } },
        ],
        "cameras": [
            { "type": "perspective", "perspective": { "yfov": 0.5, "znear": 0.1, "aspectRatio": 1.5 } },
        ],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3" },
            { "bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR" },
        ],
        "bufferViews": [
            { "buffer": 0, "byteLength": 48 },
            { "buffer": 0, "byteOffset": 48, "byteLength": 12 },
        ],
        "buffers": [{ "byteLength": 60, "uri": format!("data:application/octet-stream;base64,{BUFFER}") }],
    })
}

pub(super) fn load_bytes(name: &str, bytes: &[u8]) -> Result<GltfFile, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    load_gltf(&path)
}

pub(super) fn load(document: &Value) -> Result<GltfFile, Error> {
    load_bytes("model.gltf", document.to_string().as_bytes())
}

/// A `.glb` whose first buffer is its binary chunk.
pub(super) fn glb(mut document: Value, binary: &[u8]) -> Vec<u8> {
    document["buffers"][0].as_object_mut().unwrap().remove("uri");
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend((12 + 8 + json.len() as u32 + 8 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &json[..]), (b"BIN\0", binary)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

pub(super) fn square_bytes() -> Vec<u8> {
    let positions: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    let indices: [u16; 6] = [0, 1, 2, 0, 2, 3];
    let positions = positions.iter().flat_map(|x| x.to_le_bytes());
    positions.chain(indices.iter().flat_map(|i| i.to_le_bytes())).collect()
}

#[test]
fn meshes_are_placed_in_the_world() {
    let GltfFile { model, .. } = load(&square()).unwrap();
    let [mesh] = &model.meshes[..] else { panic!("one mesh") };
    assert_eq!(mesh.name, "square");
    let vertices = [[0.0, 0.0, -1.0], [2.0, 0.0, -1.0], [2.0, 2.0, -1.0], [0.0, 2.0, -1.0]];
    assert_eq!(mesh.world_vertices().collect::<Vec<_>>(), vertices.map(DVec3::from));
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    let [red] = &model.materials[..] else { panic!("one material") };
    assert_eq!((red.name.as_str(), &mesh.materials[..]), ("red", &[0, 0][..]));
    assert_eq!(red.material.as_ref().unwrap().values.diffuse, DVec3::new(0.5, 0.25, 0.125));
}

/// Primitives of several materials often have one accessor of vertices, and name different ones of these.
#[test]
fn primitives_share_the_vertices_of_an_accessor() {
    let mut document = square();
    let accessors = document["accessors"].as_array_mut().unwrap();
    let mut second = accessors[1].clone();
    (accessors[1]["count"], second["count"]) = (json!(3), json!(3));
    second["byteOffset"] = json!(6);
    accessors.push(second);
    document["meshes"][0]["primitives"] = json!([
        { "attributes": { "POSITION": 0 }, "indices": 1, "material": 1 },
        { "attributes": { "POSITION": 0 }, "indices": 2, "material": 0 },
    ]);
    let GltfFile { model, .. } = load(&document).unwrap();
    let [mesh] = &model.meshes[..] else { panic!("one mesh") };
    assert_eq!(mesh.vertices.len(), 4);
    assert_eq!(
        (&mesh.triangles[..], &mesh.materials[..]),
        (&[[0, 1, 2], [0, 2, 3]][..], &[0, 1][..])
    );
}

/// The square without its first corner, which is no direction, and with the other positions as normals.
fn with_normals() -> Value {
    let mut document = square();
    let accessors = document["accessors"].as_array_mut().unwrap();
    accessors[0]["byteOffset"] = json!(12);
    accessors[0]["count"] = json!(3);
    let indices = document["accessors"].as_array_mut().unwrap();
    indices[1]["count"] = json!(3);
    document["meshes"][0]["primitives"] = json!([
        { "attributes": { "POSITION": 0, "NORMAL": 0 } },
        { "attributes": { "POSITION": 0 } },
    ]);
    document
}

fn read(document: &Value) -> Result<Mesh, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.gltf");
    fs::write(&path, document.to_string()).unwrap();
    read_gltf(&path, FileNormals::Read).map(|mut file| file.model.meshes.remove(0))
}

#[test]
fn normals_are_read_where_they_are_wanted() {
    let mut document = with_normals();
    let directions = vec![[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let triangles = vec![Some([0, 1, 2]), None];
    let expected = Normals::Given { directions, triangles };
    assert_eq!(read(&document).unwrap().normals, expected);
    assert_eq!(load(&document).unwrap().model.meshes[0].normals, Normals::Flat);

    // A matrix that shears moves vertices; normals stay perpendicular to what they were.
    document["nodes"][1] = json!({
        "mesh": 0, "matrix": [1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
    });
    let sheared = read(&document).unwrap();
    assert_eq!(sheared.vertices[0..3], [[1.0, 0.0, -1.0], [2.0, 1.0, -1.0], [1.0, 1.0, -1.0]]);
    let directions = sheared.normals.directions();
    assert_eq!(directions, [[1.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);

    // One that mirrors, too, turns the corners round, so that the outside stays the outside.
    document["nodes"][1] = json!({
        "mesh": 0, "matrix": [-1, 0, 0, 0, -1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
    });
    let mirrored = read(&document).unwrap();
    let corners = mirrored.triangles[0].map(|index| mirrored.vertices[index as usize]);
    assert_eq!(corners, [[-1.0, 0.0, -1.0], [-1.0, 1.0, -1.0], [-2.0, 1.0, -1.0]]);
    let directions = mirrored.normals.directions();
    assert_eq!(directions, [[-1.0, -1.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]);

    for (broken, value, expected) in [
        ("/accessors/0/byteOffset", json!(0), "NORMAL 0: a normal is the zero vector"),
        ("/meshes/0/primitives/0/attributes/NORMAL", json!(9), "there is no accessors[9], of 2"),
        ("/meshes/0/primitives/0/attributes/NORMAL", json!(1), "accessors[1]: its type is SCALAR"),
    ] {
        let mut document = with_normals();
        *document.pointer_mut(broken).unwrap() = value;
        let error = read(&document).unwrap_err().to_string();
        let place = "model.gltf: meshes[0].primitives[0]";
        assert!(error.contains(place) && error.contains(expected), "{error}");
    }
}

#[test]
fn cameras_and_lights_are_converted() {
    let GltfFile { camera, lights, .. } = load(&square()).unwrap();
    let (camera, aspect_ratio) = camera.unwrap();
    assert_eq!(camera.look_from, DVec3::new(0.5, 0.5, 3.0));
    assert_eq!((camera.look_at, camera.up), (DVec3::new(0.5, 0.5, 2.0), DVec3::Y));
    assert_eq!((camera.vfov, aspect_ratio), (0.5_f64.to_degrees(), Some(1.5)));
    let [(lamp, Light::Point(point)), (sun, Light::Distant(distant))] = &lights[..] else {
        panic!("two lights")
    };
    assert_eq!((lamp.as_str(), sun.as_str()), ("lamp", "sun"));
    assert_eq!((point.position, point.radiant_intensity), (DVec3::new(1.0, 2.0, 3.0), 5.0));
    assert!(distant.direction.distance(DVec3::NEG_Y) < 1e-12, "{}", distant.direction);
    assert_eq!((distant.color.y, distant.irradiance), (0.5, 2.0));
}

#[test]
fn spot_lights_shine_along_their_own_axis() {
    let spot = |json: Value| {
        let definition = serde_json::from_value(json).unwrap();
        lights::light(&definition, DMat4::from_translation(DVec3::ONE))
    };
    let light =
        spot(json!({ "type": "spot", "intensity": 3.0, "spot": { "innerConeAngle": 0.5 } }));
    let Ok(Light::Spot(light)) = light else { panic!("a spot light: {light:?}") };
    assert_eq!((light.position, light.direction), (DVec3::ONE, DVec3::NEG_Z));
    assert_eq!((light.inner_angle, light.radiant_intensity), (0.5_f64.to_degrees(), 3.0));
    // The default of glTF.
    assert_eq!(light.outer_angle, 45.0);
    let error = spot(json!({ "type": "spot" })).unwrap_err();
    assert_eq!(error, "is a spot light without the angles of its cone");
}

/// The radiance of a white surface that faces a light of one candela at distance one is 1 / pi in
/// glTF; ours has to be the same.
#[test]
fn a_white_surface_is_as_bright_as_gltf_says() {
    let definition = LightDefinition {
        name: None,
        kind: "point".into(),
        color: [1.0; 3],
        intensity: 1.0,
        spot: None,
    };
    let light = lights::light(&definition, DMat4::IDENTITY).unwrap();
    let surface = SurfacePoint { point: DVec3::Z, normal: DVec3::NEG_Z, view: DVec3::NEG_Z };
    let white = Material::lambertian(DVec3::ONE);
    let arriving = illuminate::<f64>(light, Place::POINT, surface.point);
    let radiance =
        direct::<f64>(white, white.lobes(Bsdf::BlinnPhong), surface, arriving, true, 1.0);
    assert!((radiance.x - 1.0 / PI).abs() < 1e-15, "{radiance}");
}

#[test]
fn a_file_alone_is_a_scene() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.gltf");
    fs::write(&path, square().to_string()).unwrap();
    let scene = renderer::experiment::Experiment::load(&path).unwrap().scene;
    assert_eq!((scene.width, scene.height), (768, 512));
    let names: Vec<&str> = scene.lights.iter().map(|light| light.name.as_str()).collect();
    assert_eq!(names, ["lamp", "sun"]);
    // The point looked at is as far as the mesh.
    assert_eq!(scene.camera.look_at, DVec3::new(0.5, 0.5, -1.0));

    let mut bare = square();
    bare["nodes"] = json!([{ "mesh": 0 }]);
    bare["scenes"] = json!([{ "nodes": [0] }]);
    fs::write(&path, bare.to_string()).unwrap();
    let scene = renderer::experiment::Experiment::load(&path).unwrap().scene;
    assert_eq!((scene.lights[0].name.as_str(), scene.width), ("key", 512));
}

#[test]
fn binary_and_files_of_their_own_hold_the_same() {
    let expected = load(&square()).unwrap();
    let binary = load_bytes("model.glb", &glb(square(), &square_bytes())).unwrap();
    assert_eq!((&binary.model.meshes, &binary.lights), (&expected.model.meshes, &expected.lights));

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.gltf");
    fs::write(folder.path().join("my data.bin"), square_bytes()).unwrap();
    let mut document = square();
    document["buffers"][0]["uri"] = json!("my%20data.bin");
    fs::write(&path, document.to_string()).unwrap();
    assert_eq!(load_gltf(&path).unwrap().model.meshes, expected.model.meshes);
}

#[test]
fn strips_fans_and_plain_lists_are_triangles() {
    let triangles = |mode: u32, indexed: bool| {
        let mut document = square();
        let primitive = &mut document["meshes"][0]["primitives"][0];
        primitive["mode"] = json!(mode);
        if !indexed {
            primitive.as_object_mut().unwrap().remove("indices");
        }
        load(&document).map(|file| file.model.meshes[0].triangles.clone())
    };
    assert_eq!(triangles(4, false).unwrap(), [[0, 1, 2]]);
    // The second triangle of a strip is turned: 2, 1, 3.
    assert_eq!(triangles(5, false).unwrap(), [[0, 1, 2], [2, 1, 3]]);
    assert_eq!(triangles(6, false).unwrap(), [[0, 1, 2], [0, 2, 3]]);
    assert!(triangles(1, true).unwrap_err().problem.contains("no triangles"));
}

/// The third position is listed apart: of the square, and of an accessor that is zero elsewhere.
#[test]
fn sparse_elements_replace_others() {
    let mut bytes = square_bytes();
    bytes.extend([2, 0, 0, 0]);
    bytes.extend([5.0_f32, 6.0, 7.0].map(f32::to_le_bytes).as_flattened());
    let mut document = square();
    document["buffers"][0]["byteLength"] = json!(bytes.len());
    let views = document["bufferViews"].as_array_mut().unwrap();
    views.push(json!({ "buffer": 0, "byteOffset": 60, "byteLength": 4 }));
    views.push(json!({ "buffer": 0, "byteOffset": 64, "byteLength": 12 }));
    document["accessors"][0]["sparse"] = json!({
        "count": 1,
        "indices": { "bufferView": 2, "componentType": 5121 },
        "values": { "bufferView": 3 },
    });
    let load = |document: &Value| load_bytes("model.glb", &glb(document.clone(), &bytes));
    let vertices = |document: &Value| load(document).unwrap().model.meshes[0].vertices.clone();
    let third = [5.0, 6.0, 7.0];
    assert_eq!(vertices(&document), [[0.0; 3], [1.0, 0.0, 0.0], third, [0.0, 1.0, 0.0]]);
    let mut zero = document.clone();
    zero["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    assert_eq!(vertices(&zero), [[0.0; 3], [0.0; 3], third, [0.0; 3]]);
    for (pointer, value, expected) in [
        ("/accessors/0/count", json!(u64::MAX), "elements without a bufferView, above 16777216"),
        ("/accessors/0/sparse", json!(null), "accessors[0]: has no bufferView"),
        ("/accessors/0/count", json!(2), "its sparse element 2 is none of 2"),
        ("/accessors/0/sparse/count", json!(2), "2 elements from byte 0 on do not fit"),
        ("/accessors/0/sparse/indices/componentType", json!(5126), "must be unsigned integers"),
    ] {
        let mut broken = zero.clone();
        *broken.pointer_mut(pointer).unwrap() = value;
        let error = load(&broken).unwrap_err();
        assert!(error.problem.contains(expected), "{error}");
    }
}

/// What light does not matter for emits its base colour.
#[test]
fn unlit_materials_emit() {
    let mut document = square();
    document["materials"][1]["extensions"] = json!({ "KHR_materials_unlit": {} });
    document["materials"][1]["emissiveFactor"] = json!([1.0, 1.0, 1.0]);
    document["extensionsRequired"] = json!(["KHR_materials_unlit"]);
    let model = load(&document).unwrap().model;
    let material = &model.materials[0].material.as_ref().unwrap().values;
    assert_eq!(material.emission, DVec3::new(0.5, 0.25, 0.125));
    assert_eq!((material.diffuse, material.specular), (DVec3::ZERO, DVec3::ZERO));
}

/// Smooth glass is read for light that takes all paths; of what else lets light through it is told.
#[test]
fn transmission_is_read_or_told() {
    let read = |pbr: Value, extensions: Value| {
        let mut document = square();
        document["materials"][1]["pbrMetallicRoughness"] = pbr;
        document["materials"][1]["extensions"] = extensions;
        let model = load(&document).unwrap().model;
        let full = model.materials[0].full.clone().unwrap();
        let told: Vec<_> = model.warnings.iter().map(|warning| warning.problem.clone()).collect();
        (full, told)
    };
    let smooth = json!({ "metallicFactor": 0, "roughnessFactor": 0 });
    let transmission = json!({ "transmissionFactor": 1.0 });
    let solid = json!({ "KHR_materials_transmission": transmission, "KHR_materials_volume": {},
        "KHR_materials_ior": { "ior": 1.33 } });
    let (glass, told) = read(smooth.clone(), solid);
    assert_eq!((glass.material.bsdf, glass.material.values.ior), (Bsdf::Dielectric, 1.33));
    assert!(glass.left_out.unwrap().problem.contains("glass is opaque unless"));
    assert_eq!(told, Vec::<String>::new());
    let only = |extension: &str, value: Value| json!({ extension: value });
    let (wall, told) =
        read(smooth.clone(), only("KHR_materials_transmission", transmission.clone()));
    assert_eq!(wall.material.bsdf, Bsdf::Dielectric);
    assert!(told[0].contains("thin wall"), "{told:?}");
    let rough = json!({ "metallicFactor": 0, "roughnessFactor": 0.3 });
    let (frosted, told) = read(rough, only("KHR_materials_transmission", transmission));
    assert_eq!(frosted.material.bsdf, Bsdf::MetallicRoughness);
    assert!(told[0].contains("none but smooth glass"), "{told:?}");
    let (bright, _) = read(smooth, only("KHR_materials_ior", json!({ "ior": 0 })));
    assert!(bright.material.values.ior > 100.0);
}

#[test]
fn broken_documents_are_refused() {
    let cases: [(&str, Value, &str); 22] = [
        ("/asset/version", json!("1.0"), "is glTF of version 1.0; version 2 is read"),
        ("/scene", json!(1), "there is no scenes[1], of 1"),
        ("/scenes/0/nodes/0", json!(9), "there is no nodes[9], of 5"),
        ("/nodes/0/children/0", json!(0), "nodes[0] has two parents, or is its own ancestor"),
        ("/nodes/1/mesh", json!(1), "there is no meshes[1], of 1"),
        ("/nodes/2/camera", json!(1), "there is no cameras[1], of 1"),
        ("/nodes/1/scale/0", json!(1e300), "mesh.square.vertices"),
        ("/cameras/0", json!({ "type": "orthographic" }), "cameras[0]: is not a perspective"),
        ("/cameras/0/perspective/aspectRatio", json!(0), "cameras[0]: its aspectRatio must be"),
        ("/cameras/0/perspective/yfov", json!(4), "camera.vfov: must lie between"),
        (
            "/extensions/KHR_lights_punctual/lights/0/type",
            json!("spot"),
            "KHR_lights_punctual.lights[0]: is a spot light",
        ),
        ("/meshes/0/primitives/0/material", json!(2), "there is no materials[2], of 2"),
        (
            "/meshes/0/primitives/0",
            json!({ "attributes": { "POSITION": 0 }, "mode": 7 }),
            "primitives[0]: mode 7 is none",
        ),
        (
            "/meshes/0/primitives/0/attributes",
            json!({}),
            "meshes[0].primitives[0]: has no attribute POSITION",
        ),
        ("/accessors/0/count", json!(5), "accessors[0]: 5 elements from byte 0 on do not fit"),
        ("/accessors/0/count", json!(u64::MAX), "accessors[0]: 18446744073709551615 elements"),
        ("/accessors/0/count", json!(2), "names vertex 2 of 2, counted from 0"),
        ("/accessors/0/type", json!("VEC2"), "accessors[0]: its type is VEC2, not VEC3"),
        ("/accessors/1/componentType", json!(5122), "accessors[1]: indices must be unsigned"),
        ("/bufferViews/0/byteLength", json!(61), "bufferViews[0]: 61 bytes from byte 0 on are not"),
        ("/buffers/0/byteLength", json!(61), "says that it has 61 bytes; it has 60"),
        ("/buffers/0/uri", json!("data:,x"), "its data is not base64"),
    ];
    for (pointer, value, expected) in cases {
        let mut document = square();
        *document.pointer_mut(pointer).unwrap() = value.clone();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("model.gltf");
        fs::write(&path, document.to_string()).unwrap();
        let error = renderer::experiment::Experiment::load(&path).unwrap_err().to_string();
        assert!(error.contains("model.gltf") && error.contains(expected), "{pointer}: {error}");
        assert!(!error.contains('\n'), "{error}");
    }
    let mut document = square();
    document["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]);
    let error = load(&document).unwrap_err();
    assert!(error.problem.contains("requires the extension KHR_draco"), "{error}");
    let error = load_bytes("model.gltf", b"{").unwrap_err();
    assert!(error.problem.starts_with("is not glTF: EOF"), "{error}");
}

#[test]
fn broken_binaries_are_refused() {
    let whole = glb(square(), &square_bytes());
    for (bytes, expected) in [
        (&whole[..6], "is cut short"),
        (&whole[..100], "it has 100"),
        (&whole[..whole.len() - 1], "says that it has"),
        (&glb(square(), &[])[..], "says that it has 60 bytes; it has 0"),
        (b"glTF\x01\0\0\0\x0c\0\0\0", "is binary glTF of version 1"),
        (b"glTF\x02\0\0\0\x0c\0\0\0", "has no chunk of JSON"),
        (b"glTF\x02\0\0\0\x03\0\0\0", "says that it has 3 bytes"),
    ] {
        let error = load_bytes("model.glb", bytes).unwrap_err();
        assert!(error.problem.contains(expected), "{expected}: {error}");
    }
    let mut nan = square_bytes();
    nan[12..16].copy_from_slice(&f32::NAN.to_le_bytes());
    let error = load_bytes("model.glb", &glb(square(), &nan)).unwrap_err();
    assert!(error.problem.ends_with("accessors[0]: vertex 1 is not finite"), "{error}");
}
