//! Materials and their textures.

use std::collections::HashMap;
use std::iter;
use std::path::Path;

use glam::{DAffine2, DMat2, DVec2, DVec3};
use renderer_core::Error;
use renderer_core::scene::{Bsdf, Material, MaterialObject, Wrap};

use super::Buffers;
use super::buffers::{embedded, percent_decoded};
use super::document::{self, Document, Sampler, TextureInfo, TextureTransform, get};
use crate::meshes::plain_material;
use crate::meshes::{
    Channel, DEFAULT_MATERIAL, FullMaterial, ModelMaps, ModelMaterial, TextureImage, TextureSource,
};
use crate::names::Names;
use crate::names::clean_name;
use crate::warning::{Warning, Warnings};

/// The materials of a document, and of these the ones that a primitive has.
pub(super) struct Materials {
    /// The last is that of primitives without one.
    all: Vec<ModelMaterial>,
    /// For each of `all` the set of texture coordinates that it uses.
    texture_sets: Vec<usize>,
    /// For each of `all`, where it is in `used`.
    places: Vec<Option<u32>>,
    pub used: Vec<ModelMaterial>,
}

impl Materials {
    /// All materials of a document at `place`, whose files are in `folder`.
    pub fn load(
        document: &Document,
        buffers: &Buffers,
        folder: &Path,
        place: &str,
        warnings: &mut Warnings,
    ) -> Result<Self, Error> {
        let mut textures = Textures { document, buffers, folder, place, read: HashMap::new() };
        let (mut all, mut texture_sets) = (Vec::new(), Vec::new());
        let mut names = Names::default();
        for (i, definition) in document.materials.iter().enumerate() {
            let name = definition.name.as_deref().map(clean_name).filter(|name| !name.is_empty());
            let name = names.take(name.unwrap_or_else(|| format!("material_{i}")));
            let place = format!("{place}: materials[{i}]");
            let (material, texture_set) =
                convert(definition, name, &place, &mut textures, warnings)?;
            all.push(material);
            texture_sets.push(texture_set);
        }
        let name = names.take(DEFAULT_MATERIAL.to_owned());
        all.push(ModelMaterial { name, ..plain_material() });
        texture_sets.push(0);
        Ok(Self { places: vec![None; all.len()], all, texture_sets, used: Vec::new() })
    }

    /// The set of texture coordinates that one of the document's materials uses.
    pub fn texture_set(&self, index: Option<usize>) -> usize {
        self.texture_sets[index.unwrap_or(self.all.len() - 1)]
    }

    /// The index among the materials that are used of one of the document.
    pub fn place(&mut self, index: Option<usize>) -> u32 {
        let index = index.unwrap_or(self.all.len() - 1);
        *self.places[index].get_or_insert_with(|| {
            self.used.push(self.all[index].clone());
            self.used.len() as u32 - 1
        })
    }
}

/// A material, and the set of texture coordinates that it uses.
fn convert(
    definition: &document::Material,
    name: String,
    place: &str,
    textures: &mut Textures<'_>,
    warnings: &mut Warnings,
) -> Result<(ModelMaterial, usize), Error> {
    warn_of_left_out(definition, place, warnings);
    let pbr = &definition.pbr_metallic_roughness;
    let [r, g, b, alpha] = pbr.base_color_factor;
    let opacity = opacity(definition, alpha).map_err(|problem| Error::new(place, problem))?;
    let is_unlit = definition.extensions.unlit.is_some();
    let color = DVec3::new(r, g, b);
    let mut material = MaterialObject::from(match is_unlit {
        true => Material { emission: color, ..Material::lambertian(DVec3::ZERO) },
        false => Material {
            emission: definition.extensions.emissive_strength.emissive_strength
                * DVec3::from_array(definition.emissive_factor),
            ..Material::lambertian(color)
        },
    });
    let mut full = match is_unlit {
        true => None,
        false => Some(FullMaterial {
            material: full_material(definition, material.values),
            left_out: left_out_of_facets(definition, place),
        }),
    };
    if let Some(opacity) = opacity {
        material = material.with_opacity(opacity);
        full = full.map(|full| FullMaterial {
            material: match full.material.bsdf.has("opacity") {
                true => full.material.with_opacity(opacity),
                false => full.material,
            },
            ..full
        });
    }
    let emissive = if is_unlit { &None } else { &definition.emissive_texture };
    let finish = if is_unlit { &None } else { &pbr.metallic_roughness_texture };
    let bends = definition.normal_texture.as_ref().filter(|_| !is_unlit);
    let scale = bends.map_or(1.0, |normal| normal.scale);
    for material in iter::once(&mut material).chain(full.as_mut().map(|full| &mut full.material)) {
        material.normal_scale = scale;
    }
    let normal = bends.map(|normal| &normal.info);
    let infos = [pbr.base_color_texture.as_ref(), emissive.as_ref(), finish.as_ref(), normal];
    let mut placements = infos.into_iter().flatten().map(placement);
    let (texture_set, first) = placements.next().unwrap_or_default();
    if placements.any(|other| other != (texture_set, first)) {
        let problem = "its textures have different texture coordinates; all get those of the first";
        warnings.add("placements", place, problem);
    }
    let mut source = |info: Option<&TextureInfo>| {
        info.map(|info| textures.source(info.index, warnings)).transpose()
    };
    let base = source(pbr.base_color_texture.as_ref())?;
    let covers = |source: &TextureSource| {
        let channel = alpha_channel(definition, alpha)?;
        Some(TextureSource { channel, ..source.clone() })
    };
    let emission = source(emissive.as_ref())?;
    let of_numbers = |source| TextureSource { channel: Channel::Data, ..source };
    let finish = source(finish.as_ref())?.map(of_numbers);
    let normal = source(normal)?.map(of_numbers);
    let opacity = base.as_ref().and_then(covers);
    let (emission, diffuse) = if is_unlit { (base, None) } else { (emission, base) };
    let sources = [emission, diffuse, None, opacity, finish, normal];
    let maps = ModelMaps { sources, placement: first };
    Ok((ModelMaterial { name, material: Ok(material), full, maps }, texture_set))
}

