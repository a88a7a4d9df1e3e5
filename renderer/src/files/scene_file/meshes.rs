//! Puts the meshes of files into a scene.

use std::collections::HashMap;
use std::path::Path;

use glam::{DAffine2, DVec2, DVec3};
use renderer_files::names::Names;

use super::coordinates::drop_bare_textures;
use super::format::{MeshEntry, NormalsEntry};
use super::invisible::invisible_meshes;
use super::materials::MaterialTable;
use super::numbers;
use super::{Problem, file_in, named_by};
use crate::Error;
use crate::Warning;
use crate::experiment::Experiment;
use crate::files::{FileNormals, FileObjects, Model};
#[cfg(feature = "gltf")]
use crate::files::{GltfFile, MeshFormat, load_gltf};
use crate::files::{load_mesh, load_mesh_with};
use crate::scene::{Camera, Mesh, Normals, Scene, Transform};
#[cfg(feature = "gltf")]
use crate::scene::{LightObject, LightSource};
use crate::transport::smooth::place_normal;

/// The scene that a mesh file alone gives, framed and lit by default.
pub(crate) fn load_mesh_scene(path: &Path) -> Result<Experiment, Error> {
    #[cfg(feature = "gltf")]
    if MeshFormat::of(path) == Some(MeshFormat::Gltf) {
        return load_gltf_scene(path);
    }
    framed(load_mesh(path)?, path)
}

/// The scene of a glTF file: what it brings of camera and lights replaces the default ones.
#[cfg(feature = "gltf")]
fn load_gltf_scene(path: &Path) -> Result<Experiment, Error> {
    let GltfFile { model, camera, lights } = load_gltf(path)?;
    let mut experiment = framed(model, path)?;
    let scene = &mut experiment.scene;
    if let Some((camera, aspect_ratio)) = camera {
        scene.set_camera(camera, aspect_ratio);
    }
    if !lights.is_empty() {
        let light = |(name, light)| LightObject { name, source: LightSource::Known(light) };
        scene.lights = lights.into_iter().map(light).collect();
    }
    scene.validate(path.display())?;
    Ok(experiment)
}

/// The scene of a model from the file `path`, framed and lit by default.
fn framed(model: Model, path: &Path) -> Result<Experiment, Error> {
    let mut scene = Scene::new(1, 1, Camera::looking(DVec3::Z, DVec3::ZERO));
    let mut table = MaterialTable::of_models();
    let mut warnings =
        add_model(&mut scene, &mut table, model).map_err(|problem| problem.at(path))?;
    let files = table.files();
    warnings.append(&mut table.move_into(&mut scene));
    warnings.append(&mut drop_bare_textures(&mut scene, &path.display().to_string()));
    warnings.extend(invisible_meshes(&scene, &path.display().to_string()));
    // First the mesh by itself: what is wrong with it would show in the camera too.
    scene.validate(path.display())?;
    scene.frame();
    scene.check().map_err(|_| {
        let extent = scene.bounding_box().map_or(0.0, |(low, high)| low.distance(high));
        let problem = format!(
            "is {extent:.1e} across, too little where it stands for a camera to look at it; give it \
             another `scale` or `translation` in a scene file"
        );
        Error::new(path.display(), problem)
    })?;
    Ok(Experiment { warnings, files, ..Experiment::new(scene, None) })
}

/// Adds what one `[[mesh]]` names; what was left out of its file.
pub(super) fn add_entry(
    scene: &mut Scene,
    table: &mut MaterialTable<'_>,
    entry: &MeshEntry,
    folder: &Path,
) -> Result<Vec<Warning>, Problem> {
    let Some(path) = &entry.path else {
        let name = entry.name.as_deref().unwrap_or_default();
        return Err(Problem::new(format!("mesh.{name}.path"), "is missing; a mesh needs one"));
    };
    let shaded_with = entry.normals.unwrap_or_default();
    let normals = match shaded_with {
        NormalsEntry::File => FileNormals::Read,
        NormalsEntry::Flat | NormalsEntry::Smooth => FileNormals::Ignore,
    };
    let place = format!("mesh.{}", entry.name.clone().unwrap_or(path.display().to_string()));
    let field = || format!("{place}.path");
    let file = file_in(folder, path, field)?;
    let objects = if entry.name.is_some() { FileObjects::Joined } else { FileObjects::Apart };
    let mut model = load_mesh_with(&file, normals, objects).map_err(named_by(field()))?;
    if let Some(name) = &entry.name {
        if scene.meshes.iter().any(|other| other.name == *name) {
            return Err(Problem::new(format!("mesh.{name}.name"), "another mesh has this name"));
        }
        model.meshes = vec![join(model.meshes, name.clone())];
    }
    for mesh in &mut model.meshes {
        place_mesh(mesh, entry, &place)?;
        if shaded_with == NormalsEntry::Smooth {
            mesh.normals = Normals::Smooth;
        }
    }
    let is_flat = |mesh: &Mesh| mesh.normals == Normals::Flat;
    if shaded_with == NormalsEntry::File && model.meshes.iter().all(is_flat) {
        let problem = format!("{} holds no normals; \"smooth\" computes them", path.display());
        return Err(Problem::new(format!("{place}.normals"), problem));
    }
    let Some(material) = &entry.material else { return add_model(scene, table, model) };
    let index = table
        .index(material)
        .map_err(|problem| Problem::new(format!("{place}.material"), problem))?;
    add_meshes(scene, model.meshes, &vec![index; model.materials.len()]);
    Ok(model.warnings)
}

