//! The document, as far as it is read.

use std::collections::HashMap;

use serde::Deserialize;
use serde::de::IgnoredAny;

/// The extensions that are read.
const EXTENSIONS: [&str; 7] = [
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
];

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Document {
    asset: Asset,
    #[serde(default)]
    extensions_required: Vec<String>,
    #[serde(default)]
    extensions_used: Vec<String>,
    pub scene: Option<usize>,
    #[serde(default)]
    pub scenes: Vec<Scene>,
    #[serde(default)]
    pub nodes: Vec<Node>,
    #[serde(default)]
    pub meshes: Vec<Mesh>,
    #[serde(default)]
    pub materials: Vec<Material>,
    #[serde(default)]
    pub textures: Vec<Texture>,
    #[serde(default)]
    pub images: Vec<Image>,
    #[serde(default)]
    pub samplers: Vec<Sampler>,
    #[serde(default)]
    pub animations: Vec<IgnoredAny>,
    #[serde(default)]
    pub cameras: Vec<Camera>,
    #[serde(default)]
    pub accessors: Vec<Accessor>,
    #[serde(default)]
    pub buffer_views: Vec<BufferView>,
    #[serde(default)]
    pub buffers: Vec<Buffer>,
    #[serde(default)]
    pub extensions: Extensions,
}

#[derive(Deserialize)]
struct Asset {
    version: String,
}

#[derive(Deserialize)]
pub(super) struct Scene {
    #[serde(default)]
    pub nodes: Vec<usize>,
}

#[derive(Deserialize)]
pub(super) struct Node {
    pub name: Option<String>,
    pub mesh: Option<usize>,
    pub skin: Option<IgnoredAny>,
    pub camera: Option<usize>,
    #[serde(default)]
    pub children: Vec<usize>,
    /// The 4 x 4 matrix of a node, column by column.
    pub matrix: Option<[f64; 16]>,
    pub translation: Option<[f64; 3]>,
    /// A quaternion, its real part last.
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
    #[serde(default)]
    pub extensions: NodeExtensions,
}

#[derive(Default, Deserialize)]
pub(super) struct NodeExtensions {
    #[serde(rename = "KHR_lights_punctual")]
    pub light: Option<LightReference>,
}

#[derive(Deserialize)]
pub(super) struct LightReference {
    pub light: usize,
}

#[derive(Default, Deserialize)]
pub(super) struct Extensions {
    #[serde(default, rename = "KHR_lights_punctual")]
    pub lights: Lights,
}

#[derive(Default, Deserialize)]
pub(super) struct Lights {
    #[serde(default)]
    pub lights: Vec<LightDefinition>,
}

#[derive(Deserialize)]
pub(super) struct LightDefinition {
    pub name: Option<String>,
    #[serde(rename = "type")]
    pub kind: String,
    #[serde(default = "white")]
    pub color: [f64; 3],
    #[serde(default = "one")]
    pub intensity: f64,
    pub spot: Option<Spot>,
}

/// The angles of a spot light, radians from its axis.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Spot {
    #[serde(default)]
    pub inner_cone_angle: f64,
    #[serde(default = "eighth_turn")]
    pub outer_cone_angle: f64,
}

