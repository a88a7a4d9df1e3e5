//! The texels of a texture as lookups read them.

use std::sync::Arc;

use ad::vector::Vector3;
use ad::{Real, Vec3};

/// Texels in the precision of a pass, or, where they do not vary, those of the scene.
pub enum TexelInputs<L: Real> {
    /// As an image gave them.
    Shared(Arc<Vec<[f32; 3]>>),
    /// Set or varying as parameters.
    Own(Vec<Vec3<L>>),
}

impl<L: Real> TexelInputs<L> {
    /// The texel at an index.
    #[inline]
    pub fn at(&self, index: usize) -> Vec3<L> {
        match self {
            Self::Shared(texels) => {
                let [r, g, b] = texels[index].map(|value| L::from_f64(value.into()));
                Vector3::new(r, g, b)
            }
            Self::Own(texels) => texels[index],
        }
    }
}
