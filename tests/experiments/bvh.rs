#[path = "../../examples/bvh/experiment.rs"]
mod experiment;
#[path = "../../renderer/benches/sphere.rs"]
mod sphere;

use renderer::PrimaryVisibility;

#[test]
fn the_hierarchy_shows_what_brute_force_shows() {
    for triangles in [137, 20_000] {
        let scene = experiment::scene(triangles, 48).unwrap();
        assert_eq!(scene.meshes()[0].triangles.len(), triangles);
        let [bvh, brute] = [PrimaryVisibility::Bvh, PrimaryVisibility::BruteForce]
            .map(|visibility| experiment::renderer(&scene, visibility).unwrap().render());
        // Where two triangles are equally near, either may be shown.
        let pairs = bvh.pixels.iter().zip(&brute.pixels);
        let different = pairs.filter(|(bvh, brute)| bvh != brute).count();
        assert!(different <= 4, "{different} pixels");
    }
}
