//! OBJ files, good and bad.

use std::fs;

use glam::DVec3;
use renderer_core::scene::{Material, MaterialObject, Mesh, Normals, Transform};

use super::*;

/// A folder with the given files.
pub(super) fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn load(text: &str) -> Model {
    load_obj(&folder(&[("a.obj", text)]).path().join("a.obj")).unwrap()
}

/// What is said of `a.obj`, or of one of its materials, from the name of the file on.
pub(super) fn refused(files: &[(&str, &str)]) -> String {
    let folder = folder(files);
    let loaded = load_obj(&folder.path().join("a.obj"));
    let error = loaded.unwrap_err().to_string();
    assert!(!error.contains('\n'), "{error}");
    let prefix = format!("{}/", folder.path().display());
    error.strip_prefix(&prefix).unwrap_or_else(|| panic!("names no file: {error}")).to_owned()
}

pub(super) const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn objects_materials_and_groups() {
    let text = "mtllib two words.mtl\n\
        o left\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
        usemtl red\nf 1 2 3\nusemtl blue\ng part\nf 1 3 4\n\
        o right\nv 5 0 0\nv 6 0 0\nv 6 1 0\nusemtl red\nf -3 -2 -1\n";
    let library = "newmtl red\nKa 1 1 1\nKd 0.5 0.25 0.125\nKs 0.1 0.2 0.3\nNs 10\nillum 2\n\
        map_Kd x.png\nnewmtl blue\nKd 0.5\n";
    let folder = folder(&[("a.obj", text), ("two words.mtl", library)]);
    let model = load_obj(&folder.path().join("a.obj")).unwrap();

    let names: Vec<&str> = model.meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(names, ["left", "right"]);
    // The two materials of the left object share its vertices.
    assert_eq!(model.meshes[0].vertices.len(), 4);
    assert_eq!(model.meshes[0].triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(model.meshes[0].materials, [0, 1]);
    assert_eq!(model.meshes[1].vertices, [[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [6.0, 1.0, 0.0]]);
    assert_eq!(model.meshes[1].materials, [0]);

    let red = Material {
        specular: DVec3::new(0.1, 0.2, 0.3),
        exponent: 10.0,
        ..Material::lambertian(DVec3::new(0.5, 0.25, 0.125))
    };
    assert_eq!(model.materials[0].material, Ok(red.into()));
    assert_eq!(model.materials[1].name, "blue");
    assert_eq!(model.materials[1].material.as_ref().unwrap().values.diffuse, DVec3::splat(0.5));
}

#[test]
fn groups_are_meshes_where_there_are_no_objects() {
    let model = load(&format!("{TRIANGLE}f 1 2 3\ng one\nf 1 2 3\ng one\nf 3 2 1\ng\nf 1 3 2\n"));
    let names: Vec<&str> = model.meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(names, ["a", "one", "one_2", "a_2"]);
    assert_eq!(model.materials.len(), 1);
    assert_eq!(model.materials[0].name, DEFAULT_MATERIAL);
    assert_eq!(model.materials[0].material, Ok(Material::default().into()));
}

#[test]
fn polygons_become_triangles() {
    let model = load(
        "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nusemtl default\nf 1 2 3 4 5\nf 1 1 1\nf 1 1 1\n",
    );
    let mesh = &model.meshes[0];
    assert_eq!(mesh.triangles[..3], [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    // An arrow head, whose notch is its third corner: a fan around the first corner would leave it.
    let arrow = load(
        "v 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 0.3 0.5\nvt 1 1\n\
        f 2/2 3/3 4/4 1/1\n",
    );
    let [arrow] = &arrow.meshes[..] else { panic!("one mesh") };
    assert_eq!(arrow.texture_coordinates.len(), 4);
    let corner = |&i: &u32| DVec3::from_array(arrow.vertices[i as usize]);
    for (triangle, texture) in arrow.triangles.iter().zip(&arrow.texture_triangles) {
        let [a, b, c] = [0, 1, 2].map(|i| corner(&triangle[i]));
        assert_eq!(0.5 * (b - a).cross(c - a).z, 0.25, "{triangle:?}");
        // Corners keep their texture coordinates: u is 0 at the tail and 1 at the tips.
        for (vertex, coordinate) in triangle.iter().zip(texture.unwrap()) {
            let u = arrow.texture_coordinates[coordinate as usize][0];
            assert_eq!(corner(vertex).x, if u == 0.3 { 0.5 } else { 2.0 * u });
        }
    }
    // Triangles without area and repeated ones are kept.
    assert_eq!(mesh.triangles[3..], [[0, 0, 0]; 2]);
    assert_eq!(mesh.materials, [0; 5]);
}

#[test]
fn odd_but_whole_files_are_read() {
    let plain = load(&format!("{TRIANGLE}f 1 2 3\n"));
    let texts = [
        // Windows line ends, tabs, a byte order mark, comments.
        "\u{feff}# caf\u{e9}\r\nv\t0 0\t0\r\nv 1 0 0 # right\r\nv 0 1 0\r\n  f\t1 2   3 # all\r\n",
        // No line end at the end; normals and texture coordinates in every form.
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1 2//1 3/-1/-1",
        // Colours, weights, exponents, a continued face, lines and points, unknown statements.
        "v 0 0 0 1 0 0\nv 2e0 0 0 2.0\nv 0 1e-0 0.0 1 1 1\nl 1 2 3\np 1\ns off\nf 1 2 \\\n 3\nxyz 1\n",
    ];
    for text in texts {
        assert_eq!(load(text).meshes, plain.meshes, "{text}");
    }
}

#[test]
fn indices_are_relative_to_what_stands_before() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf -3/-3 -2/-2 -1/-1\n\
        v 0 0 5\nv 1 0 5\nv 0 1 5\nvt 0.5 0.5\nf -3/-1 -2/-1 -1/-1\n";
    let mesh = &load(text).meshes[0];
    assert_eq!(mesh.vertices[3..], [[0.0, 0.0, 5.0], [1.0, 0.0, 5.0], [0.0, 1.0, 5.0]]);
    assert_eq!(mesh.triangles, [[0, 1, 2], [3, 4, 5]]);
    assert_eq!(mesh.texture_triangles, [Some([0, 1, 2]), Some([3, 3, 3])]);
    assert_eq!(mesh.texture_coordinates[3], [0.5, 0.5]);
}

/// What has no texture coordinates gets none of others.
#[test]
fn corners_without_texture_coordinates_are_kept_apart() {
    let text = format!(
        "{TRIANGLE}v 1 1 0\nvt 0.1 0.2\nvt 0.3 0.4\nvt 0.5 0.6\no plain\nf 1 2 3\n\
         o mixed\nf 1 2 3\nf 1/2 2/3 4/3 3\n"
    );
    let [plain, mixed] = &load(&text).meshes[..] else { panic!("two meshes") };
    assert_eq!((plain.texture_coordinates.len(), plain.texture_triangles.len()), (0, 0));
    assert_eq!(mixed.texture_coordinates, [[0.3, 0.4], [0.5, 0.6]]);
    assert_eq!(mixed.texture_triangles, [None, Some([0, 1, 1]), None]);
}

/// As for texture coordinates: with indices of their own, from the end, or not there at all.
#[test]
fn normals_are_read_where_they_are_wanted() {
    let text = format!(
        "{TRIANGLE}v 1 1 0\nvt 0 0\nvn 0 0 1\nvn 0 3 4\nvn 1 0 0\no plain\nf 1 2 3\n\
         o mixed\nf 1//3 2/1/2 4//-1\nf 1//1 2/1 3//1\nf -1/1/-2 -2//-2 -3//-2\n"
    );
    let folder = folder(&[("a.obj", &text)]);
    let path = folder.path().join("a.obj");
    let [plain, mixed] =
        &read_obj(&path, FileNormals::Read, FileObjects::Apart).unwrap().meshes[..]
    else {
        panic!("two meshes")
    };
    assert_eq!(plain.normals, Normals::Flat);
    let directions = vec![[1.0, 0.0, 0.0], [0.0, 3.0, 4.0]];
    let triangles = vec![Some([0, 1, 0]), None, Some([1; 3])];
    assert_eq!(mixed.normals, Normals::Given { directions, triangles });
    for mesh in load_obj(&path).unwrap().meshes {
        assert_eq!(mesh.normals, Normals::Flat);
    }
}

/// Those that nothing shows do not matter.
#[test]
fn broken_normals_are_refused_with_their_line() {
    for (normal, expected) in [
        ("nan 0 1", "`nan` is not a finite number"),
        ("0 1e999 1", "`1e999` is not a finite number"),
        ("0 0 0", "a normal is the zero vector, which has no direction"),
        ("0 1", "a normal has 3 coordinates, this one 2"),
        ("", "a normal has 3 coordinates, this one 0"),
    ] {
        let text = format!("{TRIANGLE}vn {normal}\nf 1//1 2//1 3//1\n");
        let folder = folder(&[("a.obj", &text)]);
        let path = folder.path().join("a.obj");
        let error = read_obj(&path, FileNormals::Read, FileObjects::Apart).unwrap_err().to_string();
        assert_eq!(error, format!("{}:4: {expected}", path.display()));
        assert_eq!(load_obj(&path).unwrap().meshes[0].normals, Normals::Flat);
    }
}

#[test]
fn what_is_left_out_is_told_once() {
    let text = format!(
        "s 1\nvn 0 0 1\n{TRIANGLE}v 0 0 0 1 0 0\nv 0 0 0 1 0 0\nl 1 2\nl 1 2\np 1\n\
         surf 0 1\nf 1 2 3\n"
    );
    let folder = folder(&[("a.obj", &text)]);
    let path = folder.path().join("a.obj");
    let warnings = load_obj(&path).unwrap().warnings;
    let expected = [
        (6, "the colours of vertices are left out"),
        (8, "`l` is left out: only faces (`f`) are shown"),
        (10, "`p` is left out: only faces (`f`) are shown"),
        (11, "`surf` is left out: it is no statement that is read here"),
    ];
    let expected = expected.map(|(line, problem)| format!("{}:{line}: {problem}", path.display()));
    assert_eq!(warnings.iter().map(ToString::to_string).collect::<Vec<_>>(), expected);
}

/// Files with many groups of one name are read in a time that grows with their length.
#[test]
fn many_groups_of_one_name_are_numbered() {
    let groups = "g\nf 1 2 3\n".repeat(20_000);
    let model = load(&format!("{TRIANGLE}{groups}"));
    assert_eq!(model.meshes.len(), 20_000);
    assert_eq!(model.meshes[19_999].name, "a_20000");
}

#[test]
fn bytes_that_are_no_text_are_read_over() {
    let folder = folder(&[]);
    let path = folder.path().join("a.obj");
    fs::write(&path, b"# caf\xe9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    assert_eq!(load_obj(&path).unwrap().meshes[0].triangles, [[0, 1, 2]]);
    fs::write(&path, b"\xff\xfev\x000\x00").unwrap();
    assert_eq!(load_obj(&path).unwrap_err().problem, "is text in UTF-16; save it as UTF-8");
}

#[test]
fn broken_files_are_refused_with_their_line() {
    for (rest, expected) in [
        ("v nan 0 0\n", "a.obj:4: `nan` is not a finite number"),
        ("v 0 -inf 0\n", "a.obj:4: `-inf` is not a finite number"),
        ("v 0 0 1e999\n", "a.obj:4: `1e999` is not a finite number"),
        ("v 0 0 1,5\n", "a.obj:4: `1,5` is not a number"),
        ("v 1 2", "a.obj:4: a vertex has 3 coordinates, this one 2"),
        ("v 1e300 2 3 1e-300\n", "a.obj:4: the weight 1e-300 takes the vertex to infinity"),
        ("v 0 0 0 0\n", "a.obj:4: the weight 0.0 takes the vertex to infinity"),
        ("\nf 1 2 4\n", "a.obj:5: vertex 4 is out of range: 3 are defined before this line"),
        ("f 1 2 0\n", "a.obj:4: vertex 0 is out of range: 3 are defined before this line"),
        ("f -4 -1 -2\n", "a.obj:4: vertex -4 is out of range: 3 are defined before this line"),
        ("f 1 2 -9223372036854775808\n", "a.obj:4: vertex -9223372036854775808 is out of range"),
        ("f 1 2 99999999999999999999\n", "a.obj:4: `99999999999999999999` is not the index"),
        ("f 1 2\n", "a.obj:4: a face has at least 3 vertices, this one 2"),
        ("f\n", "a.obj:4: a face has at least 3 vertices, this one 0"),
        ("f 1 2 x\n", "a.obj:4: `x` is not the index of a vertex"),
        ("f 1 2 3/1\n", "a.obj:4: texture coordinate 1 is out of range: 0 are defined"),
        ("f 1/1/1/1 2 3\n", "a.obj:4: `1/1/1/1` is not vertex/texture/normal"),
        ("", "a.obj: holds no triangles"),
        ("l 1 2 3\n", "a.obj: holds no triangles"),
    ] {
        let error = refused(&[("a.obj", &format!("{TRIANGLE}{rest}"))]);
        assert!(error.starts_with(expected), "{rest:?}: {error}");
    }
    let point = |i: i32| (1.0 + f64::from(i % 2)) * glam::DVec2::from_angle(f64::from(i) / 200.0);
    let points = (0..1002).map(point).map(|p| format!("v {} {} 0\n", p.x, p.y));
    let corners: String = (1..=1002).map(|i| format!(" {i}")).collect();
    let star = format!("{}f 1 2 3\n\nf{corners}\n", points.collect::<String>());
    let error = refused(&[("a.obj", &star)]);
    assert_eq!(error, "a.obj:1005: a face of 1002 corners is not convex; such ones may have 1000");
    assert!(refused(&[("a.obj", "")]).starts_with("a.obj: holds no triangles"));
    assert!(refused(&[]).starts_with("a.obj: no such file"));
}

#[test]
fn a_written_mesh_is_read_back_bit_for_bit() {
    let vertices =
        [[0.1, 1.0 / 3.0, -1e-300], [1e17 + 2.0, -0.0, f64::MIN_POSITIVE], [5e-324, 123.456, 1e6]];
    let coordinates = [[0.1, -2.0 / 3.0], [1e-300, 5.0]];
    let mut mesh = Mesh {
        name: "Cube.001 #b".to_owned(),
        vertices: vertices.to_vec(),
        triangles: vec![[0, 1, 2], [2, 1, 0], [0, 0, 1]],
        materials: vec![1, 0, 1],
        texture_coordinates: coordinates.to_vec(),
        texture_triangles: vec![Some([1, 0, 1]), None, Some([1, 1, 0])],
        normals: Normals::Given {
            directions: vec![[0.1, -1.0 / 3.0, 1e-300], [-0.0, 1e17, 2.0]],
            triangles: vec![Some([0, 1, 0]), Some([1, 1, 0]), None],
        },
        transform: Transform { translation: DVec3::X, ..Transform::IDENTITY },
    };
    let named = |name: &str| MaterialObject { name: name.to_owned(), ..Material::default().into() };
    let names = ["a b", "c"].map(named);
    let folder = folder(&[]);
    let path = folder.path().join("m.obj");
    save_obj(&mesh, &names, &path).unwrap();
    let model = read_obj(&path, FileNormals::Read, FileObjects::Apart).unwrap();
    assert_eq!(model.meshes[0].name, mesh.name);
    assert_eq!(model.meshes[0].normals, mesh.normals);
    assert_eq!(model.meshes[0].triangles, mesh.triangles);
    // In the order of their first use.
    assert_eq!(model.meshes[0].texture_coordinates, [coordinates[1], coordinates[0]]);
    let swapped = [Some([0, 1, 0]), None, Some([0, 0, 1])];
    assert_eq!(model.meshes[0].texture_triangles, swapped);
    let bits = |v: &[[f64; 3]]| v.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&model.meshes[0].vertices), bits(&vertices));
    let assigned: Vec<&str> = (model.meshes[0].materials.iter())
        .map(|&index| model.materials[index as usize].name.as_str())
        .collect();
    assert_eq!(assigned, ["c", "a b", "c"]);

    mesh.vertices.truncate(2);
    let error = save_obj(&mesh, &names, &path).unwrap_err();
    assert!(error.problem.contains("Cube.001 #b is inconsistent"), "{error}");
}
