//! PLY files, good and bad.

use std::fs;

use renderer_core::scene::Normals;

use super::*;

const HEADER: &str = "\
ply
format ascii 1.0
comment a square and a triangle
element vertex 5
property float x
property float y
property uchar red
property double z
element face 2
property list uchar int vertex_indices
property float quality
end_header
";
const DATA: &str = "0 0 255 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n9 9 9 9\n4 0 1 2 3 0.5\n3 2 0 1 0.5\n";

fn load(bytes: impl AsRef<[u8]>) -> Result<Model, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scan.ply");
    fs::write(&path, bytes).unwrap();
    load_ply(&path)
}

fn refused(bytes: impl AsRef<[u8]>) -> String {
    let error = load(bytes).unwrap_err();
    let place = error.place.rsplit('/').next().unwrap().to_owned();
    format!("{place}: {}", error.problem)
}

/// The file in binary, each number by `f32`, `u8`, `f64` or `i32` to its bytes.
fn binary(format: &str, big: bool) -> Vec<u8> {
    let mut bytes = HEADER.replace("ascii", format).into_bytes();
    let mut push = |little: &[u8]| {
        let mut number = little.to_vec();
        if big {
            number.reverse();
        }
        bytes.extend(number);
    };
    for [x, y, z] in [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [9, 9, 9]] {
        push(&(x as f32).to_le_bytes());
        push(&(y as f32).to_le_bytes());
        push(&[255]);
        push(&f64::from(z).to_le_bytes());
    }
    for face in [&[0_i32, 1, 2, 3][..], &[2, 0, 1]] {
        push(&[face.len() as u8]);
        face.iter().for_each(|index| push(&index.to_le_bytes()));
        push(&0.5_f32.to_le_bytes());
    }
    bytes
}

#[test]
fn every_format_is_the_same_mesh() {
    let ascii = load(format!("{HEADER}{DATA}")).unwrap();
    let [mesh] = &ascii.meshes[..] else { panic!("one mesh") };
    assert_eq!(mesh.name, "scan");
    assert_eq!(mesh.vertices, [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [2, 0, 1]]);
    assert_eq!(mesh.materials, [0; 3]);
    let binaries = [binary("binary_little_endian", false), binary("binary_big_endian", true)];
    for bytes in binaries {
        assert_eq!(load(bytes).unwrap().meshes, ascii.meshes);
    }
}

#[test]
fn odd_but_clear_files_are_read() {
    let whole = load(format!("{HEADER}{DATA}")).unwrap().meshes;
    let odd = [
        format!("{HEADER}{DATA}").replace('\n', "\r\n"),
        format!("\u{feff}{HEADER}{DATA}"),
        format!("{HEADER}{}", DATA.replace(['\n', ' '], "\t\n")),
        format!("{}{DATA}", HEADER.replace("float", "float32").replace("uchar int", "int8 uint32")),
        format!("{}{DATA}", HEADER.replace("vertex_indices", "vertex_index")),
        format!(
            "{}{DATA}",
            HEADER.replace("element face", "obj_info x\nelement none 9\nelement face")
        ),
        format!("{HEADER}{DATA}and more that nobody asked for"),
        format!(
            "{}7\n{DATA}",
            HEADER.replace("element vertex", "element a 1\nproperty int b\nelement vertex")
        ),
        format!("{HEADER}{}", DATA.replace("1 0 0 0\n", "1e0 0 0 -0.0\n")),
    ];
    for text in odd {
        assert_eq!(load(&text).unwrap().meshes, whole, "{text}");
    }
    // Faces may stand first; one of two corners is a line.
    let text = "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int vertex_indices\n\
                element vertex 3\nproperty int x\nproperty int y\nproperty int z\nend_header\n\
                3 2 1 0\n2 0 1\n0 0 0\n1 0 0\n0 1 0\n";
    assert_eq!(load(text).unwrap().meshes[0].triangles, [[0, 1, 2]]);
    // An arrow head is cut at its notch.
    let notch = DATA.replace("1 1 0 0", "0.2 0.2 0 0");
    assert_eq!(load(format!("{HEADER}{notch}")).unwrap().meshes[0].triangles[..2].len(), 2);
}

