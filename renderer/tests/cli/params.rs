//! `renderer params`

use std::process::Stdio;

use crate::sandbox::{Sandbox, numbers};

#[test]
fn the_table_lists_every_parameter() {
    let sandbox = Sandbox::new();
    let table = sandbox.succeed(&["params", "scene.toml"]);
    let row = |path: &str| {
        let row = table.lines().find(|line| line.starts_with(&format!("{path} ")));
        row.unwrap_or_else(|| panic!("no {path} in\n{table}")).to_owned()
    };
    assert!(row("light.key.position").ends_with("[1.5, 3, 2]"));
    assert!(row("light.key.radiant_intensity").contains("  differentiable "));
    assert!(row("sphere.ball.radius").contains("without moving edges"));
    assert!(row("mesh.floor.vertices").contains(" 4 x 3 "));
    assert!(row("camera.width").contains("not differentiable"));
    assert!(row("camera.width").ends_with(" 24"));
}

#[test]
fn json_maps_paths_to_numbers() {
    let sandbox = Sandbox::new();
    let json = sandbox.succeed_json(&["params", "scene.toml", "--json", "--precision", "f64"]);
    assert_eq!(numbers(&json["light.key.position"]), [1.5, 3.0, 2.0]);
    assert_eq!(json["light.key.radiant_intensity"], 30.0);
    assert_eq!(json["camera.height"], 16);
    assert_eq!(json["mesh.floor.vertices"].as_array().unwrap().len(), 4);
    let table = sandbox.succeed(&["params", "scene.toml"]);
    assert_eq!(table.lines().count(), json.len());
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let sandbox = Sandbox::new();
    // More than a pipe holds, so that the process still writes when its reader is gone.
    let grid: String = (0..30_000).map(|i| format!("v {i} 0 {}\n", i % 7)).collect();
    let faces: String = (1..29_999).map(|i| format!("f {i} {} {}\n", i + 1, i + 2)).collect();
    sandbox.write("grid.obj", grid + &faces);
    let mut child = sandbox
        .command(&["params", "grid.obj", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    assert_eq!(output.status.code(), Some(0));
}
