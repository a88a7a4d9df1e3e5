//! Images of a sphere of triangles, found through the hierarchy and by testing all triangles.

use glam::DVec3;
use renderer::{Error, Mesh, PrimaryVisibility, Renderer, Scene, Settings};

use super::sphere;

/// A sphere of `triangles` triangles around the origin, with a hole where a whole one would have
/// more, in an image of `size` by `size` pixels.
pub fn scene(triangles: usize, size: u32) -> Result<Scene, Error> {
    // A sphere of `n` rings has `4 n (n - 1)` triangles, and some without area at its poles.
    let mut rings = 2;
    while 4 * (rings * (rings - 1)) as usize <= triangles {
        rings += 1;
    }
    let Mesh { name, vertices, triangles: mut corners, .. } = sphere::bumpy_sphere(rings);
    corners.retain(|corners| {
        let [a, b, c] = corners.map(|corner| DVec3::from_array(vertices[corner as usize]));
        (b - a).cross(c - a).length() > 1e-12
    });
    corners.truncate(triangles);
    sphere::scene(Mesh::new(name, vertices, corners), size, 1)
}

/// The scene, to be rendered with or without a hierarchy.
pub fn renderer(scene: &Scene, visibility: PrimaryVisibility) -> Result<Renderer, Error> {
    Renderer::new(scene, &Settings { visibility, ..Settings::default() })
}
