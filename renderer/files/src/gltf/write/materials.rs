//! Materials, their textures, and what is approximated of them.

use std::collections::BTreeSet;

use glam::DVec3;
use renderer_core::Error;
use renderer_core::scene::{Bsdf, Material, MaterialObject, Scene, Slot, Texture, Wrap};
use serde_json::{Map, Value, json};

use super::binary::Binary;
use crate::export::Picture;
use crate::warning::Warnings;

/// The index of refraction of a material that names none.
const DEFAULT_IOR: f64 = 1.5;

/// The materials of a document in the making.
pub(super) struct MaterialWriter<'a> {
    scene: &'a Scene,
    warnings: &'a mut Warnings,
    /// For each material of the scene its index in the document.
    places: Vec<Option<usize>>,
    materials: Vec<Value>,
    /// What textures and images show, in their order: each texture has its image and its sampler.
    pictures: Vec<Picture>,
    images: Vec<Value>,
    samplers: Vec<Value>,
    extensions: BTreeSet<&'static str>,
}

impl<'a> MaterialWriter<'a> {
    pub fn new(scene: &'a Scene, warnings: &'a mut Warnings) -> Self {
        Self {
            scene,
            warnings,
            places: vec![None; scene.materials.len()],
            materials: Vec::new(),
            pictures: Vec::new(),
            images: Vec::new(),
            samplers: Vec::new(),
            extensions: BTreeSet::new(),
        }
    }

    /// The index in the document of a material of the scene.
    pub fn index(&mut self, material: u32, binary: &mut Binary) -> Result<usize, Error> {
        if let Some(index) = self.places[material as usize] {
            return Ok(index);
        }
        let scene = self.scene;
        let written = self.material(&scene.materials[material as usize], binary)?;
        self.materials.push(written);
        let index = self.materials.len() - 1;
        self.places[material as usize] = Some(index);
        Ok(index)
    }

