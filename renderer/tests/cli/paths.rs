//! Scenes in which light takes all paths.

use renderer::Image;
use renderer::files::{load_image, save_exr};

use crate::sandbox::{SCENE, Sandbox};

const PATH: &str = "[integrator]\ntype = \"path\"\nmax_depth = 3\nsamples = 4\n";
const SKY: &str = "[environment]\nradiance = [0.5, 0.6, 0.7]\n";
const RENDER: [&str; 4] = ["render", "bad.toml", "-o", "out.png"];

#[test]
fn scenes_say_which_paths_count() {
    let sandbox = Sandbox::new();
    sandbox.write("path.toml", format!("{PATH}{SKY}{SCENE}"));
    sandbox.succeed(&["render", "path.toml", "-o", "path.exr"]);
    sandbox.succeed(&["render", "path.toml", "-o", "albedo.exr", "--pass", "albedo"]);
    sandbox.succeed(&["render", "path.toml", "-o", "more.exr", "--samples", "16"]);
    sandbox.succeed(&["render", "scene.toml", "-o", "direct.exr"]);
    assert_ne!(sandbox.read("path.exr"), sandbox.read("direct.exr"));
    assert_ne!(sandbox.read("path.exr"), sandbox.read("more.exr"));
    // The command line goes before the samples of the scene, whose seed stays.
    for [samples, seed] in [["1", "0"], ["4", "7"]] {
        let scene = |samples: &str| {
            let path = PATH.replace("= 4", &format!("= {samples}\nseed = {seed}"));
            format!("{path}{SKY}{SCENE}")
        };
        sandbox.write("said.toml", scene(samples));
        sandbox.write("other.toml", scene("9"));
        sandbox.succeed(&["render", "said.toml", "-o", "said.exr"]);
        sandbox.succeed(&["render", "other.toml", "-o", "other.exr", "--samples", samples]);
        assert_eq!(sandbox.read("said.exr"), sandbox.read("other.exr"));
        assert_ne!(sandbox.read("said.exr"), sandbox.read("path.exr"));
    }
    let table = sandbox.succeed(&["params", "path.toml"]);
    let row = |path: &str| table.lines().find(|line| line.starts_with(path)).unwrap().to_owned();
    assert!(row("environment.radiance ").contains("  differentiable "));
    assert!(row("light.key.color ").contains("  differentiable "));
    for path in ["light.key.position ", "camera.vfov ", "sphere.ball.center "] {
        assert!(row(path).contains("  differentiable "));
    }
}

/// Derivatives by what moves are noisy where paths meet metals that are nearly mirrors.
#[test]
fn noise_of_smooth_metals_is_warned_of() {
    let sandbox = Sandbox::new();
    let metal = |roughness: &str| {
        let metal = format!(
            "[material.paint]\ntype = \"metallic_roughness\"\nmetallic = 1.0\nroughness = {roughness}\ndiffuse = [0.6, 0.3, 0.2]\n"
        );
        let (scene, _) = SCENE.split_once("[material.paint]").unwrap();
        format!("{PATH}{SKY}{scene}{metal}[optimize]\n")
    };
    sandbox.write("smooth.toml", metal("0.05"));
    sandbox.write("rough.toml", metal("0.4"));
    sandbox.succeed(&["render", "rough.toml", "-o", "target.exr"]);
    for (scene, path, warns) in [
        ("smooth.toml", "sphere.ball.center", true),
        ("smooth.toml", "material.paint.diffuse", false),
        ("rough.toml", "sphere.ball.center", false),
    ] {
        let output = sandbox.run(&["gradient", scene, "--target", "target.exr", "--param", path]);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(0), "{said}");
        let warning = "material.paint: derivatives by what moves are noisy";
        assert_eq!(said.contains(warning), warns, "{scene} {path}: {said}");
    }
}

