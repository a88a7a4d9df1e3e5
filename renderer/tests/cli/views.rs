//! Scenes with several views.

use renderer::files::load_image;
use serde_json::Value;

use crate::sandbox::{FLOOR, OPTIMIZE, SCENE, Sandbox, numbers};

const CAMERA: &str = "look_from = [0.0, 1.5, 4.0]\n";

/// The scene through three cameras, the last of which is held out.
fn with_views(targets: bool) -> String {
    let target = |name: &str| match targets {
        true => format!("target = \"truth-{name}.exr\"\n"),
        false => String::new(),
    };
    let views = format!(
        "[[view]]\nname = \"front\"\nlook_from = [0.0, 1.5, 4.0]\n{}weight = 2.0\n\
         [[view]]\nname = \"Left Side\"\nlook_from = [-3.0, 1.0, 2.5]\nwidth = 20\n{}\
         [[view]]\nname = \"right\"\nlook_from = [3.0, 2.0, 2.0]\nheld_out = true\n{}",
        target("front"),
        target("left_side"),
        target("right")
    );
    assert_eq!(SCENE.matches(CAMERA).count(), 1);
    format!("{}\n{views}", SCENE.replace(CAMERA, ""))
}

/// The views, with pictures of the true light, and what to find.
fn sandbox(more: &str) -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write("floor.obj", FLOOR);
    let truth = with_views(false).replace("[1.5, 3.0, 2.0]", "[-1.0, 2.5, 2.5]");
    sandbox.write("truth.toml", truth.replace("30.0", "22.5"));
    let made = sandbox.succeed(&["render", "truth.toml", "-o", "truth.exr"]);
    let names = ["truth-front.exr", "truth-left_side.exr", "truth-right.exr"];
    assert_eq!(made.lines().collect::<Vec<_>>(), names);
    let (head, parameters) = OPTIMIZE.split_once("[optimize.target_values]").unwrap();
    let parameters = &parameters[parameters.find("[[").unwrap()..];
    sandbox.write("views.toml", format!("{}{head}{more}{parameters}", with_views(true)));
    sandbox
}