/// Places a mesh as its entry says. A mesh that its file places already is placed within that.
fn place_mesh(mesh: &mut Mesh, entry: &MeshEntry, place: &str) -> Result<(), Problem> {
    if entry.numbers.is_empty() {
        return Ok(());
    }
    let mut transform = Transform::IDENTITY;
    numbers::assign(&mut transform, "mesh", place, &entry.numbers)?;
    bake(mesh);
    mesh.transform = transform;
    Ok(())
}

/// Moves the vertices and the normals of a mesh to their places in the world.
fn bake(mesh: &mut Mesh) {
    if mesh.transform != Transform::IDENTITY {
        mesh.vertices = mesh.world_vertices().map(|vertex| vertex.to_array()).collect();
        if let Normals::Given { directions, .. } = &mut mesh.normals {
            for normal in directions {
                *normal = place_normal::<f64>(mesh.transform, (*normal).into()).into();
            }
        }
        mesh.transform = Transform::IDENTITY;
    }
}

/// Adds the meshes of a model and their materials; what was left out of its file.
fn add_model(
    scene: &mut Scene,
    table: &mut MaterialTable<'_>,
    model: Model,
) -> Result<Vec<Warning>, Problem> {
    let Model { mut meshes, materials, warnings } = model;
    let added = materials.iter().map(|material| table.add(material));
    let added: Vec<(u32, DAffine2)> = added.collect::<Result<_, _>>()?;
    let (indices, placements): (Vec<u32>, Vec<DAffine2>) = added.into_iter().unzip();
    meshes.iter_mut().for_each(|mesh| place_textures(mesh, &placements));
    add_meshes(scene, meshes, &indices);
    Ok(warnings)
}

/// Moves the texture coordinates of a mesh to where each material looks its textures up.
fn place_textures(mesh: &mut Mesh, placements: &[DAffine2]) {
    if placements.iter().all(|placement| *placement == DAffine2::IDENTITY) {
        return;
    }
    // Triangles share coordinates, but for those whose placements differ.
    let first_equal = |placement| placements.iter().position(|other| other == placement);
    let kinds: Vec<_> = placements.iter().map(first_equal).collect();
    let (mut placed, mut places) = (Vec::new(), HashMap::new());
    for (corners, &material) in mesh.texture_triangles.iter_mut().zip(&mesh.materials) {
        for corner in corners.iter_mut().flatten() {
            let place = places.entry((*corner, kinds[material as usize])).or_insert_with(|| {
                let coordinates = DVec2::from_array(mesh.texture_coordinates[*corner as usize]);
                let moved = placements[material as usize].transform_point2(coordinates);
                placed.push(moved.to_array());
                placed.len() as u32 - 1
            });
            *corner = *place;
        }
    }
    mesh.texture_coordinates = placed;
}

/// Adds meshes whose materials are `materials` of the scene.
fn add_meshes(scene: &mut Scene, meshes: Vec<Mesh>, materials: &[u32]) {
    let mut names: Names = scene.meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    for mut mesh in meshes {
        mesh.name = names.take(mesh.name);
        mesh.materials.iter_mut().for_each(|index| *index = materials[*index as usize]);
        scene.meshes.push(mesh);
    }
}

/// All meshes as one.
fn join(meshes: Vec<Mesh>, name: String) -> Mesh {
    let mut joined = Mesh::new(name, Vec::new(), Vec::new());
    let mut places = Joined::default();
    let mut normals = Joined::default();
    for mut mesh in meshes {
        bake(&mut mesh);
        let first = joined.vertices.len() as u32;
        joined.triangles.extend(mesh.triangles.iter().map(|corners| corners.map(|i| i + first)));
        joined.vertices.extend(mesh.vertices);
        joined.materials.extend(mesh.materials);
        let count = joined.triangles.len();
        places.add(mesh.texture_coordinates, &mesh.texture_triangles, count);
        match mesh.normals {
            Normals::Given { directions, triangles } => normals.add(directions, &triangles, count),
            Normals::Flat | Normals::Smooth => normals.add(Vec::new(), &[], count),
        }
    }
    if !places.points.is_empty() {
        (joined.texture_coordinates, joined.texture_triangles) = (places.points, places.triangles);
    }
    if !normals.points.is_empty() {
        let Joined { points: directions, triangles } = normals;
        joined.normals = Normals::Given { directions, triangles };
    }
    joined
}

/// What the corners of triangles of several meshes have.
#[derive(Default)]
struct Joined<const N: usize> {
    points: Vec<[f64; N]>,
    triangles: Vec<Option<[u32; 3]>>,
}

impl<const N: usize> Joined<N> {
    /// Adds those of a mesh, after which there are `count` triangles.
    fn add(&mut self, points: Vec<[f64; N]>, triangles: &[Option<[u32; 3]>], count: usize) {
        let first = self.points.len() as u32;
        let moved = |corners: &Option<[u32; 3]>| corners.map(|c| c.map(|index| index + first));
        self.triangles.extend(triangles.iter().map(moved));
        self.triangles.resize(count, None);
        self.points.extend(points);
    }
}
