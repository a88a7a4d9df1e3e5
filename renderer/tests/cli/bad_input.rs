//! Bad input: exit code 2, one line that names file and field, nothing written. What "one line"
//! means is in [`Sandbox::refuse`].

use std::io::Cursor;

use image::codecs::openexr::OpenExrEncoder;
use image::{ExtendedColorType, ImageEncoder};

use crate::sandbox::{FLOOR, Sandbox};

const RENDER: [&str; 4] = ["render", "bad.toml", "-o", "out.png"];

#[test]
fn scene_files() {
    let sandbox = Sandbox::new();
    let cases: &[(&str, &str, &[&str])] = &[
        ("width = 24", "width = 0", &["bad.toml:5", "camera.width", "at least 1 pixel"]),
        ("height = 16", "height = 0", &["bad.toml:6", "camera.height", "at least 1 pixel"]),
        ("width = 24", "width = -24", &["bad.toml:5", "width"]),
        ("width = 24", "width = 4294967295", &["camera.width", "pixels"]),
        ("width = 24", "widht = 24", &["bad.toml:5", "unknown field `widht`", "width"]),
        ("width = 24\n", "", &["bad.toml:2", "camera.width: is missing"]),
        ("[0.0, 1.5, 4.0]", "[0.0, 0.3, 0.0]", &["camera.look_from", "must differ"]),
        ("[0.0, 1.5, 4.0]", "[0.0, 9.0, 0.0]", &["bad.toml:2: camera.up", "parallel"]),
        ("[0.0, 1.5, 4.0]", "[nan, 1.5, 4.0]", &["bad.toml:3", "camera.look_from", "NaN"]),
        ("[0.0, 1.5, 4.0]", "[0.0, 1.5]", &["bad.toml:3", "look_from"]),
        (
            "radiant_intensity = 30.0",
            "radiant_intensity = inf",
            &["light.key.radiant_intensity", "inf"],
        ),
        ("radiant_intensity = 30.0", "intensity = 120.0", &["bad.toml:12", "a quarter"]),
        (
            "radiant_intensity = 30.0",
            "radiant_intensity = -1.0",
            &["light.key.radiant_intensity", "negative"],
        ),
        (
            "radiant_intensity = 30.0",
            "radiant_intensity = \"x\"",
            &["bad.toml:12", "string", "radiant_intensity"],
        ),
        ("\"point\"", "\"area\"", &["bad.toml:10", "`area` is no type of light", "point"]),
        ("position", "direction", &["bad.toml:11", "light.key.direction", "position"]),
        ("position = [1.5, 3.0, 2.0]\n", "", &["light.key.position", "is missing"]),
        ("radius = 0.5", "radius = -0.5", &["bad.toml:20", "sphere.ball.radius", "above 0"]),
        ("radius = 0.5", "radius = 0.0", &["sphere.ball.radius", "above 0"]),
        ("\"paint\"", "\"pain\"", &["sphere.ball.material", "no material `pain`", "paint"]),
        ("[0.6, 0.3, 0.2]", "[0.6, -0.3, 0.2]", &["material.paint.diffuse", "negative"]),
        ("[0.6, 0.3, 0.2]", "[0.6, 0.3, 0.2", &["bad.toml"]),
        ("floor.obj", "flor.obj", &["bad.toml:15: mesh.flor.obj.path: flor.obj: no such file"]),
        ("width = 24", "width = 24\nwidth = 24", &["bad.toml:6: `width` is given twice"]),
        ("width = 24", "width = 4294967296", &["bad.toml:5", "from 0 to 4294967295", "width"]),
        (
            "width = 24",
            "width = 99999999999999999999",
            &["bad.toml:5: invalid type: integer `99999999999999999999`, expected a whole"],
        ),
        ("= 30.0", "= 99999999999999999999999999999999999999999", &["bad.toml:12"]),
        ("[camera]", "[kamera]", &["bad.toml:2", "unknown field `kamera`", "camera"]),
    ];
    for (from, to, parts) in cases {
        sandbox.write_changed("bad.toml", from, to);
        sandbox.refuse_with(&RENDER, parts);
    }
    let lights: &[(&str, &str, &[&str])] = &[
        ("[1.0, 0.0, 0.0]", "[0.0, 0.0, 0.0]", &["light.lamp.up: must be a direction"]),
        ("[0.0, 0.0, 0.0]", "[0.0, 1.0, 0.0]", &["light.lamp.right: must be a direction"]),
        ("[1.0, 0.0, 0.0]", "[2.0, 0.0, 0.0]", &["light.lamp.right", "along one line"]),
    ];
    for (right, up, parts) in lights {
        let lamp = format!(
            "[[light]]\nname = \"lamp\"\ntype = \"rectangle\"\ncenter = [0, 3, 0]\nradiance = 1\n\
             right = {right}\nup = {up}\n\n[[mesh]]"
        );
        sandbox.write_changed("bad.toml", "[[mesh]]", &lamp);
        sandbox.refuse_with(&RENDER, parts);
    }
    for (table, field) in [
        ("[optimize]\ntarget = \"\"", "optimize.target"),
        ("[optimize]\nmask = \"\"", "optimize.mask"),
        ("[[mesh]]\nname = \"m\"\npath = \"\"", "mesh.m.path"),
        ("[texture.t]\npath = \"\"", "texture.t.path"),
        ("[[view]]\npath = \"\"", "view.path"),
        ("[[view]]\nname = \"v\"\ndepth = \"\"", "view.v.depth"),
        ("[[view]]\nname = \"v\"\nnormals = { path = \"\" }", "view.v.normals"),
        ("[[view]]\nname = \"v\"\ntarget = \"\"", "view.v.target"),
        ("[[view]]\nname = \"v\"\nmask = \"\"", "view.v.mask"),
    ] {
        sandbox.write("bad.toml", format!("{}{table}\n", crate::sandbox::SCENE));
        sandbox.refuse_with(&RENDER, &["bad.toml:", &format!("{field}: is empty")]);
    }
    for content in ["", "camera", "\0", "# nothing"] {
        sandbox.write("bad.toml", content);
        sandbox.refuse_with(&RENDER, &["bad.toml"]);
    }
}

