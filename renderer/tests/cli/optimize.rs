//! `renderer optimize`

use renderer::files::load_image;

use crate::sandbox::{SCENE, Sandbox, numbers};

#[test]
fn leaves_every_result() {
    let sandbox = Sandbox::new();
    let output = sandbox.run(&["optimize", "experiment.toml", "--out", "out"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert_eq!(
        sandbox.names("out"),
        [
            "checkpoint.json",
            "difference.png",
            "final.png",
            "history.csv",
            "initial.png",
            "loss.svg",
            "meshes",
            "scene.toml",
            "strip",
            "summary.json",
            "target.png",
            "trajectory.json"
        ]
    );
    for name in ["target", "initial", "final", "difference"] {
        let image = load_image(&sandbox.path(&format!("out/{name}.png"))).unwrap().image;
        assert_eq!((image.width, image.height), (24, 16), "{name}");
    }
    assert!(sandbox.read("out/loss.svg").starts_with(b"<svg"));

    // The summary tells the whole story, and the history agrees.
    let summary = sandbox.json("out/summary.json");
    let loss = |name: &str| summary["loss"][name].as_f64().unwrap();
    assert!(loss("final") < 0.1 * loss("initial"), "{summary:#}");
    assert_eq!(
        (&summary["iterations"], &summary["stop_reason"]),
        (&40.into(), &"iterations".into())
    );
    assert!(summary["seconds"].as_f64().unwrap() > 0.0);
    let position = &summary["parameters"]["light.key.position"];
    assert_eq!(numbers(&position["initial"]), [1.5, 3.0, 2.0]);
    assert_eq!(numbers(&position["target"]), [-1.0, 2.5, 2.5]);
    let history = String::from_utf8(sandbox.read("out/history.csv")).unwrap();
    let losses = history.lines().skip(1).map(|row| row.split(',').nth(1).unwrap().parse());
    let losses: Vec<f64> = losses.collect::<Result<_, _>>().unwrap();
    assert_eq!((losses.len(), losses[0]), (41, loss("initial")));
    assert_eq!(losses.iter().copied().fold(f64::INFINITY, f64::min), loss("final"));

    // Lines for people: truth beside recovery, and plain progress, for this is no terminal.
    let report = String::from_utf8(output.stdout).unwrap();
    assert!(report.contains("  true       [-1, 2.5, 2.5]"), "{report}");
    assert!(report.ends_with("results in out\n"), "{report}");
    let progress = String::from_utf8(output.stderr).unwrap();
    let first = progress.lines().next().unwrap();
    assert!(first.starts_with("iteration 0/40  loss "), "{progress}");
    assert!(!progress.contains(['\r', '\u{1b}']), "{progress:?}");
}

#[test]
fn a_report_is_one_page_that_needs_nothing_else() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&["optimize", "experiment.toml", "--out", "out"]);
    assert_eq!(sandbox.succeed(&["report", "out"]), "out/report.html\n");
    let page = String::from_utf8(sandbox.read("out/report.html")).unwrap();
    let strip = sandbox.json("out/summary.json")["strip"].as_array().unwrap().len();
    assert_eq!(page.matches("class=\"frame\"").count(), strip);
    assert!(strip > 10 && page.contains("<h2>Trajectories</h2>"));
    assert_eq!(page.matches("class=\"truth\"").count(), 4);
    assert_eq!(page.matches("src=").count(), 4 + strip);
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 4 + strip);
    sandbox.refuse_with(&["report", "none"], &["none/summary.json: no such file"]);
    sandbox.refuse_with(&["report", "scene.toml"], &["scene.toml: is a file", "folder"]);
}

