//! The materials of a scene while its file is read: those of the scene file, and those that meshes
//! bring along.

use glam::{DAffine2, DVec3};

use super::Problem;
use super::format::{MaterialEntry, Ordered};
use super::textures::TextureTable;
use crate::files::Warning;
use crate::files::model::{ModelMaterial, default_material};
use crate::files::names::Names;
use crate::files::warnings::Warnings;
use crate::kernels::material::Material;
use crate::scene::{MaterialObject, MaterialTextures, Scene};

/// Names and values, first those of the scene file, in its order.
pub(super) struct MaterialTable<'a> {
    objects: Vec<MaterialObject>,
    materials: Vec<Material<f64>>,
    /// Of those that are transparent.
    opacities: Vec<Option<f64>>,
    names: Names,
    textures: TextureTable,
    entries: &'a [(String, MaterialEntry)],
    /// For each entry of the scene file, whether a mesh's library has filled in what it left out.
    filled: Vec<bool>,
    /// About materials of meshes that neither their files nor the scene file define.
    undefined: Warnings,
}

impl<'a> MaterialTable<'a> {
    /// The materials that the scene file names. What an entry leaves out is as in the default
    /// material, until a library says otherwise.
    pub fn new(
        entries: &'a Ordered<MaterialEntry>,
        textures: TextureTable,
    ) -> Result<Self, Problem> {
        let material = |(_, entry): &(_, _)| overridden(default_material(), entry);
        let object = |(name, entry): &(String, MaterialEntry)| {
            let none = MaterialTextures::default();
            let textures = overridden_textures(none, name, entry, &textures)?;
            Ok(MaterialObject { textures, ..MaterialObject::new(name) })
        };
        Ok(Self {
            objects: entries.iter().map(object).collect::<Result<_, Problem>>()?,
            materials: entries.iter().map(material).collect(),
            opacities: entries.iter().map(|(_, entry)| entry.opacity).collect(),
            names: entries.iter().map(|(name, _)| name.as_str()).collect(),
            textures,
            filled: vec![false; entries.len()],
            entries,
            undefined: Warnings::default(),
        })
    }

    /// Without a scene file.
    pub fn of_models() -> Self {
        Self {
            objects: Vec::new(),
            materials: Vec::new(),
            opacities: Vec::new(),
            names: Names::default(),
            textures: TextureTable::default(),
            entries: &[],
            filled: Vec::new(),
            undefined: Warnings::default(),
        }
    }

    /// The index of the material `name`.
    ///
    /// # Errors
    ///
    /// If there is none; the text says which there are.
    pub fn index(&self, name: &str) -> Result<u32, String> {
        let position = self.objects.iter().position(|object| object.name == name);
        position.map(|index| index as u32).ok_or_else(|| {
            let names: Vec<&str> = self.objects.iter().map(|o| o.name.as_str()).collect();
            let known = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
            format!("no material `{name}`; the scene has {known}; define it as [material.{name}]")
        })
    }

    /// The index of a model's material, which is added if the scene does not have it yet; and from the
    /// texture coordinates of the model's meshes to those at which it looks textures up.
    pub fn add(&mut self, model: &ModelMaterial) -> Result<(u32, DAffine2), Problem> {
        let entry = self.entries.iter().position(|(name, _)| *name == model.name);
        let value = match (entry, &model.material) {
            (Some(entry), Err(_)) => return Ok((entry as u32, DAffine2::IDENTITY)),
            (Some(entry), Ok(material)) => overridden(*material, &self.entries[entry].1),
            (None, Ok(material)) => *material,
            (None, Err(undefined)) => {
                self.undefined.add_new(undefined);
                default_material()
            }
        };
        let opacity = entry.and_then(|entry| self.entries[entry].1.opacity).or(model.opacity);
        let own = self.textures.add(&model.maps)?;
        let (mut textures, mut placement) = (own, model.maps.placement);
        if let Some(entry) = entry {
            let (name, fields) = &self.entries[entry];
            // What is said of textures that the scene file replaces is not said of the new ones.
            if !keeps_texture(own, fields) {
                placement = DAffine2::IDENTITY;
            }
            textures = overridden_textures(textures, name, fields, &self.textures)?;
            if !self.filled[entry] {
                self.filled[entry] = true;
                self.materials[entry] = value;
                self.objects[entry].textures = textures;
                self.opacities[entry] = opacity;
            }
        }
        // Files may give one name to one material, or to different ones.
        let is_same = |&index: &usize| {
            let MaterialObject { name, textures: worn, .. } = &self.objects[index];
            (self.materials[index], self.opacities[index], *worn) == (value, opacity, textures)
                && (*name == model.name || is_numbered(name, &model.name))
        };
        let same = (0..self.objects.len()).find(is_same);
        if let Some(index) = same {
            return Ok((index as u32, placement));
        }
        let name = self.names.take(model.name.clone());
        self.objects.push(MaterialObject { textures, ..MaterialObject::new(name) });
        self.materials.push(value);
        self.opacities.push(opacity);
        Ok(((self.objects.len() - 1) as u32, placement))
    }

