//! Writes the meshes of a scene as one OBJ file, with a material library and textures.

use std::path::Path;

use glam::DVec3;
use renderer_core::Error;
use renderer_core::scene::{
    Bsdf, MaterialObject, Mesh, Normals, Scene, Slot, Texture, Transform, Wrap,
};
use renderer_core::transport::smooth::place_normal;

use super::write::{Counts, push, push_object};
use crate::disk::write_together;
use crate::export::{Picture, with_directions};
use crate::names::{file_stem, file_stems};
use crate::warning::Warnings;

/// Writes `path`, and beside it the library and the textures, whose names begin with that of the file.
pub(crate) fn save_objects(
    scene: &Scene,
    path: &Path,
    warnings: &mut Warnings,
) -> Result<(), Error> {
    let stem = file_stem(path);
    let library = path.with_file_name(format!("{stem}.mtl"));
    let files = file_stems(scene.textures.iter().map(|texture| &texture.name[..]));
    let mut writer = LibraryWriter { scene, stem: &stem, files, pictures: Vec::new(), warnings };
    let mut text = String::new();
    for (index, material) in scene.materials.iter().enumerate() {
        if scene.meshes.iter().any(|mesh| mesh.materials.contains(&(index as u32))) {
            writer.push_material(&mut text, material);
        }
    }
    let pictures = std::mem::take(&mut writer.pictures);
    let mut written = Vec::new();
    for (picture, file) in pictures {
        written.push((path.with_file_name(file), picture.png(scene, warnings)?));
    }
    written.push((library, text.into_bytes()));
    let (mut text, mut counts) = (format!("mtllib {stem}.mtl\n"), Counts::default());
    for mesh in &scene.meshes {
        push_object(&mut text, &placed(mesh), &scene.materials, &mut counts).ok_or_else(|| {
            Error::new(path.display(), format!("mesh {} is inconsistent", mesh.name))
        })?;
    }
    // What names the other files comes last.
    written.push((path.to_owned(), text.into_bytes()));
    // The scene may be made of files that are there.
    write_together(&written)
}

/// A mesh where its transform puts it, with its normals as directions.
fn placed(mesh: &Mesh) -> Mesh {
    let mut placed = with_directions(mesh);
    placed.vertices = mesh.world_vertices().map(|vertex| vertex.to_array()).collect();
    if let Normals::Given { directions, .. } = &mut placed.normals
        && mesh.transform != Transform::IDENTITY
    {
        for direction in directions {
            *direction = place_normal::<f64>(mesh.transform, (*direction).into()).to_array();
        }
    }
    if mesh.is_mirrored() {
        // So the outside stays the outside.
        let turn_round = |[_, b, c]: &mut [u32; 3]| std::mem::swap(b, c);
        placed.triangles.iter_mut().for_each(turn_round);
        placed.texture_triangles.iter_mut().flatten().for_each(turn_round);
        if let Normals::Given { directions, triangles } = &mut placed.normals {
            triangles.iter_mut().flatten().for_each(turn_round);
            directions.as_flattened_mut().iter_mut().for_each(|coordinate| *coordinate *= -1.0);
        }
    }
    placed
}

/// A material library in the making.
struct LibraryWriter<'a> {
    scene: &'a Scene,
    /// What the names of all files begin with.
    stem: &'a str,
    /// What the names of the files of textures go on with, by their indices.
    files: Vec<String>,
    /// The images that are named so far, and their files.
    pictures: Vec<(Picture, String)>,
    warnings: &'a mut Warnings,
}

impl LibraryWriter<'_> {
    fn push_material(&mut self, text: &mut String, material: &MaterialObject) {
        let values = &material.values;
        let place = format!("material.{}", material.name);
        push(text, format_args!("newmtl {}\n", material.name));
        let mut line = |keyword: &str, [x, y, z]: [f64; 3]| {
            push(text, format_args!("{keyword} {x:?} {y:?} {z:?}\n"));
        };
        line("Kd", values.diffuse.to_array());
        line("Ke", values.emission.to_array());
        match material.bsdf {
            Bsdf::BlinnPhong => {
                let is_mirror = values.mirror != DVec3::ZERO;
                if is_mirror && values.mirror != values.specular {
                    let problem =
                        "its highlight gets the colour of its mirror: MTL has one for both";
                    self.warnings.add("mirror", &place, problem);
                }
                if values.roughness > 0.0 {
                    let problem = "the roughness of matt surfaces is left out: MTL has none";
                    self.warnings.add("matt roughness", &place, problem);
                }
                line("Ks", if is_mirror { values.mirror } else { values.specular }.to_array());
                let illumination = if is_mirror { 3 } else { 2 };
                push(text, format_args!("Ns {:?}\nillum {illumination}\n", values.exponent));
            }
            Bsdf::MetallicRoughness => {
                let (metallic, roughness, ior) = (values.metallic, values.roughness, values.ior);
                push(text, format_args!("Pm {metallic:?}\nPr {roughness:?}\nNi {ior:?}\n"));
                if material.textures.get(Slot::MetallicRoughness).is_some() {
                    let problem =
                        "textures of the metallic part and the roughness are left out of MTL";
                    self.warnings.add("metallic roughness", &place, problem);
                }
            }
            Bsdf::Dielectric => {
                line("Tf", values.diffuse.to_array());
                push(text, format_args!("Ni {:?}\nillum 7\n", values.ior));
            }
        }
        if material.transparent {
            push(text, format_args!("d {:?}\n", values.opacity));
        }
        if material.textures.get(Slot::Normal).is_some() && material.normal_scale != 1.0 {
            let problem = "normal_scale is left out: MTL has none";
            self.warnings.add("normal scale", &place, problem);
        }
        let slots = [
            ("map_Kd", Slot::Diffuse),
            ("map_Ke", Slot::Emission),
            ("map_Ks", Slot::Specular),
            ("map_d", Slot::Opacity),
            ("norm", Slot::Normal),
        ];
        for (keyword, slot) in slots {
            let Some(index) = material.textures.get(slot) else { continue };
            let picture = match slot {
                Slot::Opacity | Slot::Normal => Picture::Data(index),
                _ => Picture::Color(index),
            };
            let clamp = self.clamp(picture.texture(self.scene));
            let file = self.file(picture, slot, index);
            push(text, format_args!("{keyword} {clamp}{file}\n"));
        }
    }

    /// The option that says how a texture goes on.
    fn clamp(&mut self, texture: &Texture) -> &'static str {
        match texture.wrap {
            Wrap::Repeat => "",
            Wrap::Clamp => "-clamp on ",
            Wrap::Mirror => {
                let problem = "is repeated instead of mirrored: MTL has no mirrored textures";
                self.warnings.add("mirrored", format_args!("texture.{}", texture.name), problem);
                ""
            }
        }
    }

    /// The file of a picture.
    fn file(&mut self, picture: Picture, slot: Slot, texture: u32) -> String {
        if let Some((_, file)) = self.pictures.iter().find(|(other, _)| *other == picture) {
            return file.clone();
        }
        let kind = match slot {
            Slot::Opacity => "_opacity",
            Slot::Normal => "_normal",
            _ => "",
        };
        let file = format!("{}_{}{kind}.png", self.stem, self.files[texture as usize]);
        self.pictures.push((picture, file.clone()));
        file
    }
}
