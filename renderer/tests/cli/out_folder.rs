//! Results never replace what they are made from.

use std::fs;

use crate::sandbox::{FLOOR, OPTIMIZE, SCENE, Sandbox};

const TUNE: [&str; 2] = ["--param", "light.key.radiant_intensity"];

#[test]
fn the_scene_the_target_and_the_meshes_are_safe() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&["render", "scene.toml", "-o", "target.png"]);
    sandbox.succeed(&["render", "scene.toml", "-o", "photo.png"]);
    let optimize = |scene, target| {
        [&["optimize", scene, "--target", target, "--out", "."], &TUNE[..]].concat()
    };
    sandbox.refuse_with(&optimize("scene.toml", "photo.png"), &["scene.toml", "--out"]);
    sandbox.write("mine.toml", SCENE);
    sandbox.refuse_with(&optimize("mine.toml", "target.png"), &["target.png", "--out"]);

    fs::create_dir(sandbox.path("meshes")).unwrap();
    sandbox.write("meshes/floor.obj", FLOOR);
    sandbox.succeed(&["render", "meshes/floor.obj", "-o", "floor.png"]);
    let mesh = ["optimize", "meshes/floor.obj", "--target", "floor.png", "--out", "."];
    sandbox.refuse_with(&[&mesh[..], &TUNE].concat(), &["meshes/floor.obj", "--out"]);
}

#[test]
fn a_recovered_scene_can_be_optimised_further() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&["render", "scene.toml", "-o", "photo.png"]);
    let optimize = |scene| {
        let arguments = ["optimize", scene, "--target", "photo.png", "--iterations", "2"];
        [&arguments[..], &TUNE].concat()
    };
    sandbox.succeed(&optimize("experiment.toml"));
    // By default beside the first results, not over them.
    sandbox.succeed(&optimize("out/experiment/scene.toml"));
    assert!(sandbox.path("out/scene/summary.json").exists());
}

/// A texture of the scene, and the map of a material that a mesh brings along.
const TEXTURED: &str = "
[texture.sky]
path = \"sky.png\"
[environment]
texture = \"sky\"
[integrator]
type = \"path\"
max_depth = 2
samples = 1
";

#[test]
fn images_replace_nothing_that_their_scene_is_made_of() {
    let sandbox = Sandbox::new();
    for name in ["sky.png", "tiles.png", "photo.png"] {
        sandbox.succeed(&["render", "scene.toml", "-o", name]);
    }
    let floor = FLOOR.replace("f 4 3 2 1", "vt 0 0\nusemtl tiles\nf 4/1 3/1 2/1 1/1");
    sandbox.write("floor.obj", format!("mtllib floor.mtl\n{floor}"));
    sandbox.write("floor.mtl", "newmtl tiles\nmap_Kd tiles.png\n");
    sandbox.write("all.toml", format!("{TEXTURED}{SCENE}[optimize]\ntarget = \"photo.png\"\n"));
    let refused = |output: &str, by: &str| {
        let render = ["render", "all.toml", "-o", output];
        sandbox.refuse_with(&render, &[output, by, "choose another name"]);
    };
    for output in ["sky.png", "./sky.png", "meshes/../sky.png"] {
        fs::create_dir_all(sandbox.path("meshes")).unwrap();
        refused(output, "all.toml:3: texture.sky.path");
    }
    refused("tiles.png", "floor.mtl:2");
    refused("photo.png", "optimize.target");
    #[cfg(unix)]
    for [target, by] in [["all.toml", "the command line"], ["floor.obj", "mesh.floor.obj.path"]] {
        let link = format!("{target}.png");
        std::os::unix::fs::symlink(sandbox.path(target), sandbox.path(&link)).unwrap();
        refused(&link, by);
    }
    let error = ["--target-error", "0.9", "--standard-error", "sky.hdr"];
    sandbox.succeed(&["render", "scene.toml", "-o", "sky.hdr"]);
    sandbox.write("all.toml", format!("{TEXTURED}{SCENE}").replace("sky.png", "sky.hdr"));
    let render = [&["render", "all.toml", "-o", "new.png"], &error[..]].concat();
    sandbox.refuse_with(&render, &["sky.hdr", "texture.sky.path"]);
    sandbox.succeed(&["render", "all.toml", "-o", "photo.png"]);
}

