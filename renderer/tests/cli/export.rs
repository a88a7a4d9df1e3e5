//! Meshes for other programs.

use crate::sandbox::Sandbox;

#[test]
fn scenes_are_written_as_meshes() {
    let sandbox = Sandbox::new();
    for file in ["object.glb", "object.obj"] {
        let output = sandbox.run(&["export", "scene.toml", "-o", file]);
        assert_eq!(String::from_utf8(output.stdout).unwrap(), format!("{file}\n"));
        let warning = format!(
            "warning: {file}: spheres are left out (1 in the scene): only meshes are written\n"
        );
        assert_eq!(String::from_utf8(output.stderr).unwrap(), warning);
        assert!(output.status.success());
        sandbox.succeed(&["render", file, "-o", "picture.png", "--width", "8"]);
    }
    assert!(sandbox.path("object.mtl").is_file());
    // What a recovery leaves is a scene as any other.
    sandbox.succeed(&["optimize", "experiment.toml", "--out", "out", "--iterations", "0"]);
    sandbox.succeed(&["export", "out/scene.toml", "-o", "found.glb"]);
    assert_eq!(sandbox.read("found.glb"), sandbox.read("object.glb"));
}

/// A floor under lights of all kinds that glTF has, seen by a camera that is tilted and zoomed.
const LIT: &str = r#"
[camera]
look_from = [1.0, 2.5, 4.0]
look_at = [0.2, 0.3, -0.1]
up = [0.2, 1.0, 0.1]
vfov = 50.0
film_scale = 0.7
width = 480
height = 320

[[light]]
name = "key"
type = "point"
position = [1.5, 3.0, 2.0]
color = [2.0, 1.0, 0.5]
radiant_intensity = 20.0

[[light]]
name = "sun"
type = "distant"
direction = [-0.3, -1.0, 0.2]
irradiance = 0.3

[[light]]
name = "stage"
type = "spot"
position = [-1.0, 2.0, 0.5]
direction = [0.4, -1.0, 0.2]
radiant_intensity = 15.0
inner_angle = 10.0
outer_angle = 25.0

[[mesh]]
path = "floor.obj"
material = "paint"

[material.paint]
diffuse = [0.6, 0.3, 0.2]
"#;

/// The levels of the pixels of a picture.
fn levels(sandbox: &Sandbox, file: &str) -> Vec<u8> {
    image::load_from_memory(&sandbox.read(file)).unwrap().to_rgb8().into_raw()
}

/// How far the levels of two pictures of the same size are apart at most.
fn farthest(sandbox: &Sandbox, one: &str, other: &str) -> u8 {
    let (one, other) = (levels(sandbox, one), levels(sandbox, other));
    assert_eq!(one.len(), other.len());
    one.iter().zip(&other).map(|(a, b)| a.abs_diff(*b)).max().unwrap()
}

#[test]
fn cameras_and_lights_make_the_same_picture() {
    let sandbox = Sandbox::new();
    sandbox.write("lit.toml", LIT);
    sandbox.succeed(&["render", "lit.toml", "-o", "before.png"]);
    sandbox.succeed(&["export", "lit.toml", "-o", "lit.glb"]);
    sandbox.succeed(&["render", "lit.glb", "-o", "after.png", "--width", "480"]);
    let levels = levels(&sandbox, "before.png");
    assert!(levels.iter().any(|level| *level > 200) && levels.iter().any(|level| *level < 100));
    assert!(farthest(&sandbox, "before.png", "after.png") <= 1);
}

#[test]
fn lights_that_the_format_lacks_are_named() {
    let sandbox = Sandbox::new();
    let window = "[environment]\nradiance = [1, 1, 1]\n[[light]]\nname = \"window\"\ntype = \"disc\"\n\
                  center = [0, 3, 0]\nright = [1, 0, 0]\nup = [0, 0, 1]\nradiance = 1\n";
    sandbox.write("window.toml", format!("{LIT}{window}"));
    let output = sandbox.run(&["export", "window.toml", "-o", "window.glb"]);
    assert!(output.status.success());
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("warning: light.window: is left out"), "{said}");
    assert!(said.contains("warning: environment: is left out"), "{said}");
}