#[test]
fn broken_headers_are_refused() {
    let cases = [
        ("ply\n", "plx\n", "scan.ply: is no PLY file"),
        ("ascii 1.0", "ascii 2.0", "scan.ply:2: `format ascii 2.0` is no line of a header"),
        ("ascii", "utf8", "scan.ply:2: no format `utf8`"),
        ("format ascii 1.0\n", "", "scan.ply: names no format"),
        ("vertex 5", "vertex -5", "scan.ply:4: the count of vertex is `-5`"),
        ("vertex 5", "vertex", "scan.ply:4: `element vertex` is no line"),
        ("element vertex 5\n", "", "scan.ply:4: a property stands before any element"),
        ("float x", "half x", "scan.ply:5: no type `half`"),
        ("float x", "float x y", "scan.ply:5: a property is a type and a name"),
        ("list uchar", "list float", "scan.ply:10: the count of the list vertex_indices is no int"),
        ("float x\n", "float w\n", "scan.ply: its vertices have no property x"),
        ("float y\n", "float x\n", "scan.ply: its vertices have the property x twice"),
        ("element face", "element fase", "scan.ply: has no element face"),
        ("element face", "element vertex", "scan.ply:9: the element vertex is defined twice"),
        ("element vertex", "element vertices", "scan.ply: has no element vertex"),
        ("vertex_indices", "corners", "scan.ply: its element face has no list vertex_indices"),
        ("end_header\n", "", "scan.ply:12: `0 0 255 0` is no line"),
    ];
    for (from, to, expected) in cases {
        assert!(HEADER.contains(from), "{from}");
        let refused = refused(format!("{}{DATA}", HEADER.replacen(from, to, 1)));
        assert!(refused.starts_with(expected), "{from} -> {to}: {refused}");
    }
    assert!(refused("").starts_with("scan.ply: is no PLY file"));
    assert!(refused("ply\n").starts_with("scan.ply: ends within the header"));
}

/// Every second triangle of a strip turns the other way; -1 ends one, and equal corners draw nothing.
#[test]
fn strips_are_triangles() {
    let header = HEADER.replace("element face 2", "element tristrips 1");
    let header = header.replace("list uchar", "list int").replace("property float quality\n", "");
    let vertices = DATA.split("4 0 1").next().unwrap();
    let strips = |list: &str| load(format!("{header}{vertices}{list}\n"));
    let model = strips("10 0 1 3 2 2 -1 0 3 1 -1").unwrap();
    let [mesh] = &model.meshes[..] else { panic!("one mesh") };
    let corners = |t: &[u32; 3]| t.map(|i| mesh.vertices[i as usize]);
    let [a, b, c, d] = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let expected = [[a, b, d], [d, b, c], [a, d, b]];
    assert_eq!(mesh.triangles.iter().map(corners).collect::<Vec<_>>(), expected);
    let error = strips("3 0 1 5").unwrap_err().problem;
    assert_eq!(error, "tristrips 1: names vertex 5 of 5, counted from 0");
    assert!(strips("2 0 -2").unwrap_err().problem.contains("names vertex -2"));
    assert!(strips("4 0 1 -1 2").unwrap_err().problem.contains("holds no triangles"));
}

#[test]
fn broken_data_is_refused() {
    let cases = [
        ("1 1 0 0", "1 nan 0 0", "scan.ply:15: vertex 3: y is NaN, not a finite number"),
        ("1 1 0 0", "1 1e999 0 0", "scan.ply:15: vertex 3: y is inf, not a finite number"),
        ("1 1 0 0", "1 x 0 0", "scan.ply:15: vertex 3: `x` is not a number"),
        ("4 0 1 2 3", "4 0 1 2 5", "scan.ply:18: face 1: names vertex 5 of 5"),
        ("4 0 1 2 3", "4 0 1 2 -1", "scan.ply:18: face 1: names vertex -1 of 5"),
        ("4 0 1 2 3", "4 0 1 2 1.5", "scan.ply:18: face 1: `1.5` is not an integer"),
        ("4 0 1 2 3", "nan 0 1 2 3", "scan.ply:18: face 1: `nan` is not an integer"),
        ("4 0 1 2 3", "-4 0 1 2 3", "scan.ply:18: face 1: a list has -4 items"),
        ("4 0 1 2 3", "1e18 0 1 2 3", "scan.ply:18: face 1: `0.5` is not an integer"),
        ("3 2 0 1 0.5\n", "", "scan.ply:19: face 2: the file ends before its data does"),
    ];
    for (from, to, expected) in cases {
        let refused = refused(format!("{HEADER}{}", DATA.replacen(from, to, 1)));
        assert!(refused.starts_with(expected), "{from} -> {to}: {refused}");
    }
    // Counts that nothing stands behind.
    for (from, to) in [("vertex 5", "vertex 18446744073709551615"), ("face 2", "face 99999999999")]
    {
        let refused = refused(format!("{}{DATA}", HEADER.replace(from, to)));
        assert!(
            refused.ends_with("`0.5` is not an integer") || refused.contains("ends before"),
            "{refused}"
        );
    }
    // A polygon that goes around the notch again and again.
    let header = HEADER.replace("uchar int", "ushort int");
    let many = format!("1004{}", " 0 1 2 3".repeat(251));
    let notch = DATA.replace("1 1 0 0", "0.2 0.2 0 0");
    let refusal = refused(format!("{header}{}", notch.replace("4 0 1 2 3", &many)));
    assert!(refusal.contains("face 1: a face of 1004 corners is not convex"), "{refusal}");
    let none = HEADER.replace("face 2", "face 0");
    assert!(refused(format!("{none}{DATA}")).contains("holds no triangles"));
    let whole = binary("binary_little_endian", false);
    let refusal = refused(&whole[..whole.len() - 1]);
    assert_eq!(refusal, "scan.ply: face 2: the file ends before its data does");
}

