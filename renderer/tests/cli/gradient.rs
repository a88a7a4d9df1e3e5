//! `renderer gradient`

use crate::sandbox::{Sandbox, numbers};

/// Every parameter that moves no edge.
const SMOOTH: [&str; 6] = [
    "light.key.color",
    "light.key.radiant_intensity",
    "material.paint.emission",
    "material.paint.diffuse",
    "material.paint.specular",
    "material.paint.exponent",
];

fn arguments<'a>(parameters: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    let mut arguments = vec!["gradient", "scene.toml", "--target", "target.exr"];
    arguments.extend(parameters.iter().flat_map(|path| ["--param", path]));
    arguments.extend(more);
    arguments
}

fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write_changed("truth.toml", "[0.6, 0.3, 0.2]", "[0.2, 0.5, 0.6]");
    sandbox.succeed(&["render", "truth.toml", "-o", "target.exr"]);
    sandbox
}

#[test]
fn check_agrees_with_finite_differences() {
    let sandbox = sandbox();
    for (precision, samples) in [("f32", "1"), ("f64", "1"), ("f64", "5")] {
        let options = ["--check", "--precision", precision, "--samples", samples];
        let errors = errors(&sandbox, &arguments(&SMOOTH, &options));
        assert_eq!(errors.len(), SMOOTH.len());
        let most = if precision == "f32" { 1e-3 } else { 1e-5 };
        assert!(errors.iter().all(|&(_, error)| error < most), "{precision}: {errors:?}");
    }
}

/// The relative errors that `gradient --check` finds, in the order of their paths.
fn errors(sandbox: &Sandbox, arguments: &[&str]) -> Vec<(String, f64)> {
    let mut arguments = arguments.to_vec();
    arguments.push("--json");
    let json = sandbox.succeed_json(&arguments);
    let errors = json["check"].as_object().unwrap();
    errors.iter().map(|(path, error)| (path.clone(), error.as_f64().unwrap())).collect()
}

#[test]
fn check_judges_what_moves_edges_by_finely_sampled_images() {
    let sandbox = Sandbox::new();
    sandbox.write_changed("truth.toml", "[0.0, 0.5, 0.0]", "[0.1, 0.5, 0.1]");
    sandbox.succeed(&["render", "truth.toml", "-o", "target.exr"]);
    let paths = ["light.key.position", "sphere.ball.radius"];
    let with = |paths: &[&'static str], edges| {
        arguments(paths, &["--check", "--samples", "64", "--edges", edges])
    };
    let text = sandbox.succeed(&[&with(&paths, "on")[..], &["--tolerance", "0.1"]].concat());
    assert_eq!(text.matches("agrees").count(), 2, "{text}");

    let output = sandbox.run(&with(&paths, "off"));
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.matches("DISAGREES").count(), 2, "{text}");
    let note = String::from_utf8(output.stderr).unwrap();
    assert!(note.contains("interior term only"), "{note}");

    let mut lenient = with(&paths[1..], "off");
    lenient.extend(["--tolerance", "0.99"]);
    let json = sandbox.run(&[&lenient[..], &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert!(json["check"]["sphere.ball.radius"].as_f64().unwrap() > 0.1, "{json}");
}

/// Scaled and shifted by options of the library; the differences of places on a texture are taken
/// between its kinks.
#[test]
fn textures_agree_with_finite_differences() {
    let sandbox = Sandbox::new();
    let light = sandbox.succeed(&["render", "scene.toml", "-o", "noise.png"]);
    assert_eq!(light, "noise.png\n");
    let floor = crate::sandbox::FLOOR
        .replace("f 4 3 2 1", "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl wood\nf 4/4 3/3 2/2 1/1");
    sandbox.write("floor.obj", format!("mtllib wood.mtl\n{floor}"));
    sandbox.write("wood.mtl", "newmtl wood\nmap_Kd -s 1.5 2 -o 0.25 -0.5 noise.png\n");
    sandbox.write_changed("truth.toml", "radiant_intensity = 30.0", "radiant_intensity = 22.5");
    sandbox.succeed(&["render", "truth.toml", "-o", "target.exr"]);
    let parameters = ["mesh.floor.texture_coordinates", "texture.noise.texels"];
    let errors = errors(&sandbox, &arguments(&parameters, &["--check", "--precision", "f64"]));
    assert!(errors.len() == 2 && errors.iter().all(|&(_, error)| error < 1e-5), "{errors:?}");
}

#[test]
fn json_maps_paths_to_the_numbers_of_the_table() {
    let sandbox = sandbox();
    let parameters = ["light.key.radiant_intensity", "light.key.position", "mesh.floor.vertices"];
    let json = sandbox.succeed_json(&arguments(&parameters, &["--json"]));
    assert_eq!(json.len(), 3);
    assert!(json["light.key.radiant_intensity"].is_number());
    assert_eq!(json["light.key.position"].as_array().unwrap().len(), 3);
    assert_eq!(numbers(&json["mesh.floor.vertices"]).len(), 12);

    let table = sandbox.succeed(&arguments(&parameters, &[]));
    let listed: Vec<f64> =
        table.lines().filter_map(|line| line.split_whitespace().last()?.parse().ok()).collect();
    let expected = parameters.iter().flat_map(|path| numbers(&json[*path]));
    for (listed, expected) in listed[1..].iter().zip(expected) {
        assert!((listed - expected).abs() <= 1e-5 * expected.abs(), "{listed} {expected}");
    }
    assert_eq!(listed.len(), 1 + 1 + 3 + 12);
}

#[test]
fn one_vertex_has_its_part_of_the_gradient() {
    let sandbox = Sandbox::new();
    sandbox.write_changed("truth.toml", "radiant_intensity = 30.0", "radiant_intensity = 22.5");
    sandbox.succeed(&["render", "truth.toml", "-o", "target.exr"]);
    let vertex = "mesh.floor.vertices[2]";
    let json =
        sandbox.succeed_json(&arguments(&["mesh.floor.vertices", "light.key.color"], &["--json"]));
    let expected = numbers(&json["mesh.floor.vertices"])[6..9].to_vec();
    assert!(expected.iter().any(|derivative| *derivative != 0.0));
    let json = sandbox.succeed_json(&arguments(&[vertex], &["--json"]));
    assert_eq!((json.len(), numbers(&json[vertex])), (1, expected));
}

#[test]
fn threads_change_no_bit() {
    let sandbox = sandbox();
    let parameters = ["camera.look_from", "light.key.position", "mesh.floor.vertices"];
    let [one, two] = ["1", "2"]
        .map(|threads| sandbox.succeed(&arguments(&parameters, &["--json", "--threads", threads])));
    assert_eq!(one, two);
}

#[test]
fn the_parameters_of_the_scene_file_are_the_default() {
    let sandbox = Sandbox::new();
    let json = sandbox.succeed_json(&["gradient", "experiment.toml", "--json"]);
    assert_eq!(
        json.keys().collect::<Vec<_>>(),
        ["light.key.position", "light.key.radiant_intensity"]
    );
}
