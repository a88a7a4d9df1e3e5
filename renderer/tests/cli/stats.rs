//! `--stats`

use crate::sandbox::Sandbox;

/// What `--stats` counts, by label.
fn counts(sandbox: &Sandbox, arguments: &[&str]) -> impl Fn(&str) -> u64 + use<> {
    let mut arguments = arguments.to_vec();
    arguments.push("--stats");
    let output = sandbox.run(&arguments);
    assert!(output.status.success(), "{output:?}");
    let text = String::from_utf8(output.stderr).unwrap();
    move |label| {
        let line = text.lines().find_map(|line| line.strip_prefix(label));
        line.unwrap_or_else(|| panic!("no {label} in {text}")).trim().parse().unwrap()
    }
}

const CAMERA: &str = "[camera]\nlook_from = [0.0, 0.0, 4.0]\nlook_at = [0.0, 0.0, 0.0]\n\
                      width = 32\nheight = 24\n";
const LIGHT: &str = "[[light]]\nname = \"key\"\ntype = \"point\"\nposition = [0.0, 3.0, 4.0]\n\
                     radiant_intensity = 5.0\n";
const SPHERE: &str =
    "[[sphere]]\nname = \"ball\"\ncenter = [0.0, 0.0, 0.0]\nradius = 1.0\nmaterial = \"paint\"\n";
const OTHER: &str =
    "[[sphere]]\nname = \"other\"\ncenter = [0.5, 1.5, 1.0]\nradius = 0.3\nmaterial = \"paint\"\n";

const MESH: &str = "[[mesh]]\npath = \"mesh.obj\"\nname = \"patches\"\nmaterial = \"paint\"\n";
/// Two triangles apart: one to the left, one to the right.
const PATCHES: &str = "v -2 -1 0\nv -0.5 -1 0\nv -1 1 0\nv 0.5 -1 0\nv 2 -1 0\nv 1 1 0\n\
                       f 1 2 3\nf 4 5 6\n";

const PAINT: &str = "[material.paint]\ndiffuse = [0.6, 0.3, 0.2]\n";

#[test]
fn an_image_takes_what_the_scene_requires() {
    let sandbox = Sandbox::new();
    let image = |name: &str, scene: &str| {
        sandbox.write(name, scene);
        counts(&sandbox, &["render", name, "-o", "image.png", "--antialias", "none"])
    };
    let alone = image("alone.toml", &format!("{CAMERA}{LIGHT}{SPHERE}{PAINT}"));
    assert_eq!(alone("primary rays"), 32 * 24);
    assert!(alone("points shaded") > 0 && alone("points shaded") < 32 * 24);
    // Nothing else is there to cast a shadow, reflect, or have a texture.
    for label in ["shadow rays", "rays that go on", "texture lookups", "shading pullbacks"] {
        assert_eq!(alone(label), 0, "{label}");
    }

    let two = image("two.toml", &format!("{CAMERA}{LIGHT}{SPHERE}{OTHER}{PAINT}"));
    let facing = two("shadow rays");
    assert!(facing > 0 && facing < two("points shaded"), "{facing}");
    assert!(two("nodes visited") > 0);

    let dark = LIGHT.replace("= 5.0", "= 0.0");
    let dark = image("dark.toml", &format!("{CAMERA}{dark}{SPHERE}{OTHER}{PAINT}"));
    assert_eq!(dark("shadow rays"), 0);

    let mirror =
        format!("bounces = 1\n{CAMERA}{LIGHT}{SPHERE}{OTHER}{PAINT}mirror = [0.5, 0.5, 0.5]\n");
    let mirror = image("mirror.toml", &mirror);
    assert_eq!(mirror("rays that go on"), two("points shaded"));
    assert_eq!(mirror("primary rays"), 32 * 24);

    let samples = counts(&sandbox, &["render", "two.toml", "-o", "image.png", "--samples", "4"]);
    assert_eq!(samples("primary rays"), 4 * 32 * 24);
}

#[test]
fn a_gradient_takes_what_its_parameters_require() {
    let sandbox = Sandbox::new();
    sandbox.write("two.toml", format!("{CAMERA}{LIGHT}{SPHERE}{OTHER}{PAINT}"));
    sandbox.write(
        "other.toml",
        format!("{CAMERA}{LIGHT}{SPHERE}{OTHER}{PAINT}").replace("= 5.0", "= 7.5"),
    );
    sandbox.succeed(&["render", "other.toml", "-o", "target.exr"]);
    let gradient = |path: &str, edges: &str| {
        let problem = ["gradient", "two.toml", "--target", "target.exr", "--param", path];
        counts(&sandbox, &[&problem[..], &["--edges", edges]].concat())
    };
    let light = gradient("light.key.radiant_intensity", "auto");
    assert_eq!(light("primary rays"), 32 * 24);
    assert_eq!(light("surface pullbacks"), 0);
    // Where no light comes, the images are the same, and nothing flows back.
    assert!(light("shading pullbacks") > 0);
    assert!(light("shading pullbacks") <= light("points shaded"));

    // Nothing flows back to what does not show the vertex.
    sandbox.write("both.toml", format!("{CAMERA}{LIGHT}{PAINT}{MESH}"));
    sandbox.write("mesh.obj", PATCHES);
    let gradient_of_mesh = |path: &str| {
        let problem = ["gradient", "both.toml", "--target", "target.exr", "--param", path];
        counts(&sandbox, &[&problem[..], &["--edges", "off"]].concat())
    };
    let all = gradient_of_mesh("mesh.patches.vertices");
    let one = gradient_of_mesh("mesh.patches.vertices[1]");
    for label in ["shading pullbacks", "surface pullbacks"] {
        assert!(one(label) > 0 && 2 * one(label) <= all(label), "{label}");
    }
    assert_eq!(one("points shaded"), all("points shaded"));

    let camera = gradient("camera.look_from", "off");
    assert_eq!(camera("surface pullbacks"), camera("shading pullbacks"));
    // Crossings have two sides each, which are surface points too.
    let with_edges = [(); 2].map(|()| gradient("camera.look_from", "on")("surface pullbacks"));
    assert!(with_edges[0] > camera("surface pullbacks"));
    assert_eq!(with_edges[0], with_edges[1]);
}
