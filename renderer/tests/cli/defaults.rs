//! Without learning rates, within the default number of iterations.

use crate::sandbox::{SCENE, Sandbox, numbers};

/// The loss of the recovered parameters over that of the initial ones.
fn ratio(scene: &str, truth: &[(&str, &str)]) -> f64 {
    let sandbox = Sandbox::new();
    let values: String =
        truth.iter().map(|(path, value)| format!("\"{path}\" = {value}\n")).collect();
    let parameters: String = truth
        .iter()
        .map(|(path, _)| format!("[[optimize.parameter]]\npath = \"{path}\"\n"))
        .collect();
    let experiment = format!("{scene}\n[optimize.target_values]\n{values}\n{parameters}");
    sandbox.write("experiment.toml", experiment);
    sandbox.succeed(&["optimize", "experiment.toml", "--out", "out"]);
    sandbox.json("out/summary.json")["loss"]["ratio"].as_f64().unwrap()
}

#[test]
fn lights_materials_and_spheres_are_recovered() {
    let cases: &[&[(&str, &str)]] = &[
        &[("material.paint.diffuse", "[0.2, 0.7, 0.5]")],
        &[("light.key.radiant_intensity", "100.0")],
        &[("light.key.position", "[-2.0, 2.5, 1.0]")],
        &[("light.key.position", "[-1.0, 2.5, 2.5]"), ("light.key.radiant_intensity", "22.5")],
        &[("material.paint.specular", "[0.5, 0.5, 0.5]"), ("material.paint.exponent", "30.0")],
    ];
    for truth in cases {
        let ratio = ratio(SCENE, truth);
        assert!(ratio < 1e-2, "{truth:?}: {ratio:e}");
    }
}

#[test]
fn a_light_that_is_off_is_found() {
    for initial in ["0.0", "0.0025", "2500.0"] {
        let scene =
            SCENE.replace("radiant_intensity = 30.0", &format!("radiant_intensity = {initial}"));
        let ratio = ratio(&scene, &[("light.key.radiant_intensity", "30.0")]);
        assert!(ratio < 1e-6, "from {initial}: {ratio:e}");
    }
}

#[test]
fn the_unit_of_length_and_the_origin_do_not_matter() {
    for (scale, shift) in [(1e-4, 0.0), (1e4, 0.0), (1.0, 500.0)] {
        let at = |v: [f64; 3]| format!("{:?}", v.map(|x| x * scale + shift));
        let scene = format!(
            "[camera]\nlook_from = {}\nlook_at = {}\nwidth = 24\nheight = 24\n\
             [[light]]\nname = \"key\"\ntype = \"point\"\nposition = {}\nradiant_intensity = {:?}\n\
             [[sphere]]\nname = \"ball\"\ncenter = {}\nradius = {:?}\nmaterial = \"m\"\n\
             [material.m]\n",
            at([0.0, 0.0, 4.0]),
            at([0.0; 3]),
            at([2.0, 3.0, 3.0]),
            75.0 * scale * scale,
            at([0.0; 3]),
            scale,
        );
        let ratio = ratio(&scene, &[("light.key.position", &at([-1.5, 3.0, 3.5]))]);
        assert!(ratio < 1e-4, "{scale} {shift}: {ratio:e}");
    }
}

/// The target is three times as bright as a white ball under this light: the colour stays at 1, unless
/// someone says otherwise.
#[test]
fn surfaces_reflect_no_more_than_they_receive_by_default() {
    let sandbox = Sandbox::new();
    let dim = SCENE.replace("radiant_intensity = 30.0", "radiant_intensity = 3.0");
    let found = |initial: &str, bound: &str| {
        let scene = dim.replace("diffuse = [0.6, 0.3, 0.2]", &format!("diffuse = {initial}"));
        let experiment = format!(
            "{scene}\n[optimize]\niterations = 200\n[optimize.target_values]\n\
             \"light.key.radiant_intensity\" = 30.0\n\
             [[optimize.parameter]]\npath = \"material.paint.diffuse\"\n{bound}"
        );
        sandbox.write("experiment.toml", experiment);
        sandbox.succeed(&["optimize", "experiment.toml", "--out", "out", "--overwrite"]);
        let summary = sandbox.json("out/summary.json");
        numbers(&summary["parameters"]["material.paint.diffuse"]["final"])
    };
    let initial = "[0.6, 0.3, 0.2]";
    assert_eq!(found(initial, ""), [1.0; 3]);
    assert!(found(initial, "max = 2.5")[0] > 2.0);
    // What is brighter to begin with may stay so.
    let bright = found("[1.5, 0.3, 0.2]", "");
    assert!(bright[0] <= 1.5 && bright[0] > 1.2 && bright[1] == 1.0, "{bright:?}");
}
