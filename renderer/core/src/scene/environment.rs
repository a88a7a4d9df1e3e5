//! What surrounds a scene.

use std::borrow::Cow;

use ad::{Field, Fields};
use glam::DVec3;

use super::numbers::Numbers;
use super::{Scene, Texture};
use crate::transport::environment::Environment;

/// What surrounds a scene: its numbers, and what they vary by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnvironmentObject {
    /// The numbers. Without a texture the rotation is no parameter: it changes nothing.
    pub values: Environment<f64>,
    /// The index of a texture that multiplies the radiance: a map of all directions, by latitude and
    /// longitude.
    ///
    /// Its rows go from +y down to -y. Its middle column is seen towards -z, and columns to the right of it
    /// towards +x. Whatever the `wrap` of the texture, columns go around, and rows end at the poles.
    pub texture: Option<u32>,
    /// What the camera sees in place of it, straight and not by mirrors. It lights nothing and is no
    /// parameter.
    pub background: Option<DVec3>,
}

impl EnvironmentObject {
    /// The environment with a texture, by index.
    #[must_use]
    pub fn with_texture(self, texture: u32) -> Self {
        Self { texture: Some(texture), ..self }
    }
}

impl Scene {
    /// The texture of the environment, if it has one.
    pub(crate) fn environment_map(&self) -> Option<&Texture> {
        Some(&self.textures[self.environment?.texture? as usize])
    }
}

/// The same from everywhere, as the camera sees it.
impl From<Environment<f64>> for EnvironmentObject {
    fn from(values: Environment<f64>) -> Self {
        Self { values, texture: None, background: None }
    }
}

impl Numbers for EnvironmentObject {
    fn fields(&self) -> Vec<Field> {
        let fields = Environment::<f64>::FIELDS.iter();
        let is_one = |field: &&Field| self.texture.is_some() || field.name != "rotation";
        fields.filter(is_one).copied().collect()
    }

    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>> {
        Numbers::get(&self.values, field)
    }

    fn set(&mut self, field: &str, first: usize, numbers: &[f64]) {
        Numbers::set(&mut self.values, field, first, numbers);
    }
}