    fn material(&mut self, material: &MaterialObject, binary: &mut Binary) -> Result<Value, Error> {
        self.warn(material);
        let MaterialObject { bsdf, values, textures, .. } = material;
        let [r, g, b] = values.diffuse.min(DVec3::ONE).to_array();
        let (metallic, roughness) = match bsdf {
            Bsdf::BlinnPhong => (0.0, roughness_of_highlight(values)),
            Bsdf::MetallicRoughness => (values.metallic, values.roughness),
            Bsdf::Dielectric => (0.0, 0.0),
        };
        let mut pbr = json!({
            "baseColorFactor": [r, g, b, values.opacity],
            "metallicFactor": metallic,
            "roughnessFactor": roughness,
        });
        if let Some(picture) = self.base_color(material) {
            pbr["baseColorTexture"] = self.texture(picture, binary)?;
        }
        if let Some(index) = textures.get(Slot::MetallicRoughness) {
            let picture = Picture::Data(index);
            pbr["metallicRoughnessTexture"] = self.texture(picture, binary)?;
        }
        let mut extensions = Map::new();
        let mut extend = |name: &'static str, value: Value| {
            extensions.insert(name.to_owned(), value);
            self.extensions.insert(name);
        };
        // By the standard factors are at most 1.
        let strength = values.emission.max_element().max(1.0);
        if strength > 1.0 {
            extend("KHR_materials_emissive_strength", json!({ "emissiveStrength": strength }));
        }
        if *bsdf != Bsdf::BlinnPhong && values.ior != DEFAULT_IOR {
            extend("KHR_materials_ior", json!({ "ior": values.ior }));
        }
        if *bsdf == Bsdf::Dielectric {
            extend("KHR_materials_transmission", json!({ "transmissionFactor": 1.0 }));
            // What has a thickness is a solid, and refracts.
            extend("KHR_materials_volume", json!({ "thicknessFactor": 1.0 }));
        }
        let mut written = json!({
            "name": material.name,
            "pbrMetallicRoughness": pbr,
            "emissiveFactor": (values.emission / strength).to_array(),
            // The surface of a solid has an inside.
            "doubleSided": *bsdf != Bsdf::Dielectric,
        });
        if let Some(index) = textures.get(Slot::Emission) {
            written["emissiveTexture"] = self.texture(Picture::Color(index), binary)?;
        }
        if let Some(index) = textures.get(Slot::Normal) {
            let mut texture = self.texture(Picture::Data(index), binary)?;
            texture["scale"] = material.normal_scale.into();
            written["normalTexture"] = texture;
        }
        if material.transparent {
            written["alphaMode"] = "BLEND".into();
        }
        if !extensions.is_empty() {
            written["extensions"] = extensions.into();
        }
        Ok(written)
    }

    /// What the texture of the base colour shows, if there is one.
    fn base_color(&mut self, material: &MaterialObject) -> Option<Picture> {
        let color = material.textures.get(Slot::Diffuse);
        let Some(opacity) = material.textures.get(Slot::Opacity) else {
            return color.map(Picture::Color);
        };
        let of = |index: u32| &self.scene.textures[index as usize];
        let shape = |index| (of(index).width, of(index).height, of(index).wrap);
        if color.is_some_and(|color| shape(color) != shape(opacity)) {
            let problem = "its opacity_texture is left out: in glTF it is the alpha of the \
                           diffuse_texture, and theirs differ in size or wrap";
            self.warnings.add("opacity", format_args!("material.{}", material.name), problem);
            return color.map(Picture::Color);
        }
        Some(Picture::Covered { color, opacity })
    }

    /// The reference to the texture of a picture, which is added if there is none yet.
    fn texture(&mut self, picture: Picture, binary: &mut Binary) -> Result<Value, Error> {
        let known = self.pictures.iter().position(|other| *other == picture);
        let index = match known {
            Some(index) => index,
            None => {
                let Texture { name, wrap, .. } = picture.texture(self.scene);
                let view = binary.view(&picture.png(self.scene, self.warnings)?);
                let image = json!({ "name": name, "bufferView": view, "mimeType": "image/png" });
                self.images.push(image);
                let mode = match wrap {
                    Wrap::Repeat => 10497,
                    Wrap::Clamp => 33071,
                    Wrap::Mirror => 33648,
                };
                self.samplers.push(json!({ "wrapS": mode, "wrapT": mode }));
                self.pictures.push(picture);
                self.pictures.len() - 1
            }
        };
        Ok(json!({ "index": index }))
    }

    /// Warns of what the format has nothing for.
    fn warn(&mut self, material: &MaterialObject) {
        let Material { diffuse, roughness, specular, mirror, .. } = material.values;
        let is_phong = material.bsdf == Bsdf::BlinnPhong;
        let problems = [
            (diffuse.max_element() > 1.0, "a diffuse albedo above 1 is written as 1"),
            (
                is_phong && specular != DVec3::ZERO,
                "the highlight (specular, exponent) becomes that of a roughness: glTF has no Blinn-Phong",
            ),
            (
                is_phong && mirror != DVec3::ZERO,
                "mirror is left out: in glTF metals alone are mirrors",
            ),
            (is_phong && roughness > 0.0, "the roughness of matt surfaces is left out of glTF"),
        ];
        for (_, problem) in problems.into_iter().filter(|(is_lost, _)| *is_lost) {
            self.warnings.add(problem, format_args!("material.{}", material.name), problem);
        }
    }

    /// Adds everything to a document; the names of the extensions that materials need.
    pub fn finish(self, document: &mut Map<String, Value>) -> Vec<&'static str> {
        let mut insert = |name: &str, value: Vec<Value>| {
            if !value.is_empty() {
                document.insert(name.to_owned(), value.into());
            }
        };
        let texture = |index: usize| json!({ "source": index, "sampler": index });
        insert("textures", (0..self.pictures.len()).map(texture).collect());
        insert("images", self.images);
        insert("samplers", self.samplers);
        insert("materials", self.materials);
        self.extensions.into_iter().collect()
    }
}

/// The roughness of facets whose highlight is about as wide as that of an exponent: Blinn-Phong's is the
/// distribution of facets of `alpha^2 = 2 / (n + 2)` (Walter et al., EGSR 2007), and in glTF alpha is the
/// square of the roughness.
fn roughness_of_highlight(values: &Material<f64>) -> f64 {
    match values.specular == DVec3::ZERO {
        true => 1.0,
        false => (2.0 / (values.exponent + 2.0)).powf(0.25),
    }
}
