//! `renderer tradeoff`, and `--accuracy`

use super::sandbox::Sandbox;

#[test]
fn settings_are_measured_into_a_table_and_plots() {
    let sandbox = Sandbox::new();
    let arguments = ["tradeoff", "scene.toml", "--seconds", "0", "--param"];
    let text = sandbox.succeed(&[&arguments[..], &["material.paint.exponent"]].concat());
    let row = |start: &str| -> Vec<&str> {
        let line = text.lines().find(|line| line.starts_with(start));
        line.unwrap_or_else(|| panic!("no {start}: {text}")).split_whitespace().collect()
    };
    // The last columns: memory, the errors of image and gradient.
    let memory: f64 = row("adjoint           f64x8")[4].parse().unwrap();
    assert!(memory > 0.0, "{text}");
    let error: f64 = row("other engines     tape per strip")[10].parse().unwrap();
    assert!(error < 1e-10, "{text}");
    assert!(text.contains("differences, f64: the best step is"), "{text}");
    assert!(text.contains("1/4, 1/2, full"), "{text}");

    let names = sandbox.names("out/tradeoff");
    let expected = ["-rays.csv", "-rays.svg", "-schedules.svg", "-steps.svg", ".csv", ".svg"];
    assert_eq!(names, expected.map(|suffix| format!("scene{suffix}")));
    let csv = String::from_utf8(sandbox.read("out/tradeoff/scene.csv")).unwrap();
    let columns = csv.lines().map(|line| line.split(',').count()).collect::<Vec<_>>();
    assert!(columns.len() > 30 && columns[0] == 8, "{csv}");
    for name in names.iter().filter(|name| name.ends_with(".svg")) {
        let svg = String::from_utf8(sandbox.read(&format!("out/tradeoff/{name}"))).unwrap();
        assert!(svg.contains("<circle") || svg.contains("<polyline"), "{name}");
        assert!(!svg.contains("NaN"), "{name}");
    }
}

#[test]
fn the_dial_picks_single_precision_where_it_is_enough() {
    let sandbox = Sandbox::new();
    let arguments =
        |accuracy: &'static str| ["gradient", "experiment.toml", "--accuracy", accuracy];
    for (accuracy, setting) in [("1e-2", "f32x16"), ("1e-9", "f64x8")] {
        let output = sandbox.run(&arguments(accuracy));
        assert!(output.status.success(), "{output:?}");
        let notes = String::from_utf8(output.stderr).unwrap();
        assert!(
            notes.contains(&format!(": {setting}, 0 bounces, 1 ray per pixel, the cheapest")),
            "{notes}"
        );
        let shown = String::from_utf8(output.stdout).unwrap();
        assert!(shown.starts_with("loss "), "{shown}");
        if setting == "f64x8" {
            let chosen = ["gradient", "experiment.toml", "--precision", "f64"];
            assert_eq!(shown, sandbox.succeed(&chosen));
        }
    }
    let output = sandbox.run(&arguments("1e-18"));
    let notes = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && notes.contains("cannot be met"), "{notes}");
}

/// The pixels of an image file are integrals, so their rays are chosen, unless somebody does.
#[test]
fn the_dial_chooses_rays_for_an_image_file() {
    let sandbox = Sandbox::new();
    sandbox.write_changed("dim.toml", "radiant_intensity = 30.0", "radiant_intensity = 20.0");
    sandbox.succeed(&["render", "dim.toml", "--samples", "64", "-o", "photo.png"]);
    let gradient = |extra: &[&'static str]| {
        let arguments = [
            "gradient",
            "scene.toml",
            "--target",
            "photo.png",
            "--param",
            "light.key.radiant_intensity",
            "--accuracy",
            "0.01",
        ];
        let output = sandbox.run(&[&arguments[..], extra].concat());
        assert!(output.status.success(), "{output:?}");
        let notes = String::from_utf8(output.stderr).unwrap();
        (notes.lines().next().unwrap().to_owned(), String::from_utf8(output.stdout).unwrap())
    };
    let (chosen, shown) = gradient(&[]);
    assert!(chosen.contains("rays per pixel, the cheapest within it"), "{chosen}");
    let count = chosen.split(" rays").next().unwrap().rsplit(' ').next().unwrap();
    let count: u32 = count.parse().unwrap();
    assert!((2..=256).contains(&count), "{chosen}");

    let (given, other) = gradient(&["--samples", "1"]);
    assert!(given.contains("1 ray per pixel, the cheapest within it"), "{given}");
    assert_ne!(shown, other);
    let (stratified, _) = gradient(&["--sampler", "stratified"]);
    assert!(stratified.contains("rays per pixel"), "{stratified}");

    let unmet = ["--accuracy", "1e-12"];
    let arguments = ["gradient", "scene.toml", "--target", "photo.png", "--param"];
    let output = sandbox.run(&[&arguments[..], &["light.key.radiant_intensity"], &unmet].concat());
    let notes = String::from_utf8(output.stderr).unwrap();
    assert!(notes.contains("cannot be met") && notes.contains("256 rays per pixel"), "{notes}");
}

#[test]
fn an_optimisation_within_an_accuracy_can_be_resumed() {
    let sandbox = Sandbox::new();
    let arguments = ["optimize", "experiment.toml", "--accuracy", "1e-9", "--iterations"];
    sandbox.succeed(&[&arguments[..], &["10"]].concat());
    sandbox.succeed(&[&arguments[..], &["40", "--resume"]].concat());
    let whole = ["optimize", "experiment.toml", "--precision", "f64", "--out", "whole"];
    sandbox.succeed(&whole);
    let values =
        |folder: &str| sandbox.json(&format!("{folder}/summary.json"))["parameters"].clone();
    assert_eq!(values("out/experiment"), values("whole"));
}

#[test]
fn contradictions_are_refused() {
    let sandbox = Sandbox::new();
    let gradient = ["gradient", "experiment.toml", "--accuracy", "1e-3"];
    sandbox.refuse_with(
        &[&gradient[..], &["--precision", "f64"]].concat(),
        &["--accuracy", "leave out --precision"],
    );
    sandbox.refuse_with(&["tradeoff", "scene.toml"], &["scene.toml", "no parameter"]);
    sandbox.write("file", "");
    let tradeoff = ["tradeoff", "experiment.toml", "--out", "file"];
    sandbox.refuse_with(&tradeoff, &["file", "need a folder"]);
}
