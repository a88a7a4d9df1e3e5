//! Textures of glTF files, and what is left out.

use std::fs;

use glam::{DVec2, DVec3};
use renderer_core::scene::{MaterialObject, Scene, Slot, Wrap};
use serde_json::{Value, json};

use super::tests::{glb, load, load_bytes, square, square_bytes};
use super::*;
use crate::meshes::TextureImage;
use renderer::experiment::Experiment;

/// Two texels side by side, the right one transparent.
fn png() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
    encoder.set_color(png::ColorType::Rgba);
    let pixels = [255, 0, 0, 255, 0, 255, 0, 0];
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
    bytes
}

const UV: [[f32; 2]; 4] = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.25], [0.0, 0.25]];

/// The square with texture coordinates and a texture, and the bytes of its buffer; the image is
/// embedded.
fn textured() -> (Value, Vec<u8>) {
    let mut document = square();
    let mut bytes = square_bytes();
    bytes.extend(UV.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
    let png = png();
    bytes.extend(&png);
    document["buffers"][0]["byteLength"] = json!(bytes.len());
    let views = document["bufferViews"].as_array_mut().unwrap();
    views.push(json!({ "buffer": 0, "byteOffset": 60, "byteLength": 32 }));
    views.push(json!({ "buffer": 0, "byteOffset": 92, "byteLength": png.len() }));
    let accessors = document["accessors"].as_array_mut().unwrap();
    accessors.push(json!({ "bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2" }));
    document["images"] = json!([{ "name": "paint", "bufferView": 3, "mimeType": "image/png" }]);
    document["samplers"] = json!([{ "wrapS": 33648, "wrapT": 33648, "magFilter": 9729 }]);
    document["textures"] = json!([{ "source": 0, "sampler": 0 }]);
    document["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"] = json!({ "index": 0 });
    document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = json!(2);
    (document, bytes)
}

fn scene((document, bytes): (Value, Vec<u8>)) -> Result<Scene, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.glb");
    fs::write(&path, glb(document, &bytes)).unwrap();
    Experiment::load(&path).map(|experiment| experiment.scene)
}

#[test]
fn textures_multiply_the_base_colour() {
    let scene = scene(textured()).unwrap();
    let [texture] = &scene.textures[..] else { panic!("one texture") };
    assert_eq!((texture.name.as_str(), texture.wrap), ("paint", Wrap::Mirror));
    // The right texel is transparent, but green all the same.
    assert_eq!(texture.image().pixels, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(scene.materials[0].values.diffuse, DVec3::new(0.5, 0.25, 0.125));
    assert_eq!(scene.materials[0].textures.get(Slot::Diffuse), Some(0));
    // Upwards: what is at the lower edge in the file, v = 1, is at 0.
    let upwards = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.75], [0.0, 0.75]];
    assert_eq!(scene.meshes[0].texture_coordinates, upwards);
    assert_eq!(scene.meshes[0].texture_triangles, [Some([0, 1, 2]), Some([0, 2, 3])]);
}

#[test]
fn images_may_be_files_or_data() {
    let embedded = scene(textured()).unwrap();
    let (mut document, bytes) = textured();
    document["images"][0] = json!({ "uri": "my%20paint.png" });
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.glb");
    fs::write(&path, glb(document.clone(), &bytes)).unwrap();
    let experiment = Experiment::load(&path).unwrap();
    assert!(experiment.scene.textures.is_empty());
    assert_eq!(experiment.scene.materials[0].values, embedded.materials[0].values);
    let [missing] = &experiment.warnings[..] else { panic!("one warning") };
    assert!(missing.place.ends_with("model.glb: images[0]"), "{missing}");
    assert!(missing.problem.ends_with("my paint.png is missing; white stands for it"), "{missing}");
    fs::write(folder.path().join("my paint.png"), png()).unwrap();
    let experiment = Experiment::load(&path).unwrap();
    assert_eq!(experiment.scene.textures[0].texels, embedded.textures[0].texels);
    assert_eq!(experiment.scene.textures[0].name, "my paint");
    let [transparent] = &experiment.warnings[..] else { panic!("one warning") };
    assert!(transparent.place.ends_with("my paint.png"), "{transparent}");
    assert_eq!(transparent.problem, "has transparent texels; they are shown opaque");

    // A PNG of one white texel, grey in its format.
    let grey = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg==";
    document["images"][0] = json!({ "uri": format!("data:image/png;base64,{grey}") });
    assert_eq!(scene((document, bytes)).unwrap().textures[0].image().pixels, [[1.0; 3]]);
}