#[test]
fn optimize_sections() {
    let sandbox = Sandbox::new();
    let parameter = "[[optimize.parameter]]\npath = \"light.key.radiant_intensity\"\n";
    let cases: &[(&str, &[&str])] = &[
        ("target = \"none.png\"", &["bad.toml:31: optimize.target: none.png: no such file"]),
        ("mask = \"none.png\"", &["bad.toml:31: optimize.mask: none.png: no such file"]),
        ("learning_rate = 0.0", &["optimize.learning_rate", "above 0"]),
        ("tolerance = -1.0", &["optimize.tolerance", "negative"]),
        ("tolerance = nan", &["optimize.tolerance"]),
        ("iterations = -1", &["bad.toml:31", "iterations"]),
        ("loss = \"l2\"", &["bad.toml:31", "unknown variant `l2`"]),
        ("optimizer = \"adan\"", &["bad.toml:31", "unknown variant `adan`", "adamw"]),
        (
            "optimizer = \"sgd\"",
            &["bad.toml: light.key.radiant_intensity", "give one", "learning_rate"],
        ),
        ("optimizer = \"lbfgs\"\nschedule = \"step\"", &["optimize.schedule", "leave it out"]),
        ("schedule = { type = \"cosine\", end = 2 }", &["bad.toml:31", "end", "from 0 to 1"]),
        ("step = 1", &["bad.toml:31", "unknown field `step`"]),
        ("target_values = { \"light.kee.color\" = 1 }", &["light.kee.color", "light.key.color"]),
        ("target_values = { \"light.key.color\" = 1 }", &["light.key.color", "needs 3 numbers"]),
        ("target_values = { \"sphere.ball.radius\" = -1 }", &["sphere.ball.radius", "above 0"]),
    ];
    for (line, parts) in cases {
        let scene = String::from_utf8(sandbox.read("scene.toml")).unwrap();
        sandbox.write("bad.toml", format!("{scene}\n\n\n[optimize]\n{line}\n{parameter}"));
        sandbox.refuse_with(&["optimize", "bad.toml"], parts);
    }
    let fields: &[(&str, &[&str])] = &[
        ("path = \"camera.width\"", &["camera.width", "is no parameter"]),
        ("path = \"light.key.radiant_intensty\"", &["closest: light.key.radiant_intensity"]),
        (
            "path = \"light.key.radiant_intensity\"\nmin = 50",
            &["min", "above the initial value 30"],
        ),
        ("path = \"light.key.radiant_intensity\"\nmax = 5", &["max", "below the initial value 30"]),
        ("path = \"light.key.radiant_intensity\"\nmax = nan", &["max", "not a number"]),
        ("path = \"light.key.color\"\nmin = [0.0, 0.0]", &["min", "needs 3 numbers, has 2"]),
        (
            "path = \"light.key.radiant_intensity\"\nlearning_rate = -1",
            &["learning_rate", "above 0"],
        ),
        ("path = \"light.key.radiant_intensity\"\nmin = 3\nmax = 2", &["min", "above max"]),
        (
            "path = \"light.key.color\"\nlaplacian = 0.1",
            &["laplacian", "floating point `0.1`, expected a table with a `weight`"],
        ),
        (
            "path = \"light.key.color\"\nremesh = 1",
            &["remesh", "integer `1`, expected a table with an `edge_length`"],
        ),
        ("path = \"light.key.color\"\nscale = \"ln\"", &["unknown variant `ln`", "linear", "log"]),
        (
            "path = \"camera.look_at\"\nscale = \"log\"",
            &["optimize.parameter.camera.look_at.scale", "above 0", "one is 0"],
        ),
    ];
    for (fields, parts) in fields {
        let scene = String::from_utf8(sandbox.read("scene.toml")).unwrap();
        sandbox.write("bad.toml", format!("{scene}[[optimize.parameter]]\n{fields}\n"));
        sandbox.refuse_with(&["optimize", "bad.toml"], &[&["bad.toml:2"], *parts].concat());
    }
    sandbox.write("bad.toml", format!("{}{parameter}{parameter}", crate::sandbox::SCENE));
    sandbox.refuse_with(&["optimize", "bad.toml"], &["light.key.radiant_intensity", "twice"]);
}