/// Images are rendered to an error or a time, and say how far they are off.
#[test]
fn images_may_be_rendered_to_an_error_or_a_time() {
    let sandbox = Sandbox::new();
    sandbox.write("path.toml", format!("{PATH}{SKY}{SCENE}"));
    let render = ["render", "path.toml", "-o", "a.exr"];
    let run = |more: &[&str]| {
        let output = sandbox.run(&[&render[..], more].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let said = String::from_utf8(output.stderr).unwrap();
        let number = |after: &str| {
            let rest = said.split(after).nth(1).unwrap();
            rest.split([' ', ',']).next().unwrap().parse::<f64>().unwrap()
        };
        (said.split(' ').next().unwrap().parse::<f64>().unwrap(), number("error "))
    };
    let (few, error) = run(&["--target-error", "0.05", "--standard-error", "off.exr"]);
    assert!(error <= 0.05 && few >= 8.0, "{few} {error}");
    let off = load_image(&sandbox.path("off.exr")).unwrap().image;
    assert!(off.is_finite() && off.pixels.iter().any(|pixel| pixel[0] > 0.0));
    let (more, error) = run(&["--target-error", "0.02"]);
    assert!(error <= 0.02 && more > few, "{more} {error}");
    assert_eq!(run(&["--time-limit", "1e-9"]).0, 2.0);
    for time in ["0", "-1", "soon"] {
        let limited = [&render[..], &["--time-limit", time]].concat();
        sandbox.refuse_with(&limited, &["--time-limit", "has to be a number of seconds above 0"]);
    }
    let refused = |scene: &str, more: &[&str], part: &str| {
        sandbox.refuse_with(&[&["render", scene, "-o", "a.exr"], more].concat(), &[part]);
    };
    refused(
        "scene.toml",
        &["--time-limit", "1"],
        "--time-limit: images of direct light have no noise",
    );
    refused(
        "path.toml",
        &["--standard-error", "b.exr"],
        "--standard-error: is that of several batches",
    );
    let output = sandbox.run(&[&render[..], &["--target-error", "0"]].concat());
    assert_eq!(output.status.code(), Some(2));
}

const MAP: &str = "[environment]\ntexture = \"sky\"\n[texture.sky]\npath = \"sky.hdr\"\n";

/// A map is what the program renders itself, in either format; what is no light is refused.
#[test]
fn environments_are_maps_from_files() {
    let sandbox = Sandbox::new();
    sandbox.write("path.toml", format!("{PATH}{SKY}{SCENE}"));
    sandbox.succeed(&["render", "path.toml", "-o", "sky.hdr"]);
    sandbox.succeed(&["render", "path.toml", "-o", "sky.exr"]);
    for name in ["sky.hdr", "sky.exr"] {
        sandbox.write("map.toml", format!("{PATH}{MAP}{SCENE}").replace("sky.hdr", name));
        sandbox.succeed(&["render", "map.toml", "-o", "lit.png", "--tone", "aces"]);
    }
    let table = sandbox.succeed(&["params", "map.toml"]);
    let row = |path: &str| table.lines().find(|line| line.starts_with(path)).unwrap().to_owned();
    for path in ["environment.radiance ", "environment.rotation ", "texture.sky.texels "] {
        assert!(row(path).contains("  differentiable "), "{table}");
    }
    let gradient = ["gradient", "map.toml", "--target", "lit.png", "--param"];
    let verdict = sandbox.succeed(&[&gradient[..], &["environment.rotation", "--check"]].concat());
    assert!(verdict.contains("  agrees: "), "{verdict}");
    let render = ["render", "map.toml", "-o", "out.png"];
    let dark = Image { width: 2, height: 1, pixels: vec![[1.0; 3], [1.0, -0.5, 1.0]] };
    save_exr(&dark, &sandbox.path("sky.exr")).unwrap();
    sandbox.refuse_with(&render, &["texture.sky.texels[1]", "must not be negative, is -0.5"]);
    sandbox.write("sky.exr", "no image");
    sandbox.refuse_with(&render, &["texture.sky", "is not a PNG, JPEG, OpenEXR or Radiance HDR"]);
}

#[test]
fn gradients_are_checked_and_know_edges() {
    let sandbox = Sandbox::new();
    sandbox.write("path.toml", format!("{PATH}{SKY}{SCENE}"));
    sandbox.succeed(&["render", "scene.toml", "-o", "target.exr"]);
    let gradient = ["gradient", "path.toml", "--target", "target.exr", "--param"];
    let checked = ["environment.radiance", "--check"];
    let verdict = sandbox.succeed(&[&gradient[..], &checked].concat());
    assert!(verdict.contains("  agrees: "), "{verdict}");
    for path in ["light.key.position", "mesh.floor.vertices"] {
        let of = |edges| sandbox.succeed(&[&gradient[..], &[path, "--edges", edges]].concat());
        assert_eq!(of("on"), of("auto"));
        assert_ne!(of("on"), of("off"));
    }
}

/// A few paths through each pixel give a gradient that is mostly noise, and not one that is wrong.
#[test]
fn checks_tell_noise_from_errors() {
    let sandbox = Sandbox::new();
    sandbox.write("path.toml", format!("{PATH}{SKY}{SCENE}"));
    sandbox.succeed(&["render", "scene.toml", "-o", "target.exr"]);
    let gradient = ["gradient", "path.toml", "--target", "target.exr", "--samples", "4", "--check"];
    let of = |more: &[&str]| sandbox.run(&[&gradient[..], more].concat());
    let output = of(&["--param", "camera.vfov"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success() && text.contains("  cannot tell: "), "{text}");
    let output = of(&["--param", "camera.vfov", "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(json["uncertainty"]["camera.vfov"].as_f64().unwrap() > 0.02, "{json}");
    // Paths end at random in steps, which smaller changes do not reach.
    let output = of(&["--param", "material.paint.diffuse"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success() && text.contains("  agrees: "), "{text}");
    // A roughness at which the one that directions are sampled by is rounded to another.
    let roughness = ((-45.0_f64 - 0.37) / 32.0).exp();
    let metal = format!("type = \"metallic_roughness\"\nmetallic = 0.5\nroughness = {roughness}");
    let scene = SCENE.replace("specular = [0.1, 0.1, 0.1]\nexponent = 12.0", &metal);
    sandbox.write("path.toml", format!("{PATH}{SKY}{scene}"));
    let roughness = ["--param", "material.paint.roughness", "--tolerance", "0.1"];
    sandbox.succeed(&[&gradient[..4], &["--samples", "64", "--check"], &roughness].concat());
}

#[test]
fn what_makes_no_sense_is_refused() {
    let sandbox = Sandbox::new();
    for (head, parts) in [
        (PATH.replace("samples = 4", "samples = 0"), ["bad.toml:4: integrator.samples", "65536"]),
        (PATH.replace("samples = 4", "samples = 70000"), ["bad.toml:4", "65536, is 70000"]),
        (PATH.replace("= 3", "= 0"), ["bad.toml:3: integrator.max_depth", "at least 1"]),
        (PATH.replace("= 3", "= 4000000000"), ["bad.toml:3: integrator.max_depth", "memory"]),
        (PATH.replace("= 3", "= -1"), ["bad.toml:3: ", "`integrator.max_depth`"]),
        (PATH.replace("path", "paths"), ["bad.toml:2: ", "`paths`"]),
        (PATH.replace("samples", "spp"), ["bad.toml:4: ", "`spp`"]),
        (
            format!("{SKY}background = [1.0, 0.0, 0.0]\n"),
            ["environment.background", "integrator.type = \"path\""],
        ),
        (PATH.to_owned() + "[environment]\n", ["bad.toml:5: environment.radiance", "is missing"]),
        (format!("{PATH}{SKY}").replace("0.5", "-1.0"), ["bad.toml:6", "negative"]),
        (format!("{PATH}[environment]\ntexture = \"moon\"\n"), ["bad.toml:6", "no texture `moon`"]),
        (format!("{PATH}{SKY}rotation = 5.0\n"), ["bad.toml:7: environment.rotation", "has none"]),
        (
            format!("{PATH}{SKY}background = [-1.0, 0.0, 0.0]\n"),
            ["environment.background", "negative"],
        ),
    ] {
        sandbox.write("bad.toml", head + SCENE);
        sandbox.refuse_with(&RENDER, &parts);
    }
}

/// A run takes other paths in each iteration, unless it is told not to or its method compares losses; it ends with the
/// same bits if it is resumed, on any number of threads.
#[test]
fn runs_take_other_paths_in_each_iteration() {
    let sandbox = Sandbox::new();
    let with = |optimize: &str| {
        format!(
            "{PATH}{SKY}{SCENE}\n[optimize]\ntarget = \"photo.exr\"\niterations = 12\n{optimize}\n\
             [[optimize.parameter]]\npath = \"material.paint.diffuse\"\nlearning_rate = 0.05\n"
        )
    };
    let truth = format!("{PATH}{SKY}{SCENE}").replace("[0.6, 0.3, 0.2]", "[0.2, 0.5, 0.4]");
    sandbox.write("truth.toml", truth);
    sandbox.succeed(&["render", "truth.toml", "-o", "photo.exr", "--samples", "64"]);
    sandbox.write("other.toml", with(""));
    sandbox.write("same.toml", with("resample = false"));
    let run = |scene: &str, out: &str, more: &[&str]| {
        sandbox.succeed(&[&["optimize", scene, "--out", out], more].concat());
        let history = String::from_utf8(sandbox.read(&format!("{out}/history.csv"))).unwrap();
        let loss = |row: &str| row.split(',').nth(1).unwrap().to_owned();
        (history.lines().map(loss).collect::<Vec<_>>(), sandbox.read(&format!("{out}/scene.toml")))
    };
    let whole = run("other.toml", "other", &["--threads", "1"]);
    run("other.toml", "parts", &["--iterations", "5"]);
    assert_eq!(run("other.toml", "parts", &["--resume", "--threads", "2"]), whole);
    let same = run("same.toml", "same", &[]);
    assert_ne!(same.0[1], whole.0[1]);
    // Where losses are compared, they are those of the same paths.
    let lbfgs = ["--optimizer", "lbfgs"];
    assert_eq!(run("other.toml", "lbfgs", &lbfgs).0, run("same.toml", "lbfgs_same", &lbfgs).0);
    // Where derivatives are not in proportion to differences, halves do not rid them of noise.
    for [name, resample] in [["l1.toml", ""], ["l1_same.toml", "\nresample = false"]] {
        sandbox.write(name, with(&format!("loss = \"l1\"{resample}")));
    }
    assert_eq!(run("l1.toml", "l1", &[]).0, run("l1_same.toml", "l1_same", &[]).0);
    sandbox.write("asked.toml", with("resample = true"));
    assert_eq!(run("asked.toml", "asked", &["--threads", "1"]), whole);
    sandbox.refuse_with(
        &[&["optimize", "asked.toml", "--out", "refused"], &lbfgs[..]].concat(),
        &["optimize.resample", "lbfgs"],
    );
    sandbox.write("direct.toml", with("resample = true").replace(PATH, ""));
    sandbox.refuse_with(&["optimize", "direct.toml"], &["optimize.resample", "path"]);
    let independent = ["gradient", "direct.toml", "--gradient-samples", "independent"];
    sandbox.write("direct.toml", with("").replace(PATH, ""));
    sandbox.refuse_with(&independent, &["--gradient-samples", "path"]);
    let gradient =
        |of: &str| sandbox.succeed(&["gradient", "other.toml", "--json", "--gradient-samples", of]);
    assert_ne!(gradient("same"), gradient("independent"));
}