#[test]
fn one_vertex_is_recovered_and_read_back() {
    let sandbox = Sandbox::new();
    // The edges at which it is are not in view.
    sandbox.write("floor.obj", "v -20 0 -20\nv 20 0 -20\nv 20 0 20\nv -20 0 20\nf 4 3 2 1\n");
    let section = "
[optimize]
iterations = 60

[optimize.target_values]
\"mesh.floor.vertices[1]\" = [20, 2, 20]

[[optimize.parameter]]
path = \"mesh.floor.vertices[1]\"
min = [20, -4, 20]
max = [20, 4, 20]
";
    sandbox.write("vertex.toml", format!("{SCENE}{section}"));
    sandbox.succeed(&["optimize", "vertex.toml", "--out", "out"]);
    let summary = sandbox.json("out/summary.json");
    let loss = |name: &str| summary["loss"][name].as_f64().unwrap();
    assert!(loss("final") < 0.1 * loss("initial"), "{summary:#}");
    let found = numbers(&summary["parameters"]["mesh.floor.vertices[1]"]["final"]);
    let before = sandbox.succeed_json(&["params", "scene.toml", "--json"]);
    let after = sandbox.succeed_json(&["params", "out/scene.toml", "--json"]);
    let mut expected = numbers(&before["mesh.floor.vertices"]);
    expected[3..6].copy_from_slice(&found);
    assert_eq!(numbers(&after["mesh.floor.vertices"]), expected);
}

#[test]
fn the_recovered_scene_has_the_loss_of_the_summary() {
    for precision in ["f32", "f64"] {
        let sandbox = Sandbox::new();
        sandbox.succeed(&["render", "scene.toml", "-o", "before.exr"]);
        let truth = sandbox.succeed(&["optimize", "experiment.toml", "--precision", precision]);
        // Without --out, the results are named after the scene.
        assert!(truth.ends_with("results in out/experiment\n"), "{truth}");
        let summary = sandbox.json("out/experiment/summary.json");
        let parameters = sandbox.succeed_json(&["params", "out/experiment/scene.toml", "--json"]);
        for (path, entry) in summary["parameters"].as_object().unwrap() {
            assert_eq!(numbers(&parameters[path]), numbers(&entry["final"]), "{path}");
        }

        let scene = String::from_utf8(sandbox.read("out/experiment/scene.toml")).unwrap();
        let section = crate::sandbox::OPTIMIZE;
        sandbox.write("out/experiment/again.toml", format!("{scene}{section}"));
        let again = ["gradient", "out/experiment/again.toml", "--precision", precision];
        let first = sandbox.succeed(&again).lines().next().unwrap().to_owned();
        let loss: f64 = first.strip_prefix("loss ").unwrap().parse().unwrap();
        let expected = summary["loss"]["final"].as_f64().unwrap();
        assert!((loss - expected).abs() <= 1e-5 * expected, "{precision}: {loss} {expected}");

        sandbox.succeed(&[
            "render",
            "out/experiment/scene.toml",
            "-o",
            "again.png",
            "--precision",
            precision,
        ]);
        assert_eq!(sandbox.read("again.png"), sandbox.read("out/experiment/final.png"));
    }
}

#[test]
fn an_obj_and_an_image_are_enough() {
    let sandbox = Sandbox::new();
    sandbox.write("wall.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0.5\nf 1 2 3\n");
    sandbox.succeed(&["render", "wall.obj", "-o", "photo.png"]);
    let arguments = ["optimize", "wall.obj", "--target", "photo.png", "--out", "out"];
    let more = ["--param", "material.default.diffuse", "--iterations", "3"];
    sandbox.succeed(&[&arguments[..], &more].concat());
    let summary = sandbox.json("out/summary.json");
    assert_eq!(summary["iterations"], 3);
    let diffuse = &summary["parameters"]["material.default.diffuse"];
    assert_eq!(numbers(&diffuse["initial"]), [0.7; 3]);
    assert!(diffuse.get("target").is_none());
}

