//! Images of a sphere of triangles, found through the tree and through the list of all triangles.

use glam::DVec3;
use renderer::integrator::{Prepared, RenderSettings, Visibility};
use renderer::scene::Scene;
use wide::f32x16;

use super::sphere;

/// A sphere of `triangles` triangles around the origin, with a hole where a whole one would have
/// more, in an image of `size` by `size` pixels.
pub fn scene(triangles: usize, size: u32) -> Scene {
    // A sphere of `n` rings has `4 n (n - 1)` triangles, and some without area at its poles.
    let mut rings = 2;
    while 4 * (rings * (rings - 1)) as usize <= triangles {
        rings += 1;
    }
    let mut scene = sphere::scene(rings, size, 1);
    let (mesh, vertices) = (&mut scene.meshes[0], &scene.parameters.vertices[0]);
    mesh.triangles.retain(|corners| {
        let [a, b, c] = corners.map(|corner| DVec3::from_array(vertices[corner as usize]));
        (b - a).cross(c - a).length() > 1e-12
    });
    mesh.triangles.truncate(triangles);
    mesh.materials.truncate(triangles);
    scene
}

/// The scene, to be rendered with or without a tree.
pub fn prepared(scene: &Scene, visibility: Visibility) -> Prepared<'_, f32x16> {
    Prepared::with_settings(scene, RenderSettings { visibility, ..RenderSettings::default() })
}
