//! Meshes of which nothing is seen.

use glam::DVec3;

use crate::Warning;
use crate::scene::{Mesh, Scene};

/// The largest part of the square of a side that the area of a triangle may be for single precision to see none.
const NO_AREA: f64 = f32::EPSILON as f64;

/// Warns of the meshes of a scene, from the file `place`, whose triangles are all lines or points.
pub(super) fn invisible_meshes(scene: &Scene, place: &str) -> Vec<Warning> {
    let invisible = scene.meshes.iter().filter(|mesh| is_invisible(mesh));
    let problem = "none of its triangles has an area, so nothing of it is seen";
    let warning = |mesh: &Mesh| Warning::new(format_args!("{place}: mesh.{}", mesh.name), problem);
    invisible.map(warning).collect()
}

fn is_invisible(mesh: &Mesh) -> bool {
    let vertices: Vec<DVec3> = mesh.world_vertices().collect();
    mesh.triangles.iter().all(|corners| {
        // What is wrong with a mesh is told later.
        let place = |corner: u32| vertices.get(corner as usize).copied().unwrap_or(DVec3::NAN);
        let [a, b, c] = corners.map(place);
        let (ab, ac) = (b - a, c - a);
        let longest = ab.length_squared().max(ac.length_squared()).max((c - b).length_squared());
        ab.cross(ac).length() <= NO_AREA * longest
    })
}
