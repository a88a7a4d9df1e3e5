//! The discrete part of materials and textures.

use super::Scene;

/// The discrete part of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialObject {
    /// Its name, unique among materials.
    pub name: String,
    /// What its colours and its opacity vary by.
    pub textures: MaterialTextures,
    /// The index of its opacity among [`Parameters::opacities`](super::Parameters::opacities); none if it
    /// is opaque for good.
    pub opacity: Option<u32>,
}

impl MaterialObject {
    /// An opaque material without textures.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), textures: MaterialTextures::default(), opacity: None }
    }
}

/// Indices of the textures that a material's colours, and its opacity, are multiplied by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MaterialTextures {
    /// That of `ambient`.
    pub ambient: Option<u32>,
    /// That of `diffuse`.
    pub diffuse: Option<u32>,
    /// That of `specular`.
    pub specular: Option<u32>,
    /// That of the [opacity](MaterialObject::opacity), which has to be there; the mean of the channels
    /// counts.
    pub opacity: Option<u32>,
}

impl MaterialTextures {
    /// Whether there is one.
    pub fn any(&self) -> bool {
        self.iter().next().is_some()
    }

    /// Those that there are.
    pub fn iter(&self) -> impl Iterator<Item = u32> {
        [self.ambient, self.diffuse, self.specular, self.opacity].into_iter().flatten()
    }
}

impl Scene {
    /// Whether a texture varies the opacity of a material.
    pub(crate) fn is_of_opacity(&self, texture: usize) -> bool {
        self.materials.iter().any(|material| material.textures.opacity == Some(texture as u32))
    }
}

/// The discrete part of a texture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextureObject {
    /// Its name, unique among textures.
    pub name: String,
    /// Texels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// How it goes on beyond its edges.
    pub wrap: Wrap,
}

/// How a texture goes on beyond its edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// It begins anew.
    #[default]
    Repeat,
    /// Its outermost texels go on.
    Clamp,
    /// It goes back and forth.
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
