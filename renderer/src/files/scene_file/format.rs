//! The scene file as it is written down.

pub(super) mod ordered;
mod short;
pub(super) mod value;

use std::fmt;
use std::path::PathBuf;

use serde::de::{self, DeserializeSeed, Deserializer, MapAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};

use super::numbers;
use crate::experiment::Remeshing;
use crate::files::Channel;
use crate::laplacian::Weights;
use crate::loss::LossKind;
use crate::optimize::{Optimizer, Scale, Schedule};
use crate::scene::{DEFAULT_BOUNCES, Integrator, PathTracing, Slot, Wrap};
use crate::settings::Pass;
use ordered::Ordered;
use short::{name_or_table, text_or_table};
use value::Numbers;

/// Defines tables of objects of a kind: fields of their own, and all others, which are the numbers of the
/// object, by the names that the table of parameters has for them.
macro_rules! entries {
    ($(
        $(#[$entry_doc:meta])*
        $entry:ident, $kind:literal { $($(#[$doc:meta])* $($key:literal)? $field:ident: $type:ty,)* }
    )*) => {$(
        $(#[$entry_doc])*
        #[derive(Default)]
        pub(super) struct $entry {
            $($(#[$doc])* pub $field: $type,)*
            pub numbers: Ordered<Numbers>,
        }

        impl<'de> Deserialize<'de> for $entry {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Fields;

                impl<'de> Visitor<'de> for Fields {
                    type Value = $entry;

                    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                        write!(f, "a table")
                    }

                    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<$entry, A::Error> {
                        let mut entry = $entry::default();
                        let key = Key { kind: $kind, own: &[$(key!($($key)? $field)),*] };
                        while let Some(key) = map.next_key_seed(key)? {
                            $(
                                if key == key!($($key)? $field) {
                                    entry.$field = map.next_value()?;
                                    continue;
                                }
                            )*
                            entry.numbers.push((key, map.next_value()?));
                        }
                        Ok(entry)
                    }
                }

                deserializer.deserialize_map(Fields)
            }
        }

        impl Serialize for $entry {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let mut map = serializer.serialize_map(None)?;
                $(
                    if let Some(value) = &self.$field {
                        map.serialize_entry(key!($($key)? $field), value)?;
                    }
                )*
                for (key, numbers) in &self.numbers {
                    map.serialize_entry(key, numbers)?;
                }
                map.end()
            }
        }
    )*};
}

macro_rules! key {
    ($key:literal $field:ident) => {
        $key
    };
    ($field:ident) => {
        stringify!($field)
    };
}

/// A key of the table of an object of some kind, which has fields of its own and numbers.
#[derive(Clone, Copy)]
struct Key {
    kind: &'static str,
    own: &'static [&'static str],
}

impl<'de> DeserializeSeed<'de> for Key {
    type Value = String;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<String, D::Error> {
        let key = String::deserialize(deserializer)?;
        let Self { kind, own } = self;
        let known = || numbers::names(kind).chain(own.iter().copied());
        if known().any(|name| name == key) || numbers::was_renamed(kind, &key) {
            return Ok(key);
        }
        let known: Vec<String> = known().map(|name| format!("`{name}`")).collect();
        let problem = format!("unknown field `{key}`, expected one of {}", known.join(", "));
        Err(de::Error::custom(problem))
    }
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneFile {
    #[serde(default = "default_bounces")]
    pub bounces: u32,
    pub light_samples: Option<u32>,
    pub integrator: Option<IntegratorEntry>,
    pub camera: Option<CameraEntry>,
    #[serde(default, rename = "view", skip_serializing_if = "Vec::is_empty")]
    pub views: Vec<ViewEntry>,
    pub environment: Option<EnvironmentEntry>,
    #[serde(default, rename = "light", skip_serializing_if = "Vec::is_empty")]
    pub lights: Vec<LightEntry>,
    #[serde(default, rename = "mesh", skip_serializing_if = "Vec::is_empty")]
    pub meshes: Vec<MeshEntry>,
    #[serde(default, rename = "sphere", skip_serializing_if = "Vec::is_empty")]
    pub spheres: Vec<SphereEntry>,
    #[serde(default, rename = "texture", with = "ordered", skip_serializing_if = "Vec::is_empty")]
    pub textures: Ordered<TextureEntry>,
    #[serde(default, rename = "material", with = "ordered", skip_serializing_if = "Vec::is_empty")]
    pub materials: Ordered<MaterialEntry>,
    pub optimize: Option<OptimizeEntry>,
}

/// Which paths of light count. One table of all fields, whose `type` says which count: an enum with a tag would forget
/// where its fields stand.
#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct IntegratorEntry {
    #[serde(rename = "type")]
    kind: IntegratorKind,
    max_depth: Option<u32>,
    samples: Option<u32>,
    seed: Option<u32>,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum IntegratorKind {
    Direct,
    Path,
}

impl From<IntegratorEntry> for Integrator {
    fn from(IntegratorEntry { kind, max_depth, samples, seed }: IntegratorEntry) -> Self {
        let default = PathTracing::default();
        match kind {
            IntegratorKind::Direct => Self::Direct,
            IntegratorKind::Path => Self::Path(PathTracing {
                max_depth: max_depth.unwrap_or(default.max_depth),
                samples: samples.unwrap_or(default.samples),
                seed: seed.unwrap_or(default.seed),
            }),
        }
    }
}

impl From<Integrator> for IntegratorEntry {
    fn from(integrator: Integrator) -> Self {
        match integrator {
            Integrator::Direct => {
                Self { kind: IntegratorKind::Direct, max_depth: None, samples: None, seed: None }
            }
            Integrator::Path(PathTracing { max_depth, samples, seed }) => Self {
                kind: IntegratorKind::Path,
                max_depth: Some(max_depth),
                samples: Some(samples),
                seed: Some(seed),
            },
        }
    }
}

entries! {
    EnvironmentEntry, "environment" {
        /// The name of a texture.
        texture: Option<String>,
        background: Option<[f64; 3]>,
    }

    /// The camera.
    CameraEntry, "camera" {
        width: Option<u32>,
        height: Option<u32>,
    }

    /// A camera with a name, and what its image is compared with.
    ViewEntry, "camera" {
        /// A file of many cameras, relative to the scene file, in place of one camera and its target.
        path: Option<PathBuf>,
        name: Option<String>,
        width: Option<u32>,
        height: Option<u32>,
        /// Image files, relative to the scene file.
        target: Option<PathBuf>,
        coverage: Option<MatchedEntry>,
        depth: Option<MatchedEntry>,
        normals: Option<MatchedEntry>,
        mask: Option<PathBuf>,
        weight: Option<f64>,
        held_out: Option<bool>,
    }

    LightEntry, "light" {
        name: Option<String>,
        "type" kind: Option<String>,
        /// Of a point light, in place of its radiant intensity: W.
        power: Option<f64>,
    }

    MeshEntry, "mesh" {
        /// Relative to the scene file.
        path: Option<PathBuf>,
        /// If given, all objects of the file are one mesh of this name.
        name: Option<String>,
        /// If given, replaces all materials.
        material: Option<String>,
        normals: Option<NormalsEntry>,
    }

    SphereEntry, "sphere" {
        name: Option<String>,
        material: Option<String>,
    }

    /// Textures by name. One of the opacity makes the material transparent, and so does an opacity.
    MaterialEntry, "material" {
        "type" kind: Option<String>,
        emission_texture: Option<String>,
        diffuse_texture: Option<String>,
        specular_texture: Option<String>,
        opacity_texture: Option<String>,
        metallic_roughness_texture: Option<String>,
        normal_texture: Option<String>,
        /// How much the normal texture bends; no parameter.
        normal_scale: Option<f64>,
    }
}

/// What a view is to show: a table, or its path alone.
pub(super) struct MatchedEntry(pub MatchedFile);

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MatchedFile {
    /// An image file, relative to the scene file.
    pub path: PathBuf,
    #[serde(default = "default_weight")]
    pub weight: f64,
}

impl<'de> Deserialize<'de> for MatchedEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        text_or_table(deserializer, ["path", "path"]).map(Self)
    }
}

impl Serialize for MatchedEntry {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0.weight {
            1.0 => self.0.path.serialize(serializer),
            _ => self.0.serialize(serializer),
        }
    }
}

impl ViewEntry {
    /// What is matched beside the image or in place of it.
    pub fn passes(&self) -> impl Iterator<Item = (Pass, &MatchedFile)> {
        let entries = [
            (Pass::Coverage, &self.coverage),
            (Pass::Depth, &self.depth),
            (Pass::Normals, &self.normals),
        ];
        entries.into_iter().filter_map(|(pass, entry)| Some((pass, &entry.as_ref()?.0)))
    }
}

impl MaterialEntry {
    /// The name of the texture of a slot.
    pub fn texture(&self, slot: Slot) -> Option<&str> {
        let texture = match slot {
            Slot::Emission => &self.emission_texture,
            Slot::Diffuse => &self.diffuse_texture,
            Slot::Specular => &self.specular_texture,
            Slot::Opacity => &self.opacity_texture,
            Slot::MetallicRoughness => &self.metallic_roughness_texture,
            Slot::Normal => &self.normal_texture,
        };
        texture.as_deref()
    }
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TextureEntry {
    /// An image file, relative to the scene file.
    pub path: Option<PathBuf>,
    /// Width and height of a texture without file.
    #[serde(default, deserialize_with = "exactly")]
    pub size: Option<[u32; 2]>,
    /// The colour of a texture without file.
    #[serde(default, deserialize_with = "exactly")]
    pub color: Option<[f64; 3]>,
    #[serde(default)]
    pub wrap: Wrap,
    /// What of an image file it shows.
    #[serde(default, skip_serializing_if = "ChannelEntry::is_default")]
    pub channel: ChannelEntry,
}

#[derive(Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum ChannelEntry {
    #[default]
    Color,
    Opacity,
    Data,
}

impl ChannelEntry {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

impl From<ChannelEntry> for Channel {
    fn from(entry: ChannelEntry) -> Self {
        match entry {
            ChannelEntry::Color => Self::Color,
            ChannelEntry::Opacity => Self::Mask,
            ChannelEntry::Data => Self::Data,
        }
    }
}

/// What meshes are shaded with.
#[derive(Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum NormalsEntry {
    #[default]
    Flat,
    Smooth,
    /// Normals of the mesh file.
    File,
}

#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OptimizeEntry {
    /// An image file, relative to the scene file.
    pub target: Option<PathBuf>,
    /// An image file, relative to the scene file.
    pub mask: Option<PathBuf>,
    #[serde(default, deserialize_with = "name_or_table")]
    pub loss: Option<LossKind>,
    pub coarse_to_fine: Option<u32>,
    pub batch: Option<usize>,
    pub resample: Option<bool>,
    pub starts: Option<u32>,
    pub seed: Option<u64>,
    pub learning_rate: Option<f64>,
    pub iterations: Option<u64>,
    pub tolerance: Option<f64>,
    pub gradient_tolerance: Option<f64>,
    #[serde(default, deserialize_with = "name_or_table")]
    pub optimizer: Option<Optimizer>,
    #[serde(default, deserialize_with = "name_or_table")]
    pub schedule: Option<Schedule>,
    #[serde(default, with = "ordered", skip_serializing_if = "Vec::is_empty")]
    pub target_values: Ordered<Numbers>,
    #[serde(default, rename = "parameter", skip_serializing_if = "Vec::is_empty")]
    pub parameters: Vec<ParameterEntry>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ParameterEntry {
    pub path: String,
    pub scale: Option<Scale>,
    pub learning_rate: Option<f64>,
    pub min: Option<Numbers>,
    pub max: Option<Numbers>,
    pub spread: Option<Numbers>,
    pub large_steps: Option<f64>,
    pub laplacian: Option<LaplacianEntry>,
    pub edge_length: Option<f64>,
    pub normal_consistency: Option<f64>,
    pub total_variation: Option<f64>,
    pub remesh: Option<Remeshing>,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with a `weight`: { weight = 0.1 }")]
pub(super) struct LaplacianEntry {
    pub weight: f64,
    #[serde(default)]
    pub weights: Weights,
}

fn default_weight() -> f64 {
    1.0
}

fn default_bounces() -> u32 {
    DEFAULT_BOUNCES
}

/// An array of as many elements as it is to have: serde takes the first of longer ones.
fn exactly<'de, T, D, const N: usize>(deserializer: D) -> Result<Option<[T; N]>, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    let elements = Vec::<T>::deserialize(deserializer)?;
    let count = elements.len();
    let array = elements.try_into();
    array.map(Some).map_err(|_| de::Error::custom(format!("needs {N} elements, has {count}")))
}