#[test]
fn the_command_line_goes_before_the_scene_file() {
    let sandbox = Sandbox::new();
    let tolerance = ["--tolerance", "1e9", "--param", "light.key.radiant_intensity"];
    sandbox.succeed(&[&["optimize", "experiment.toml", "--out", "out"], &tolerance[..]].concat());
    let summary = sandbox.json("out/summary.json");
    assert_eq!((&summary["iterations"], &summary["stop_reason"]), (&0.into(), &"tolerance".into()));
    let parameters = summary["parameters"].as_object().unwrap();
    assert_eq!(parameters.keys().collect::<Vec<_>>(), ["light.key.radiant_intensity"]);
}

#[test]
fn methods_and_schedules_are_chosen_by_name() {
    let sandbox = Sandbox::new();
    let mut finals = Vec::new();
    for more in [
        &["--optimizer", "adam"][..],
        &["--optimizer", "adamw"],
        &["--optimizer", "rmsprop", "--schedule", "cosine"],
        &["--optimizer", "sgd", "--learning-rate", "20", "--schedule", "step"],
        &["--optimizer", "lbfgs", "--precision", "f64"],
    ] {
        let arguments = ["optimize", "experiment.toml", "--out", "out", "--overwrite"];
        sandbox.succeed(&[&arguments[..], more].concat());
        let summary = sandbox.json("out/summary.json");
        assert!(summary["loss"]["ratio"].as_f64().unwrap() < 0.5, "{more:?}: {summary:#}");
        finals.push(summary["loss"]["final"].to_string());
    }
    finals.dedup();
    assert_eq!(finals.len(), 5, "{finals:?}");

    // A method that the scene file gives numbers keeps them.
    let scene = String::from_utf8(sandbox.read("experiment.toml")).unwrap();
    let optimizer = "[optimize]\noptimizer = { type = \"sgd\", momentum = 0.0 }";
    sandbox.write("sgd.toml", scene.replace("[optimize]", optimizer));
    let losses = [&["--optimizer", "sgd"][..], &[]].map(|more| {
        let arguments = ["optimize", "sgd.toml", "--out", "out", "--learning-rate", "2"];
        sandbox.succeed(&[&arguments[..], &["--overwrite"], more].concat());
        sandbox.json("out/summary.json")["loss"].clone()
    });
    assert_eq!(losses[0], losses[1]);
}

#[test]
fn a_run_that_comes_to_what_is_not_finite_keeps_the_best_and_fails() {
    let sandbox = Sandbox::new();
    let optimize =
        ["optimize", "experiment.toml", "--out", "out", "--learning-rate", "1e30", "--resume"];
    // The second time it is finished, and no better.
    for _ in 0..2 {
        let output = sandbox.run(&optimize);
        assert_eq!(output.status.code(), Some(1), "{output:?}");
        let errors = String::from_utf8(output.stderr).unwrap();
        let line = errors.lines().last().unwrap();
        for part in ["error: experiment.toml: the ", "at iteration 1", "iteration 0 had found"] {
            assert!(line.contains(part), "{part}: {errors}");
        }
    }
    let summary = sandbox.json("out/summary.json");
    assert!(summary["loss"]["final"].as_f64().unwrap().is_finite(), "{summary:#}");
    let position = &summary["parameters"]["light.key.position"];
    assert_eq!(numbers(&position["final"]), numbers(&position["initial"]));
    sandbox.succeed(&["render", "out/scene.toml", "-o", "kept.png"]);
}

/// What `render` writes shows edges as areas, which images of a run without them come close to by other colours.
#[test]
fn edges_are_recommended_where_the_target_has_them() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&["render", "scene.toml", "-o", "with.exr"]);
    sandbox.succeed(&["render", "scene.toml", "-o", "without.exr", "--antialias", "none"]);
    let parameter = "[[optimize.parameter]]\npath = \"material.paint.diffuse\"\n";
    let changed = SCENE.replace("[0.6, 0.3, 0.2]", "[0.4, 0.4, 0.4]");
    sandbox.write("find.toml", format!("{changed}[optimize]\niterations = 100\n{parameter}"));
    let notes = |target: &str, more: &[&str]| {
        let arguments = ["optimize", "find.toml", "--out", "out", "--target", target];
        let output = sandbox.run(&[&arguments[..], &["--overwrite"], more].concat());
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stderr).unwrap()
    };
    let recommended = notes("with.exr", &[]);
    assert_eq!(recommended.matches("--edges on recovers with edges").count(), 1, "{recommended}");
    for (target, more) in [
        ("with.exr", &["--edges", "on"][..]),
        ("with.exr", &["--edges", "off"]),
        ("without.exr", &[]),
    ] {
        let notes = notes(target, more);
        assert!(!notes.contains("--edges"), "{target} {more:?}: {notes}");
    }
}

