//! What hostile and unlucky people meet.

use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use crate::sandbox::{SCENE, Sandbox};

const RENDER: [&str; 4] = ["render", "bad.toml", "-o", "out.png"];

/// Numbers that ask for more memory than there may be.
#[test]
fn memory_is_asked_for_beforehand() {
    let sandbox = Sandbox::new();
    let mirror = SCENE.replace("diffuse = [0.6, 0.3, 0.2]", "mirror = [0.9, 0.9, 0.9]");
    sandbox.write("bad.toml", format!("bounces = 1000000000\n{mirror}"));
    sandbox.refuse_with(&RENDER, &["bad.toml:1: bounces", "TB of memory", "--max-memory"]);
    // Without mirrors no path is that long.
    sandbox.write("many.toml", format!("bounces = 1000000000\n{SCENE}"));
    sandbox.succeed(&["render", "many.toml", "-o", "out.png"]);

    let small = ["--max-memory", "1M"];
    sandbox.write("bad.toml", SCENE.replace("width = 24", "width = 2400"));
    sandbox.refuse_with(&[&RENDER[..], &small].concat(), &["camera.width", "there may be 1.0 MB"]);
    let texture = "[texture.wood]\nsize = [1000, 1000]\n";
    sandbox.write("bad.toml", format!("{SCENE}{texture}"));
    sandbox.refuse_with(&[&RENDER[..], &small].concat(), &["texture.wood.size", "36 MB"]);
    sandbox.succeed(&["render", "scene.toml", "--width", "600", "-o", "large.png"]);
    let target = ["gradient", "scene.toml", "--param", "light.key.color", "--target", "large.png"];
    sandbox
        .refuse_with(&[&target[..], &small].concat(), &["large.png: 600 x 400 pixels", "3.6 MB"]);
    sandbox.refuse_with(&["params", "scene.toml", "--max-memory", "much"], &["500M"]);
}

#[test]
fn what_is_too_small_is_told() {
    let sandbox = Sandbox::new();
    sandbox.write("bad.obj", "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n");
    sandbox.refuse_with(&["render", "bad.obj", "-o", "out.png"], &["bad.obj: is 1.4e-30 across"]);
    let ball = "[[sphere]]\nname = \"b\"\ncenter = [0, 0, 0]\nradius = 1e-30\nmaterial = \"x\"\n\
                [material.x]\n";
    sandbox.write("bad.toml", format!("{SCENE}{ball}"));
    sandbox.refuse_with(&RENDER, &["sphere.b.radius: must be at least 1e-18, is 1e-30"]);
}

#[test]
fn only_regular_files_are_read() {
    if cfg!(unix) {
        let sandbox = Sandbox::new();
        sandbox.refuse_with(&["render", "/dev/zero", "-o", "out.png"], &["/dev/zero"]);
        let target = ["--param", "light.key.color", "--target", "/dev/zero"];
        let gradient = [&["gradient", "scene.toml"], &target[..]].concat();
        sandbox.refuse_with(&gradient, &["/dev/zero: is no regular file"]);
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe.obj");
        sandbox.write("bad.toml", SCENE.replace("floor.obj", pipe.to_str().unwrap()));
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        sandbox.refuse_with(&RENDER, &["pipe.obj: is no regular file"]);
    }
}

#[test]
fn arrays_have_as_many_numbers_as_they_need() {
    let sandbox = Sandbox::new();
    for (from, to, field) in [
        ("[0.0, 1.5, 4.0]", "[0.0, 1.5, 4.0, 5.0]", "look_from"),
        ("[0.6, 0.3, 0.2]", "[0.6, 0.3, 0.2, 0.4]", "diffuse"),
        ("[1.5, 3.0, 2.0]", "[1.5, 3.0, 2.0, nan]", "position"),
    ] {
        sandbox.write_changed("bad.toml", from, to);
        sandbox.refuse_with(&RENDER, &[field, "needs 3 numbers, has 4"]);
    }
    sandbox.write("bad.toml", format!("{SCENE}[texture.wood]\nsize = [4, 4, 4]\n"));
    sandbox.refuse_with(&RENDER, &["size"]);
}

/// A run that is asked to end leaves a checkpoint, says how to go on, and comes to the same end.
#[test]
fn a_signal_ends_a_run_in_good_order() {
    if !cfg!(unix) {
        return;
    }
    let sandbox = Sandbox::new();
    fn optimize(out: &str) -> [&str; 6] {
        ["optimize", "experiment.toml", "--out", out, "--iterations", "3000"]
    }
    for signal in ["-INT", "-TERM", "-HUP"] {
        let out = format!("out{signal}");
        let mut command = sandbox.command(&optimize(&out));
        let run = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        while !sandbox.path(&out).join("checkpoint.json").exists() {
            sleep(Duration::from_millis(2));
        }
        // While it runs, nobody else may write there.
        let mut second = sandbox.command(&[&optimize(&out)[..], &["--resume"]].concat());
        let second = second.output().unwrap();
        let refused = String::from_utf8(second.stderr).unwrap();
        assert!(refused.contains("another run writes into this folder"), "{refused}");

        let kill = ["kill", signal, &run.id().to_string()].join(" ");
        assert!(std::process::Command::new("sh").args(["-c", &kill]).status().unwrap().success());
        let output = run.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130), "{output:?}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("--resume"), "{output:?}");
        sandbox.succeed(&[&optimize(&out)[..], &["--resume"]].concat());
    }
    sandbox.succeed(&optimize("whole"));
    assert_eq!(sandbox.read("out-INT/scene.toml"), sandbox.read("whole/scene.toml"));
    assert_eq!(sandbox.read("out-TERM/scene.toml"), sandbox.read("whole/scene.toml"));
}