/// A material with its facets, or glass, by its numbers without.
fn full_material(definition: &document::Material, values: Material<f64>) -> MaterialObject {
    let pbr = &definition.pbr_metallic_roughness;
    let extensions = &definition.extensions;
    let values = Material {
        metallic: pbr.metallic_factor.unwrap_or(1.0),
        roughness: pbr.roughness_factor,
        ior: match extensions.ior.unwrap_or_default().ior {
            // By the extension, what reflects everything.
            0.0 => HIGHEST_IOR,
            ior => ior.max(1.0),
        },
        ..values
    };
    let bsdf = if is_glass(definition) { Bsdf::Dielectric } else { Bsdf::MetallicRoughness };
    MaterialObject { bsdf, ..values.into() }
}

/// The index of refraction of what reflects nearly everything.
const HIGHEST_IOR: f64 = 1e3;

/// Whether a material lets through most of the light, and is smooth: glass has no other part here.
fn is_glass(definition: &document::Material) -> bool {
    let pbr = &definition.pbr_metallic_roughness;
    transmitted(definition) > 0.5
        && pbr.metallic_factor.unwrap_or(1.0) < 0.5
        && pbr.roughness_factor < 0.1
}

fn transmitted(definition: &document::Material) -> f64 {
    definition.extensions.transmission.as_ref().map_or(0.0, |of| of.transmission_factor)
}

/// What of facets and glass is left out where light does not take all paths.
fn left_out_of_facets(definition: &document::Material, place: &str) -> Option<Warning> {
    let pbr = &definition.pbr_metallic_roughness;
    if is_glass(definition) {
        let problem =
            "KHR_materials_transmission is left out: glass is opaque unless light takes all paths";
        return Some(Warning::new(place, problem));
    }
    let problem = match pbr {
        _ if pbr.metallic_roughness_texture.is_some() => "metallicRoughnessTexture is left out",
        _ if pbr.metallic_factor.is_some_and(|factor| factor > 0.0) => "metallicFactor is left out",
        _ => return None,
    };
    Some(Warning::new(
        place,
        format_args!("{problem}: metals are shown as matt surfaces unless light takes all paths"),
    ))
}

fn warn_of_left_out(definition: &document::Material, place: &str, warnings: &mut Warnings) {
    let extensions = &definition.extensions;
    let left_out = [
        (definition.occlusion_texture.is_some(), "occlusionTexture is left out"),
        (
            transmitted(definition) > 0.0 && !is_glass(definition),
            "KHR_materials_transmission is left out: light goes through none but smooth glass, which lets \
             through more than half",
        ),
        (
            is_glass(definition) && definition.extensions.volume.is_none(),
            "without KHR_materials_volume glass is a thin wall; it is shown solid, and has to be closed",
        ),
        (
            extensions.transmission.as_ref().is_some_and(|of| of.transmission_texture.is_some()),
            "transmissionTexture is left out",
        ),
        (
            extensions.ior.is_some_and(|of| of.ior > 0.0 && of.ior < 1.0),
            "its ior is below 1, and taken as 1",
        ),
    ];
    for (_, problem) in left_out.into_iter().filter(|(is_given, _)| *is_given) {
        warnings.add(problem, place, problem);
    }
}

/// The alpha from which on a surface is there, if a material does not say.
const DEFAULT_CUTOFF: f64 = 0.5;

/// The opacity of a material of this alpha, if it is transparent.
fn opacity(definition: &document::Material, alpha: f64) -> Result<Option<f64>, String> {
    let opacity = match definition.alpha_mode.as_deref() {
        None | Some("OPAQUE") => 1.0,
        Some("BLEND") => alpha,
        Some("MASK") if alpha < definition.alpha_cutoff.unwrap_or(DEFAULT_CUTOFF) => 0.0,
        Some("MASK") => 1.0,
        Some(mode) => return Err(format!("alphaMode is `{mode}`, which is none")),
    };
    if !(0.0..=1.0).contains(&opacity) {
        return Err(format!("the alpha of baseColorFactor must lie between 0 and 1, is {opacity}"));
    }
    Ok(Some(opacity).filter(|&opacity| opacity < 1.0))
}

