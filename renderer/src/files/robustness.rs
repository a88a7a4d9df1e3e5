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

use super::{FileNormals, FileObjects, MeshFormat, load_image, load_mesh_with};
use crate::Error;
use crate::experiment::Experiment;

/// A file that is read without an error: its name, and its content.
type Seed = (&'static str, &'static [u8]);

/// A seed of the fuzz targets.
macro_rules! seed {
    ($path:literal) => {
        include_bytes!(concat!("../../../fuzz/seeds/", $path))
    };
}

/// What other files may name.
const NAMED: [Seed; 3] = [
    ("seed.obj", seed!("obj/seed.obj")),
    ("seed.mtl", seed!("mtl/seed.mtl")),
    ("seed.png", seed!("image/seed.png")),
];

fn seeds() -> Vec<Seed> {
    let mut seeds = NAMED.to_vec();
    seeds.extend::<[Seed; 3]>([
        ("seed.toml", seed!("scene/seed.toml")),
        ("seed.exr", seed!("image/seed.exr")),
        ("seed.jpg", seed!("image/seed.jpg")),
    ]);
    #[cfg(feature = "ply")]
    seeds.extend::<[Seed; 4]>([
        ("seed.ply", seed!("ply/ascii.ply")),
        ("seed.ply", seed!("ply/little_endian.ply")),
        ("seed.ply", seed!("ply/big_endian.ply")),
        ("seed.ply", seed!("ply/strips.ply")),
    ]);
    #[cfg(feature = "stl")]
    seeds.extend::<[Seed; 2]>([
        ("seed.stl", seed!("stl/ascii.stl")),
        ("seed.stl", seed!("stl/binary.stl")),
    ]);
    #[cfg(feature = "gltf")]
    seeds.extend::<[Seed; 3]>([
        ("seed.gltf", seed!("gltf/seed.gltf")),
        ("seed.gltf", seed!("gltf/sparse.gltf")),
        ("seed.glb", seed!("gltf/seed.glb")),
    ]);
    seeds
}

/// A folder with what files may name.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in NAMED {
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
            let normals =
                || load_mesh_with(&path, FileNormals::Read, FileObjects::Joined).map(|_| ());
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
        assert_eq!(load(folder.path(), name, content), Ok(()), "{name}");
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
        let (name, content) = *seed.get(&seeds);
        let mut content = content.to_vec();
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