    /// Hands all materials and textures to the scene; the warnings about materials that nothing
    /// defines and about the images of textures.
    pub fn move_into(self, scene: &mut Scene) -> Vec<Warning> {
        scene.materials = self.objects;
        scene.parameters.materials = self.materials;
        for (object, given) in scene.materials.iter_mut().zip(self.opacities) {
            // A texture varies it from 1 on where nothing else is said.
            let opacity = given.or(object.textures.opacity.map(|_| 1.0));
            object.opacity = opacity.map(|opacity| {
                scene.parameters.opacities.push(opacity);
                scene.parameters.opacities.len() as u32 - 1
            });
        }
        let mut warnings = self.undefined.finish();
        warnings.append(&mut self.textures.move_into(scene));
        warnings
    }
}

/// `base` with the fields that `entry` gives.
fn overridden(base: Material<f64>, entry: &MaterialEntry) -> Material<f64> {
    Material {
        ambient: entry.ambient.map_or(base.ambient, DVec3::from_array),
        diffuse: entry.diffuse.map_or(base.diffuse, DVec3::from_array),
        specular: entry.specular.map_or(base.specular, DVec3::from_array),
        exponent: entry.exponent.unwrap_or(base.exponent),
        reflection: entry.reflection.map_or(base.reflection, DVec3::from_array),
    }
}

/// `base` with the textures that `entry`, the material `name`, gives.
fn overridden_textures(
    base: MaterialTextures,
    name: &str,
    entry: &MaterialEntry,
    textures: &TextureTable,
) -> Result<MaterialTextures, Problem> {
    let texture = |field: &str, given: &Option<String>, base: Option<u32>| match given {
        None => Ok(base),
        Some(texture) => textures
            .index(texture)
            .map(Some)
            .map_err(|problem| Problem::new(format!("material.{name}.{field}"), problem)),
    };
    Ok(MaterialTextures {
        ambient: texture("ambient_texture", &entry.ambient_texture, base.ambient)?,
        diffuse: texture("diffuse_texture", &entry.diffuse_texture, base.diffuse)?,
        specular: texture("specular_texture", &entry.specular_texture, base.specular)?,
        opacity: texture("opacity_texture", &entry.opacity_texture, base.opacity)?,
    })
}

/// Whether one of the textures `own` is not replaced by `entry`.
fn keeps_texture(own: MaterialTextures, entry: &MaterialEntry) -> bool {
    let pairs = [
        (own.ambient, &entry.ambient_texture),
        (own.diffuse, &entry.diffuse_texture),
        (own.specular, &entry.specular_texture),
        (own.opacity, &entry.opacity_texture),
    ];
    pairs.iter().any(|(own, replaced)| own.is_some() && replaced.is_none())
}

/// Whether `name` is `base_2` or the like.
fn is_numbered(name: &str, base: &str) -> bool {
    let number = name.strip_prefix(base).and_then(|rest| rest.strip_prefix('_'));
    number.is_some_and(|number| number.parse::<u32>().is_ok())
}
