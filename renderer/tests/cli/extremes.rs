//! Scenes at the limits: they render, or say why not.

use renderer::Image;
use renderer::files::{load_image, save_exr, save_png};

use crate::sandbox::{SCENE, Sandbox, numbers};

/// The image of `scene.toml` with some parts replaced.
fn render(sandbox: &Sandbox, changes: &[(&str, &str)]) -> Image {
    let mut scene = SCENE.to_owned();
    for (from, to) in changes {
        assert_eq!(scene.matches(from).count(), 1, "{from}");
        scene = scene.replace(from, to);
    }
    sandbox.write("extreme.toml", scene);
    sandbox.succeed(&["render", "extreme.toml", "-o", "extreme.exr"]);
    load_image(&sandbox.path("extreme.exr")).unwrap().image
}

fn is_black(image: &Image) -> bool {
    image.pixels.as_flattened().iter().all(|&value| value == 0.0)
}

#[test]
fn one_pixel_and_one_row() {
    let sandbox = Sandbox::new();
    let one = render(&sandbox, &[("width = 24", "width = 1"), ("height = 16", "height = 1")]);
    assert_eq!(one.pixels.len(), 1);
    assert!(one.pixels[0][0] > 0.0);
    let row = render(
        &sandbox,
        &[("width = 24", "width = 16384"), ("height = 16", "height = 1\nvfov = 0.01")],
    );
    assert_eq!((row.width, row.height), (16384, 1));
    assert!(!is_black(&row));
    sandbox.succeed(&["render", "extreme.toml", "-o", "row.png"]);
}

#[test]
fn the_image_does_not_depend_on_the_unit_of_length() {
    let sandbox = Sandbox::new();
    let scene = |scale: f64| {
        let vector = |v: [f64; 3]| format!("{:?}", v.map(|x| x * scale));
        let floor = crate::sandbox::FLOOR.replace('2', &format!("{:?}", 2.0 * scale));
        // The face lost its second vertex to the line above.
        let (vertices, _) = floor.rsplit_once("f ").unwrap();
        sandbox.write("floor.obj", format!("{vertices}f 4 3 2 1\n"));
        let flux = format!("radiant_intensity = {:?}", 30.0 * scale * scale);
        let radius = format!("radius = {:?}", 0.5 * scale);
        render(
            &sandbox,
            &[
                ("[0.0, 1.5, 4.0]", &vector([0.0, 1.5, 4.0])),
                ("[0.0, 0.3, 0.0]", &vector([0.0, 0.3, 0.0])),
                ("[1.5, 3.0, 2.0]", &vector([1.5, 3.0, 2.0])),
                ("[0.0, 0.5, 0.0]", &vector([0.0, 0.5, 0.0])),
                ("radiant_intensity = 30.0", &flux),
                ("radius = 0.5", &radius),
            ],
        )
    };
    let expected = scene(1.0);
    for scale in [1e-6, 1e6] {
        let image = scene(scale);
        let difference = image.absolute_difference(&expected).unwrap();
        let different = difference.pixels.iter().filter(|p| p.iter().any(|&d| d > 1e-3)).count();
        assert!(different <= 2, "{scale}: {different} pixels differ");
    }
}

#[test]
fn inside_a_sphere_behind_the_camera_and_nothing_at_all() {
    let sandbox = Sandbox::new();
    let inside = render(
        &sandbox,
        &[("radius = 0.5", "radius = 50.0"), ("[[mesh]]\npath = \"floor.obj\"", "")],
    );
    assert!(inside.pixels.iter().all(|pixel| pixel[0] > 0.0), "the ball is all around");
    let behind = render(&sandbox, &[("[0.0, 0.3, 0.0]", "[0.0, 1.6, 9.0]")]);
    assert!(is_black(&behind));

    let (camera, _) = SCENE.split_once("[[light]]").unwrap();
    sandbox.write("empty.toml", camera);
    sandbox.succeed(&["render", "empty.toml", "-o", "empty.exr"]);
    assert!(is_black(&load_image(&sandbox.path("empty.exr")).unwrap().image));
    // There is nothing to see, and so nothing to learn.
    let arguments = ["optimize", "empty.toml", "--target", "empty.exr", "--param", "camera.vfov"];
    let report = sandbox.succeed(&arguments);
    assert!(report.contains("loss 0\n"), "{report}");
    save_png(
        &Image { width: 24, height: 16, pixels: vec![[0.5; 3]; 24 * 16] },
        &sandbox.path("grey.png"),
    )
    .unwrap();
    let arguments = ["optimize", "empty.toml", "--target", "grey.png", "--param", "camera.vfov"];
    let report = sandbox.succeed(&[&arguments[..], &["--overwrite"]].concat());
    assert!(report.contains("the gradient vanished"), "{report}");
}