#[test]
fn the_demo_recovers_the_light() {
    let sandbox = Sandbox::new();
    // It starts from the beginning, whatever an earlier one left.
    std::fs::create_dir_all(sandbox.path("out/demo")).unwrap();
    sandbox.write("out/demo/checkpoint.json", "broken");
    sandbox.write("out/demo/summary.json", "finished");
    let report = sandbox.succeed(&[]);
    let summary = sandbox.json("out/demo/summary.json");
    assert!(summary["loss"]["ratio"].as_f64().unwrap() < 1e-4, "{summary:#}");
    assert!(report.contains("  true       5000"), "{report}");
    assert!(report.contains("degrees off, irradiance"), "{report}");
}

/// The brightness of three lights, too dark or too bright by a hundred, or both.
#[test]
fn intensities_that_are_off_by_a_hundred_are_found_as_logarithms() {
    let sandbox = Sandbox::new();
    let lights = [
        ("key", "radiant_intensity", 30.0),
        ("fill", "radiant_intensity", 8.0),
        ("sun", "irradiance", 1.0),
    ];
    let more = "[[light]]\nname = \"fill\"\ntype = \"point\"\nposition = [-2.0, 2.0, 1.5]\n\
                color = [0.4, 1.0, 0.4]\nradiant_intensity = 8.0\n\
                [[light]]\nname = \"sun\"\ntype = \"distant\"\ndirection = [0.1, 1.0, -0.4]\nirradiance = 1.0\n";
    for factors in [[0.01; 3], [100.0; 3], [0.01, 100.0, 0.01]] {
        let found = |scale: &str| {
            let mut text = format!("{SCENE}{more}");
            let (mut truth, mut parameters) = (String::new(), String::new());
            for ((name, field, value), factor) in lights.into_iter().zip(factors) {
                let start = factor * value;
                text =
                    text.replace(&format!("{field} = {value:.1}"), &format!("{field} = {start:?}"));
                truth += &format!("\"light.{name}.{field}\" = {value:?}\n");
                parameters += &format!(
                    "[[optimize.parameter]]\npath = \"light.{name}.{field}\"\nscale = \"{scale}\"\n"
                );
            }
            let section = "[optimize]\nloss = \"l1\"\noptimizer = \"rmsprop\"\niterations = 300\n";
            let target = format!("[optimize.target_values]\n{truth}");
            sandbox.write("off.toml", format!("{text}{section}{target}{parameters}"));
            sandbox.succeed(&["optimize", "off.toml", "--out", scale, "--overwrite"]);
            let summary = sandbox.json(&format!("{scale}/summary.json"));
            let off = |((name, field, value), factor): ((&str, &str, f64), f64)| {
                let parameter = &summary["parameters"][format!("light.{name}.{field}")];
                assert_eq!(numbers(&parameter["initial"]), [factor * value], "{name}");
                (numbers(&parameter["final"])[0] / value).ln().abs()
            };
            lights.into_iter().zip(factors).map(off).fold(0.0, f64::max)
        };
        let (linear, logarithmic) = (found("linear"), found("log"));
        assert!(logarithmic < 0.02, "{factors:?}: {logarithmic}");
        assert!(factors == [0.01; 3] || linear > 0.1, "{factors:?}: {linear}");
    }
}
