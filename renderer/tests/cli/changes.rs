//! What the command line writes to begin with, and changes.

use crate::sandbox::{FLOOR, Sandbox, numbers};

#[test]
fn what_init_writes_can_be_rendered_and_optimised() {
    let sandbox = Sandbox::new();
    assert_eq!(sandbox.succeed(&["init", "-o", "mine.toml"]), "mine.toml\n");
    let small = ["--width", "24"];
    sandbox.succeed(&[&["render", "mine.toml", "-o", "mine.png"], &small[..]].concat());
    sandbox.succeed(
        &[&["optimize", "mine.toml", "--out", "o", "--iterations", "2"], &small[..]].concat(),
    );
    sandbox.refuse_with(&["init", "-o", "mine.toml"], &["mine.toml: is there already"]);

    // Places are written as exactly as the size of the mesh asks for, wherever it is.
    for far in [0.0, 12_345_678.9] {
        let [low, high] = [-2.0, 2.0].map(|x| format!("v {:?} ", x + far));
        sandbox.write("floor.obj", FLOOR.replace("v -2 ", &low).replace("v 2 ", &high));
        let scene = format!("floor{far}.toml");
        sandbox.succeed(&["init", "floor.obj", "-o", &scene]);
        let [framed, written] =
            ["floor.obj", &scene].map(|scene| sandbox.succeed_json(&["params", scene, "--json"]));
        for path in ["camera.look_from", "camera.look_at", "light.key.position"] {
            for (a, b) in numbers(&framed[path]).iter().zip(numbers(&written[path])) {
                assert!((a - b).abs() < 1e-5, "{far}: {path} is {b}, not {a}");
            }
        }
    }
}

#[test]
fn the_format_is_explained() {
    let text = Sandbox::new().succeed(&["scene"]);
    for word in ["[[light]]", "radiant_intensity", "[[optimize.parameter]]", "roughness"] {
        assert!(text.contains(word), "{word}");
    }
}

#[test]
fn sizes_and_numbers_are_changed() {
    let sandbox = Sandbox::new();
    let json =
        |more: &[&str]| sandbox.succeed_json(&[&["params", "scene.toml", "--json"], more].concat());
    let changed = json(&["--width", "48", "--set", "light.key.position=1,2,3.5"]);
    assert_eq!((&changed["camera.width"], &changed["camera.height"]), (&48.into(), &32.into()));
    assert_eq!(changed["light.key.position"], serde_json::json!([1.0, 2.0, 3.5]));
    let changed = json(&["--height", "8", "--set", "material.paint.diffuse = 0.5"]);
    assert_eq!((&changed["camera.width"], &changed["camera.height"]), (&12.into(), &8.into()));
    assert_eq!(changed["material.paint.diffuse"], serde_json::json!([0.5, 0.5, 0.5]));

    for (change, problem) in [
        ("light.key.position", "is not PATH=VALUE"),
        ("light.key.positon=1", "closest: light.key.position"),
        ("light.key.position=1,2", "needs 3 numbers, has 2"),
        ("light.key.position=1,2,x", "`x` is not a number"),
        ("sphere.ball.radius=-1", "sphere.ball.radius"),
    ] {
        sandbox.refuse_with(&["params", "scene.toml", "--set", change], &[problem]);
    }
}

/// The losses differ by what they divide by.
#[test]
fn the_loss_is_chosen() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&[
        "render",
        "scene.toml",
        "--set",
        "light.key.radiant_intensity=40",
        "-o",
        "a.exr",
    ]);
    let gradient = |loss| {
        let arguments = ["gradient", "scene.toml", "--target", "a.exr", "--json", "--loss", loss];
        let parameter = ["--param", "light.key.radiant_intensity"];
        let found = sandbox.succeed_json(&[&arguments[..], &parameter].concat());
        crate::sandbox::numbers(&found["light.key.radiant_intensity"])[0]
    };
    let ratio = gradient("sum_squared") / gradient("mean_squared");
    assert!((ratio / (3.0 * 24.0 * 16.0) - 1.0).abs() < 1e-6, "{ratio}");
    assert!(gradient("l1") < 0.0);
}
