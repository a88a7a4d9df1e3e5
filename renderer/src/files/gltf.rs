//! Meshes and scenes: glTF 2.0, `.gltf` (JSON) and `.glb` (binary).
//!
//! serde_json reads the document; what is a few structs and slices of bytes beyond that is our own.
//! The crate `gltf` (1.4.1, of 2024) was turned down: its validation tells lists of internal paths
//! where a line for people is needed, and it does not check that accessors stay within their
//! buffers.

mod accessor;
mod buffers;
mod document;
mod nodes;
mod primitive;

#[cfg(test)]
mod tests;

use std::f64::consts::PI;
use std::path::Path;

use glam::{DMat4, DVec3};

use super::io::read;
use super::meshes::{clean_name, file_stem, plain_material};
use super::obj::{
    DEFAULT_MATERIAL, Mesh, Model, ModelMaps, ModelMaterial, default_material, unique,
};
use crate::Error;
use crate::kernels::camera::Camera;
use crate::kernels::light::{DistantLight, PointLight};
use crate::kernels::material::Material;
use crate::scene::Light;
use buffers::Buffers;
use document::{Document, LightDefinition};
use nodes::PlacedNode;

/// What a glTF file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct GltfFile {
    /// Its meshes, one for each node that shows one, in world coordinates.
    pub model: Model,
    /// The first camera of the scene, and the width of its image over the height, if it says.
    pub camera: Option<(Camera<f64>, Option<f64>)>,
    /// The names and values of its lights.
    pub lights: Vec<(String, Light<f64>)>,
}

/// Reads a glTF 2.0 file, with its buffers: embedded, or in files relative to it. Of several scenes
/// it is the default one, or the first.
///
/// - Every node with a mesh is a mesh, named after the node (or the mesh), its vertices transformed
///   by the node and those above it. Skins, morph targets and animations are not read.
/// - The base colour of a material is the diffuse colour. Its textures, metalness, roughness and the
///   rest are not read. Primitives without a material wear [`DEFAULT_MATERIAL`](super::obj::DEFAULT_MATERIAL).
/// - The first camera counts; it has to be a perspective one.
/// - Lights are those of `KHR_lights_punctual`, without a range; spot lights are refused. Candela
///   and lux are taken as watts per steradian and per square metre, and divided by pi: a diffuse
///   surface of ours reflects its colour times the irradiance, one of glTF that over pi.
///
/// # Errors
///
/// If a file cannot be read, is cut short, an index or an offset is out of range, a number is not
/// finite, an extension is required that is not read here, or there is no triangle. The message
/// names the file and the part of the document.
pub fn load_gltf(path: &Path) -> Result<GltfFile, Error> {
    let place = path.display().to_string();
    let refuse = |problem: String| Error::new(&place, problem);
    let bytes = read(path)?;
    let (json, binary) = buffers::split(&bytes).map_err(refuse)?;
    let document = Document::parse(json).map_err(refuse)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let buffers = Buffers::load(&document, binary, folder, &place)?;
    let nodes = nodes::placed(&document).map_err(refuse)?;
    Ok(GltfFile {
        model: model(&document, &buffers, &nodes, path)?,
        camera: camera(&document, &nodes).map_err(refuse)?,
        lights: lights(&document, &nodes).map_err(refuse)?,
    })
}