#[test]
fn meshes() {
    let sandbox = Sandbox::new();
    let cases: &[(&str, &str, &[&str])] = &[
        ("v 2 0 -2", "v nan 0 -2", &["bad.obj:2", "nan", "not a finite number"]),
        ("v 2 0 -2", "v inf 0 -2", &["bad.obj:2", "inf", "not a finite number"]),
        ("v 2 0 -2", "v 2 0", &["bad.obj:2"]),
        ("v 2 0 -2", "v 2 0 x", &["bad.obj:2", "x"]),
        ("f 4 3 2 1", "f 4 3 2 5", &["bad.obj:5", "5", "4"]),
        ("f 4 3 2 1", "f 0 1 2", &["bad.obj:5", "0"]),
        ("f 4 3 2 1", "f 1 2 -9", &["bad.obj:5", "-9"]),
        ("f 4 3 2 1", "f 1 2", &["bad.obj:5"]),
        ("f 4 3 2 1", "f 1 2 99999999999999999999", &["bad.obj:5"]),
        ("f 4 3 2 1", "", &["bad.obj", "no triangles"]),
        ("v 2 0 -2", "v 2e30 0 -2", &["bad.obj", "vertices"]),
    ];
    for (from, to, parts) in cases {
        assert_eq!(FLOOR.matches(from).count(), 1, "{from}");
        sandbox.write("bad.obj", FLOOR.replace(from, to));
        sandbox.refuse_with(&["render", "bad.obj", "-o", "out.png"], parts);
        sandbox.write_changed("bad.toml", "floor.obj", "bad.obj");
        sandbox.refuse(&["params", "bad.toml"]);
    }
    for content in [&b""[..], b"\x89PNG\r\n\x1a\n", &[0xff; 100]] {
        sandbox.write("bad.obj", content);
        sandbox.refuse_with(&["render", "bad.obj", "-o", "out.png"], &["bad.obj"]);
    }
}