#[test]
fn folders_of_earlier_runs_are_spoken_of() {
    let sandbox = Sandbox::new();
    let optimize = ["optimize", "experiment.toml", "--out", "out", "--iterations", "2"];
    let notes = |arguments: &[&str]| {
        let output = sandbox.run(arguments);
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stderr).unwrap()
    };
    let resumed = notes(&[&optimize[..], &["--resume"]].concat());
    assert!(resumed.contains("out: no run to resume; a new one begins"), "{resumed}");
}

#[test]
fn an_invisible_material_is_warned_about() {
    let sandbox = Sandbox::new();
    sandbox.write("a.mtl", "newmtl a\nKd 1 1 1\nTr 1\n");
    sandbox.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    let output = sandbox.run(&["render", "a.obj", "-o", "out.png"]);
    let warning = String::from_utf8(output.stderr).unwrap();
    assert!(warning.contains("the opacity of a is 0, so it is invisible"), "{warning}");
}

#[test]
fn a_mesh_without_area_is_warned_about() {
    let sandbox = Sandbox::new();
    let warnings = |obj: &str, scene: &str| {
        sandbox.write("a.obj", obj);
        sandbox.write("with.toml", SCENE.replace("path = \"floor.obj\"", scene));
        ["a.obj", "with.toml"].map(|file| {
            let output = sandbox.run(&["render", file, "-o", "out.png", "--width", "8"]);
            assert!(output.status.success(), "{output:?}");
            String::from_utf8(output.stderr).unwrap()
        })
    };
    let line = "o a\nv 0.1 0 0\nv 0.2 0.1 0.3\nv 0.3 0.2 0.6\nf 1 2 3\nf 1 2 2\n";
    let [alone, within] = warnings(line, "path = \"a.obj\"");
    let [of_mesh, of_scene] = ["a.obj", "with.toml"].map(|file| {
        format!(
            "warning: {file}: mesh.a: none of its triangles has an area, so nothing of it is seen\n"
        )
    });
    let black =
        "warning: a.obj: the image is black: nothing that the camera sees sends light to it\n";
    assert_eq!([alone, within], [of_mesh + black, of_scene]);
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let some = format!("{triangle}f 1 2 2\nf 1 2 3\n");
    assert_eq!(warnings(&some, "path = \"a.obj\""), ["", ""]);
    let [_, flat] = warnings(&some, "path = \"a.obj\"\nscale = [1, 0, 1]");
    assert!(flat.contains("none of its triangles has an area"), "{flat}");
}

#[test]
fn errors_of_the_command_line_are_one_line() {
    let sandbox = Sandbox::new();
    sandbox.refuse_with(&["render", "scene.toml"], &["--output <IMAGE>"]);
    sandbox.refuse_with(&["rendre"], &["rendre", "render"]);
    sandbox.refuse_with(&["render", "scene.toml", "-o", "a.png", "--samples", "-1"], &["-1"]);
    sandbox.refuse_with(&["optimize", "scene.toml", "--loss", "l7"], &["l7", "mean_squared"]);
}

/// What is merely missing or unknown is warned about, and left out.
#[test]
fn what_is_missing_is_left_out() {
    let sandbox = Sandbox::new();
    let warned = |obj: &str, parts: &[&str]| {
        sandbox.write("a.obj", obj);
        let output = sandbox.run(&["render", "a.obj", "-o", "out.png", "--width", "8"]);
        let warnings = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{warnings}");
        for part in parts {
            assert!(warnings.contains(part), "{part}: {warnings}");
        }
        warnings
    };
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    warned(&format!("{triangle}usemtl\nf 1 2 3\n"), &["a.obj:4", "`usemtl` names no material"]);
    assert_eq!(warned(&format!("{triangle}f 1//7 2//8 3//9\n"), &[]), "");
    assert_eq!(warned(&format!("{triangle}f 1 2 3\n").replace('\n', "\r"), &[]), "");
    sandbox.write("a.mtl", "newmtl a\nmap_Kd a.bmp\n");
    sandbox.write("a.bmp", "BM and so on");
    let textured = "mtllib a.mtl\nusemtl a\nvt 0 0\nf 1/1 2/1 3/1\n";
    warned(&format!("{triangle}{textured}"), &["a.bmp is not a PNG", "white stands for it"]);
}

/// Where the target is white, what is infinite does not count as equal to it.
#[test]
fn infinite_pixels_are_seen_before_a_white_target() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&[
        "render",
        "scene.toml",
        "--set",
        "light.key.radiant_intensity=1e6",
        "-o",
        "white.png",
    ]);
    sandbox.write_changed("bad.toml", "radiant_intensity = 30.0", "radiant_intensity = 1e38");
    let white = ["--target", "white.png", "--param", "material.paint.diffuse"];
    sandbox.refuse_with(
        &[&["gradient", "bad.toml", "--set", "light.key.color=1e6"], &white[..]].concat(),
        &["finite"],
    );
}