#[test]
fn cameras_of_views_are_written_as_transforms() {
    let sandbox = Sandbox::new();
    let views = "[[view]]\nname = \"left\"\nlook_from = [-2.0, 1.0, 3.0]\ntarget = \"photos/left.jpg\"\n\
                 [[view]]\nname = \"high\"\nlook_at = [0.3, 0.1, 0.0]\nvfov = 30.0\nwidth = 360\n";
    sandbox.write("views.toml", format!("{LIT}{views}"));
    sandbox.succeed(&["render", "views.toml", "-o", "before.png"]);
    std::fs::create_dir(sandbox.path("found")).unwrap();
    let output = sandbox.run(&["export", "views.toml", "-o", "found/transforms.json"]);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(
        said,
        "warning: view.high: has no image; its file_path names high.png, which is not written\n"
    );
    let written = sandbox.json("found/transforms.json");
    let files = [0, 1].map(|frame| written["frames"][frame]["file_path"].as_str().unwrap());
    assert_eq!(files, ["../photos/left.jpg", "high.png"]);
    // What differs from the first is the frame's own.
    assert_eq!((&written["w"], &written["frames"][1]["w"]), (&480.0.into(), &360.0.into()));
    assert!(written["frames"][0]["w"].is_null());

    sandbox.write("read.toml", format!("{LIT}[[view]]\npath = \"found/transforms.json\"\n"));
    sandbox.succeed(&["render", "read.toml", "-o", "after.png"]);
    for view in ["left", "high"] {
        let [before, after] = ["before", "after"].map(|name| format!("{name}-{view}.png"));
        assert!(farthest(&sandbox, &before, &after) <= 1, "{view}");
    }
    // Without views the camera of the scene is written.
    sandbox.succeed(&["export", "scene.toml", "-o", "none.json"]);
    assert_eq!(sandbox.json("none.json")["frames"][0]["file_path"], "camera.png");
}

/// The second texture has a name that is too long for a file: the first is not left behind.
#[test]
fn a_failed_export_leaves_nothing_behind() {
    let sandbox = Sandbox::new();
    sandbox
        .write("plate.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    let long = "x".repeat(250);
    let scene = crate::sandbox::SCENE.replace("floor.obj\"", "plate.obj\"\nmaterial = \"paint\"");
    let textures = format!(
        "diffuse_texture = \"short\"\nspecular_texture = \"{long}\"\n[texture.short]\nsize = [2, 2]\n\
         color = [1, 1, 1]\n[texture.{long}]\nsize = [2, 2]\ncolor = [1, 1, 1]\n"
    );
    sandbox.write("long.toml", format!("{scene}{textures}"));
    std::fs::create_dir(sandbox.path("out")).unwrap();
    sandbox.refuse_with(&["export", "long.toml", "-o", "out/a.obj"], &["cannot be written"]);
    assert!(sandbox.names("out").is_empty(), "{:?}", sandbox.names("out"));
}

#[test]
fn what_cannot_be_written_is_refused() {
    let sandbox = Sandbox::new();
    sandbox.refuse_with(&["export", "scene.toml", "-o", "a.stl"], &["a.stl: ", ".glb", ".obj"]);
    sandbox.refuse_with(&["export", "scene.toml", "-o", "a/b.glb"], &["a/b.glb", "does not exist"]);
    sandbox.refuse_with(&["export", "scene.toml", "-o", "floor.obj"], &["floor.obj", "exists"]);
    sandbox.write("kept.mtl", "");
    sandbox.refuse_with(&["export", "scene.toml", "-o", "kept.obj"], &["kept.mtl", "exists"]);
    sandbox.refuse_with(&["export", "none.toml", "-o", "a.glb"], &["none.toml"]);
}
