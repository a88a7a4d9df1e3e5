//! `renderer bench`

use super::sandbox::Sandbox;

#[test]
fn every_part_of_an_iteration_has_its_time() {
    let sandbox = Sandbox::new();
    let text = sandbox.succeed(&["bench", "scene.toml", "--seconds", "0"]);
    let number = |name: &str| -> f64 {
        let line = text.lines().find(|line| line.starts_with(name));
        let last = line.and_then(|line| line.split_whitespace().last());
        last.and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("no {name}: {text}"))
    };
    for name in [
        "load",
        "preparation, with the hierarchy",
        "first image",
        "first gradient",
        "image",
        "  of it primary rays",
        "iteration: parameters to gradient",
        "  of it parameters and hierarchy",
        "  of it rays, shading, pullbacks",
        "primary rays, millions per second",
    ] {
        assert!(number(name) > 0.0, "{name}: {text}");
    }
}
