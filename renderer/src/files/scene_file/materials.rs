//! The materials of a scene while its file is read: those of the scene file, and those that meshes
//! bring along.

use glam::{DAffine2, DVec3};
use renderer_files::Warnings;
use renderer_files::names::Names;

use super::format::MaterialEntry;
use super::format::ordered::Ordered;
use super::textures::TextureTable;
use super::{Problem, numbers};
use crate::Warning;
use crate::experiment::NamedFile;
use crate::files::{FullMaterial, ModelMaterial};
use crate::scene::{Bsdf, Material, MaterialObject, MaterialTextures, Scene, Slot};

/// The materials, first those of the scene file, in its order.
pub(super) struct MaterialTable<'a> {
    objects: Vec<MaterialObject>,
    names: Names,
    textures: TextureTable,
    entries: &'a [(String, MaterialEntry)],
    /// For each entry of the scene file, whether a mesh's library has filled in what it left out.
    filled: Vec<bool>,
    /// Whether light takes all paths, and shows the facets of materials.
    takes_all_paths: bool,
    /// About materials of meshes that neither their files nor the scene file define, and what is left out of
    /// others.
    warnings: Warnings,
}

impl<'a> MaterialTable<'a> {
    /// The materials that the scene file names. What an entry leaves out is as in the default
    /// material, until a library says otherwise.
    pub fn new(
        entries: &'a Ordered<MaterialEntry>,
        textures: TextureTable,
        takes_all_paths: bool,
    ) -> Result<Self, Problem> {
        let object = |entry: &(String, MaterialEntry)| {
            let default = match entry.1.kind.as_deref() {
                // Clear glass.
                Some("dielectric") => Material::lambertian(DVec3::ONE),
                _ => Material::default(),
            };
            let mut object = overridden(default.into(), entry)?;
            object.textures = overridden_textures(object.textures, entry, &textures)?;
            Ok(object)
        };
        Ok(Self {
            objects: entries.iter().map(object).collect::<Result<_, Problem>>()?,
            names: entries.iter().map(|(name, _)| name.as_str()).collect(),
            textures,
            filled: vec![false; entries.len()],
            entries,
            takes_all_paths,
            warnings: Warnings::default(),
        })
    }

