//! Files that are broken at random: whatever they hold, reading them ends in a result or in one
//! clear line.
//!
//! `PROPTEST_CASES=100000 cargo test --release -p renderer robustness` looks longer: at so many changed
//! files of each format.

use std::fs;
use std::path::Path;

use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::TestRunner;

use super::{FileNormals, MeshFormat, load_image, load_mesh_with};
use crate::Error;
use crate::experiment::Experiment;

/// A file that is read without an error: its name, and its content.
type Seed = (&'static str, Vec<u8>);

const OBJ: &str = "mtllib seed.mtl\no a\nv 0 0 0 1.0\nv 1 0 0.5\nv 1 1 -1e0 0.5 0.5 0.5\nv 0 1 0\n\
                   v 0.2 0.5 0\nvt 0 0\nvt 1 0.5\nvn 0 0 1\nusemtl red\n\
                   f 1/1/1 2/2/1 3/1/1 4/-1/1 5/1/-1\nl 1 2\ns off\ng b\nusemtl blue\nf -1//1 -2 \\\n-3\n";
const MTL: &str = "newmtl red\nKa 1 1 1\nKd 0.5 0.25 0.125\nKs 0.1\nNs 10\nillum 2\nd 0.5\n\
                   map_Kd -s 2 2 1 -o 0.5 -clamp on -bm 1 seed.png\nnewmtl blue\nKd 0 0 1\nKe 0.5\n\
                   illum 3\nbump x.png\n";
const PLY: &str = "ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 4\n\
                   property float x\nproperty float y\nproperty float z\nproperty float u\n\
                   property float v\nelement face 1\nproperty list uchar int vertex_indices\n\
                   end_header\n0 0 0 0 0\n1 0 0 1 0\n0.2 0.2 0 0 0\n0 1 0 0 1\n4 0 1 2 3\n";
const STL: &str = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n\
                   endloop\nendfacet\nendsolid s\n";
const GLTF: &str = r#"{"asset":{"version":"2.0"},"extensions":{"KHR_lights_punctual":{"lights":[
{"type":"point"}]}},"nodes":[{"mesh":0,"children":[1,2]},{"camera":0,"translation":[0,0,3]},
{"extensions":{"KHR_lights_punctual":{"light":0}}}],"meshes":[{"primitives":[{"attributes":
{"POSITION":0,"TEXCOORD_1":2},"indices":1,"material":0}]}],"materials":[{"pbrMetallicRoughness":{
"baseColorFactor":[1,0.5,0,1],"baseColorTexture":{"index":0,"texCoord":1,"extensions":{
"KHR_texture_transform":{"offset":[0.5,0],"rotation":1,"scale":[2,1]}}}},"emissiveFactor":[1,0,0],
"alphaMode":"MASK"}],"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071}],"images":[{
"uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg=="}],
"cameras":[{"perspective":{"yfov":0.5}}],"accessors":[
{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},
{"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"}],"bufferViews":[
{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],"buffers":[
{"byteLength":60,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAABAAIAAAACAAMA"}]}"#;
const TOML: &str = "[camera]\nlook_from = [0, 0, 5]\nlook_at = [0, 0, 0]\nwidth = 8\nheight = 6\n\
                    [[light]]\nname = \"key\"\ntype = \"point\"\nposition = [1, 2, 3]\n\
                    radiant_intensity = 9.0\n[[sphere]]\nname = \"ball\"\ncenter = [0, 0, 0]\nradius = 1\n\
                    material = \"paint\"\n[[mesh]]\npath = \"seed.obj\"\nname = \"all\"\n\
                    material = \"paint\"\nnormals = \"file\"\n[material.paint]\ndiffuse = [0.5, 0.5, 0.5]\n[optimize]\n\
                    optimizer = { type = \"adam\", beta1 = 0.8 }\nschedule = \"cosine\"\n\
                    target_values = { \"light.key.color\" = [1, 0, 0] }\n\
                    [[optimize.parameter]]\npath = \"light.key.color\"\nmin = 0\nmax = [2, 2, 2]\n";

fn binary_ply(format: &str, bytes: fn(f32) -> [u8; 4], index: fn(i32) -> [u8; 4]) -> Vec<u8> {
    let header = PLY.split("0 0 0 0 0\n").next().unwrap().replace("ascii", format);
    let mut file = header.into_bytes();
    for [x, y, u] in [[0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.2, 0.2, 0.0], [0.0, 1.0, 0.0]] {
        file.extend([x, y, 0.0, u, y].map(bytes).as_flattened());
    }
    file.push(4);
    file.extend([0, 1, 2, 3].map(index).as_flattened());
    file
}

fn binary_stl() -> Vec<u8> {
    let mut file = vec![b' '; 80];
    file.extend(1_u32.to_le_bytes());
    let numbers = [0.0_f32, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    file.extend(numbers.map(f32::to_le_bytes).as_flattened());
    file.extend([0, 0]);
    file
}

/// The file in binary, its buffer in a chunk of its own.
fn glb() -> Vec<u8> {
    let (before, data) = GLTF.split_once("\"byteLength\":60,\"uri\":").unwrap();
    let (_, after) = data.split_once("\"}").unwrap();
    let mut json = format!("{before}\"byteLength\":60}}{after}").into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let positions = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    let mut binary = positions.map(f32::to_le_bytes).as_flattened().to_vec();
    binary.extend([0_u16, 1, 2, 0, 2, 3].map(u16::to_le_bytes).as_flattened());
    let mut file = b"glTF\x02\0\0\0".to_vec();
    file.extend((28 + json.len() as u32 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", json), (b"BIN\0", binary)] {
        file.extend((chunk.len() as u32).to_le_bytes());
        file.extend(kind);
        file.extend(chunk);
    }
    file
}

fn jpeg() -> Vec<u8> {
    let grey: Vec<u8> = (0..63).map(|index| 20 * (index % 9) + 9 * (index / 9)).collect();
    let mut bytes = Vec::new();
    let encoder = jpeg_encoder::Encoder::new(&mut bytes, 80);
    encoder.encode(&grey, 9, 7, jpeg_encoder::ColorType::Luma).unwrap();
    bytes
}

fn image(name: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    let pixels = (0..12).map(|i| [i as f32 / 12.0, 0.5, 0.1]).collect();
    let image = crate::Image { width: 4, height: 3, pixels };
    super::save_image(&image, &path).unwrap();
    fs::read(&path).unwrap()
}

fn seeds() -> Vec<Seed> {
    vec![
        ("seed.obj", OBJ.into()),
        ("seed.mtl", MTL.into()),
        ("seed.toml", TOML.into()),
        ("seed.png", image("a.png")),
        ("seed.exr", image("a.exr")),
        ("seed.jpg", jpeg()),
        #[cfg(feature = "ply")]
        ("seed.ply", PLY.into()),
        #[cfg(feature = "ply")]
        ("seed.ply", binary_ply("binary_little_endian", f32::to_le_bytes, i32::to_le_bytes)),
        #[cfg(feature = "ply")]
        ("seed.ply", binary_ply("binary_big_endian", f32::to_be_bytes, i32::to_be_bytes)),
        #[cfg(feature = "ply")]
        ("seed.ply", include_bytes!("../../../fuzz/seeds/ply/strips.ply").into()),
        #[cfg(feature = "stl")]
        ("seed.stl", STL.into()),
        #[cfg(feature = "stl")]
        ("seed.stl", binary_stl()),
        #[cfg(feature = "gltf")]
        ("seed.gltf", GLTF.into()),
        #[cfg(feature = "gltf")]
        ("seed.gltf", include_bytes!("../../../fuzz/seeds/gltf/sparse.gltf").into()),
        #[cfg(feature = "gltf")]
        ("seed.glb", glb()),
    ]
}

/// A folder with what files may name.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in
        [("seed.obj", OBJ.into()), ("seed.mtl", MTL.into()), ("seed.png", image("a.png"))]
    {
        fs::write(folder.path().join(name), content).unwrap();
    }
    folder
}

/// Reads `content` as the file `name`, which a mesh that stands beside it may name.
fn load(folder: &Path, name: &str, content: &[u8]) -> Result<(), Error> {
    let path = folder.join(name);
    let before = fs::read(&path).ok();
    fs::write(&path, content).unwrap();
    let result = match path.extension().and_then(|extension| extension.to_str()) {
        Some("png" | "exr" | "jpg") => {
            let texture = Experiment::load(&folder.join("seed.obj")).map(|_| ());
            load_image(&path).map(|_| ()).and(texture)
        }
        Some("mtl") => Experiment::load(&folder.join("seed.obj")).map(|_| ()),
        _ => {
            let is_mesh = MeshFormat::of(&path).is_some();
            let normals = || load_mesh_with(&path, FileNormals::Read).map(|_| ());
            let normals = if is_mesh { normals() } else { Ok(()) };
            Experiment::load(&path).map(|_| ()).and(normals)
        }
    };
    if let Some(before) = before {
        fs::write(&path, before).unwrap();
    }
    result
}

/// Whether a result is one that a person can use.
fn is_clear(result: &Result<(), Error>) -> bool {
    match result {
        Ok(()) => true,
        Err(error) => {
            let line = error.to_string();
            !error.problem.trim().is_empty() && !line.contains(['\n', '\r']) && line.len() < 2000
        }
    }
}

#[test]
fn seeds_are_read() {
    let folder = folder();
    for (name, content) in seeds() {
        assert_eq!(load(folder.path(), name, &content), Ok(()), "{name}");
    }
}

#[test]
fn files_cut_short_anywhere_are_read_or_refused() {
    let folder = folder();
    for (name, content) in seeds() {
        for end in 0..content.len() {
            let result = load(folder.path(), name, &content[..end]);
            assert!(is_clear(&result), "{name} {end}: {result:?}");
        }
    }
}

/// One change of a file.
#[derive(Clone, Debug)]
enum Change {
    Replace { at: usize, by: u8 },
    Insert { at: usize, text: &'static str },
    Remove { at: usize, count: usize },
    Double { at: usize, count: usize },
    Swap { a: usize, b: usize },
}

/// What breaks parsers, as text.
const TROUBLE: [&str; 22] = [
    "-1",
    "0",
    "nan",
    "inf",
    "-inf",
    "1e999",
    "-1e-999",
    "1e38",
    "1e18",
    "4294967295",
    "18446744073709551616",
    "9999999999",
    "\n",
    "\r\n",
    "\\\n",
    "\t",
    " ",
    "\u{feff}",
    "\u{0}",
    "#",
    "\"",
    "é",
];

fn change() -> impl Strategy<Value = Change> {
    let at = any::<usize>;
    prop_oneof![
        (at(), any::<u8>()).prop_map(|(at, by)| Change::Replace { at, by }),
        (at(), prop::sample::select(&TROUBLE[..]))
            .prop_map(|(at, text)| Change::Insert { at, text }),
        (at(), 1_usize..20).prop_map(|(at, count)| Change::Remove { at, count }),
        (at(), 1_usize..40).prop_map(|(at, count)| Change::Double { at, count }),
        (at(), at()).prop_map(|(a, b)| Change::Swap { a, b }),
    ]
}

fn apply(content: &mut Vec<u8>, change: &Change) {
    let len = content.len();
    if len == 0 {
        return;
    }
    match *change {
        Change::Replace { at, by } => content[at % len] = by,
        Change::Insert { at, text } => {
            let at = at % len;
            content.splice(at..at, text.bytes());
        }
        Change::Remove { at, count } => {
            let at = at % len;
            content.drain(at..(at + count).min(len));
        }
        Change::Double { at, count } => {
            let at = at % len;
            let piece = content[at..(at + count).min(len)].to_vec();
            content.splice(at..at, piece);
        }
        Change::Swap { a, b } => content.swap(a % len, b % len),
    }
}

/// Reads as many changed files of a format as `PROPTEST_CASES` says.
fn read_changed(extensions: &[&str]) {
    let is_meant = |name: &str| extensions.iter().any(|extension| name.ends_with(extension));
    let seeds: Vec<Seed> = seeds().into_iter().filter(|(name, _)| is_meant(name)).collect();
    let folder = folder();
    let config = ProptestConfig { source_file: Some(file!()), ..ProptestConfig::default() };
    let cases = (any::<Index>(), prop::collection::vec(change(), 1..6));
    let result = TestRunner::new(config).run(&cases, |(seed, changes)| {
        let (name, mut content) = seed.get(&seeds).clone();
        changes.iter().for_each(|change| apply(&mut content, change));
        let result = load(folder.path(), name, &content);
        prop_assert!(is_clear(&result), "{}: {:?}", name, result);
        Ok(())
    });
    if let Err(error) = result {
        panic!("{error}");
    }
}

macro_rules! changed_files_are_read_or_refused {
    ($($(#[$feature:meta])* $format:ident: $extensions:expr,)*) => {
        $(
            $(#[$feature])*
            #[test]
            fn $format() {
                read_changed(&$extensions);
            }
        )*
    };
}

changed_files_are_read_or_refused! {
    changed_obj: ["obj"],
    changed_mtl: ["mtl"],
    changed_scene_files: ["toml"],
    changed_png: ["png"],
    changed_exr: ["exr"],
    changed_jpeg: ["jpg"],
    #[cfg(feature = "ply")]
    changed_ply: ["ply"],
    #[cfg(feature = "stl")]
    changed_stl: ["stl"],
    #[cfg(feature = "gltf")]
    changed_gltf: ["gltf", "glb"],
}