#[test]
fn target_images() {
    let sandbox = Sandbox::new();
    let optimize =
        ["optimize", "scene.toml", "--param", "light.key.radiant_intensity", "--target", "bad.png"];
    sandbox.refuse_with(&optimize, &["bad.png", "no such file"]);
    sandbox.succeed(&["render", "scene.toml", "-o", "good.png"]);
    let good = sandbox.read("good.png");

    let mut flipped = good.clone();
    flipped[good.len() / 2] ^= 0xff;
    for broken in [&good[..good.len() / 2], &good[..20], &good[..0], b"not an image", &flipped] {
        sandbox.write("bad.png", broken);
        sandbox.refuse_with(&optimize, &["bad.png"]);
    }

    sandbox.write_changed("wide.toml", "width = 24", "width = 25");
    sandbox.succeed(&["render", "wide.toml", "-o", "bad.png"]);
    sandbox.refuse_with(&optimize, &["bad.png", "25 x 16", "scene.toml has 24 x 16"]);
    let gradient = [&["gradient"], &optimize[1..]].concat();
    sandbox.refuse_with(&gradient, &["bad.png", "25 x 16"]);

    // The library refuses to write such an image.
    let mut samples = vec![0.25_f32; 24 * 16 * 3];
    samples[30 * 3 + 1] = f32::NAN;
    let bytes: Vec<u8> = samples.iter().flat_map(|sample| sample.to_ne_bytes()).collect();
    let mut file = Cursor::new(Vec::new());
    OpenExrEncoder::new(&mut file).write_image(&bytes, 24, 16, ExtendedColorType::Rgb32F).unwrap();
    sandbox.write("bad.exr", file.get_ref());
    let exr = ["optimize", "scene.toml", "--param", "light.key.color", "--target", "bad.exr"];
    sandbox.refuse_with(&exr, &["bad.exr", "green at column 6, row 1", "NaN"]);
}

#[test]
fn arguments() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&["render", "scene.toml", "-o", "photo.png"]);
    let cases: &[(&[&str], &[&str])] = &[
        (&["render", "none.toml", "-o", "out.png"], &["none.toml", "no such file"]),
        (&["render", ".", "-o", "out.png"], &["is a directory"]),
        (&["render", "photo.png", "-o", "out.png"], &["photo.png", "scene file (TOML)"]),
        (&["render", "scene.toml", "-o", "out.bmp"], &["out.bmp", ".png", ".exr"]),
        (&["render", "scene.toml", "-o", "out"], &["out", ".png", ".exr"]),
        (&["render", "scene.toml", "-o", ".png"], &[".png"]),
        (&["render", "scene.toml", "-o", "no/out.png"], &["no/out.png", "does not exist"]),
        (&["params", "none.obj"], &["none.obj", "no such file"]),
        (&["gradient", "scene.toml"], &["scene.toml", "no parameter"]),
        (&["gradient", "scene.toml", "--param", "camera.vfov"], &["scene.toml", "no target"]),
        (&["gradient", "scene.toml", "--param", "camera.vfow"], &["closest: camera.vfov"]),
        (&["gradient", "scene.toml", "--param", "camera.width"], &["is no parameter"]),
        (&["gradient", "scene.toml", "--param", ""], &["--param", "paths begin with"]),
        (
            &["gradient", "scene.toml", "--param", "mesh.floor.vertices[4]"],
            &["mesh `floor` has 4 vertices, counted from 0", "`4` is none of them"],
        ),
        (&["gradient", "scene.toml", "--param", "mesh.floor.vertices[-1]"], &["`-1` is none of"]),
        (&["gradient", "scene.toml", "--param", "mesh.flor.vertices[1]"], &["mesh.floor.vertices"]),
        (
            &[
                "gradient",
                "scene.toml",
                "--param",
                "mesh.floor.vertices[1]",
                "--param",
                "mesh.floor.vertices",
            ],
            &["--param mesh.floor.vertices: overlaps mesh.floor.vertices[1], which is given too"],
        ),
        (&["optimize", "scene.toml", "--target", "photo.png"], &["scene.toml", "no parameter"]),
        (&["optimize", "experiment.toml", "--target", "."], &["is a directory"]),
        (&["optimize", "experiment.toml", "--out", "scene.toml"], &["scene.toml", "folder"]),
        (
            &["gradient", "scene.toml", "--param", "camera.vfov", "--param", "camera.vfov"],
            &["--param camera.vfov", "twice"],
        ),
    ];
    for (arguments, parts) in cases {
        sandbox.refuse_with(arguments, parts);
    }
}

