//! Materials of a scene.

use std::borrow::Cow;

use ad::Field;

use super::Scene;
use super::numbers::Numbers;
use crate::transport::material::Material;

/// A material: its numbers, and what they vary by.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialObject {
    /// The name, unique among materials.
    pub name: String,
    /// The numbers. Where the material is opaque, its opacity is 1 and no parameter; where it is
    /// transparent, it is no mirror.
    pub values: Material<f64>,
    /// Whether what lies behind the surface is seen through it.
    pub transparent: bool,
    /// The textures that the numbers vary by.
    pub textures: MaterialTextures,
}

impl MaterialObject {
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

/// An opaque material without textures, yet without a name.
impl From<Material<f64>> for MaterialObject {
    fn from(values: Material<f64>) -> Self {
        let (name, textures) = (String::new(), MaterialTextures::default());
        Self { name, values, transparent: false, textures }
    }
}

/// A number of a material that a texture can vary.
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
}

impl Slot {
    /// All slots, in the order of their numbers.
    pub const ALL: [Self; 4] = [Self::Emission, Self::Diffuse, Self::Specular, Self::Opacity];

    /// The name of the number that varies.
    pub fn field(self) -> &'static str {
        match self {
            Self::Emission => "emission",
            Self::Diffuse => "diffuse",
            Self::Specular => "specular",
            Self::Opacity => "opacity",
        }
    }
}

/// The indices of a material's textures, by [`Slot`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MaterialTextures(pub [Option<u32>; 4]);

impl MaterialTextures {
    /// The texture of a slot.
    pub fn get(&self, slot: Slot) -> Option<u32> {
        self.0[slot as usize]
    }

    /// Whether there is a texture.
    pub fn any(&self) -> bool {
        self.0.iter().any(Option::is_some)
    }
}

impl Scene {
    /// Whether a texture varies the opacity of a material.
    pub(crate) fn is_opacity_texture(&self, texture: usize) -> bool {
        let mut textures = self.materials.iter().map(|material| material.textures);
        textures.any(|textures| textures.get(Slot::Opacity) == Some(texture as u32))
    }
}

impl Numbers for MaterialObject {
    fn fields(&self) -> Vec<Field> {
        let absent = if self.transparent { "mirror" } else { "opacity" };
        let fields = Numbers::fields(&self.values).into_iter();
        fields.filter(|field| field.name != absent).collect()
    }

    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>> {
        Numbers::get(&self.values, field)
    }

    fn set(&mut self, field: &str, first: usize, numbers: &[f64]) {
        Numbers::set(&mut self.values, field, first, numbers);
    }
}
