//! The textures of a scene while its file is read: those of the scene file, and those that the
//! materials of meshes bring along.

use std::path::Path;

use super::Problem;
use super::format::{Ordered, TextureEntry};
use crate::Error;
use crate::files::Warning;
use crate::files::images::{TextureFile, decode_texture};
use crate::files::io::read;
use crate::files::meshes::{clean_name, file_stem};
use crate::files::model::{ModelMaps, TextureImage, TextureSource};
use crate::files::names::Names;
use crate::image::Image;
use crate::scene::{MOST_PIXELS, MaterialTextures, Scene, TextureObject, Wrap};

/// First the textures of the scene file, in its order.
#[derive(Default)]
pub(super) struct TextureTable {
    textures: Vec<TextureObject>,
    texels: Vec<Vec<[f64; 3]>>,
    /// Where the texels of each texture are from, if they are not from the scene file.
    images: Vec<Option<TextureImage>>,
    names: Names,
    /// About the images.
    warnings: Vec<Warning>,
}

impl TextureTable {
    /// The textures that a scene file in `folder` names.
    pub fn new(entries: &Ordered<TextureEntry>, folder: &Path) -> Result<Self, Problem> {
        let names = entries.iter().map(|(name, _)| name.as_str()).collect();
        let mut table = Self { names, ..Self::default() };
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
                    let image = TextureImage::File(folder.join(path));
                    let texels = table.load(&image, "")?;
                    table.push(name.clone(), &texels, entry.wrap.into(), image);
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
                    table.images.push(None);
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

    fn push(&mut self, name: String, texels: &Image, wrap: Wrap, image: TextureImage) {
        let &Image { width, height, ref pixels } = texels;
        self.textures.push(TextureObject { name, width, height, wrap });
        self.texels.push(pixels.iter().map(|pixel| pixel.map(f64::from)).collect());
        self.images.push(Some(image));
    }

    /// The texels of an image, which an embedding file has at `place`.
    fn load(&mut self, image: &TextureImage, place: &str) -> Result<Image, Error> {
        let (texture, place) = match image {
            TextureImage::File(path) => {
                (decode_texture(&read(path)?, path.display())?, path.display().to_string())
            }
            TextureImage::Embedded { bytes, .. } => {
                (decode_texture(bytes, place)?, place.to_owned())
            }
        };
        let TextureFile { image, is_transparent } = texture;
        if is_transparent {
            let problem = "has transparent texels; they are shown opaque";
            self.warnings.push(Warning::new(place, problem));
        }
        Ok(image)
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
        let mut add = |source: &Option<TextureSource>| match source {
            Some(source) => self.add_source(source),
            None => Ok(None),
        };
        Ok(MaterialTextures {
            ambient: add(&maps.ambient)?,
            diffuse: add(&maps.diffuse)?,
            specular: add(&maps.specular)?,
        })
    }

    /// The index of a texture; none if its file is missing, of which is warned: files are often passed
    /// on without their pictures. A picture that is there and broken is an error.
    fn add_source(&mut self, source: &TextureSource) -> Result<Option<u32>, Error> {
        let TextureSource { image, wrap, place } = source;
        let known = self.images.iter().zip(&self.textures);
        let mut known = known.map(|(image, texture)| (image.as_ref(), texture.wrap));
        if let Some(index) = known.position(|known| known == (Some(image), *wrap)) {
            return Ok(Some(index as u32));
        }
        let name = match image {
            TextureImage::File(path) if !path.is_file() => {
                let missing = path.display();
                let problem = format_args!("the texture {missing} is missing; white stands for it");
                let warning = Warning::new(place, problem);
                if !self.warnings.contains(&warning) {
                    self.warnings.push(warning);
                }
                return Ok(None);
            }
            TextureImage::File(path) => file_stem(path),
            TextureImage::Embedded { name, .. } => match clean_name(name) {
                name if name.is_empty() => "texture".to_owned(),
                name => name,
            },
        };
        let name = self.names.take(name);
        let texels = self.load(image, place)?;
        self.push(name, &texels, *wrap, image.clone());
        Ok(Some((self.textures.len() - 1) as u32))
    }

    /// Hands all textures to the scene; the warnings about their images.
    pub fn move_into(self, scene: &mut Scene) -> Vec<Warning> {
        scene.textures = self.textures;
        scene.parameters.textures = self.texels;
        self.warnings
    }
}
