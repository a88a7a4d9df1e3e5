use std::fs;

use glam::DVec3;

use super::*;

/// A camera at (0, 0, 4) that looks at the origin, with x to the right.
const FRAME: &str = r#"{ "file_path": "./train/r_0",
    "transform_matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 4], [0, 0, 0, 1]] }"#;

fn transforms(head: &str) -> Result<Vec<FoundView>, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("transforms.json");
    fs::write(&path, format!("{{ {head} \"frames\": [{FRAME}] }}")).unwrap();
    load_cameras(&path)
}

fn colmap(camera: &str, images: &str) -> Result<Vec<FoundView>, Error> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("cameras.txt"), format!("# CAMERAS\n{camera}\n")).unwrap();
    fs::write(folder.path().join("images.txt"), format!("# IMAGES\n{images}\n")).unwrap();
    load_cameras(folder.path())
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
fn cameras_of_colmap_look_along_z() {
    // Turned by half a turn about x, and moved: the same camera as that of the other test.
    let pose = "1 0 1 0 0 0 0 4 7 r 0.png\n\n";
    let found = colmap("7 PINHOLE 400 200 200 200 200 100", pose).unwrap();
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
    ] {
        let error = transforms(&format!("{size}{head}")).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("frames[0]"), "{error}");
    }
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