#[derive(Deserialize)]
pub(super) struct Mesh {
    pub name: Option<String>,
    pub primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
pub(super) struct Primitive {
    /// Accessors by name: `POSITION`, `TEXCOORD_0`, ...
    #[serde(default)]
    pub attributes: HashMap<String, usize>,
    pub indices: Option<usize>,
    pub material: Option<usize>,
    #[serde(default = "triangles")]
    pub mode: u32,
    pub targets: Option<IgnoredAny>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Material {
    pub name: Option<String>,
    #[serde(default)]
    pub pbr_metallic_roughness: Pbr,
    /// Linear.
    #[serde(default)]
    pub emissive_factor: [f64; 3],
    pub emissive_texture: Option<TextureInfo>,
    pub normal_texture: Option<NormalTextureInfo>,
    pub occlusion_texture: Option<IgnoredAny>,
    pub alpha_mode: Option<String>,
    pub alpha_cutoff: Option<f64>,
    #[serde(default)]
    pub extensions: MaterialExtensions,
}

#[derive(Default, Deserialize)]
pub(super) struct MaterialExtensions {
    #[serde(default, rename = "KHR_materials_emissive_strength")]
    pub emissive_strength: EmissiveStrength,
    /// There if light does not matter: the base colour is what is seen.
    #[serde(rename = "KHR_materials_unlit")]
    pub unlit: Option<IgnoredAny>,
    #[serde(rename = "KHR_materials_ior")]
    pub ior: Option<Ior>,
    #[serde(rename = "KHR_materials_transmission")]
    pub transmission: Option<Transmission>,
    /// Whether a surface is that of a solid. How a solid absorbs light is left out.
    #[serde(rename = "KHR_materials_volume")]
    pub volume: Option<IgnoredAny>,
}

/// What the emission is multiplied by.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct EmissiveStrength {
    pub emissive_strength: f64,
}

impl Default for EmissiveStrength {
    fn default() -> Self {
        Self { emissive_strength: 1.0 }
    }
}

#[derive(Clone, Copy, Deserialize)]
#[serde(default)]
pub(super) struct Ior {
    pub ior: f64,
}

impl Default for Ior {
    fn default() -> Self {
        Self { ior: 1.5 }
    }
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Transmission {
    pub transmission_factor: f64,
    pub transmission_texture: Option<IgnoredAny>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Pbr {
    /// Linear.
    pub base_color_factor: [f64; 4],
    pub base_color_texture: Option<TextureInfo>,
    pub metallic_factor: Option<f64>,
    pub roughness_factor: f64,
    pub metallic_roughness_texture: Option<TextureInfo>,
}

impl Default for Pbr {
    fn default() -> Self {
        Self {
            base_color_factor: [1.0; 4],
            base_color_texture: None,
            metallic_factor: None,
            roughness_factor: 1.0,
            metallic_roughness_texture: None,
        }
    }
}

/// Which texture, and where on it.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct TextureInfo {
    pub index: usize,
    /// The number of the set of texture coordinates.
    #[serde(default)]
    pub tex_coord: usize,
    #[serde(default)]
    pub extensions: TextureInfoExtensions,
}

/// A texture of normals, and how much it bends.
#[derive(Deserialize)]
pub(super) struct NormalTextureInfo {
    #[serde(flatten)]
    pub info: TextureInfo,
    #[serde(default = "one")]
    pub scale: f64,
}

#[derive(Default, Deserialize)]
pub(super) struct TextureInfoExtensions {
    #[serde(rename = "KHR_texture_transform")]
    pub transform: Option<TextureTransform>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct TextureTransform {
    #[serde(default)]
    pub offset: [f64; 2],
    /// An angle in radians.
    #[serde(default)]
    pub rotation: f64,
    #[serde(default = "ones")]
    pub scale: [f64; 2],
    /// Replaces that of the texture.
    pub tex_coord: Option<usize>,
}

#[derive(Deserialize)]
pub(super) struct Texture {
    pub source: Option<usize>,
    pub sampler: Option<usize>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Image {
    pub name: Option<String>,
    pub uri: Option<String>,
    pub buffer_view: Option<usize>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Sampler {
    pub wrap_s: Option<u32>,
    pub wrap_t: Option<u32>,
    pub mag_filter: Option<u32>,
}

#[derive(Deserialize)]
pub(super) struct Camera {
    pub perspective: Option<Perspective>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Perspective {
    /// An angle in radians.
    pub yfov: f64,
    pub aspect_ratio: Option<f64>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub buffer_view: Option<usize>,
    #[serde(default)]
    pub byte_offset: usize,
    pub component_type: u32,
    #[serde(default)]
    pub normalized: bool,
    pub count: usize,
    #[serde(rename = "type")]
    pub shape: String,
    pub sparse: Option<Sparse>,
}

/// Elements of an accessor that are listed one by one.
#[derive(Deserialize)]
pub(super) struct Sparse {
    pub count: usize,
    pub indices: SparseIndices,
    pub values: SparseValues,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparseIndices {
    pub buffer_view: usize,
    #[serde(default)]
    pub byte_offset: usize,
    pub component_type: u32,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparseValues {
    pub buffer_view: usize,
    #[serde(default)]
    pub byte_offset: usize,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: usize,
    pub byte_length: usize,
    pub byte_stride: Option<usize>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Buffer {
    pub uri: Option<String>,
    pub byte_length: usize,
}

fn white() -> [f64; 3] {
    [1.0; 3]
}

fn eighth_turn() -> f64 {
    std::f64::consts::FRAC_PI_4
}

fn one() -> f64 {
    1.0
}

fn ones() -> [f64; 2] {
    [1.0; 2]
}

fn triangles() -> u32 {
    4
}

impl Document {
    /// Parses a document of version 2 that requires no extension but known ones.
    pub fn parse(json: &[u8]) -> Result<Self, String> {
        let json = json.strip_prefix("\u{feff}".as_bytes()).unwrap_or(json);
        let document: Self =
            serde_json::from_slice(json).map_err(|error| format!("is not glTF: {error}"))?;
        let version = &document.asset.version;
        if version.split('.').next() != Some("2") {
            return Err(format!("is glTF of version {version}; version 2 is read"));
        }
        match document.extensions_required.iter().find(|name| !is_read(name)) {
            Some(name) => Err(format!("requires the extension {name}, which is not read")),
            None => Ok(document),
        }
    }

    /// The extensions that it can do without, and has to here.
    pub fn unread_extensions(&self) -> impl Iterator<Item = &str> {
        self.extensions_used.iter().map(String::as_str).filter(|name| !is_read(name))
    }
}

fn is_read(extension: &str) -> bool {
    EXTENSIONS.contains(&extension)
}

/// An element of one of the document's arrays.
pub(super) fn get<'a, T>(array: &'a [T], index: usize, name: &str) -> Result<&'a T, String> {
    array.get(index).ok_or_else(|| format!("there is no {name}[{index}], of {}", array.len()))
}
