//! The textures of a scene while its file is read: those of the scene file, and those that the
//! materials of meshes bring along.

use std::path::{Path, PathBuf};

use super::Problem;
use super::format::{Ordered, TextureEntry};
use crate::Error;
use crate::files::images::load_image;
use crate::files::obj::{ModelMaps, TextureSource, unique};
use crate::image::Image;
use crate::scene::{MOST_PIXELS, MaterialTextures, Scene, TextureObject, Wrap};

/// First the textures of the scene file, in its order.
#[derive(Default)]
pub(super) struct TextureTable {
    textures: Vec<TextureObject>,
    texels: Vec<Vec<[f64; 3]>>,
    /// The file of each texture, if it has one.
    files: Vec<Option<PathBuf>>,
}

impl TextureTable {
    /// The textures that a scene file in `folder` names.
    pub fn new(entries: &Ordered<TextureEntry>, folder: &Path) -> Result<Self, Problem> {
        let mut table = Self::default();
        for (name, entry) in entries {
            let refuse = |field: &str, problem: &str| {
                Err(Problem::new(format!("texture.{name}.{field}"), problem))
            };
            match (&entry.path, entry.size, entry.color) {
                (Some(_), Some(_), _) => {
                    return refuse("size", "a texture from a file has the size of the image");
                }
                (Some(_), _, Some(_)) => {
                    return refuse("color", "a texture from a file has the colours of the image");
                }
                (Some(path), None, None) => {
                    let path = folder.join(path);
                    let image = load_image(&path)?.image;
                    table.push(name.clone(), &image, entry.wrap.into(), Some(path));
                }
                (None, Some([0, _] | [_, 0]), _) => {
                    return refuse("size", "must be at least 1 x 1");
                }
                (None, Some([width, height]), color) => {
                    let count = width as usize * height as usize;
                    if count as u64 > MOST_PIXELS {
                        return refuse(
                            "size",
                            &format!("{count} texels; a texture may have up to {MOST_PIXELS}"),
                        );
                    }
                    let wrap = entry.wrap.into();
                    table.textures.push(TextureObject { name: name.clone(), width, height, wrap });
                    table.texels.push(vec![color.unwrap_or([1.0; 3]); count]);
                    table.files.push(None);
                }
                (None, None, _) => {
                    return refuse(
                        "path",
                        "is missing; a texture has a path, or a size and a color",
                    );
                }
            }
        }
        Ok(table)
    }

    fn push(&mut self, name: String, image: &Image, wrap: Wrap, file: Option<PathBuf>) {
        let &Image { width, height, ref pixels } = image;
        self.textures.push(TextureObject { name, width, height, wrap });
        self.texels.push(pixels.iter().map(|pixel| pixel.map(f64::from)).collect());
        self.files.push(file);
    }

    /// The index of the texture `name`.
    ///
    /// # Errors
    ///
    /// If there is none; the text says which there are.
    pub fn index(&self, name: &str) -> Result<u32, String> {
        let position = self.textures.iter().position(|texture| texture.name == name);
        position.map(|index| index as u32).ok_or_else(|| {
            let names: Vec<&str> = self.textures.iter().map(|t| t.name.as_str()).collect();
            let known = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
            format!("no texture `{name}`; the scene has {known}; define it as [texture.{name}]")
        })
    }

    /// The textures of a model's material; those that are not known yet are read.
    pub fn add(&mut self, maps: &ModelMaps) -> Result<MaterialTextures, Error> {
        let mut add = |source: &Option<TextureSource>| {
            source.as_ref().map(|source| self.add_source(source)).transpose()
        };
        Ok(MaterialTextures {
            ambient: None,
            diffuse: add(&maps.diffuse)?,
            specular: add(&maps.specular)?,
        })
    }

    fn add_source(&mut self, source: &TextureSource) -> Result<u32, Error> {
        let TextureSource { path, wrap, place } = source;
        let known = self.files.iter().zip(&self.textures);
        let mut known = known.map(|(file, texture)| (file.as_ref(), texture.wrap));
        if let Some(index) = known.position(|known| known == (Some(path), *wrap)) {
            return Ok(index as u32);
        }
        if !path.is_file() {
            return Err(Error::new(place, format!("the texture {} is missing", path.display())));
        }
        let image = load_image(path)?.image;
        let stem = path.file_stem().map_or("texture".into(), |stem| stem.to_string_lossy());
        let stem = stem.trim().replace(char::is_control, "_");
        let taken = |name: &str| self.textures.iter().any(|other| other.name == name);
        let name = unique(stem, taken);
        self.push(name, &image, *wrap, Some(path.clone()));
        Ok((self.textures.len() - 1) as u32)
    }

    /// Hands all textures to the scene.
    pub fn move_into(self, scene: &mut Scene) {
        scene.textures = self.textures;
        scene.parameters.textures = self.texels;
    }
}
