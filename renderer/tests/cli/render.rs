//! `renderer render`

use renderer::experiment::Experiment;
use renderer::files::load_image;
use renderer::{Arithmetic, Edges, Settings, render};

use crate::sandbox::{FLOOR, SCENE, Sandbox};

#[test]
fn png_and_exr_hold_the_same_image() {
    let sandbox = Sandbox::new();
    assert_eq!(sandbox.succeed(&["render", "scene.toml", "-o", "a.png"]), "a.png\n");
    sandbox.succeed(&["render", "scene.toml", "--output", "a.exr"]);
    let png = load_image(&sandbox.path("a.png")).unwrap();
    let exr = load_image(&sandbox.path("a.exr")).unwrap();
    assert_eq!((png.image.width, png.image.height), (24, 16));
    assert!(png.saturates && !exr.saturates);
    let mut lit = 0;
    for (rounded, exact) in png.image.pixels.iter().zip(&exr.image.pixels) {
        for (rounded, exact) in rounded.iter().zip(exact) {
            // Half a level of an 8 bit sRGB value.
            assert!((rounded - exact.min(1.0)).abs() < 0.005, "{rounded} {exact}");
        }
        lit += usize::from(exact[0] > 0.05);
    }
    assert!(lit > 24 * 16 / 4, "{lit} pixels are lit");
}

#[test]
fn an_obj_is_framed_and_nothing_that_faces_the_light_is_clipped() {
    let sandbox = Sandbox::new();
    sandbox.write(
        "wall.obj",
        FLOOR.replace("f 4 3 2 1", "f 1 2 3 4\nv 0 3 3\nv 2 3 3\nv 2 4 1\nf 5 6 7"),
    );
    sandbox.succeed(&["render", "wall.obj", "-o", "wall.exr"]);
    let image = load_image(&sandbox.path("wall.exr")).unwrap().image;
    assert_eq!((image.width, image.height), (512, 512));
    let brightest = image.pixels.as_flattened().iter().copied().fold(0.0, f32::max);
    assert!(brightest > 0.3 && brightest < 1.0, "{brightest}");
}

#[test]
fn threads_change_nothing_and_precision_little() {
    let sandbox = Sandbox::new();
    sandbox.succeed(&["render", "scene.toml", "-o", "one.exr", "--threads", "1"]);
    sandbox.succeed(&["--threads", "2", "render", "scene.toml", "-o", "two.exr"]);
    sandbox.succeed(&["render", "scene.toml", "-o", "double.exr", "--precision", "f64"]);
    assert_eq!(sandbox.read("one.exr"), sandbox.read("two.exr"));
    let single = load_image(&sandbox.path("one.exr")).unwrap().image;
    let double = load_image(&sandbox.path("double.exr")).unwrap().image;
    assert_ne!(single, double);
    let difference = single.absolute_difference(&double).unwrap();
    let difference = difference.pixels.as_flattened().iter().copied().fold(0.0, f32::max);
    assert!(difference < 1e-4, "{difference}");
}

#[test]
fn widths_agree_to_rounding() {
    let sandbox = Sandbox::new();
    let scene = Experiment::load(&sandbox.path("scene.toml")).unwrap().scene;
    for (single, lanes, tolerance) in
        [(Arithmetic::F32, Arithmetic::F32x16, 1e-5), (Arithmetic::F64, Arithmetic::F64x8, 1e-7)]
    {
        let image = |arithmetic| {
            let settings = Settings { arithmetic, edges: Edges::On, ..Settings::default() };
            render(&scene, &settings).unwrap()
        };
        let difference = image(single).absolute_difference(&image(lanes)).unwrap();
        let difference = difference.pixels.as_flattened().iter().copied().fold(0.0, f32::max);
        assert!(difference <= tolerance, "{lanes:?}: {difference}");
    }
}

#[test]
fn help_and_version_are_no_errors() {
    let sandbox = Sandbox::new();
    let commands: [&[&str]; 6] =
        [&[], &["render"], &["params"], &["gradient"], &["optimize"], &["bench"]];
    for command in commands {
        let help = sandbox.succeed(&[command, &["--help"]].concat());
        assert!(help.contains("Usage: renderer") && help.contains("--threads"), "{help}");
    }
    assert!(sandbox.succeed(&["--version"]).starts_with("renderer "));
}