#[test]
fn many_lights_add_up() {
    let sandbox = Sandbox::new();
    let one = render(&sandbox, &[]);
    let light = |i: usize| {
        format!(
            "name = \"l{i}\"\ntype = \"point\"\nposition = [1.5, 3.0, 2.0]\nradiant_intensity = 1.5\n"
        )
    };
    let lights: Vec<String> = (0..20).map(light).collect();
    let (before, rest) = SCENE.split_once("[[light]]").unwrap();
    let (_, after) = rest.split_once("[[mesh]]").unwrap();
    let many = format!("{before}[[light]]\n{}\n[[mesh]]{after}", lights.join("\n[[light]]\n"));
    sandbox.write("many.toml", many);
    sandbox.succeed(&["render", "many.toml", "-o", "many.exr"]);
    let many = load_image(&sandbox.path("many.exr")).unwrap().image;
    for (one, many) in one.pixels.as_flattened().iter().zip(many.pixels.as_flattened()) {
        assert!((one - many).abs() <= 1e-5 * one, "{one} {many}");
    }
    let parameters = sandbox.succeed_json(&["params", "many.toml", "--json"]);
    assert_eq!(numbers(&parameters["light.l19.radiant_intensity"]), [1.5]);
}

#[test]
fn a_black_target_puts_the_light_out() {
    let sandbox = Sandbox::new();
    save_exr(&Image::black(24, 16), &sandbox.path("black.exr")).unwrap();
    let arguments = ["optimize", "scene.toml", "--target", "black.exr", "--out", "out"];
    sandbox.succeed(&[&arguments[..], &["--param", "light.key.radiant_intensity"]].concat());
    let summary = sandbox.json("out/summary.json");
    assert_eq!(numbers(&summary["parameters"]["light.key.radiant_intensity"]["final"]), [0.0]);
    assert_eq!(summary["loss"]["final"], 0.0);
}

/// A scene whose lit pixels overflow, and a target for it.
fn bright() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write_changed("bright.toml", "radiant_intensity = 30.0", "radiant_intensity = 2.5e37");
    let scene = String::from_utf8(sandbox.read("bright.toml")).unwrap();
    let scene = scene.replace("diffuse = [0.6, 0.3, 0.2]", "diffuse = [1e30, 0.3, 0.2]");
    sandbox.write("bright.toml", scene);
    save_exr(&Image::black(24, 16), &sandbox.path("black.exr")).unwrap();
    sandbox
}

const TUNE_BRIGHT: [&str; 5] =
    ["bright.toml", "--target", "black.exr", "--param", "material.paint.emission"];

#[test]
fn what_overflows_is_refused_before_anything_is_written() {
    let sandbox = bright();
    let parts =
        ["bright.toml", "of 384 pixels are not finite", "the radiance is [inf", "sphere.ball"];
    sandbox.refuse_with(&["render", "bright.toml", "-o", "out.exr"], &parts);
    for command in ["optimize", "gradient"] {
        sandbox.refuse_with(&[&[command], &TUNE_BRIGHT[..]].concat(), &parts[1..]);
    }
}

#[test]
fn what_overflows_may_be_left_out() {
    let sandbox = bright();
    for arguments in [
        vec!["render", "bright.toml", "-o", "out.exr"],
        [&["gradient"], &TUNE_BRIGHT[..]].concat(),
        [&["optimize", "--out", "out", "--iterations", "2"], &TUNE_BRIGHT[..]].concat(),
    ] {
        let output = sandbox.run(&[&arguments[..], &["--allow-non-finite"]].concat());
        let warnings = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {warnings}");
        assert!(warnings.contains("warning: "), "{arguments:?}: {warnings}");
        assert!(warnings.contains("of 384 pixels are not finite"), "{arguments:?}: {warnings}");
    }
    let image = load_image(&sandbox.path("out.exr")).unwrap().image;
    assert!(image.pixels.contains(&[0.0; 3]) && image.pixels.iter().any(|p| *p != [0.0; 3]));
}
