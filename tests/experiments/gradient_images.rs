#[path = "../../examples/gradient_images/experiment.rs"]
mod experiment;

/// Both ways agree at all pixels for what moves no edge, and but for some at edges otherwise.
#[test]
fn forward_mode_agrees_with_differences() {
    let scene = experiment::scene(64).unwrap();
    for (path, element, at_most) in [
        ("material.leaves.diffuse", 1, 0.0),
        ("material.leaves.exponent", 0, 0.0),
        ("light.key.radiant_intensity", 0, 0.0),
        ("light.key.position", 0, 0.02),
        ("camera.look_from", 0, 0.05),
    ] {
        let id = scene.parameter(path).unwrap();
        let forward = experiment::by_forward_mode(&scene, id, element).unwrap();
        let differences = experiment::by_differences(&scene, id, element).unwrap();
        assert!(experiment::largest(&forward) > 0.0, "{path}");
        let different = experiment::different(&forward, &differences, 1e-2);
        assert!(different <= at_most, "{path}: {different}");
    }
}