#[test]
fn views_are_matched_together_and_held_out_ones_reported() {
    let sandbox = sandbox("");
    let arguments = ["optimize", "views.toml", "--out", "out", "--optimizer", "lbfgs"];
    let printed = sandbox.succeed(&arguments);
    assert!(printed.contains("view right, held out: PSNR "), "{printed}");
    let summary = sandbox.json("out/summary.json");
    let found = numbers(&summary["parameters"]["light.key.position"]["final"]);
    let error = found.iter().zip([-1.0, 2.5, 2.5]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(error < 0.1, "{found:?}");
    let views = summary["views"].as_array().unwrap();
    assert_eq!(views.len(), 3);
    for (view, held_out) in views.iter().zip([false, false, true]) {
        assert_eq!(view["held_out"], held_out);
        assert!(view["psnr"].as_f64().unwrap() > 35.0, "{view}");
        for file in view["files"].as_object().unwrap().values() {
            sandbox.read(&format!("out/{}", file.as_str().unwrap()));
        }
    }
    // What is recovered is a scene with the same views.
    sandbox.succeed(&["render", "out/scene.toml", "-o", "again.png"]);
    sandbox.read("again-left_side.png");
    sandbox.succeed(&["report", "out"]);
    let page = String::from_utf8(sandbox.read("out/report.html")).unwrap();
    assert!(page.contains("right, held out") && page.contains("PSNR"), "no views on the page");
}

/// The loss of two views is the sum of theirs, and a gradient is that by differences.
#[test]
fn losses_add_up_and_gradients_hold() {
    let sandbox = sandbox("");
    let loss = |scene: &str| -> f64 {
        let printed = sandbox.succeed(&["gradient", scene, "--precision", "f64", "--edges", "off"]);
        printed.lines().next().unwrap().strip_prefix("loss ").unwrap().parse().unwrap()
    };
    let both = loss("views.toml");
    let text = String::from_utf8(sandbox.read("views.toml")).unwrap();
    sandbox.write("first.toml", text.replace("width = 20", "width = 20\nheld_out = true"));
    sandbox.write("second.toml", text.replace("weight = 2.0", "held_out = true"));
    let sum = loss("first.toml") + loss("second.toml");
    assert!((both - sum).abs() < 1e-5 * sum, "{both} {sum}");
    // Batches are for iterations.
    sandbox.write("batch.toml", text.replace("[optimize]\n", "[optimize]\nbatch = 1\n"));
    assert_eq!(loss("batch.toml"), both);
    let mut arguments = vec!["gradient", "batch.toml", "--check", "--precision", "f64"];
    arguments.extend(["--param", "view.Left Side.look_from", "--param", "light.key.position"]);
    let printed =
        sandbox.succeed(&[&arguments[..], &["--edges", "on", "--tolerance", "0.1"]].concat());
    assert_eq!(printed.matches("agrees").count(), 2, "{printed}");
}

#[test]
fn a_camera_of_a_view_is_recovered() {
    let sandbox = sandbox("");
    let text = String::from_utf8(sandbox.read("views.toml")).unwrap();
    let head = &text[..text.find("[[optimize.parameter]]").unwrap()];
    let head = head.replace("[1.5, 3.0, 2.0]", "[-1.0, 2.5, 2.5]").replace("= 30.0", "= 22.5");
    let text = head.replace("[-3.0, 1.0, 2.5]", "[-2.9, 1.1, 2.6]");
    let parameter = "[[optimize.parameter]]\npath = \"view.Left Side.look_from\"\n";
    sandbox.write("pose.toml", format!("{text}{parameter}"));
    sandbox.succeed(&["optimize", "pose.toml", "--out", "out", "--optimizer", "lbfgs"]);
    let summary = sandbox.json("out/summary.json");
    let found = numbers(&summary["parameters"]["view.Left Side.look_from"]["final"]);
    let error = found.iter().zip([-3.0, 1.0, 2.5]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(error < 2e-3, "{found:?}");
}

#[test]
fn batches_resume_to_the_same_bits_on_any_number_of_threads() {
    let sandbox = sandbox("batch = 1\nseed = 7\n");
    let run = |out: &str, iterations: &str, threads: &str| {
        let arguments = ["optimize", "views.toml", "--out", out, "--iterations", iterations];
        sandbox.succeed(&[&arguments[..], &["--resume", "--threads", threads]].concat());
        let summary = sandbox.json(&format!("{out}/summary.json"));
        let fields = ["loss", "best_iteration", "parameters", "views"];
        fields.map(|name| summary[name].clone()).to_vec()
    };
    let whole: Vec<Value> = run("whole", "31", "1");
    for iterations in ["6", "13", "31"] {
        run("parts", iterations, "2");
    }
    assert_eq!(run("parts", "31", "1"), whole);
    // What is recovered of samples is the last; losses are of all views.
    assert_eq!(whole[1], 31);
    let printed = sandbox.succeed(&["gradient", "views.toml"]);
    let initial: f64 = printed.lines().next().unwrap().replace("loss ", "").parse().unwrap();
    let of_run = whole[0]["initial"].as_f64().unwrap();
    assert!((of_run - initial).abs() < 1e-5 * initial, "{of_run} {initial}");
    let arguments = ["optimize", "views.toml", "--out", "other", "--optimizer", "lbfgs"];
    sandbox.refuse_with(&arguments, &["optimize.batch", "lbfgs"]);
}

/// A batch of all views gives the run without one: the best parameters are kept.
#[test]
fn a_batch_of_all_views_is_none() {
    let [batch, none] = ["batch = 9\nseed = 7\n", ""].map(|more| {
        let sandbox = sandbox(more);
        let arguments = ["optimize", "views.toml", "--out", "out", "--iterations", "12"];
        sandbox.succeed(&[&arguments[..], &["--optimizer", "adam"]].concat());
        let summary = sandbox.json("out/summary.json");
        ["loss", "best_iteration", "parameters"].map(|name| summary[name].clone())
    });
    assert_eq!(batch, none);
}

#[test]
fn cameras_that_no_loss_depends_on_are_refused() {
    let sandbox = sandbox("");
    for command in ["gradient", "optimize"] {
        let arguments = [command, "views.toml", "--param", "view.right.look_from"];
        sandbox.refuse_with(&arguments, &["view.right.look_from", "held out"]);
    }
}

/// What a mask leaves out may be anything: here a target that is right in its left half alone.
#[test]
fn masks_leave_pixels_out() {
    let sandbox = sandbox("");
    let text = String::from_utf8(sandbox.read("views.toml")).unwrap();
    let write = |name: &str, pixel: fn(u32) -> [u8; 3]| {
        let file = std::fs::File::create(sandbox.path(name)).unwrap();
        let mut encoder = png::Encoder::new(file, 24, 16);
        encoder.set_color(png::ColorType::Rgb);
        let bytes: Vec<u8> = (0..24 * 16).flat_map(|index| pixel(index % 24)).collect();
        encoder.write_header().unwrap().write_image_data(&bytes).unwrap();
    };
    write("wrong.png", |_| [255, 0, 0]);
    write("none.png", |_| [0; 3]);
    write("left.png", |x| if x < 12 { [255; 3] } else { [0; 3] });
    let loss = |scene: &str| -> f64 {
        let arguments = ["gradient", scene, "--precision", "f64", "--edges", "off", "--set"];
        let printed =
            sandbox.succeed(&[&arguments[..], &["light.key.position=-1,2.5,2.5"]].concat());
        printed.lines().next().unwrap().strip_prefix("loss ").unwrap().parse().unwrap()
    };
    let all = loss("views.toml");
    sandbox.write("half.toml", text.replace("weight = 2.0", "mask = \"left.png\"\nweight = 2.0"));
    let half = loss("half.toml");
    assert!(half > 0.0 && half != all, "{half} {all}");
    // Nor are they shown where images differ.
    sandbox.write("shown.toml", text.replace("weight = 2.0", "mask = \"left.png\""));
    sandbox.succeed(&["optimize", "shown.toml", "--iterations", "0", "--out", "shown"]);
    for file in ["shown/difference.png", "shown/views/front-difference.png"] {
        let difference = load_image(&sandbox.path(file)).unwrap().image;
        let (left, right): (Vec<_>, Vec<_>) =
            difference.pixels.chunks(12).enumerate().partition(|(at, _)| at % 2 == 0);
        let is_black = |half: &[(usize, &[[f32; 3]])]| {
            half.iter().flat_map(|(_, row)| *row).all(|pixel| *pixel == [0.0; 3])
        };
        assert!(is_black(&right) && !is_black(&left), "{file}");
    }
    let nothing = text.replace("weight = 2.0", "mask = \"none.png\"");
    sandbox.write("nothing.toml", nothing);
    sandbox.refuse_with(&["gradient", "nothing.toml"], &["none.png", "no pixel"]);
    let size = text.replace("width = 20", "width = 20\nmask = \"left.png\"");
    sandbox.write("size.toml", size);
    sandbox.refuse_with(&["gradient", "size.toml"], &["left.png", "24 x 16", "20 x 16"]);
}

#[test]
fn cameras_of_other_programs_are_views() {
    let sandbox = sandbox("");
    let frame = |file: &str, x: f64| {
        format!(
            r#"{{"file_path": "{file}", "transform_matrix":
               [[1, 0, 0, {x}], [0, 1, 0, 0.5], [0, 0, 1, 4], [0, 0, 0, 1]]}}"#
        )
    };
    let head = r#""w": 24, "h": 16, "camera_angle_x": 1.0"#;
    let file =
        format!("{{{head}, \"frames\": [{}, {}]}}", frame("a.exr", 0.0), frame("b.exr", 0.4));
    sandbox.write("transforms.json", &file);
    let table = "[[view]]\npath = \"transforms.json\"\nname = \"train\"\n";
    let scene = SCENE.replace("[camera]", "").replace(CAMERA, "");
    let scene = scene.replace("look_at = [0.0, 0.3, 0.0]\nwidth = 24\nheight = 16\n", "");
    sandbox.write("nerf.toml", format!("{table}{scene}"));
    sandbox.succeed(&["render", "nerf.toml", "-o", "picture.png"]);
    sandbox.read("picture-train_b.png");
    let parameters = sandbox.succeed_json(&["params", "nerf.toml", "--json"]);
    assert_eq!(numbers(&parameters["view.train.b.look_from"]), [0.4, 0.5, 4.0]);
    // It looks at the depth of the objects.
    assert_eq!(numbers(&parameters["view.train.b.look_at"])[2], 0.0);
    let bent = file.replace("\"w\": 24", "\"w\": 24, \"k1\": 0.1");
    sandbox.write("transforms.json", bent);
    let arguments = ["params", "nerf.toml"];
    sandbox.refuse_with(&arguments, &["transforms.json", "frames[0]", "k1 = 0.1", "undistort"]);
}

