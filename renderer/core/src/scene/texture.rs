//! Textures of a scene.

use std::borrow::Cow;

use ad::Field;

use super::numbers::Numbers;

/// An image that varies the numbers of materials.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The name, unique among textures.
    pub name: String,
    /// Texels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// What lies beyond its edges.
    pub wrap: Wrap,
    /// Linear RGB, row by row from the top left.
    pub texels: Vec<[f64; 3]>,
}

/// What lies beyond the edges of a texture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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
        (field == "texels").then(|| Cow::Borrowed(self.texels.as_flattened()))
    }

    fn set(&mut self, _: &str, first: usize, numbers: &[f64]) {
        self.texels.as_flattened_mut()[first..][..numbers.len()].copy_from_slice(numbers);
    }
}

#[cfg(test)]
mod tests {
    use super::Wrap;

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