    /// A table for meshes that no scene file describes.
    pub fn of_models() -> Self {
        Self {
            objects: Vec::new(),
            names: Names::default(),
            textures: TextureTable::default(),
            entries: &[],
            filled: Vec::new(),
            takes_all_paths: false,
            warnings: Warnings::default(),
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
        let mut object = match (entry, &model.material) {
            (Some(entry), Err(_)) => return Ok((entry as u32, DAffine2::IDENTITY)),
            (_, Ok(object)) => object.clone(),
            (None, Err(undefined)) => {
                self.warnings.add_new(undefined);
                Material::default().into()
            }
        };
        // Another type begins with the numbers that the file has for what it shows without facets.
        let is_of_type = |full: &&FullMaterial| {
            let kind = entry.and_then(|entry| self.entries[entry].1.kind.as_deref());
            kind.is_none_or(|kind| Bsdf::ALL.contains(&(kind, full.material.bsdf)))
        };
        if self.takes_all_paths {
            if let Some(full) = model.full.as_ref().filter(is_of_type) {
                object = full.material.clone();
            }
        } else if let Some(left_out) = model.full.as_ref().and_then(|full| full.left_out.as_ref()) {
            self.warnings.add_new(left_out);
        }
        object.name.clone_from(&model.name);
        let own = self.textures.add(&model.maps, object.bsdf)?;
        object.textures = own;
        let mut placement = model.maps.placement;
        if let Some(index) = entry {
            let entry = &self.entries[index];
            // What is said of textures that the scene file replaces is not said of the new ones.
            if !keeps_texture(own, &entry.1) {
                placement = DAffine2::IDENTITY;
            }
            object = overridden(object, entry)?;
            object.textures = overridden_textures(object.textures, entry, &self.textures)?;
            if !self.filled[index] {
                self.filled[index] = true;
                self.objects[index] = object.clone();
            }
        }
        // Files may give one name to one material, or to different ones.
        let is_same = |other: &MaterialObject| {
            MaterialObject { name: String::new(), ..other.clone() }
                == MaterialObject { name: String::new(), ..object.clone() }
                && (other.name == model.name || is_numbered(&other.name, &model.name))
        };
        if let Some(index) = self.objects.iter().position(is_same) {
            return Ok((index as u32, placement));
        }
        object.name = self.names.take(model.name.clone());
        self.objects.push(object);
        Ok(((self.objects.len() - 1) as u32, placement))
    }

    /// The files of textures that models name, and where.
    pub fn files(&self) -> Vec<NamedFile> {
        self.textures.files.clone()
    }

    /// Hands all materials and textures to the scene; the warnings about materials that nothing
    /// defines and about the images of textures.
    pub fn move_into(self, scene: &mut Scene) -> Vec<Warning> {
        scene.materials = self.objects;
        for material in &mut scene.materials {
            // A texture varies the opacity from 1 on where nothing else is said.
            material.transparent |= material.textures.get(Slot::Opacity).is_some();
        }
        let mut warnings = self.warnings.finish();
        warnings.append(&mut self.textures.move_into(scene));
        warnings
    }
}

/// `base` with the type and the numbers that an entry gives. An opacity makes it transparent.
fn overridden(
    base: MaterialObject,
    (name, entry): &(String, MaterialEntry),
) -> Result<MaterialObject, Problem> {
    let mut object = MaterialObject { name: name.clone(), ..base };
    let path = format!("material.{name}");
    if let Some(kind) = &entry.kind {
        object = of_type(object, kind)
            .map_err(|problem| Problem::new(format!("{path}.type"), problem))?;
    }
    for (key, _) in &entry.numbers {
        let known: Vec<&str> =
            Bsdf::ALL.iter().filter(|(_, bsdf)| bsdf.has(key)).map(|(kind, _)| *kind).collect();
        if !known.is_empty() && !object.bsdf.has(key) {
            let problem = format!("is of materials of the type {}", known.join(" or "));
            return Err(Problem::new(format!("{path}.{key}"), problem));
        }
    }
    numbers::assign(&mut object.values, "material", &path, &entry.numbers)?;
    object.transparent |= entry.numbers.iter().any(|(key, _)| key == "opacity");
    object.normal_scale = entry.normal_scale.unwrap_or(object.normal_scale);
    Ok(object)
}

/// A material as one of another type, with the numbers and textures that both have.
fn of_type(mut object: MaterialObject, kind: &str) -> Result<MaterialObject, String> {
    let Some((_, bsdf)) = Bsdf::ALL.into_iter().find(|(name, _)| *name == kind) else {
        let kinds = Bsdf::ALL.map(|(name, _)| name).join(", ");
        return Err(format!("`{kind}` is no type of material; there are {kinds}"));
    };
    let default = Material::default();
    object.bsdf = bsdf;
    if !bsdf.has("mirror") {
        object.values.mirror = default.mirror;
    }
    if !bsdf.has("opacity") {
        (object.transparent, object.values.opacity) = (false, default.opacity);
    }
    for slot in Slot::ALL.into_iter().filter(|slot| !bsdf.has(slot.field())) {
        object.textures.0[slot as usize] = None;
    }
    Ok(object)
}

/// `base` with the textures that an entry gives.
fn overridden_textures(
    base: MaterialTextures,
    (name, entry): &(String, MaterialEntry),
    textures: &TextureTable,
) -> Result<MaterialTextures, Problem> {
    let mut overridden = base;
    for slot in Slot::ALL {
        let Some(texture) = entry.texture(slot) else { continue };
        let index = textures.index(texture).map_err(|problem| {
            Problem::new(format!("material.{name}.{}_texture", slot.field()), problem)
        })?;
        overridden.0[slot as usize] = Some(index);
    }
    Ok(overridden)
}

/// Whether one of the textures `own` is not replaced by `entry`.
fn keeps_texture(own: MaterialTextures, entry: &MaterialEntry) -> bool {
    Slot::ALL.iter().any(|&slot| own.get(slot).is_some() && entry.texture(slot).is_none())
}

/// Whether `name` is `base_2` or the like.
fn is_numbered(name: &str, base: &str) -> bool {
    let number = name.strip_prefix(base).and_then(|rest| rest.strip_prefix('_'));
    number.is_some_and(|number| number.parse::<u32>().is_ok())
}