#[test]
fn results_replace_nothing_that_their_scene_is_made_of() {
    let sandbox = Sandbox::new();
    for folder in ["textures", "views"] {
        fs::create_dir(sandbox.path(folder)).unwrap();
    }
    for name in ["picture0-final.png", "textures/sky.exr", "views/a.png", "loss.svg"] {
        sandbox.succeed(&["render", "scene.toml", "-o", "sky.exr"]);
        fs::rename(sandbox.path("sky.exr"), sandbox.path(name)).unwrap();
        sandbox.write("all.toml", format!("{TEXTURED}{OPTIMIZE}{SCENE}").replace("sky.png", name));
        let optimize = ["optimize", "all.toml", "--iterations", "1", "--out"];
        let parts = [name, "all.toml:3: texture.sky.path", "--out"];
        sandbox.refuse_with(&[&optimize[..], &["."]].concat(), &parts);
    }
    // What has another name stays as it is.
    fs::rename(sandbox.path("textures/sky.exr"), sandbox.path("picture.png")).unwrap();
    sandbox.write(
        "all.toml",
        format!("{TEXTURED}{OPTIMIZE}{SCENE}").replace("sky.png", "picture.png"),
    );
    sandbox.succeed(&["optimize", "all.toml", "--iterations", "1", "--out", "."]);
    sandbox.refuse_with(&["report", ".", "-o", "summary.json"], &["summary.json", "is a result"]);
    sandbox.succeed(&["report", "."]);
    sandbox.succeed(&["report", "."]);
}

/// A run that does not come to its end leaves nothing that could be taken for its result.
#[test]
fn the_results_of_an_earlier_run_are_gone_once_another_begins() {
    let sandbox = Sandbox::new();
    let optimize = ["optimize", "experiment.toml", "--out", "out", "--iterations", "3"];
    sandbox.succeed(&optimize);
    assert!(sandbox.path("out/summary.json").exists());
    // Nobody has to fear for results who does not ask for that.
    sandbox.refuse_with(&optimize, &["out: holds the results", "--out", "--overwrite"]);
    fs::rename(sandbox.path("out/checkpoint.json"), sandbox.path("kept.json")).unwrap();
    let resume = [&optimize[..], &["--resume"]].concat();
    sandbox.refuse_with(&resume, &["out: holds the results", "--overwrite"]);
    fs::rename(sandbox.path("kept.json"), sandbox.path("out/checkpoint.json")).unwrap();
    // It cannot write its images.
    fs::remove_dir_all(sandbox.path("out/strip")).unwrap();
    sandbox.write("out/strip", "a file");
    let output = sandbox.run(&[&optimize[..], &["--overwrite"]].concat());
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    for name in ["summary.json", "history.csv", "trajectory.json", "loss.svg"] {
        assert!(!sandbox.path("out").join(name).exists(), "{name}");
    }
    // Whoever resumes it gets all of them.
    fs::remove_file(sandbox.path("out/strip")).unwrap();
    sandbox.succeed(&resume);
    assert!(sandbox.path("out/summary.json").exists());
    // A run of another problem, and one that is not finished, make room too.
    sandbox.succeed(&[&optimize[..], &["--overwrite", "--param", "light.key.color"]].concat());
    let checkpoint = String::from_utf8(sandbox.read("out/checkpoint.json")).unwrap();
    sandbox.write("out/checkpoint.json", checkpoint.replace("\"checksum\"", "\"lost\""));
    sandbox.succeed(&[&optimize[..], &["--overwrite"]].concat());
}