/// What the alpha of the texture of its base colour says, whose factor is `alpha`.
fn alpha_channel(definition: &document::Material, alpha: f64) -> Option<Channel> {
    match definition.alpha_mode.as_deref() {
        Some("BLEND") => Some(Channel::Alpha { cutoff: None }),
        Some("MASK") => {
            let cutoff = definition.alpha_cutoff.unwrap_or(DEFAULT_CUTOFF);
            // With a factor below it nothing is left that could vary.
            (alpha >= cutoff).then(|| Channel::Alpha { cutoff: Some(cutoff / alpha) })
        }
        _ => None,
    }
}

/// The set of texture coordinates, and from these, whose v is turned upwards, to where the texture is
/// looked up.
fn placement(info: &TextureInfo) -> (usize, DAffine2) {
    let Some(transform) = &info.extensions.transform else {
        return (info.tex_coord, DAffine2::IDENTITY);
    };
    let &TextureTransform { offset, rotation, scale, tex_coord } = transform;
    // To the right and downwards, counter-clockwise is from u towards -v.
    let turn = DMat2::from_angle(-rotation) * DMat2::from_diagonal(DVec2::from_array(scale));
    let downwards = DAffine2::from_mat2_translation(turn, DVec2::from_array(offset));
    let flip = DAffine2::from_mat2_translation(
        DMat2::from_diagonal(DVec2::new(1.0, -1.0)),
        DVec2::new(0.0, 1.0),
    );
    (tex_coord.unwrap_or(info.tex_coord), flip * downwards * flip)
}

/// The textures of a document.
struct Textures<'a> {
    document: &'a Document,
    buffers: &'a Buffers,
    folder: &'a Path,
    place: &'a str,
    /// By index of the image.
    read: HashMap<usize, TextureImage>,
}

impl Textures<'_> {
    fn source(&mut self, index: usize, warnings: &mut Warnings) -> Result<TextureSource, Error> {
        let refuse = |problem: String| Error::new(self.place, problem);
        let texture = get(&self.document.textures, index, "textures").map_err(refuse)?;
        let sampler = match texture.sampler {
            None => None,
            Some(sampler) => {
                Some(get(&self.document.samplers, sampler, "samplers").map_err(refuse)?)
            }
        };
        let texture_place = format!("{}: textures[{index}]", self.place);
        let wrap = wrap(sampler, &texture_place, warnings)
            .map_err(|problem| Error::new(&texture_place, problem))?;
        let Some(image) = texture.source else {
            return Err(Error::new(texture_place, "has no source"));
        };
        let place = format!("{}: images[{image}]", self.place);
        let image = match self.read.get(&image) {
            Some(known) => known.clone(),
            None => {
                let new = self.image(image).map_err(|problem| Error::new(&place, problem))?;
                self.read.insert(image, new.clone());
                new
            }
        };
        Ok(TextureSource { image, channel: Channel::Color, wrap, place })
    }

    fn image(&self, index: usize) -> Result<TextureImage, String> {
        let image = get(&self.document.images, index, "images")?;
        let bytes = match (image.uri.as_deref(), image.buffer_view) {
            (Some(uri), _) => match embedded(uri) {
                None => return Ok(TextureImage::File(self.folder.join(percent_decoded(uri)))),
                Some(bytes) => bytes?,
            },
            (None, Some(view)) => {
                let view = get(&self.document.buffer_views, view, "bufferViews")?;
                self.buffers.view(view)?.to_vec()
            }
            (None, None) => return Err("has neither a uri nor a bufferView".to_owned()),
        };
        let name = image.name.clone().unwrap_or_default();
        Ok(TextureImage::Embedded { name, bytes: bytes.into() })
    }
}

/// How a texture goes on beyond its edges.
fn wrap(sampler: Option<&Sampler>, place: &str, warnings: &mut Warnings) -> Result<Wrap, String> {
    let Some(sampler) = sampler else { return Ok(Wrap::Repeat) };
    let mode = |code: Option<u32>| match code {
        None | Some(10497) => Ok(Wrap::Repeat),
        Some(33071) => Ok(Wrap::Clamp),
        Some(33648) => Ok(Wrap::Mirror),
        Some(code) => Err(format!("a wrap mode of its sampler is {code}, which is none")),
    };
    let (along_u, along_v) = (mode(sampler.wrap_s)?, mode(sampler.wrap_t)?);
    if along_u != along_v {
        let problem = "its sampler wraps u and v in different ways; v is wrapped as u is";
        warnings.add("wrap", place, problem);
    }
    if sampler.mag_filter == Some(9728) {
        warnings.add("filter", place, "its sampler takes the nearest texel; all are bilinear here");
    }
    Ok(along_u)
}
