//! STL files, good and bad.

use std::fs;

use super::*;

const SQUARE: &str = "\
solid square
  facet normal 0 0 1
    outer loop
      vertex 0 0 0
      vertex 1 0 0
      vertex 1 1 0
    endloop
  endfacet
  facet normal 0 0 1
    outer loop
      vertex 0 0 0
      vertex 1 1 0
      vertex -0.0 1 0
    endloop
  endfacet
endsolid square
";

fn binary_square() -> Vec<u8> {
    let mut bytes = b"solid, says the header, but it is binary".to_vec();
    bytes.resize(80, 0);
    bytes.extend(2_u32.to_le_bytes());
    for corners in [[0, 0, 1, 0, 1, 1], [0, 0, 1, 1, 0, 1]] {
        bytes.extend([0; 12]);
        for xy in corners.chunks(2) {
            for value in [xy[0], xy[1], 0] {
                bytes.extend((value as f32).to_le_bytes());
            }
        }
        bytes.extend([7, 7]);
    }
    bytes
}

fn load(bytes: impl AsRef<[u8]>) -> Result<Model, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.stl");
    fs::write(&path, bytes).unwrap();
    load_stl(&path)
}

fn refused(bytes: impl AsRef<[u8]>) -> String {
    let error = load(bytes).unwrap_err();
    let place = error.place.rsplit('/').next().unwrap().to_owned();
    format!("{place}: {}", error.problem)
}

#[test]
fn ascii_and_binary_are_the_same_mesh() {
    let ascii = load(SQUARE).unwrap();
    let [mesh] = &ascii.meshes[..] else { panic!("one mesh") };
    assert_eq!(mesh.name, "square");
    assert_eq!(mesh.vertices, [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(mesh.materials, [0, 0]);
    assert_eq!(ascii.materials[0].name, "default");

    let mut binary = load(binary_square()).unwrap();
    assert_eq!(binary.meshes[0].name, "part");
    binary.meshes[0].name = "square".to_owned();
    assert_eq!(binary.meshes, ascii.meshes);
}

#[test]
fn odd_but_clear_text_is_read() {
    let whole = load(SQUARE).unwrap().meshes;
    let odd = [
        SQUARE.replace('\n', "\r\n"),
        SQUARE.replace(' ', "\t"),
        SQUARE.to_uppercase().replace("SQUARE", "square"),
        format!("\u{feff}{SQUARE}"),
        format!("\n\n  {SQUARE}\n\n"),
        SQUARE.replace("endsolid square\n", ""),
        SQUARE.replace("vertex 1 1 0", "vertex 1.0E0 +1 0e-400"),
    ];
    for text in odd {
        assert_eq!(load(&text).unwrap().meshes, whole, "{text}");
    }
    let two = load(format!("{SQUARE}{}solid  empty\nendsolid\n", SQUARE.replace("square", "")));
    let names: Vec<String> = two.unwrap().meshes.into_iter().map(|mesh| mesh.name).collect();
    assert_eq!(names, ["square", "part"]);
    let twice = load(format!("{SQUARE}{SQUARE}")).unwrap();
    assert_eq!(twice.meshes[1].name, "square_2");
}

#[test]
fn broken_files_are_refused() {
    let cases = [
        ("vertex 1 0 0", "vertex 1 nan 0", "part.stl:5: nan is not a finite number"),
        ("vertex 1 0 0", "vertex 1 1e999 0", "part.stl:5: 1e999 is not a finite number"),
        ("vertex 1 0 0", "vertex 1 x 0", "part.stl:5: `x` is not a number"),
        ("vertex 1 0 0", "vertex 1 0", "part.stl:5: a vertex is 3 numbers, here are 2"),
        ("vertex 1 0 0\n", "", "part.stl:7: this facet has 2 vertices; it needs 3"),
        ("  endfacet\n  facet", "  facet", "part.stl:8: `facet` stands within a facet"),
        ("solid square\n  facet normal 0 0 1\n", "solid\n", "part.stl:2: `outer` stands outside"),
        ("outer loop", "outer loop\nf 1 2 3\n", "part.stl:4: `f` is no statement of STL"),
        ("  endfacet\nendsolid square\n", "", "part.stl:14: ends within a facet"),
    ];
    for (from, to, expected) in cases {
        let refused = refused(SQUARE.replacen(from, to, 1));
        assert!(refused.starts_with(expected), "{from} -> {to}: {refused}");
    }
    assert_eq!(refused("solid nothing\nendsolid nothing\n"), "part.stl: holds no triangles");
    assert!(refused("").contains("neither text that begins with `solid` nor has a header"));
    assert!(refused("soli").contains("is no STL file"));

    let binary = binary_square();
    // Its header begins like a text.
    assert!(refused(&binary[..binary.len() - 30]).contains("after the header there are"));
    let mut wrong_count = binary.clone();
    wrong_count[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    wrong_count[0] = b'x';
    let refusal = refused(&wrong_count);
    assert!(refusal.contains("4294967295 triangles") && refusal.contains("100 bytes"), "{refusal}");
    let mut infinite = binary.clone();
    infinite[84 + 50 + 12..][..4].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert_eq!(refused(&infinite), "part.stl: triangle 2: inf is not a finite number");
    let mut none = binary[..84].to_vec();
    none[80..84].fill(0);
    assert_eq!(refused(&none), "part.stl: holds no triangles");
}

/// Colours, in some programs.
#[test]
fn attribute_bytes_are_told_once() {
    let warnings = load(binary_square()).unwrap().warnings;
    let [warning] = &warnings[..] else { panic!("{warnings:?}") };
    assert!(warning.place.ends_with("part.stl: triangle 1"), "{warning}");
    assert_eq!(warning.problem, "the attribute bytes, often a colour, are left out");

    let mut plain = binary_square();
    for attribute in plain[HEADER..].chunks_exact_mut(TRIANGLE) {
        attribute[TRIANGLE - 2..].fill(0);
    }
    assert_eq!(load(plain).unwrap().warnings, []);
    assert_eq!(load(SQUARE).unwrap().warnings, []);
}
