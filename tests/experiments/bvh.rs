#[path = "../../examples/bvh/experiment.rs"]
mod experiment;
#[path = "../../renderer/benches/sphere.rs"]
mod sphere;

use std::time::Instant;

use renderer::integrator::{Visibility, render};

#[test]
fn the_tree_shows_what_the_list_shows_in_less_time() {
    for (triangles, factor) in [(137, 0), (20_000, 5)] {
        let scene = experiment::scene(triangles, 48);
        assert_eq!(scene.meshes[0].triangles.len(), triangles);
        let [tree, list] = [Visibility::Tree, Visibility::List].map(|visibility| {
            let prepared = experiment::prepared(&scene, visibility);
            let clock = Instant::now();
            (render(&prepared), clock.elapsed())
        });
        // Where two triangles are equally near, either may be shown.
        let pairs = tree.0.pixels.iter().zip(&list.0.pixels);
        let different = pairs.filter(|(tree, list)| tree != list).count();
        assert!(different <= 4, "{different} pixels");
        assert!(list.1 > factor * tree.1, "{triangles}: {:?} {:?}", tree.1, list.1);
    }
}
