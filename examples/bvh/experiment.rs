//! Images of a sphere of triangles, found through the tree and through the list of all triangles.

use renderer::integrator::{Prepared, Settings, Visibility};
use renderer::scene::Scene;
use wide::f32x16;

use super::sphere;

/// A sphere of `triangles` triangles around the origin, with a hole where a whole one would have
/// more, in an image of `size` by `size` pixels.
pub fn scene(triangles: usize, size: u32) -> Scene {
    let mut rings = 1;
    while 4 * (rings * rings) as usize <= triangles {
        rings += 1;
    }
    let mut scene = sphere::scene(rings, size, 1);
    let mesh = &mut scene.meshes[0];
    mesh.triangles.truncate(triangles);
    mesh.materials.truncate(triangles);
    scene
}

/// The scene, to be rendered with or without a tree.
pub fn prepared(scene: &Scene, visibility: Visibility) -> Prepared<'_, f32x16> {
    Prepared::with_settings(scene, Settings { visibility, ..Settings::default() })
}