#[test]
fn what_is_wrong_with_views_is_said() {
    let sandbox = sandbox("");
    let text = String::from_utf8(sandbox.read("views.toml")).unwrap();
    let refuse = |from: &str, to: &str, parts: &[&str]| {
        assert!(text.contains(from), "{from}");
        sandbox.write("bad.toml", text.replace(from, to));
        sandbox.refuse_with(&["optimize", "bad.toml"], parts);
    };
    refuse("name = \"right\"", "name = \"front\"", &["view.front", "have this name"]);
    refuse("name = \"right\"\n", "", &["number 3", "name"]);
    refuse("weight = 2.0", "weight = -2.0", &["bad.toml:31: view.front.weight", "is -2"]);
    refuse("weight = 2.0", "wieght = 2.0", &["bad.toml", "unknown field `wieght`", "`weight`"]);
    refuse("[-3.0, 1.0, 2.5]", "[0.0, 0.3, 0.0]", &["view.Left Side.look_from", "must differ"]);
    refuse("target = \"truth-front.exr\"\n", "", &["no target for the view `front`"]);
    refuse("truth-front.exr", "truth-left_side.exr", &["20 x 16", "view `front`", "24 x 16"]);
    refuse("[optimize]\n", "[optimize]\ntarget = \"a.png\"\n", &["optimize.target", "[[view]]"]);
    refuse("[optimize]\n", "[optimize]\nbatch = 0\n", &["optimize.batch", "at least 1"]);
    refuse("[optimize]\n", "[optimize]\nseed = 1\n", &["optimize.seed", "batch"]);
    refuse(
        "path = \"light.key.position\"",
        "path = \"camera.vfov\"",
        &["camera.vfov", "begin with view"],
    );
    sandbox.refuse_with(&["optimize", "views.toml", "--target", "a.png"], &["a.png", "[[view]]"]);
    sandbox.refuse_with(&["optimize", "views.toml", "--width", "48"], &["48 x 32", "(--width 24 "]);
    sandbox.refuse_with(&["tradeoff", "views.toml"], &["views.toml", "several views"]);
    let text = format!("{SCENE}{}", OPTIMIZE.replace("[optimize]\n", "[optimize]\nbatch = 2\n"));
    sandbox.write("bad.toml", text);
    sandbox.refuse_with(&["optimize", "bad.toml"], &["optimize.batch", "none"]);
}