fn model(
    document: &Document,
    buffers: &Buffers,
    nodes: &[PlacedNode<'_>],
    path: &Path,
) -> Result<Model, Error> {
    let place = path.display().to_string();
    let mut materials = materials(document, &place);
    let mut meshes: Vec<Mesh> = Vec::new();
    for PlacedNode { node, to_world, .. } in nodes {
        let Some(index) = node.mesh else { continue };
        let mesh = document::get(&document.meshes, index, "meshes")
            .map_err(|problem| Error::new(&place, problem))?;
        let names = [node.name.as_deref(), mesh.name.as_deref()];
        let name = names.into_iter().flatten().map(clean_name).find(|name| !name.is_empty());
        let name = name.unwrap_or_else(|| file_stem(path));
        let name = unique(name, |name| meshes.iter().any(|mesh| mesh.name == name));
        let parts = mesh.primitives.iter().enumerate();
        let parts = parts.map(|(i, primitive)| {
            primitive::load(document, buffers, primitive)
                .map_err(|problem| format!("meshes[{index}].primitives[{i}]: {problem}"))
        });
        let parts: Vec<_> =
            parts.collect::<Result<_, _>>().map_err(|problem| Error::new(&place, problem))?;
        meshes.extend(primitive::join(parts, name, *to_world, &mut materials));
    }
    if meshes.is_empty() {
        return Err(Error::new(place, "holds no triangles"));
    }
    Ok(Model { meshes, materials: materials.used })
}

/// The materials of a document, and of these the ones that something wears.
struct Materials {
    /// The last is that of primitives without one.
    all: Vec<ModelMaterial>,
    /// For each of `all`, where it is in `used`.
    places: Vec<Option<u32>>,
    used: Vec<ModelMaterial>,
}

impl Materials {
    /// The index among the materials that are used of one of the document.
    fn place(&mut self, index: Option<usize>) -> u32 {
        let index = index.unwrap_or(self.all.len() - 1);
        *self.places[index].get_or_insert_with(|| {
            self.used.push(self.all[index].clone());
            self.used.len() as u32 - 1
        })
    }
}

fn materials(document: &Document, place: &str) -> Materials {
    let mut all: Vec<ModelMaterial> = Vec::new();
    for (i, definition) in document.materials.iter().enumerate() {
        let name = definition.name.as_deref().map(clean_name).filter(|name| !name.is_empty());
        let name = name.unwrap_or_else(|| format!("material_{i}"));
        let name = unique(name, |name| all.iter().any(|other| other.name == name));
        let [r, g, b, _] = definition.pbr_metallic_roughness.base_color_factor;
        let material = Material { diffuse: DVec3::new(r, g, b), ..default_material() };
        let place = format!("{place}: materials[{i}]");
        all.push(ModelMaterial {
            name,
            material: Some(material),
            maps: ModelMaps::default(),
            place,
        });
    }
    let name =
        unique(DEFAULT_MATERIAL.to_owned(), |name| all.iter().any(|other| other.name == name));
    all.push(ModelMaterial { name, ..plain_material(place.to_owned()) });
    Materials { places: vec![None; all.len()], all, used: Vec::new() }
}

type FoundCamera = Option<(Camera<f64>, Option<f64>)>;

fn camera(document: &Document, nodes: &[PlacedNode<'_>]) -> Result<FoundCamera, String> {
    let Some((index, node)) = nodes.iter().find_map(|node| Some((node.node.camera?, node))) else {
        return Ok(None);
    };
    let definition = document::get(&document.cameras, index, "cameras")?;
    let Some(perspective) = &definition.perspective else {
        return Err(format!(
            "cameras[{index}]: is not a perspective camera; name the file as a [[mesh]] of a scene \
             file to give it another one"
        ));
    };
    let look_from = node.to_world.transform_point3(DVec3::ZERO);
    let axis = |axis: DVec3| node.to_world.transform_vector3(axis).normalize_or_zero();
    let (forward, up) = (axis(DVec3::NEG_Z), axis(DVec3::Y));
    let camera = Camera {
        look_from,
        look_at: look_from + forward,
        up,
        vfov: perspective.yfov.to_degrees(),
        focus: 1.0,
    };
    if perspective.aspect_ratio.is_some_and(|ratio| ratio <= 0.0) {
        return Err(format!("cameras[{index}]: its aspectRatio must be above 0"));
    }
    Ok(Some((camera, perspective.aspect_ratio)))
}

fn lights(
    document: &Document,
    nodes: &[PlacedNode<'_>],
) -> Result<Vec<(String, Light<f64>)>, String> {
    let definitions = &document.extensions.lights.lights;
    let mut lights: Vec<(String, Light<f64>)> = Vec::new();
    for PlacedNode { node, to_world, .. } in nodes {
        let Some(reference) = &node.extensions.light else { continue };
        let index = reference.light;
        let definition = document::get(definitions, index, "lights")?;
        let light = light(definition, *to_world)
            .map_err(|problem| format!("KHR_lights_punctual.lights[{index}]: {problem}"))?;
        let names = [node.name.as_deref(), definition.name.as_deref()];
        let name = names.into_iter().flatten().map(clean_name).find(|name| !name.is_empty());
        let name = name.unwrap_or_else(|| "light".to_owned());
        let taken = |name: &str| lights.iter().any(|(other, _)| other == name);
        lights.push((unique(name, taken), light));
    }
    Ok(lights)
}

fn light(definition: &LightDefinition, to_world: DMat4) -> Result<Light<f64>, String> {
    let color = DVec3::from_array(definition.color);
    match definition.kind.as_str() {
        "point" => Ok(Light::Point(PointLight {
            position: to_world.transform_point3(DVec3::ZERO),
            color,
            // Per steradian, of 4 pi; over pi.
            intensity: 4.0 * definition.intensity,
        })),
        "directional" => Ok(Light::Distant(DistantLight {
            // It shines along its own -z; ours is the direction towards the light.
            direction: to_world.transform_vector3(DVec3::Z).normalize_or_zero(),
            color,
            intensity: definition.intensity / PI,
        })),
        kind => Err(format!("is a {kind} light; only point and directional ones are read")),
    }
}