#[test]
fn meshes_of_every_format_are_rendered() {
    let sandbox = Sandbox::new();
    let triangle = "0 0 0\n1 0 0\n0 1 0\n";
    sandbox.write("a.obj", format!("v {}f 1 2 3\n", triangle.trim().replace('\n', "\nv ") + "\n"));
    sandbox.write(
        "a.ply",
        format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
             property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n\
             {triangle}3 0 1 2\n"
        ),
    );
    let vertices = triangle.trim().replace('\n', "\nvertex ");
    sandbox.write(
        "a.stl",
        format!("solid a\nfacet normal 0 0 1\nouter loop\nvertex {vertices}\nendloop\nendfacet\n"),
    );
    sandbox.write(
        "a.gltf",
        r#"{"asset":{"version":"2.0"},"nodes":[{"mesh":0,"name":"a"}],"meshes":[{"primitives":[
        {"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,
        "type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,
        "uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}"#,
    );
    let images = ["obj", "ply", "stl", "gltf"].map(|extension| {
        let mesh = format!("a.{extension}");
        sandbox.succeed(&["render", &mesh, "-o", "alone.png"]);
        sandbox.write_changed("with.toml", "floor.obj", &mesh);
        sandbox.succeed(&["render", "with.toml", "-o", "within.png"]);
        (sandbox.read("alone.png"), sandbox.read("within.png"))
    });
    assert!(images.iter().all(|image| *image == images[0]));
    sandbox.write_changed("with.toml", "floor.obj", "floor.fbx");
    sandbox.refuse_with(
        &["render", "with.toml", "-o", "x.png"],
        &["floor.fbx: is no mesh file: one of .obj, .ply, .stl, .gltf, .glb"],
    );
}

#[test]
fn exposure_tone_and_range_are_those_asked_for() {
    let sandbox = Sandbox::new();
    let render = |more: &[&str]| {
        sandbox.succeed(&[&["render", "scene.toml", "-o", "a.exr"], more].concat());
        load_image(&sandbox.path("a.exr")).unwrap().image.pixels.as_flattened().to_vec()
    };
    let plain = render(&[]);
    let exposed = render(&["--exposure", "-1"]);
    assert!(plain.iter().zip(&exposed).all(|(plain, exposed)| 0.5 * plain == *exposed));
    let toned = render(&["--tone", "reinhard", "--exposure", "10"]);
    let brightest = toned.iter().copied().fold(0.0, f32::max);
    assert!((0.9..2.0).contains(&brightest), "{brightest}");
    let normalized = render(&["--normalize"]);
    let ends = |values: &[f32]| {
        let low = values.iter().copied().fold(f32::INFINITY, f32::min);
        (low, values.iter().copied().fold(0.0, f32::max))
    };
    assert_eq!(ends(&normalized), (0.0, 1.0));
    for more in
        [&["--exposure", "nan"][..], &["--tone", "filmic"], &["--normalize", "--exposure", "1"]]
    {
        let output = sandbox.run(&[&["render", "scene.toml", "-o", "b.exr"], more].concat());
        assert_eq!(output.status.code(), Some(2), "{more:?}");
    }
}

