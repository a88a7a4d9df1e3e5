#[path = "../../examples/bvh/experiment.rs"]
mod experiment;
#[path = "../../renderer/benches/sphere.rs"]
mod sphere;

use std::time::{Duration, Instant};

use renderer::{Image, PrimaryVisibility, Scene};

/// The image, and the time of the fastest of a few: other work on the machine may delay some.
fn fastest(scene: &Scene, visibility: PrimaryVisibility) -> (Image, Duration) {
    let renderer = experiment::renderer(scene, visibility).unwrap();
    let timed = |_| {
        let clock = Instant::now();
        (renderer.render(), clock.elapsed())
    };
    (0..10).map(timed).min_by_key(|(_, time)| *time).unwrap()
}

#[test]
fn the_hierarchy_shows_what_brute_force_shows_in_less_time() {
    for triangles in [137, 20_000] {
        let scene = experiment::scene(triangles, 48).unwrap();
        assert_eq!(scene.meshes()[0].triangles.len(), triangles);
        let [bvh, brute] =
            [PrimaryVisibility::Bvh, PrimaryVisibility::BruteForce].map(|way| fastest(&scene, way));
        // Where two triangles are equally near, either may be shown.
        let pairs = bvh.0.pixels.iter().zip(&brute.0.pixels);
        let different = pairs.filter(|(bvh, brute)| bvh != brute).count();
        assert!(different <= 4, "{different} pixels");
        // The hierarchy is for large meshes.
        if triangles > 1000 {
            assert!(brute.1 > 3 * bvh.1, "{triangles}: {:?} {:?}", bvh.1, brute.1);
        }
    }
}
