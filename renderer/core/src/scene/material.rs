//! Materials of a scene.

use std::borrow::Cow;

use ad::Field;
use glam::DVec3;

use super::numbers::Numbers;
use super::{Object, Scene};
use crate::transport::material::{Bsdf, Lobes, Material};

/// A material: its numbers, and what they vary by.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialObject {
    /// The name, unique among materials.
    pub name: String,
    /// What the numbers stand for. Those that a BSDF does not have are no parameters.
    pub bsdf: Bsdf,
    /// The numbers. Where the material is opaque, its opacity is 1 and no parameter; where it is
    /// transparent, it is no mirror.
    pub values: Material<f64>,
    /// Whether what lies behind the surface is seen through it.
    pub transparent: bool,
    /// The textures that the numbers vary by.
    pub textures: MaterialTextures,
    /// How much the [normal map](Slot::Normal) bends, if there is one: the factor of its first two numbers. It is
    /// no parameter.
    pub normal_scale: f64,
}

impl MaterialObject {
    /// A metal, or a glossy layer on a diffuse surface, with numbers from 0 to 1. The index of refraction is
    /// 1.5.
    pub fn metallic_roughness(color: DVec3, metallic: f64, roughness: f64) -> Self {
        let values = Material { metallic, roughness, ..Material::lambertian(color) };
        Self { bsdf: Bsdf::MetallicRoughness, ..values.into() }
    }

    /// Colourless glass with an index of refraction. Where light takes all paths, it goes through it.
    pub fn dielectric(ior: f64) -> Self {
        let values = Material { ior, ..Material::lambertian(DVec3::ONE) };
        Self { bsdf: Bsdf::Dielectric, ..values.into() }
    }

    /// The lobes that its BRDF has.
    #[doc(hidden)]
    pub fn lobes(&self) -> Lobes {
        self.values.lobes(self.bsdf)
    }

    /// The material with an opacity, from 0 to 1: what lies behind it is seen through it.
    #[must_use]
    pub fn with_opacity(mut self, opacity: f64) -> Self {
        self.values.opacity = opacity;
        self.transparent = true;
        self
    }

    /// The material with a texture, by index, for one of its numbers. One for the opacity makes the
    /// material transparent.
    #[must_use]
    pub fn with_texture(mut self, slot: Slot, texture: u32) -> Self {
        self.textures.0[slot as usize] = Some(texture);
        self.transparent |= slot == Slot::Opacity;
        self
    }
}

/// An opaque material with a highlight, without textures, yet without a name.
impl From<Material<f64>> for MaterialObject {
    fn from(values: Material<f64>) -> Self {
        let (name, textures) = (String::new(), MaterialTextures::default());
        let (bsdf, transparent, normal_scale) = (Bsdf::BlinnPhong, false, 1.0);
        Self { name, bsdf, values, transparent, textures, normal_scale }
    }
}

/// What a texture of a material can vary: a number, or the shading normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// The emission, which is multiplied by the texture.
    Emission,
    /// The diffuse albedo, which is multiplied by the texture.
    Diffuse,
    /// The specular albedo, which is multiplied by the texture.
    Specular,
    /// The opacity, which is multiplied by the mean of the texture's channels.
    Opacity,
    /// The roughness and the metallic part, which are multiplied by the texture's green and blue channels.
    MetallicRoughness,
    /// The shading normal: a [normal map](crate::transport::normal_map) in the space of tangents.
    Normal,
}

impl Slot {
    /// All slots, in the order of their numbers.
    pub const ALL: [Self; 6] = [
        Self::Emission,
        Self::Diffuse,
        Self::Specular,
        Self::Opacity,
        Self::MetallicRoughness,
        Self::Normal,
    ];

    /// Those of numbers of a material: all but the last.
    pub(crate) const NUMBERS: [Self; 5] =
        [Self::Emission, Self::Diffuse, Self::Specular, Self::Opacity, Self::MetallicRoughness];

    /// Those of what is seen of the emission.
    pub(crate) const OF_EMISSION: [Self; 2] = [Self::Emission, Self::Opacity];

    /// The name of what varies.
    pub fn field(self) -> &'static str {
        match self {
            Self::Emission => "emission",
            Self::Diffuse => "diffuse",
            Self::Specular => "specular",
            Self::Opacity => "opacity",
            Self::MetallicRoughness => "metallic_roughness",
            Self::Normal => "normal",
        }
    }
}

/// The indices of a material's textures, by [`Slot`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MaterialTextures(pub [Option<u32>; 6]);

impl MaterialTextures {
    /// The texture of a slot.
    pub fn get(&self, slot: Slot) -> Option<u32> {
        self.0[slot as usize]
    }

    /// Whether there is a texture.
    pub fn any(&self) -> bool {
        self.0.iter().any(Option::is_some)
    }

    /// Whether there is one in any of these slots.
    pub(crate) fn any_of(&self, slots: &[Slot]) -> bool {
        slots.iter().any(|&slot| self.get(slot).is_some())
    }
}

impl Scene {
    /// Whether a texture varies numbers of a material that are at most 1, or its normal.
    pub(crate) fn varies_parts(&self, texture: usize) -> bool {
        let varies =
            |material: &MaterialObject, slot| material.textures.get(slot) == Some(texture as u32);
        let mut materials = self.materials.iter();
        materials.any(|material| {
            [Slot::Opacity, Slot::MetallicRoughness, Slot::Normal]
                .into_iter()
                .any(|slot| varies(material, slot))
        })
    }

    /// Whether an object is a texture that is the normal map of a material.
    pub(crate) fn is_normal_map(&self, object: Object) -> bool {
        let Object::Texture(texture) = object else { return false };
        let texture = Some(texture as u32);
        self.materials.iter().any(|material| material.textures.get(Slot::Normal) == texture)
    }
}

impl Numbers for MaterialObject {
    fn fields(&self) -> Vec<Field> {
        let is_present = |field: &Field| match field.name {
            "opacity" => self.transparent,
            "mirror" => {
                self.bsdf == Bsdf::BlinnPhong
                    && !self.transparent
                    && self.textures.get(Slot::Normal).is_none()
            }
            name => self.bsdf.has(name),
        };
        Numbers::fields(&self.values).into_iter().filter(is_present).collect()
    }

    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>> {
        Numbers::get(&self.values, field)
    }

    fn set(&mut self, field: &str, first: usize, numbers: &[f64]) {
        Numbers::set(&mut self.values, field, first, numbers);
    }
}
