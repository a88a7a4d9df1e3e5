//! Spheres of a scene.

use std::borrow::Cow;

use ad::Field;
use glam::DVec3;

use super::numbers::Numbers;
use crate::transport::sphere::Sphere;

/// A sphere and its material.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereObject {
    /// The name, unique among spheres.
    pub name: String,
    /// Centre, radius, and how its texture is turned.
    pub values: Sphere<f64>,
    /// The index of its material.
    pub material: u32,
}

impl SphereObject {
    /// A sphere with the material of index 0.
    pub fn new(name: impl Into<String>, center: DVec3, radius: f64) -> Self {
        let values = Sphere { center, radius, rotation: DVec3::ZERO };
        Self { name: name.into(), values, material: 0 }
    }

    /// The sphere with another material, by index.
    #[must_use]
    pub fn material(self, material: u32) -> Self {
        Self { material, ..self }
    }

    /// The lowest and the highest corner of the box around the sphere.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let Sphere { center, radius, .. } = self.values;
        (center - radius, center + radius)
    }
}

impl Numbers for SphereObject {
    fn fields(&self) -> Vec<Field> {
        Numbers::fields(&self.values)
    }

    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>> {
        Numbers::get(&self.values, field)
    }

    fn set(&mut self, field: &str, first: usize, numbers: &[f64]) {
        Numbers::set(&mut self.values, field, first, numbers);
    }
}
