//! Results never replace what they are made from.

use std::fs;

use crate::sandbox::{SCENE, Sandbox};

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
    sandbox.write("meshes/floor.obj", crate::sandbox::FLOOR);
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

/// A run that does not come to its end leaves nothing that could be taken for its result.
#[test]
fn the_results_of_an_earlier_run_are_gone_once_another_begins() {
    let sandbox = Sandbox::new();
    let optimize = ["optimize", "experiment.toml", "--out", "out", "--iterations", "3"];
    sandbox.succeed(&optimize);
    assert!(sandbox.path("out/summary.json").exists());
    // It cannot write its images.
    fs::remove_dir_all(sandbox.path("out/strip")).unwrap();
    sandbox.write("out/strip", "a file");
    let output = sandbox.run(&optimize);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    for name in ["summary.json", "history.csv", "trajectory.json", "loss.svg"] {
        assert!(!sandbox.path("out").join(name).exists(), "{name}");
    }
    // Whoever resumes it gets all of them.
    fs::remove_file(sandbox.path("out/strip")).unwrap();
    sandbox.succeed(&[&optimize[..], &["--resume"]].concat());
    assert!(sandbox.path("out/summary.json").exists());
}
