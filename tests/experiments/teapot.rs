#[path = "../../examples/teapot/experiment.rs"]
mod experiment;
#[path = "../../examples/teapot/patches.rs"]
mod patches;

use std::collections::HashMap;

use renderer::{Settings, render};

#[test]
fn the_teapot_has_its_published_size() {
    let all = patches::patches();
    assert_eq!(all.len(), 32);
    let (vertices, triangles) = patches::tessellate(&all, 10);
    // Eight patches end in a point, where ten halves of their quadrilaterals have no area.
    assert_eq!(triangles.len(), 6400 - 8 * 10);
    let extent = |axis: usize| {
        let along = vertices.iter().map(|vertex| vertex[axis]);
        (along.clone().fold(f64::MAX, f64::min), along.fold(f64::MIN, f64::max))
    };
    let (left, right) = extent(0);
    assert!((left + 3.0).abs() < 0.01 && (right - 3.434).abs() < 0.01, "{left} {right}");
    let (low, high) = extent(1);
    assert!(low.abs() < 1e-12 && (high - 3.15).abs() < 1e-12, "{low} {high}");
    let (back, front) = extent(2);
    assert!((back + 2.0).abs() < 0.01 && (front - 2.0).abs() < 0.01, "{back} {front}");
}

#[test]
fn neighbouring_patches_meet() {
    let (vertices, triangles) = patches::tessellate(&patches::patches(), 4);
    let key = |index: u32| vertices[index as usize].map(|x| (x * 1e9).round() as i64);
    let mut edges: HashMap<_, u32> = HashMap::new();
    for [a, b, c] in triangles {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let (from, to) = (key(from), key(to));
            *edges.entry((from.min(to), from.max(to))).or_default() += 1;
        }
    }
    // Only the rims of lid and body and the ends of handle and spout are open: 4 quarters of 4
    // edges each for the rims, 2 halves of 4 edges for each end.
    let open = edges.values().filter(|&&count| count == 1).count();
    assert_eq!(open, 2 * 16 + 4 * 8);
}

#[test]
fn the_teapot_is_seen_from_every_view() {
    let mut scene = experiment::scene(4, 64).unwrap();
    for (look_from, look_at) in experiment::VIEWS {
        scene.camera.look_from = look_from;
        scene.camera.look_at = look_at;
        let image = render(&scene, &Settings::default()).unwrap();
        let lit = image.pixels.iter().filter(|pixel| pixel[0] > 0.0).count();
        assert!((400..3000).contains(&lit), "{look_from}: {lit} pixels");
    }
}
