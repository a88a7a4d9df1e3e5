//! Scenes, written for other programs.

mod normals;
mod picture;
#[cfg(all(test, feature = "gltf"))]
mod tests;

use std::path::Path;

pub(super) use normals::with_directions;
pub(super) use picture::Picture;

use renderer_core::Error;
use renderer_core::scene::Scene;

use crate::Warning;
use crate::warning::Warnings;

/// Writes a scene into one file, in the format that the extension of `path` names: `.glb`
/// (binary glTF 2.0, textures within it) or `.obj` (with a material library and PNG textures beside it). What
/// is approximated or left out is warned of.
///
/// - A `.glb` has a node with the transform of each mesh; of positions, normals and texture coordinates it
///   keeps single precision. Vertices are split where materials, texture coordinates or normals differ.
/// - An `.obj` has no transforms: its vertices stand where the transforms put them.
/// - Textures have 8 bits. Normals that are [smooth](renderer_core::scene::Normals::Smooth) are written as directions.
/// - A `.glb` has the cameras of the scene's views, or its own, and the lights that are points, spots or distant; an
///   `.obj` has neither.
///
/// # Errors
///
/// If the extension is another one, the scene is not valid or has no triangle, an `.obj` or a file beside it is there
/// already, or a file cannot be written.
pub fn save_meshes(scene: &Scene, path: &Path) -> Result<Vec<Warning>, Error> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
    let save: fn(&Scene, &Path, &mut Warnings) -> Result<(), Error> = match extension.as_str() {
        #[cfg(feature = "gltf")]
        "glb" => super::gltf::save_glb,
        #[cfg(not(feature = "gltf"))]
        "glb" => return Err(super::load::left_out(path, super::MeshFormat::Gltf)),
        "obj" => super::obj::save_objects,
        _ => {
            let problem = "meshes are written as .glb (binary glTF) or .obj (with .mtl and .png)";
            return Err(Error::new(path.display(), problem));
        }
    };
    scene.validate(path.display())?;
    if scene.meshes.iter().all(|mesh| mesh.triangles.is_empty()) {
        return Err(Error::new(path.display(), "the scene has no triangle to write"));
    }
    let mut warnings = Warnings::default();
    for (kind, count) in [("spheres", scene.spheres.len()), ("shapes", scene.shapes.len())] {
        if count > 0 {
            let problem =
                format!("{kind} are left out ({count} in the scene): only meshes are written");
            warnings.add(kind, path.display(), problem);
        }
    }
    save(scene, path, &mut warnings)?;
    Ok(warnings.finish())
}