/// Light is in proportion to its intensity, so the derivative by that is the image over it.
#[test]
fn derivatives_are_colours_in_pictures_and_numbers_in_exr() {
    let sandbox = Sandbox::new();
    let pixels = |file: &str| load_image(&sandbox.path(file)).unwrap().image.pixels;
    // Each pixel shows one place.
    let render = ["render", "scene.toml", "--antialias", "none", "-o"];
    let derivative = |direction: &str, file: &str| {
        sandbox.succeed(&[&render[..], &[file, "--derivative", direction]].concat());
        pixels(file)
    };
    sandbox.succeed(&[&render[..], &["image.exr"]].concat());
    let found = derivative("light.key.radiant_intensity=1", "a.exr");
    for (derivative, image) in found.as_flattened().iter().zip(pixels("image.exr").as_flattened()) {
        assert!((30.0 * derivative - image).abs() <= 1e-4 * image, "{derivative} {image}");
    }
    let twice = derivative("light.key.radiant_intensity=2", "a.exr");
    assert!(found.as_flattened().iter().zip(twice.as_flattened()).all(|(a, b)| 2.0 * a == *b));
    let moved = derivative("light.key.position=1,0,0", "a.exr");
    assert!(moved.as_flattened().iter().any(|value| *value < 0.0));
    let colors = derivative("light.key.position=1,0,0", "a.png");
    assert!(colors.iter().all(|[red, _, blue]| red.max(*blue) == 1.0));

    let unseen = "[[light]]\nname = \"off\"\ntype = \"point\"\nposition = [0.0, 9.0, 0.0]\nradiant_intensity = 0.0\n";
    sandbox.write("unseen.toml", format!("{SCENE}{unseen}"));
    let render =
        ["render", "unseen.toml", "-o", "white.png", "--derivative", "light.off.position=1,0,0"];
    let output = sandbox.run(&render);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(said, "the derivative is 0 everywhere: the image is white\n");
    assert!(pixels("white.png").iter().all(|pixel| *pixel == [1.0; 3]));

    for (direction, problem) in [
        ("light.key.position=0,0,0", "light.key.position=0,0,0: the direction is zero"),
        ("light.key.position=nan,0,0", "light.key.position=nan,0,0: `nan` is not a finite number"),
        ("light.key.position=1", "light.key.position=1: needs 3 numbers, has 1"),
        ("camera.vfov=1,2", "camera.vfov=1,2: needs 1 number, has 2"),
    ] {
        let arguments = ["render", "scene.toml", "-o", "b.exr", "--derivative", direction];
        sandbox.refuse_with(&arguments, &["--derivative", problem]);
    }
}

#[test]
fn a_black_image_is_warned_of() {
    let sandbox = Sandbox::new();
    let said = |scene: &str| {
        let output = sandbox.run(&["render", scene, "-o", "black.png"]);
        assert!(output.status.success());
        String::from_utf8(output.stderr).unwrap()
    };
    sandbox.write_changed("away.toml", "look_at = [0.0, 0.3, 0.0]", "look_at = [0.0, 9.0, 9.0]");
    assert!(said("away.toml").contains("away.toml: the image is black"));
    assert_eq!(said("scene.toml"), "");
}

#[test]
fn every_way_to_visibility_shows_the_same_colours() {
    let sandbox = Sandbox::new();
    for visibility in ["bvh", "brute-force", "raster"] {
        let image = format!("{visibility}.exr");
        let arguments = ["render", "scene.toml", "-o", &image, "--visibility", visibility];
        sandbox.succeed(&[&arguments[..], &["--pass", "albedo"]].concat());
        assert_eq!(sandbox.read(&image), sandbox.read("bvh.exr"), "{visibility}");
    }
    sandbox.succeed(&["render", "scene.toml", "-o", "lit.exr"]);
    assert_ne!(sandbox.read("lit.exr"), sandbox.read("bvh.exr"));
}

/// Once for each file and kind of statement, beside the image.
#[test]
fn what_files_leave_out_is_told_on_the_error_stream() {
    let sandbox = Sandbox::new();
    let floor = crate::sandbox::FLOOR.replace("f 4", "usemtl glass\nf 4");
    sandbox.write("glass.obj", format!("mtllib glass.mtl\n{floor}l 1 2\nl 2 3\n"));
    sandbox.write("glass.mtl", "newmtl glass\nKd 1 0 0\nNi 1.5\nNi 1.4\n");
    sandbox.write_changed("glass.toml", "floor.obj", "glass.obj");
    for command in [&["render", "glass.toml", "-o", "out.png"][..], &["params", "glass.obj"]] {
        let output = sandbox.run(command);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let lines = String::from_utf8(output.stderr).unwrap();
        let expected = "warning: glass.obj:8: `l` is left out: only faces (`f`) are shown\n\
                        warning: glass.mtl:3: Ni is left out: rays go straight on behind \
                        transparent surfaces\n";
        assert_eq!(lines, expected);
        assert!(!String::from_utf8(output.stdout).unwrap().contains("warning"));
    }
}
