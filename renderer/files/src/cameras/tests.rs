use std::fs;

use glam::DVec3;

use super::*;

/// A camera at (0, 0, 4) that looks at the origin, with x to the right.
const FRAME: &str = r#"{ "file_path": "./train/r_0",
    "transform_matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 4], [0, 0, 0, 1]] }"#;

fn transforms(head: &str) -> Result<Vec<FoundView>, Error> {
    frames(head, FRAME)
}

fn frames(head: &str, frames: &str) -> Result<Vec<FoundView>, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("transforms.json");
    fs::write(&path, format!("{{ {head} \"frames\": [{frames}] }}")).unwrap();
    load_cameras(&path)
}

fn colmap(camera: &str, images: &str) -> Result<Vec<FoundView>, Error> {
    colmap_in("", camera, images)
}

/// Of a project in whose folder of this name the files lie.
fn colmap_in(model: &str, camera: &str, images: &str) -> Result<Vec<FoundView>, Error> {
    let project = tempfile::tempdir().unwrap();
    let folder = project.path().join(model);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("cameras.txt"), format!("# CAMERAS\n{camera}\n")).unwrap();
    fs::write(folder.join("images.txt"), format!("# IMAGES\n{images}\n")).unwrap();
    load_cameras(project.path())
}

#[test]
fn cameras_of_nerf_look_along_negative_z() {
    let found = transforms(r#""camera_angle_x": 1.5707963267948966, "w": 400, "h": 200,"#).unwrap();
    let [FoundView { view, image }] = &found[..] else { panic!("{found:?}") };
    assert_eq!((view.width, view.height, &view.name[..]), (400, 200, "r_0"));
    assert!(image.ends_with("train/r_0.png"), "{image:?}");
    let camera = &view.camera;
    assert_eq!((camera.look_from, camera.look_at), (DVec3::Z * 4.0, DVec3::Z * 3.0));
    assert_eq!(camera.up, DVec3::Y);
    // 45 degrees to the right edge, half as much of the tangent to the upper one.
    assert!((camera.vfov - 2.0 * 0.5_f64.atan().to_degrees()).abs() < 1e-9, "{}", camera.vfov);
}

#[test]
fn what_a_frame_says_of_its_lens_counts() {
    let own = FRAME.replacen('{', r#"{"camera_angle_x": 1.5707963267948966,"#, 1);
    let both = [FRAME, &own].join(",");
    let found = frames(r#""w": 400, "h": 200, "fl_x": 400,"#, &both).unwrap();
    for (found, focal) in found.iter().zip([400.0, 200.0]) {
        let vfov = 2.0 * (100.0_f64 / focal).atan().to_degrees();
        assert!((found.view.camera.vfov - vfov).abs() < 1e-9, "{:?}", found.view.camera);
    }
}

#[test]
fn cameras_of_colmap_look_along_z() {
    // Turned by half a turn about x, and moved: the same camera as that of the other test.
    let pose = "1 0 1 0 0 0 0 4 7 r 0.png\n\n";
    let lens = "7 PINHOLE 400 200 200 200 200 100";
    let found = colmap(lens, pose).unwrap();
    for model in ["sparse/0", "sparse"] {
        assert_eq!(colmap_in(model, lens, pose).unwrap()[0].view, found[0].view);
    }
    let elsewhere = colmap_in("dense", lens, pose).unwrap_err();
    assert!(elsewhere.problem.contains("no cameras.bin"), "{elsewhere}");
    let [FoundView { view, image }] = &found[..] else { panic!("{found:?}") };
    assert!(image.ends_with("r 0.png"), "{image:?}");
    let camera = &view.camera;
    assert!(camera.look_from.distance(DVec3::Z * 4.0) < 1e-12, "{camera:?}");
    assert!(camera.look_at.distance(DVec3::Z * 3.0) < 1e-12, "{camera:?}");
    assert!(camera.up.distance(DVec3::Y) < 1e-12, "{camera:?}");
    assert!((camera.vfov - 2.0 * 0.5_f64.atan().to_degrees()).abs() < 1e-9, "{}", camera.vfov);
}

#[test]
fn what_is_not_modelled_is_refused_by_name() {
    let size = r#""w": 400, "h": 200, "fl_x": 300,"#;
    for (head, part) in [
        (r#""k1": 0.01,"#, "k1 = 0.01"),
        (r#""is_fisheye": true,"#, "fisheye"),
        (r#""camera_model": "OPENCV_FISHEYE","#, "OPENCV_FISHEYE"),
        (r#""cx": 190,"#, "principal point at 190, 100"),
        (r#""fl_y": 310,"#, "no squares"),
        (r#""camera_angle_x": 1.2,"#, "camera_angle_x means 292.3"),
    ] {
        let error = transforms(&format!("{size}{head}")).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("frames[0]"), "{error}");
    }
    let error = transforms(r#""w": 400, "fl_x": 300,"#).unwrap_err().to_string();
    assert!(error.contains("no `h`"), "{error}");
    let error = transforms(r#""w": 400, "h": 200,"#).unwrap_err().to_string();
    assert!(error.contains("neither fl_x nor camera_angle_x"), "{error}");
    let pose = "1 0 1 0 0 0 0 4 1 a.png\n";
    for (camera, part) in [
        ("1 SIMPLE_RADIAL 400 200 300 200 100 0.02", "k = 0.02"),
        ("1 FISHEYE 400 200 300 200 100 0.02", "FISHEYE"),
        ("1 PINHOLE 400 200 300 200 100", "ends before its cy"),
        ("1 PINHOLE 400 200 x 200 100 100", "fx: `x`"),
        ("2 PINHOLE 400 200 300 300 200 100", "names camera 1"),
    ] {
        let error = colmap(camera, pose).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains(".txt:2"), "{error}");
    }
}

/// The same two cameras and images as in text.
fn binary(change: impl Fn(&mut Vec<u8>, &mut Vec<u8>)) -> Result<Vec<FoundView>, Error> {
    let mut cameras = 2_u64.to_le_bytes().to_vec();
    let lenses: [(u32, u32, &[f64]); 2] =
        [(7, 1, &[200.0, 200.0, 200.0, 100.0]), (9, 2, &[300.0, 200.0, 100.0, 0.0])];
    for (id, model, numbers) in lenses {
        cameras.extend(id.to_le_bytes());
        cameras.extend(model.to_le_bytes());
        [400_u64, 200].iter().for_each(|side| cameras.extend(side.to_le_bytes()));
        numbers.iter().for_each(|number| cameras.extend(number.to_le_bytes()));
    }
    let mut images = 2_u64.to_le_bytes().to_vec();
    let poses: [(u32, [f64; 7], &str); 2] = [
        (7, [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 4.0], "r 0.png"),
        (9, [0.9, 0.1, -0.3, 0.2, 1.0, 2.0, 3.0], "r1.png"),
    ];
    for (camera, pose, name) in poses {
        images.extend(1_u32.to_le_bytes());
        pose.iter().for_each(|number| images.extend(number.to_le_bytes()));
        images.extend(camera.to_le_bytes());
        images.extend(name.bytes().chain([0]));
        images.extend(2_u64.to_le_bytes());
        images.extend([0x55; 48]);
    }
    change(&mut cameras, &mut images);
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("cameras.bin"), cameras).unwrap();
    fs::write(folder.path().join("images.bin"), images).unwrap();
    load_cameras(folder.path())
}

#[test]
fn binary_files_of_colmap_say_what_text_says() {
    let lenses = "7 PINHOLE 400 200 200 200 200 100\n9 SIMPLE_RADIAL 400 200 300 200 100 0";
    let poses = "1 0 1 0 0 0 0 4 7 r 0.png\n55 55 5\n1 0.9 0.1 -0.3 0.2 1 2 3 9 r1.png\n55 55 5\n";
    let views = |found: Vec<FoundView>| found.into_iter().map(|of| of.view).collect::<Vec<_>>();
    let text = views(colmap(lenses, poses).unwrap());
    assert_eq!(views(binary(|_, _| {}).unwrap()), text);
    assert_eq!(text.len(), 2);
}

#[test]
fn broken_binary_files_of_colmap_are_named() {
    type Change = fn(&mut Vec<u8>, &mut Vec<u8>);
    let changes: [(Change, &[&str]); 7] = [
        (|cameras, _| cameras.truncate(40), &["cameras.bin: camera 0", "ends before its fy"]),
        (|cameras, _| cameras[12] = 5, &["cameras.bin: camera 0", "OPENCV_FISHEYE"]),
        (|cameras, _| cameras[12] = 77, &["cameras.bin: camera 0", "lens 77"]),
        (|cameras, _| cameras.push(0), &["cameras.bin", "1 bytes"]),
        (|cameras, _| cameras[0] = 255, &["cameras.bin: camera 2", "ends before its number"]),
        (|cameras, _| cameras[8] = 8, &["images.bin: image 0", "names camera 7"]),
        (|_, images| images.truncate(100), &["images.bin: image 0", "ends before its points"]),
    ];
    for (change, parts) in changes {
        let error = binary(change).unwrap_err().to_string();
        assert!(parts.iter().all(|part| error.contains(part)), "{error}");
    }
}
