#[path = "../../examples/bvh/experiment.rs"]
mod experiment;
#[path = "../../renderer/benches/sphere.rs"]
mod sphere;

use std::time::{Duration, Instant};

use renderer::image::Image;
use renderer::integrator::{Visibility, render};
use renderer::scene::Scene;

/// The image, and the time of the fastest of a few: other work on the machine may delay some.
fn fastest(scene: &Scene, visibility: Visibility) -> (Image, Duration) {
    let prepared = experiment::prepared(scene, visibility);
    let timed = |_| {
        let clock = Instant::now();
        (render(&prepared), clock.elapsed())
    };
    (0..10).map(timed).min_by_key(|(_, time)| *time).unwrap()
}

#[test]
fn the_tree_shows_what_the_list_shows_in_less_time() {
    for triangles in [137, 20_000] {
        let scene = experiment::scene(triangles, 48);
        assert_eq!(scene.meshes[0].triangles.len(), triangles);
        let [tree, list] = [Visibility::Tree, Visibility::List].map(|way| fastest(&scene, way));
        // Where two triangles are equally near, either may be shown.
        let pairs = tree.0.pixels.iter().zip(&list.0.pixels);
        let different = pairs.filter(|(tree, list)| tree != list).count();
        assert!(different <= 4, "{different} pixels");
        // The tree is for large meshes.
        if triangles > 1000 {
            assert!(list.1 > 3 * tree.1, "{triangles}: {:?} {:?}", tree.1, list.1);
        }
    }
}
