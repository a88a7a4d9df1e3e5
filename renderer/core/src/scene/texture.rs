//! Textures of a scene.

use std::borrow::Cow;
use std::sync::Arc;

use ad::Field;

use super::numbers::Numbers;
use crate::Image;

/// An image that varies the numbers of materials.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The name, unique among textures.
    pub name: String,
    /// Texels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// What lies beyond its edges; not on spheres, where columns go around, and rows end at the poles.
    pub wrap: Wrap,
    /// Linear RGB, row by row from the top left.
    pub texels: Texels,
}

impl Texture {
    /// The texels as an image, in single precision.
    pub fn image(&self) -> Image {
        let pixels = self.texels.iter().map(|texel| texel.map(|value| value as f32)).collect();
        Image { width: self.width, height: self.height, pixels }
    }
}

/// The texels of a texture, linear RGB. Those of an image take 12 bytes each, which a scene shares with
/// its copies and with what is rendered; those that are set as a parameter are in double precision, 24
/// bytes each.
#[derive(Clone, Debug)]
pub struct Texels(Kept);

#[derive(Clone, Debug)]
enum Kept {
    Single(Arc<Vec<[f32; 3]>>),
    Double(Vec<[f64; 3]>),
}

impl Texels {
    /// How many there are.
    pub fn len(&self) -> usize {
        match &self.0 {
            Kept::Single(texels) => texels.len(),
            Kept::Double(texels) => texels.len(),
        }
    }

    /// Returns `true` if there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The texels, one after the other.
    pub fn iter(&self) -> impl Iterator<Item = [f64; 3]> {
        (0..self.len()).map(|index| self.at(index))
    }

    /// One of them.
    ///
    /// # Panics
    ///
    /// If there are not as many.
    pub fn at(&self, index: usize) -> [f64; 3] {
        match &self.0 {
            Kept::Single(texels) => texels[index].map(f64::from),
            Kept::Double(texels) => texels[index],
        }
    }

    /// The texels of an image, to be shared.
    pub(crate) fn shared(&self) -> Option<&Arc<Vec<[f32; 3]>>> {
        match &self.0 {
            Kept::Single(texels) => Some(texels),
            Kept::Double(_) => None,
        }
    }
}

impl From<Vec<[f32; 3]>> for Texels {
    fn from(texels: Vec<[f32; 3]>) -> Self {
        Self(Kept::Single(Arc::new(texels)))
    }
}

impl From<Vec<[f64; 3]>> for Texels {
    fn from(texels: Vec<[f64; 3]>) -> Self {
        Self(Kept::Double(texels))
    }
}

impl PartialEq for Texels {
    /// Compares values, in whatever precision they are kept.
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

/// What lies beyond the edges of a texture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Wrap {
    /// The texture again.
    #[default]
    Repeat,
    /// Its outermost texels.
    Clamp,
    /// The texture mirrored.
    Mirror,
}

impl Wrap {
    /// The column of an image of `size` columns that stands at `index`; the same for rows.
    pub fn index(self, index: i64, size: u32) -> u32 {
        let size = i64::from(size);
        let inside = match self {
            _ if (0..size).contains(&index) => index,
            Self::Repeat => index.rem_euclid(size),
            Self::Clamp => index.clamp(0, size - 1),
            Self::Mirror => {
                let forth = index.rem_euclid(2 * size);
                forth.min(2 * size - 1 - forth)
            }
        };
        inside as u32
    }
}

impl Numbers for Texture {
    fn fields(&self) -> Vec<Field> {
        vec![Field { name: "texels", len: 3 * self.texels.len() }]
    }

    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>> {
        (field == "texels").then(|| match &self.texels.0 {
            Kept::Single(texels) => texels.as_flattened().iter().copied().map(f64::from).collect(),
            Kept::Double(texels) => Cow::Borrowed(texels.as_flattened()),
        })
    }

    fn set(&mut self, _: &str, first: usize, numbers: &[f64]) {
        let mut texels = match &mut self.texels.0 {
            Kept::Single(_) => self.texels.iter().collect(),
            Kept::Double(texels) => std::mem::take(texels),
        };
        texels.as_flattened_mut()[first..][..numbers.len()].copy_from_slice(numbers);
        self.texels = texels.into();
    }
}

#[cfg(test)]
mod tests {
    use super::{Numbers, Texels, Texture, Wrap};

    /// Steps of finite differences, and those of optimisers, are smaller than single precision.
    #[test]
    fn texels_that_are_set_keep_double_precision() {
        let image = vec![[0.25_f32, 0.5, 0.1], [1.0, 0.0, 2.0]];
        let name = String::new();
        let texels = Texels::from(image.clone());
        let mut texture = Texture { name, width: 2, height: 1, wrap: Wrap::Clamp, texels };
        assert_eq!(texture.image().pixels, image);
        assert_eq!(texture.get("texels").unwrap()[2], f64::from(0.1_f32));
        let before = texture.clone();
        texture.set("texels", 3, &[1.0 + 1e-12]);
        assert_eq!(texture.get("texels").unwrap()[2..4], [f64::from(0.1_f32), 1.0 + 1e-12]);
        assert!(texture != before && before.texels.shared().is_some());
        texture.set("texels", 3, &[1.0]);
        assert_eq!(texture, before);
    }

    #[test]
    fn textures_go_on_beyond_their_edges() {
        let indices = |wrap: Wrap| (-4..7).map(|i| wrap.index(i, 3)).collect::<Vec<_>>();
        assert_eq!(indices(Wrap::Repeat), [2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0]);
        assert_eq!(indices(Wrap::Clamp), [0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2]);
        assert_eq!(indices(Wrap::Mirror), [2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0]);
        for wrap in [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror] {
            assert!([i64::MIN, i64::MAX].iter().all(|&index| wrap.index(index, 5) < 5));
        }
    }
}
