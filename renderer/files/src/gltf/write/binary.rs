//! The binary chunk of a `.glb`, and the file around it.

use serde_json::{Map, Value, json};

use crate::gltf::buffers::{BINARY_CHUNK, JSON_CHUNK, MAGIC};

/// Every part of the file begins at a multiple of so many bytes.
const ALIGNMENT: usize = 4;
/// What views are for: attributes of vertices, or indices of triangles.
const VERTICES: u32 = 34962;
const TRIANGLES: u32 = 34963;
/// The types of components.
const U16: u32 = 5123;
const U32: u32 = 5125;
const F32: u32 = 5126;

/// The bytes of the file, and the views and accessors into them.
#[derive(Default)]
pub(super) struct Binary {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Binary {
    /// Adds bytes as they are; the index of the view.
    pub fn view(&mut self, bytes: &[u8]) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(ALIGNMENT), 0);
        let view = json!({
            "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len(),
        });
        self.views.push(view);
        self.bytes.extend(bytes);
        self.views.len() - 1
    }

    /// Adds an attribute of vertices, in single precision; the index of the accessor.
    pub fn vectors<const N: usize>(&mut self, vectors: impl Iterator<Item = [f64; N]>) -> usize {
        let vectors: Vec<[f32; N]> = vectors.map(|vector| vector.map(|x| x as f32)).collect();
        let extreme = |choose: fn(f32, f32) -> f32| -> [f32; N] {
            let all = vectors.iter().copied();
            let pick = |a: [f32; N], b: [f32; N]| std::array::from_fn(|i| choose(a[i], b[i]));
            all.reduce(pick).unwrap_or([0.0; N])
        };
        let (min, max) = (extreme(f32::min), extreme(f32::max));
        let bytes: Vec<u8> = vectors.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
        let accessor = json!({
            "componentType": F32, "count": vectors.len(), "type": format!("VEC{N}"),
            "min": &min[..], "max": &max[..],
        });
        self.accessor(&bytes, VERTICES, accessor)
    }

    /// Adds indices of so many vertices; the index of the accessor.
    pub fn indices(&mut self, indices: &[u32], vertices: usize) -> usize {
        // The largest number of a type stands for the end of a strip.
        let is_short = vertices <= usize::from(u16::MAX);
        let bytes: Vec<u8> = match is_short {
            true => indices.iter().flat_map(|&index| (index as u16).to_le_bytes()).collect(),
            false => indices.iter().flat_map(|index| index.to_le_bytes()).collect(),
        };
        let component = if is_short { U16 } else { U32 };
        let accessor =
            json!({ "componentType": component, "count": indices.len(), "type": "SCALAR" });
        self.accessor(&bytes, TRIANGLES, accessor)
    }

    fn accessor(&mut self, bytes: &[u8], target: u32, mut accessor: Value) -> usize {
        let view = self.view(bytes);
        self.views[view]["target"] = target.into();
        accessor["bufferView"] = view.into();
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// The file of a document.
    ///
    /// # Errors
    ///
    /// If it is longer than the format can say.
    pub fn file(mut self, mut document: Map<String, Value>) -> Result<Vec<u8>, String> {
        self.bytes.resize(self.bytes.len().next_multiple_of(ALIGNMENT), 0);
        document.insert("buffers".to_owned(), json!([{ "byteLength": self.bytes.len() }]));
        document.insert("bufferViews".to_owned(), self.views.into());
        document.insert("accessors".to_owned(), self.accessors.into());
        let mut json = Value::Object(document).to_string().into_bytes();
        json.resize(json.len().next_multiple_of(ALIGNMENT), b' ');
        let length = MAGIC.len() + 8 + 8 + json.len() + 8 + self.bytes.len();
        let length_of = |length: usize| {
            u32::try_from(length)
                .map_err(|_| format!("would have {length} bytes; a .glb has less than 4 GiB"))
        };
        let mut file = MAGIC.to_vec();
        file.extend(2_u32.to_le_bytes());
        file.extend(length_of(length)?.to_le_bytes());
        for (kind, chunk) in [(JSON_CHUNK, &json), (BINARY_CHUNK, &self.bytes)] {
            file.extend(length_of(chunk.len())?.to_le_bytes());
            file.extend(kind.to_le_bytes());
            file.extend(chunk);
        }
        Ok(file)
    }
}