#[test]
fn usage() {
    let sandbox = Sandbox::new();
    let cases: &[(&[&str], &str)] = &[
        (&["render", "scene.toml"], "--output"),
        (&["render"], "<SCENE>"),
        (&["paint"], "'paint'"),
        (&["params", "scene.toml", "--threads", "0"], "--threads"),
        (&["params", "scene.toml", "--threads", "100000000"], "--threads"),
        (&["params", "scene.toml", "--threads", "two"], "--threads"),
        (&["params", "scene.toml", "--precision", "f16"], "f32, f64"),
        (&["bench", "scene.toml", "--seconds", "nan"], "--seconds"),
        (&["bench", "scene.toml", "--param", "light.none.color"], "--param light.none.color"),
        (&["optimize", "experiment.toml", "--iterations", "many"], "--iterations"),
        (&["optimize", "experiment.toml", "--iterations=-1"], "--iterations"),
        (&["optimize", "experiment.toml", "--tolerance", "nan"], "--tolerance"),
        (&["optimize", "experiment.toml", "--tolerance", "-1"], "<X>': must"),
        (&["optimize", "experiment.toml", "--learning-rate", "-1"], "<X>': must be above 0"),
        (
            &["optimize", "experiment.toml", "--optimizer", "lm", "--learning-rate", "0.1"],
            "--learning-rate: lm finds the lengths of its steps itself",
        ),
        (&["bench", "scene.toml", "--seconds", "-1"], "<SECONDS>': has to"),
        (&["render", "scene.toml", "-o", "a.png", "--samples", "-3"], "'--samples <N>': -3 is not"),
        (&["params", "scene.toml", "--threads", "-3"], "'--threads <N>': -3 is not"),
        (&["gradient", "experiment.toml", "--tolerance", "0.1"], "--check"),
        (&["gradient", "experiment.toml", "--check", "--tolerance", "2"], "--tolerance"),
    ];
    for (arguments, part) in cases {
        let names = sandbox.names(".");
        let output = sandbox.run(arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {errors}");
        assert!(errors.starts_with("error: ") && errors.contains(part), "{errors}");
        assert_eq!(sandbox.names("."), names, "{arguments:?}");
    }
}

#[test]
fn names_with_line_breaks_stay_on_one_line() {
    let sandbox = Sandbox::new();
    sandbox.refuse_with(&["params", "two\nlines.toml"], &["lines.toml", "no such file"]);
    let scene = crate::sandbox::SCENE.replace("\"key\"", "\"ke\\ny\"");
    sandbox.write("bad.toml", scene);
    sandbox.refuse_with(&RENDER, &["bad.toml", "control characters"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let sandbox = Sandbox::new();
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = sandbox.command(&["params", "scene.toml"]).stdout(full).output().unwrap();
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(errors.starts_with("error: standard output: ") && errors.lines().count() == 1);
}
