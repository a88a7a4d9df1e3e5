//! The materials of a scene while its file is read: those of the scene file, and those that meshes
//! bring along.

use glam::DVec3;

use super::format::{MaterialEntry, Ordered};
use crate::Error;
use crate::files::obj::{ModelMaterial, default_material, unique};
use crate::kernels::material::Material;
use crate::scene::Scene;

/// Names and values, first those of the scene file, in its order.
pub(super) struct MaterialTable<'a> {
    names: Vec<String>,
    materials: Vec<Material<f64>>,
    entries: &'a [(String, MaterialEntry)],
    /// For each entry of the scene file, whether a mesh's library has filled in what it left out.
    filled: Vec<bool>,
}

impl<'a> MaterialTable<'a> {
    /// The materials that the scene file names. What an entry leaves out is as in the default
    /// material, until a library says otherwise.
    pub fn new(entries: &'a Ordered<MaterialEntry>) -> Self {
        let material = |(_, entry): &(_, _)| overridden(default_material(), entry);
        Self {
            names: entries.iter().map(|(name, _)| name.clone()).collect(),
            materials: entries.iter().map(material).collect(),
            filled: vec![false; entries.len()],
            entries,
        }
    }

    /// The index of the material `name`.
    ///
    /// # Errors
    ///
    /// If there is none; the text says which there are.
    pub fn index(&self, name: &str) -> Result<u32, String> {
        let position = self.names.iter().position(|other| other == name);
        position.map(|index| index as u32).ok_or_else(|| {
            let known = if self.names.is_empty() { "none".into() } else { self.names.join(", ") };
            format!("no material `{name}`; the scene has {known}; define it as [material.{name}]")
        })
    }

    /// The index of a model's material, which is added if the scene does not have it yet.
    pub fn add(&mut self, model: &ModelMaterial) -> Result<u32, Error> {
        let entry = self.entries.iter().position(|(name, _)| *name == model.name);
        let value = match (entry, model.material) {
            (Some(entry), None) => return Ok(entry as u32),
            (Some(entry), Some(material)) => overridden(material, &self.entries[entry].1),
            (None, Some(material)) => material,
            (None, None) => {
                let problem = format!(
                    "no material `{}`: neither a material library of the mesh nor a scene file \
                     defines it",
                    model.name
                );
                return Err(Error::new(&model.place, problem));
            }
        };
        if let Some(entry) = entry
            && !self.filled[entry]
        {
            self.filled[entry] = true;
            self.materials[entry] = value;
        }
        // Files may give one name to one material, or to different ones.
        let same = self.names.iter().zip(&self.materials).position(|(name, material)| {
            *material == value && (*name == model.name || is_numbered(name, &model.name))
        });
        if let Some(index) = same {
            return Ok(index as u32);
        }
        let taken = |name: &str| self.names.iter().any(|other| other == name);
        let name = unique(model.name.clone(), taken);
        self.names.push(name);
        self.materials.push(value);
        Ok((self.names.len() - 1) as u32)
    }

    /// Hands all materials to the scene.
    pub fn move_into(self, scene: &mut Scene) {
        scene.material_names = self.names;
        scene.parameters.materials = self.materials;
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

/// Whether `name` is `base_2` or the like.
fn is_numbered(name: &str, base: &str) -> bool {
    let number = name.strip_prefix(base).and_then(|rest| rest.strip_prefix('_'));
    number.is_some_and(|number| number.parse::<u32>().is_ok())
}
