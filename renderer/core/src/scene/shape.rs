//! Custom shapes in a scene.

use std::borrow::Cow;

use ad::{Field, Fields};
use glam::DVec3;

use super::numbers::{Numbers, range_of};
use crate::custom::{ShapeFamily, ShapeKernel};
use crate::transport::transform::Transform;

/// A custom shape, its place and its material. Scene files do not know it.
///
/// Where light takes all paths, these come to a shape that shines by chance alone, and gradients by what moves it lack what
/// its light changes on other surfaces.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeObject {
    /// The name, unique among shapes.
    pub name: String,
    /// The kernel.
    pub kernel: ShapeKernel,
    /// The numbers of all its fields.
    pub numbers: Vec<f64>,
    /// The place in the world.
    pub transform: Transform<f64>,
    /// The index of its material, which has no texture and no opacity.
    pub material: u32,
}

impl ShapeObject {
    pub(super) fn new<T: ShapeFamily>(name: impl Into<String>, shape: &T, material: u32) -> Self {
        Self {
            name: name.into(),
            kernel: T::kernel(),
            numbers: (0..T::LEN).map(|index| shape.number(index)).collect(),
            transform: Transform::IDENTITY,
            material,
        }
    }

    /// The lowest and the highest corner of a box around the shape in the world.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        self.kernel.bounds(&self.numbers, self.transform)
    }
}

impl Numbers for ShapeObject {
    fn fields(&self) -> Vec<Field> {
        [self.kernel.fields, Transform::<f64>::FIELDS].concat()
    }

    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>> {
        match range_of(self.kernel.fields, field) {
            Some(range) => Some(Cow::Borrowed(&self.numbers[range])),
            None => Numbers::get(&self.transform, field),
        }
    }

    fn set(&mut self, field: &str, first: usize, numbers: &[f64]) {
        match range_of(self.kernel.fields, field) {
            Some(range) => {
                self.numbers[range.start + first..][..numbers.len()].copy_from_slice(numbers);
            }
            None => Numbers::set(&mut self.transform, field, first, numbers),
        }
    }
}
