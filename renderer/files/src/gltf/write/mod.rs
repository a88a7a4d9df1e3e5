//! Writes the meshes, the cameras and the lights of a scene as a binary glTF file.

mod binary;
mod cameras;
mod corners;
mod lights;
mod materials;

use std::path::Path;

use glam::{DQuat, DVec3};
use renderer_core::Error;
use renderer_core::scene::{Mesh, Normals, Scene, Transform};
use serde_json::{Map, Value, json};

use crate::disk::write_atomically;
use crate::export::with_directions;
use crate::warning::Warnings;
use binary::Binary;
use corners::{Corner, Part, parts};
use materials::MaterialWriter;

/// Writes a node for each mesh, with the materials that triangles have and their textures, and for each camera and
/// light.
pub(crate) fn save_glb(scene: &Scene, path: &Path, warnings: &mut Warnings) -> Result<(), Error> {
    let mut binary = Binary::default();
    let mut materials = MaterialWriter::new(scene, warnings);
    let (mut meshes, mut nodes) = (Vec::new(), Vec::new());
    // A mesh of the format has at least one triangle.
    let written = scene.meshes.iter().filter(|mesh| !mesh.triangles.is_empty());
    for (index, mesh) in written.enumerate() {
        let mesh = with_directions(mesh);
        let mut primitives = Vec::new();
        for part in parts(&mesh) {
            let material = materials.index(part.material, &mut binary)?;
            primitives.push(primitive(&mesh, &part, material, &mut binary));
        }
        meshes.push(json!({ "name": mesh.name, "primitives": primitives }));
        nodes.push(node(&mesh, index));
    }
    let mut document = Map::new();
    let mut extensions_used = materials.finish(&mut document);
    let (cameras, mut of_cameras) = cameras::cameras(scene);
    nodes.append(&mut of_cameras);
    let (lights, mut of_lights) = lights::lights(scene, warnings);
    nodes.append(&mut of_lights);
    let generator = concat!("renderer ", env!("CARGO_PKG_VERSION"));
    let mut insert = |name: &str, value: Value| document.insert(name.to_owned(), value);
    insert("asset", json!({ "version": "2.0", "generator": generator }));
    insert("scene", 0.into());
    insert("scenes", json!([{ "nodes": (0..nodes.len()).collect::<Vec<_>>() }]));
    insert("nodes", nodes.into());
    insert("meshes", meshes.into());
    insert("cameras", cameras.into());
    if !lights.is_empty() {
        insert("extensions", json!({ lights::EXTENSION: { "lights": lights } }));
        extensions_used.push(lights::EXTENSION);
    }
    if !extensions_used.is_empty() {
        insert("extensionsUsed", json!(extensions_used));
    }
    let refuse = |problem| Error::new(path.display(), problem);
    write_atomically(path, &binary.file(document).map_err(refuse)?)
}

/// The node that shows mesh `index`.
fn node(mesh: &Mesh, index: usize) -> Value {
    let mut node = json!({ "name": mesh.name, "mesh": index });
    let Transform { translation, rotation, scale } = mesh.transform;
    if mesh.transform != Transform::IDENTITY {
        let rotation = DQuat::from_scaled_axis(rotation * 1_f64.to_radians());
        node["translation"] = json!(translation.to_array());
        node["rotation"] = json!(rotation.to_array());
        node["scale"] = json!(scale.to_array());
    }
    node
}

fn primitive(mesh: &Mesh, part: &Part, material: usize, binary: &mut Binary) -> Value {
    let Part { corners, indices, .. } = part;
    let position = |corner: &Corner| mesh.vertices[corner.vertex as usize];
    // In glTF the upper edge of a texture is at v = 0.
    let place = |corner: &Corner| {
        let [u, v] = mesh.texture_coordinates[corner.texture? as usize];
        Some([u, 1.0 - v])
    };
    let normal = |corner: &Corner| {
        let Normals::Given { directions, .. } = &mesh.normals else { return None };
        let direction = DVec3::from(directions[corner.normal? as usize]);
        Some(direction.normalize().to_array())
    };
    let mut attributes = json!({ "POSITION": binary.vectors(corners.iter().map(position)) });
    if corners.iter().any(|corner| corner.normal.is_some()) {
        attributes["NORMAL"] = binary.vectors(corners.iter().filter_map(normal)).into();
    }
    if corners.iter().any(|corner| corner.texture.is_some()) {
        attributes["TEXCOORD_0"] = binary.vectors(corners.iter().filter_map(place)).into();
    }
    let indices = binary.indices(indices, corners.len());
    json!({ "attributes": attributes, "indices": indices, "material": material })
}
