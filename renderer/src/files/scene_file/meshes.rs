//! Puts the meshes of files into a scene.

use std::path::Path;

use super::Problem;
use super::format::MeshEntry;
use super::materials::MaterialTable;
use crate::Error;
use crate::files::meshes::load_mesh;
use crate::files::obj::{Mesh, Model, unique};
#[cfg(feature = "gltf")]
use crate::files::{GltfFile, MeshFormat, load_gltf};
use crate::scene::{MeshObject, Scene};

/// The scene that a mesh file alone gives, framed and lit by default.
pub(crate) fn load_mesh_scene(path: &Path) -> Result<Scene, Error> {
    #[cfg(feature = "gltf")]
    if MeshFormat::of(path) == Some(MeshFormat::Gltf) {
        return load_gltf_scene(path);
    }
    framed(load_mesh(path)?, path)
}

/// The scene of a glTF file: what it brings of camera and lights replaces the default ones.
#[cfg(feature = "gltf")]
fn load_gltf_scene(path: &Path) -> Result<Scene, Error> {
    let GltfFile { model, camera, lights } = load_gltf(path)?;
    let mut scene = framed(model, path)?;
    if let Some((camera, aspect_ratio)) = camera {
        scene.set_camera(camera, aspect_ratio);
    }
    if !lights.is_empty() {
        (scene.light_names, scene.parameters.lights) = lights.into_iter().unzip();
    }
    scene.validate(path.display())?;
    Ok(scene)
}

/// The scene of a model from the file `path`, framed and lit by default.
fn framed(model: Model, path: &Path) -> Result<Scene, Error> {
    let Model { meshes, materials } = model;
    let mut scene = Scene::empty();
    let mut table = MaterialTable::of_models();
    let indices: Result<Vec<u32>, Problem> = materials.iter().map(|m| table.add(m)).collect();
    let indices = indices.map_err(|problem| problem.at(path))?;
    add_meshes(&mut scene, meshes, &indices);
    table.move_into(&mut scene);
    drop_unused_coordinates(&mut scene);
    // First the mesh by itself: what is wrong with it would show in the camera too.
    scene.validate(path.display())?;
    scene.frame();
    scene.validate(path.display())?;
    Ok(scene)
}

/// Adds what one `[[mesh]]` names.
pub(super) fn add_entry(
    scene: &mut Scene,
    table: &mut MaterialTable<'_>,
    entry: &MeshEntry,
    folder: &Path,
) -> Result<(), Problem> {
    let Model { mut meshes, materials } = load_mesh(&folder.join(&entry.path))?;
    let indices = match &entry.material {
        Some(name) => {
            let index = table.index(name).map_err(|problem| {
                let mesh = entry.name.clone().unwrap_or(entry.path.display().to_string());
                Problem::new(format!("mesh.{mesh}.material"), problem)
            })?;
            vec![index; materials.len()]
        }
        None => materials.iter().map(|m| table.add(m)).collect::<Result<Vec<u32>, Problem>>()?,
    };
    if let Some(name) = &entry.name {
        meshes = vec![join(meshes, name.clone())];
        if scene.meshes.iter().any(|other| other.name == *name) {
            return Err(Problem::new(format!("mesh.{name}.name"), "another mesh has this name"));
        }
    }
    add_meshes(scene, meshes, &indices);
    Ok(())
}

/// Adds meshes whose materials are `materials` of the scene.
fn add_meshes(scene: &mut Scene, meshes: Vec<Mesh>, materials: &[u32]) {
    for mesh in meshes {
        let taken = |name: &str| scene.meshes.iter().any(|other| other.name == name);
        let object = MeshObject {
            name: unique(mesh.name, taken),
            triangles: mesh.triangles,
            materials: mesh.materials.iter().map(|&index| materials[index as usize]).collect(),
            texture_triangles: mesh.texture_triangles,
        };
        scene.meshes.push(object);
        scene.parameters.vertices.push(mesh.vertices);
        scene.parameters.texture_coordinates.push(mesh.texture_coordinates);
    }
}

/// Forgets the texture coordinates of meshes that wear no texture: they would be parameters that
/// nothing depends on.
pub(super) fn drop_unused_coordinates(scene: &mut Scene) {
    let coordinates = &mut scene.parameters.texture_coordinates;
    for (mesh, coordinates) in scene.meshes.iter_mut().zip(coordinates) {
        let is_textured = |&material: &u32| {
            scene.materials.get(material as usize).is_some_and(|worn| worn.textures.any())
        };
        if !mesh.materials.iter().any(is_textured) {
            mesh.texture_triangles = Vec::new();
            *coordinates = Vec::new();
        }
    }
}

/// All meshes as one.
fn join(meshes: Vec<Mesh>, name: String) -> Mesh {
    let mut joined = Mesh {
        name,
        vertices: Vec::new(),
        triangles: Vec::new(),
        materials: Vec::new(),
        texture_coordinates: Vec::new(),
        texture_triangles: Vec::new(),
    };
    let textured = meshes.iter().any(|mesh| !mesh.texture_triangles.is_empty());
    for mesh in meshes {
        let first = joined.vertices.len() as u32;
        let first_coordinates = joined.texture_coordinates.len() as u32;
        if textured {
            let moved = |corners: &Option<[u32; 3]>| {
                corners.map(|corners| corners.map(|i| i + first_coordinates))
            };
            joined.texture_triangles.extend(mesh.texture_triangles.iter().map(moved));
            joined.texture_triangles.resize(joined.triangles.len() + mesh.triangles.len(), None);
        }
        joined.texture_coordinates.extend(mesh.texture_coordinates);
        joined.triangles.extend(mesh.triangles.iter().map(|corners| corners.map(|i| i + first)));
        joined.vertices.extend(mesh.vertices);
        joined.materials.extend(mesh.materials);
    }
    joined
}
