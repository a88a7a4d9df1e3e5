//! The scene file as it is written down.

use std::collections::HashMap;
use std::fmt;
use std::marker::PhantomData;
use std::path::PathBuf;

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, Deserializer, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};

use crate::files::model::Channel;
use crate::loss::LossKind;
use crate::optimize::{Optimizer, Schedule};
use crate::scene::{DEFAULT_BOUNCES, Wrap};

/// A table whose order is kept.
pub(super) type Ordered<T> = Vec<(String, T)>;

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneFile {
    #[serde(default = "default_bounces")]
    pub bounces: u32,
    pub camera: CameraEntry,
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
    #[serde(skip_serializing_if = "Option::is_none")]
    pub optimize: Option<OptimizeEntry>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CameraEntry {
    pub look_from: [f64; 3],
    pub look_at: [f64; 3],
    #[serde(default = "y_axis")]
    pub up: [f64; 3],
    /// In degrees.
    #[serde(default = "default_vfov")]
    pub vfov: f64,
    #[serde(default = "one")]
    pub focus: f64,
    pub width: u32,
    pub height: u32,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LightEntry {
    pub name: String,
    #[serde(rename = "type")]
    pub kind: LightKind,
    /// Of a point light.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<[f64; 3]>,
    /// Of a distant light, towards it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<[f64; 3]>,
    #[serde(default = "white")]
    pub color: [f64; 3],
    pub intensity: f64,
}

#[derive(Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum LightKind {
    Point,
    Distant,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshEntry {
    /// Relative to the scene file.
    pub path: PathBuf,
    /// If given, all objects of the file are one mesh of this name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// If given, replaces all materials.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SphereEntry {
    pub name: String,
    pub center: [f64; 3],
    pub radius: f64,
    pub material: String,
}

#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MaterialEntry {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ambient: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diffuse: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub specular: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exponent: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reflection: Option<[f64; 3]>,
    /// If given, the material is transparent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub opacity: Option<f64>,
    /// Names of textures. One of the opacity makes the material transparent, too.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ambient_texture: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diffuse_texture: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub specular_texture: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub opacity_texture: Option<String>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TextureEntry {
    /// An image file, relative to the scene file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<PathBuf>,
    /// Width and height of a texture without file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size: Option<[u32; 2]>,
    /// The colour of a texture without file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub color: Option<[f64; 3]>,
    #[serde(default)]
    pub wrap: WrapEntry,
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
        }
    }
}

#[derive(Clone, Copy, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum WrapEntry {
    #[default]
    Repeat,
    Clamp,
    Mirror,
}

impl From<WrapEntry> for Wrap {
    fn from(entry: WrapEntry) -> Self {
        match entry {
            WrapEntry::Repeat => Self::Repeat,
            WrapEntry::Clamp => Self::Clamp,
            WrapEntry::Mirror => Self::Mirror,
        }
    }
}

impl From<Wrap> for WrapEntry {
    fn from(wrap: Wrap) -> Self {
        match wrap {
            Wrap::Repeat => Self::Repeat,
            Wrap::Clamp => Self::Clamp,
            Wrap::Mirror => Self::Mirror,
        }
    }
}

#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OptimizeEntry {
    /// An image file, relative to the scene file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<PathBuf>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss: Option<LossKind>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub learning_rate: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub iterations: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gradient_tolerance: Option<f64>,
    #[serde(default, deserialize_with = "name_or_table", skip_serializing_if = "Option::is_none")]
    pub optimizer: Option<Optimizer>,
    #[serde(default, deserialize_with = "name_or_table", skip_serializing_if = "Option::is_none")]
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
    #[serde(skip_serializing_if = "Option::is_none")]
    pub learning_rate: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min: Option<Numbers>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max: Option<Numbers>,
}

/// A number, or an array of them.
#[derive(Clone)]
pub(super) enum Numbers {
    One(f64),
    Many(Vec<f64>),
}

fn y_axis() -> [f64; 3] {
    [0.0, 1.0, 0.0]
}

fn white() -> [f64; 3] {
    [1.0; 3]
}

fn one() -> f64 {
    1.0
}

fn default_bounces() -> u32 {
    DEFAULT_BOUNCES
}

fn default_vfov() -> f64 {
    45.0
}

impl Serialize for Numbers {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Numbers::One(value) => value.serialize(serializer),
            Numbers::Many(values) => values.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Numbers {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NumbersVisitor;

        impl<'de> Visitor<'de> for NumbersVisitor {
            type Value = Numbers;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a number or an array of numbers")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Numbers, E> {
                Ok(Numbers::One(value))
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Numbers, E> {
                Ok(Numbers::One(value as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut values: A) -> Result<Numbers, A::Error> {
                let mut numbers = Vec::new();
                while let Some(number) = values.next_element()? {
                    numbers.push(number);
                }
                Ok(Numbers::Many(numbers))
            }
        }

        deserializer.deserialize_any(NumbersVisitor)
    }
}

/// A table with a `type`, or that type alone.
fn name_or_table<'de, T, D>(deserializer: D) -> Result<Option<T>, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    struct NameOrTable<T>(PhantomData<T>);

    impl<'de, T: Deserialize<'de>> Visitor<'de> for NameOrTable<T> {
        type Value = T;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "a name or a table with a `type`")
        }

        fn visit_str<E: de::Error>(self, name: &str) -> Result<T, E> {
            T::deserialize(HashMap::from([("type", name)]).into_deserializer())
        }

        fn visit_map<A: MapAccess<'de>>(self, table: A) -> Result<T, A::Error> {
            T::deserialize(MapAccessDeserializer::new(table))
        }
    }

    deserializer.deserialize_any(NameOrTable(PhantomData)).map(Some)
}

/// Tables as a list of their entries, in the order of the file.
mod ordered {
    use std::fmt;
    use std::marker::PhantomData;

    use serde::de::{Deserializer, MapAccess, Visitor};
    use serde::{Deserialize, Serialize, Serializer};

    use super::Ordered;

    pub fn serialize<T: Serialize, S: Serializer>(
        entries: &Ordered<T>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_map(entries.iter().map(|(key, value)| (key, value)))
    }

    pub fn deserialize<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Ordered<T>, D::Error> {
        struct Entries<T>(PhantomData<T>);

        impl<'de, T: Deserialize<'de>> Visitor<'de> for Entries<T> {
            type Value = Ordered<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a table")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Ordered<T>, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(entries)
            }
        }

        deserializer.deserialize_map(Entries(PhantomData))
    }
}
