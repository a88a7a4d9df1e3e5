//! The textures of a scene while its file is read: those of the scene file, and those that the
//! materials of meshes bring along.

use std::path::Path;

use renderer_files::disk::read;
use renderer_files::names::{Names, clean_name, file_stem};

use super::format::ordered::Ordered;
use super::format::{ChannelEntry, TextureEntry};
use super::{Problem, file_in};
use crate::Error;
use crate::Image;
use crate::Warning;
use crate::experiment::NamedFile;
use crate::files::images::{TextureFile, decode_coverage, decode_data, decode_texture, is_known};
use crate::files::{Channel, ModelMaps, TextureImage, TextureSource};
use crate::memory;
use crate::scene::{Bsdf, MOST_PIXELS, MaterialTextures, Scene, Slot, Texture, Wrap};

/// What a texel takes: the number that may vary, and the one that is rendered.
const TEXEL_BYTES: u64 = 36;

/// First the textures of the scene file, in its order.
#[derive(Default)]
pub(super) struct TextureTable {
    textures: Vec<Texture>,
    /// Where the texels of each texture are from, if they are not from the scene file.
    images: Vec<Option<(TextureImage, Channel)>>,
    /// What of images of models covers everything.
    opaque: Vec<(TextureImage, Channel)>,
    names: Names,
    /// The files of textures that models name, and where.
    pub files: Vec<NamedFile>,
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
                    let file = file_in(folder, path, || format!("texture.{name}.path"))?;
                    let image = TextureImage::File(file);
                    let channel = Channel::from(entry.channel);
                    let is_covered = |(_, other): &(_, TextureEntry)| {
                        other.path == entry.path && other.channel == ChannelEntry::Opacity
                    };
                    let texels = table
                        .load(&image, channel, "", entries.iter().any(is_covered))
                        .map_err(|error| Problem::new(format!("texture.{name}.path"), error))?;
                    table.push(name.clone(), texels, entry.wrap, (image, channel));
                }
                (None, Some(_), _) if entry.channel == ChannelEntry::Opacity => {
                    return refuse(
                        "channel",
                        "a texture of one colour has no channels to choose from",
                    );
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
                    if let Err(problem) = memory::ask(count as u64 * TEXEL_BYTES) {
                        return refuse("size", &problem);
                    }
                    let wrap = entry.wrap;
                    let texels = vec![color.unwrap_or([1.0; 3]); count].into();
                    table.textures.push(Texture {
                        name: name.clone(),
                        width,
                        height,
                        wrap,
                        texels,
                    });
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

    fn push(&mut self, name: String, texels: Image, wrap: Wrap, image: (TextureImage, Channel)) {
        let Image { width, height, pixels } = texels;
        self.textures.push(Texture { name, width, height, wrap, texels: pixels.into() });
        self.images.push(Some(image));
    }

    /// The texels of an image, which an embedding file has at `place`. Where its alpha is shown by another
    /// texture, it `is_covered`; else of alpha beside colours is warned.
    fn load(
        &mut self,
        image: &TextureImage,
        channel: Channel,
        place: &str,
        is_covered: bool,
    ) -> Result<Image, Error> {
        let read_bytes;
        let (bytes, place): (&[u8], _) = match image {
            TextureImage::File(path) => {
                read_bytes = read(path)?;
                (&read_bytes, path.display().to_string())
            }
            TextureImage::Embedded { bytes, .. } => (bytes, place.to_owned()),
        };
        match channel {
            Channel::Mask => decode_coverage(bytes, place, true),
            Channel::Data => decode_data(bytes, place),
            Channel::Alpha { cutoff } => {
                let mut coverage = decode_coverage(bytes, place, false)?;
                if let Some(cutoff) = cutoff {
                    for alpha in coverage.pixels.as_flattened_mut() {
                        *alpha = if f64::from(*alpha) < cutoff { 0.0 } else { 1.0 };
                    }
                }
                Ok(coverage)
            }
            Channel::Color => {
                let TextureFile { image, is_transparent } = decode_texture(bytes, &place)?;
                if is_transparent && !is_covered {
                    let problem = "has transparent texels; they are shown opaque";
                    self.warnings.push(Warning::new(place, problem));
                }
                Ok(image)
            }
        }
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

    /// The textures that a model's material has which scatters light in this way; those that are not known yet
    /// are read.
    pub fn add(&mut self, maps: &ModelMaps, bsdf: Bsdf) -> Result<MaterialTextures, Error> {
        let covered = maps.get(Slot::Opacity).map(|source| &source.image);
        let mut textures = MaterialTextures::default();
        for slot in Slot::ALL.into_iter().filter(|slot| bsdf.has(slot.field())) {
            if let Some(source) = maps.get(slot) {
                textures.0[slot as usize] =
                    self.add_source(source, covered == Some(&source.image))?;
            }
        }
        Ok(textures)
    }

    /// The index of a texture; none if its file is missing or of another format, of which is warned: files are often passed
    /// on without their pictures. A picture that is there and broken is an error. One that covers
    /// everything is no texture of an opacity.
    fn add_source(
        &mut self,
        source: &TextureSource,
        is_covered: bool,
    ) -> Result<Option<u32>, Error> {
        let TextureSource { image, channel, wrap, place } = source;
        let shown = (image.clone(), *channel);
        let known = self.images.iter().zip(&self.textures);
        let mut known = known.map(|(image, texture)| (image.as_ref(), texture.wrap));
        if let Some(index) = known.position(|known| known == (Some(&shown), *wrap)) {
            return Ok(Some(index as u32));
        }
        if self.opaque.contains(&shown) {
            return Ok(None);
        }
        if let TextureImage::File(path) = image {
            self.files.push(NamedFile { path: path.clone(), by: place.clone() });
            let problem = match path.is_file() {
                false => Some("is missing"),
                true if is_known(&read(path)?) => None,
                true => Some("is not a PNG, JPEG, OpenEXR or Radiance HDR image"),
            };
            if let Some(problem) = problem {
                let texture = path.display();
                let problem = format_args!("the texture {texture} {problem}; white stands for it");
                let warning = Warning::new(place, problem);
                if !self.warnings.contains(&warning) {
                    self.warnings.push(warning);
                }
                return Ok(None);
            }
        }
        let name = match image {
            TextureImage::File(path) => file_stem(path),
            TextureImage::Embedded { name, .. } => match clean_name(name) {
                name if name.is_empty() => "texture".to_owned(),
                name => name,
            },
        };
        let texels =
            self.load(image, *channel, place, is_covered).map_err(|error| match image {
                TextureImage::File(_) => Error::new(place, format!("the texture {error}")),
                TextureImage::Embedded { .. } => error,
            })?;
        let name = match channel {
            Channel::Color => name,
            Channel::Data => format!("{name}_data"),
            Channel::Alpha { .. } | Channel::Mask => {
                if texels.pixels.as_flattened().iter().all(|&x| x == 1.0) {
                    self.opaque.push(shown);
                    return Ok(None);
                }
                format!("{name}_opacity")
            }
        };
        let name = self.names.take(name);
        self.push(name, texels, *wrap, shown);
        Ok(Some((self.textures.len() - 1) as u32))
    }

    /// Hands all textures to the scene; the warnings about their images.
    pub fn move_into(self, scene: &mut Scene) -> Vec<Warning> {
        scene.textures = self.textures;
        self.warnings
    }
}