#[test]
fn texture_coordinates_are_read() {
    for [u, v] in [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]] {
        let header = HEADER
            .replace("double z", &format!("double z\nproperty float {u}\nproperty float {v}"));
        let rows = "0 0 255 0 0 0\n1 0 0 0 1 0\n1 1 0 0 1 1\n0 1 0 0 0 1\n9 9 9 9 9 9\n";
        let faces = DATA.split("9 9 9 9\n").nth(1).unwrap();
        let mesh = &load(format!("{header}{rows}{faces}")).unwrap().meshes[0];
        assert_eq!(mesh.texture_coordinates, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        let corners = mesh.triangles.iter().map(|corners| Some(*corners));
        assert_eq!(mesh.texture_triangles, corners.collect::<Vec<_>>());
        let broken =
            refused(format!("{header}{}{faces}", rows.replace("1 0 0 0 1 0", "1 0 0 0 1 nan")));
        assert!(
            broken.ends_with(&format!("vertex 2: {v} is NaN, not a finite number")),
            "{broken}"
        );
    }
    // One of the two is none.
    let header = HEADER.replace("property uchar red", "property uchar u");
    assert_eq!(load(format!("{header}{DATA}")).unwrap().meshes[0].texture_triangles, []);
}

#[test]
fn normals_are_read_where_they_are_wanted() {
    let read = |text: String, normals| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scan.ply");
        fs::write(&path, text).unwrap();
        read_ply(&path, normals)
    };
    let header = HEADER
        .replace("double z", "double z\nproperty float nx\nproperty double ny\nproperty char nz");
    let rows = "0 0 255 0 0 0 1\n1 0 0 0 0 0.5 1\n1 1 0 0 2 0 0\n0 1 0 0 0 0 1\n9 9 9 9 0 0 1\n";
    let faces = DATA.split("9 9 9 9\n").nth(1).unwrap();
    let text = format!("{header}{rows}{faces}");
    let mesh = &read(text.clone(), FileNormals::Read).unwrap().meshes[0];
    let directions = vec![[0.0, 0.0, 1.0], [0.0, 0.5, 1.0], [2.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let triangles = mesh.triangles.iter().copied().map(Some).collect();
    assert_eq!(mesh.normals, Normals::Given { directions, triangles });
    for (broken, expected) in [
        ("nan 0 0", "vertex 3: nx is NaN, not a finite number"),
        ("0 0 0", "vertex 3: a normal is the zero vector, which has no direction"),
    ] {
        let text = text.replace("2 0 0\n", &format!("{broken}\n"));
        let error = read(text.clone(), FileNormals::Read).unwrap_err().to_string();
        assert!(error.ends_with(&format!("scan.ply:18: {expected}")), "{error}");
        let mesh = &read(text, FileNormals::Ignore).unwrap().meshes[0];
        assert_eq!(mesh.normals, Normals::Flat);
    }
    let without = read(format!("{HEADER}{DATA}"), FileNormals::Read).unwrap();
    assert_eq!(without.meshes[0].normals, Normals::Flat);
}

#[test]
fn what_is_left_out_is_told() {
    let header = HEADER
        .replace("comment a", "comment TextureFile a.png\ncomment a")
        .replace("float quality", "list uchar float texcoord")
        .replace("element face", "element edge 1\nproperty int vertex1\nelement face");
    let data = DATA.replace(" 0.5", " 0").replace("4 0 1 2 3", "7\n4 0 1 2 3");
    let warnings = load(format!("{header}{data}")).unwrap().warnings;
    let after_file = |warning: &crate::Warning| {
        warning.to_string().split_once("scan.ply:").unwrap().1.to_owned()
    };
    let expected = [
        "3: the texture is left out; a material of a scene file may have one",
        "8: colours are left out",
        "10: the element edge is left out",
        "14: texture coordinates of faces are left out",
    ];
    assert_eq!(warnings.iter().map(after_file).collect::<Vec<_>>(), expected);
}
