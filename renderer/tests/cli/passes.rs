//! Passes beside radiance: rendered, and matched.

use crate::sandbox::{SCENE, Sandbox, numbers};

const FLOOR_OBJECT: &str = "[[mesh]]\npath = \"floor.obj\"\nname = \"floor\"\n";

/// The scene without light, seen by a view, its floor moved by these numbers.
fn scene(moved: &str, view: &str) -> String {
    let camera = "look_from = [0.0, 1.5, 4.0]\n";
    let scene = SCENE.replace(camera, "").replace("[[mesh]]\npath = \"floor.obj\"\n", FLOOR_OBJECT);
    let (head, tail) = scene.split_once("[[light]]").unwrap();
    let tail = &tail[tail.find("[[mesh]]").unwrap()..];
    let tail = tail.replace(FLOOR_OBJECT, &format!("{FLOOR_OBJECT}{moved}"));
    format!("{head}[[view]]\nname = \"front\"\n{camera}{view}{tail}")
}

const MOVED: &str = "translation = [0.1, -0.15, 0.2]\nrotation = [4.0, -8.0, 3.0]\n";

const FIND: &str = "\
[optimize]
optimizer = \"lbfgs\"
iterations = 60
[[optimize.parameter]]
path = \"mesh.floor.translation\"
[[optimize.parameter]]
path = \"mesh.floor.rotation\"
";

#[test]
fn what_depth_and_normals_show_is_found_in_the_dark() {
    let sandbox = Sandbox::new();
    sandbox.write("truth.toml", scene(MOVED, ""));
    sandbox.succeed(&["render", "truth.toml", "--pass", "normals,depth", "-o", "truth.exr"]);
    let view =
        "depth = { path = \"truth-front.exr\", weight = 0.3 }\nnormals = \"truth-front.exr\"\n";
    sandbox.write("find.toml", format!("{}{FIND}", scene("", view)));
    let printed = sandbox.succeed(&["optimize", "find.toml", "--out", "out"]);
    assert!(printed.contains("1 matched by depth, mean: PSNR "), "{printed}");
    let summary = sandbox.json("out/summary.json");
    for (path, truth, most) in [
        ("mesh.floor.translation", [0.1, -0.15, 0.2], 0.01),
        ("mesh.floor.rotation", [4.0, -8.0, 3.0], 0.3),
    ] {
        let found = numbers(&summary["parameters"][path]["final"]);
        let off = found.iter().zip(truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < most, "{path}: {found:?}");
    }
    let passes: Vec<&str> =
        summary["views"].as_array().unwrap().iter().map(|v| v["pass"].as_str().unwrap()).collect();
    assert_eq!(passes, ["depth", "normals"]);
    for file in ["front-depth-target.png", "front-normals-difference.png"] {
        sandbox.read(&format!("out/views/{file}"));
    }
    sandbox.succeed(&["report", "out"]);
}

/// Silhouettes that are rendered, levels of 8 bits or floats, are those that a view is matched by.
#[test]
fn rendered_coverage_is_read_as_it_was() {
    let sandbox = Sandbox::new();
    for (file, most) in [("covered.png", 4e-6), ("covered.exr", 1e-12)] {
        sandbox.write("truth.toml", scene(MOVED, ""));
        sandbox.succeed(&["render", "truth.toml", "--pass", "coverage", "-o", file]);
        let view = format!("coverage = \"{}\"\n", file.replace('.', "-front."));
        sandbox.write("find.toml", format!("{}{FIND}", scene(MOVED, &view)));
        let json = sandbox.succeed(&["gradient", "find.toml"]);
        let loss: f64 = json.lines().next().unwrap()["loss ".len()..].parse().unwrap();
        assert!(loss < most, "{file}: {loss}");
    }
}

#[test]
fn only_radiance_needs_light() {
    let sandbox = Sandbox::new();
    sandbox.write("dark.toml", scene("", ""));
    for (passes, needs_light) in [
        ("radiance", true),
        ("coverage", false),
        ("albedo,normals", false),
        ("radiance,depth", true),
    ] {
        let output = sandbox.run(&["render", "dark.toml", "--pass", passes, "-o", "a.exr"]);
        assert!(output.status.success(), "{output:?}");
        let warnings = String::from_utf8(output.stderr).unwrap();
        assert_eq!(warnings.contains("has no light"), needs_light, "{passes}: {warnings}");
    }
}

#[test]
fn what_is_wrong_with_passes_is_said() {
    let sandbox = Sandbox::new();
    let refuse = |arguments: &[&str], parts: &[&str]| {
        sandbox.refuse_with(&[&["render", "scene.toml"], arguments].concat(), parts);
    };
    refuse(&["--pass", "depth,normals", "-o", "a.png"], &["a.png", "one .exr"]);
    refuse(&["--pass", "depth,depth", "-o", "a.exr"], &["--pass", "depth twice"]);
    refuse(&["--pass", "normals", "-o", "a.hdr"], &["a.hdr", "below 0"]);
    let derivative = ["--derivative", "sphere.ball.center=1,0,0"];
    refuse(&[&["--pass", "depth,normals", "-o", "a.exr"], &derivative[..]].concat(), &["one pass"]);
    sandbox.succeed(
        &[&["render", "scene.toml", "--pass", "depth", "-o", "a.png"], &derivative[..]].concat(),
    );

    sandbox.succeed(&["render", "scene.toml", "--pass", "position,albedo", "-o", "a.exr"]);
    for (view, parts) in [
        ("depth = \"a.png\"\n", &["a.png", "no OpenEXR image of depth"][..]),
        ("depth = \"a.exr\"\n", &["a.exr", "no channels of depth, but", "position.z"]),
        (
            "normals = \"none.exr\"\n",
            &["find.toml:", ": view.front.normals: none.exr: no such file"],
        ),
        ("depth = { path = \"a.exr\", weight = -1 }\n", &["view.front.depth.weight", "is -1"]),
        ("depth = { file = \"a.exr\" }\n", &["find.toml", "unknown field `file`"]),
        ("depth = 3\n", &["find.toml", "a path or a table with a `path`"]),
    ] {
        sandbox.write("find.toml", format!("{}{FIND}", scene("", view)));
        sandbox.refuse_with(&["optimize", "find.toml"], parts);
    }
}