/// The corners of the square, moved by `transform`, in the file's own coordinates.
fn moved(transform: Value) -> Vec<DVec2> {
    let (mut document, bytes) = textured();
    document["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] =
        json!({ "KHR_texture_transform": transform });
    document["extensionsRequired"] = json!(["KHR_texture_transform"]);
    let scene = scene((document, bytes)).unwrap();
    let down = |&[u, v]: &[f64; 2]| DVec2::new(u, 1.0 - v);
    scene.meshes[0].texture_coordinates.iter().map(down).collect()
}

#[test]
fn textures_are_moved_scaled_and_turned() {
    let corners = UV.map(|[u, v]| DVec2::new(u.into(), v.into()));
    let shifted = moved(json!({ "offset": [0.25, 0.5], "scale": [2.0, 4.0] }));
    let expected = corners.map(|uv| uv * DVec2::new(2.0, 4.0) + DVec2::new(0.25, 0.5));
    assert_eq!(shifted, expected);
    // A quarter turn, counter-clockwise where v goes downwards: from u to -v, from v to u.
    let turned = moved(json!({ "rotation": std::f64::consts::FRAC_PI_2 }));
    for (turned, uv) in turned.iter().zip(corners) {
        assert!(turned.distance(DVec2::new(uv.y, -uv.x)) < 1e-12, "{uv} {turned}");
    }
}

#[test]
fn materials_may_use_another_set_of_coordinates() {
    let (mut document, bytes) = textured();
    let attributes = &mut document["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_3"] = attributes.as_object_mut().unwrap().remove("TEXCOORD_0").unwrap();
    // Without them white stands for the texture.
    let bare = scene((document.clone(), bytes.clone())).unwrap();
    assert!(!bare.materials[0].textures.any() && bare.meshes[0].texture_coordinates.is_empty());
    document["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = json!(3);
    assert_eq!(scene((document, bytes)).unwrap().meshes[0].texture_coordinates.len(), 4);
}

#[test]
fn what_surfaces_emit_is_emission() {
    let (mut document, bytes) = textured();
    document["materials"][1]["emissiveFactor"] = json!([1.0, 2.0, 3.0]);
    document["materials"][1]["emissiveTexture"] = json!({ "index": 0 });
    let scene = scene((document, bytes)).unwrap();
    assert_eq!(scene.materials[0].values.emission, DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(scene.textures.len(), 1);
    assert_eq!(scene.materials[0].textures.get(Slot::Emission), Some(0));
}

#[test]
fn broken_textures_are_refused() {
    let texture = "/materials/1/pbrMetallicRoughness/baseColorTexture";
    for (pointer, value, expected) in [
        (texture, json!({ "index": 1 }), "there is no textures[1], of 1"),
        ("/textures/0", json!({ "source": 1 }), "images[1]: there is no images[1], of 1"),
        ("/textures/0", json!({}), "textures[0]: has no source"),
        ("/textures/0/sampler", json!(1), "there is no samplers[1], of 1"),
        ("/samplers/0/wrapS", json!(1), "textures[0]: a wrap mode of its sampler is 1"),
        ("/images/0", json!({}), "images[0]: has neither a uri nor a bufferView"),
        ("/images/0/bufferView", json!(9), "images[0]: there is no bufferViews[9], of 4"),
        (
            "/images/0/bufferView",
            json!(2),
            "images[0]: is not a PNG, JPEG, OpenEXR or Radiance HDR image",
        ),
        ("/images/0", json!({ "uri": "data:,x" }), "images[0]: its data is not base64"),
        ("/accessors/2/count", json!(3), "primitives[0]: has 3 TEXCOORD_0 for 4 vertices"),
        ("/accessors/2/type", json!("VEC3"), "accessors[2]: its type is VEC3, not VEC2"),
    ] {
        let (mut document, bytes) = textured();
        *document.pointer_mut(pointer).unwrap() = value.clone();
        let error = scene((document, bytes)).unwrap_err().to_string();
        assert!(error.contains("model.glb") && error.contains(expected), "{value}: {error}");
    }
}

#[test]
fn what_is_left_out_is_told() {
    let mut document = square();
    assert_eq!(load(&document).unwrap().model.warnings, []);
    document["extensionsUsed"] = json!(["KHR_lights_punctual", "KHR_materials_sheen"]);
    document["animations"] = json!([{}]);
    document["materials"][0]["occlusionTexture"] = json!({ "index": 0 });
    document["materials"][1]["pbrMetallicRoughness"]["metallicFactor"] = json!(0.5);
    let primitives = document["meshes"][0]["primitives"].as_array_mut().unwrap();
    let mut line = primitives[0].clone();
    line["mode"] = json!(1);
    primitives[0]["attributes"]["COLOR_0"] = json!(0);
    primitives.extend([line.clone(), line]);
    let model = load(&document).unwrap().model;
    let warnings = model.warnings;
    let after_file = |warning: &crate::Warning| {
        warning.to_string().split_once("model.gltf: ").unwrap().1.to_owned()
    };
    let expected = [
        "the extension KHR_materials_sheen is left out",
        "animations are left out",
        "materials[0]: occlusionTexture is left out",
        "meshes[0].primitives[0]: the colours of vertices are left out",
        "meshes[0].primitives[1]: points and lines are left out",
    ];
    assert_eq!(warnings.iter().map(after_file).collect::<Vec<_>>(), expected);
    let full = model.materials.iter().filter_map(|material| material.full.as_ref());
    let left_out: Vec<_> = full.filter_map(|full| full.left_out.as_ref()).map(after_file).collect();
    let matt = "materials[1]: metallicFactor is left out: metals are shown as matt surfaces unless \
                light takes all paths";
    assert_eq!(left_out, [matt]);

    let (mut document, bytes) = textured();
    document["samplers"][0] = json!({ "wrapS": 33071, "magFilter": 9728 });
    let model = load_bytes("model.glb", &glb(document.clone(), &bytes)).unwrap().model;
    let source = model.materials[0].maps.get(Slot::Diffuse).unwrap();
    assert_eq!(source.wrap, Wrap::Clamp);
    assert!(matches!(&source.image, TextureImage::Embedded { name, .. } if name == "paint"));
    let problems: Vec<&str> = model.warnings.iter().map(|w| w.problem.as_str()).collect();
    let expected = [
        "its sampler wraps u and v in different ways; v is wrapped as u is",
        "its sampler takes the nearest texel; all are bilinear here",
    ];
    assert_eq!(problems, expected);
    document["extensionsRequired"] = json!(["KHR_materials_sheen"]);
    let error = load_bytes("model.glb", &glb(document, &bytes)).unwrap_err();
    assert!(error.problem.contains("requires the extension KHR_materials_sheen"), "{error}");
}

/// By the numbers of the image as they are stored, whatever the light.
#[test]
fn normal_textures_bend_normals() {
    let (mut document, bytes) = textured();
    document["materials"][1]["normalTexture"] = json!({ "index": 0, "scale": 0.25 });
    let bent = scene((document.clone(), bytes.clone())).unwrap();
    let material = &bent.materials[0];
    let texture = |slot: Slot| &bent.textures[material.textures.get(slot).unwrap() as usize];
    assert_eq!(material.normal_scale, 0.25);
    assert_eq!(texture(Slot::Normal).name, "paint_data");
    assert_eq!(texture(Slot::Normal).wrap, Wrap::Mirror);
    assert_eq!(texture(Slot::Diffuse).name, "paint");
    let full = load_bytes("model.glb", &glb(document.clone(), &bytes)).unwrap();
    assert_eq!(full.model.materials[0].full.as_ref().unwrap().material.normal_scale, 0.25);

    document["materials"][1]["normalTexture"]["scale"] = json!(1e9);
    let error = scene((document.clone(), bytes.clone())).unwrap_err().to_string();
    assert!(error.contains("normal_scale: 1e9 is beyond 1e6"), "{error}");
    document["materials"][1]["normalTexture"] = json!({ "index": 7 });
    let error = scene((document.clone(), bytes.clone())).unwrap_err().to_string();
    assert!(error.contains("model.glb") && error.contains("textures"), "{error}");
    // What is not lit is not bent.
    document["materials"][1]["normalTexture"] = json!({ "index": 0 });
    document["materials"][1]["extensions"] = json!({ "KHR_materials_unlit": {} });
    let unlit = scene((document, bytes)).unwrap();
    assert_eq!(unlit.materials[0].textures.get(Slot::Normal), None);
}

/// The opacity, if the material is transparent.
fn opacity_of(material: &MaterialObject) -> Option<f64> {
    material.transparent.then_some(material.values.opacity)
}

/// The alpha of a texture varies the opacity where the alpha mode says so; only elsewhere it is warned of.
#[test]
fn the_alpha_of_textures_is_an_opacity() {
    let opacity = |mode: Value, cutoff: f64, factor: f64| {
        let (mut document, bytes) = textured();
        let material = &mut document["materials"][1];
        (material["alphaMode"], material["alphaCutoff"]) = (mode, json!(cutoff));
        material["pbrMetallicRoughness"]["baseColorFactor"] = json!([1, 1, 1, factor]);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("model.glb");
        fs::write(&path, glb(document, &bytes)).unwrap();
        let Experiment { scene, warnings, .. } = Experiment::load(&path).unwrap();
        let warned = warnings.iter().any(|w| w.problem.contains("transparent texels"));
        let assigned = scene.materials[0].textures.get(Slot::Opacity).map(|index| index as usize);
        let texels = assigned.map(|texture| {
            assert_eq!(scene.textures[texture].name, "paint_opacity");
            scene.textures[texture].texels.iter().map(|texel| texel[0]).collect::<Vec<_>>()
        });
        (opacity_of(&scene.materials[0]), texels, warned)
    };
    let texels = Some(vec![1.0, 0.0]);
    assert_eq!(opacity(json!("OPAQUE"), 0.5, 0.75), (None, None, true));
    assert_eq!(opacity(json!("BLEND"), 0.5, 0.75), (Some(0.75), texels.clone(), false));
    assert_eq!(opacity(json!("MASK"), 0.5, 0.75), (Some(1.0), texels, false));
    // Nothing reaches the cutoff; everything does.
    assert_eq!(opacity(json!("MASK"), 0.8, 0.75), (Some(0.0), None, true));
    assert_eq!(opacity(json!("MASK"), 0.0, 0.75), (None, None, false));
}

/// By the alpha mode; the default one leaves alpha out.
#[test]
fn alpha_is_the_opacity() {
    let mut document = square();
    let factor = |alpha: f64| json!({ "baseColorFactor": [1, 0, 0, alpha] });
    for (mode, alpha, opacity) in [
        (json!("OPAQUE"), 0.25, None),
        (json!("BLEND"), 0.25, Some(0.25)),
        (json!("BLEND"), 1.0, None),
        (json!("MASK"), 0.25, Some(0.0)),
        (json!("MASK"), 0.75, None),
    ] {
        document["materials"][1]["alphaMode"] = mode;
        document["materials"][1]["pbrMetallicRoughness"] = factor(alpha);
        let model = load(&document).unwrap().model;
        assert_eq!(opacity_of(model.materials[0].material.as_ref().unwrap()), opacity);
    }
    document["materials"][1]["alphaCutoff"] = json!(0.8);
    let model = load(&document).unwrap().model;
    assert_eq!(opacity_of(model.materials[0].material.as_ref().unwrap()), Some(0.0));
    document["materials"][1]["pbrMetallicRoughness"] = factor(1.5);
    document["materials"][1]["alphaMode"] = json!("BLEND");
    let error = load(&document).unwrap_err().to_string();
    assert!(
        error.ends_with("alpha of baseColorFactor must lie between 0 and 1, is 1.5"),
        "{error}"
    );
    document["materials"][1]["alphaMode"] = json!("BLUR");
    let error = load(&document).unwrap_err().to_string();
    assert!(error.ends_with("materials[1]: alphaMode is `BLUR`, which is none"), "{error}");
}
