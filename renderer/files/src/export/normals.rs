//! Normals that other programs can read.

use glam::DVec3;
use renderer_core::scene::{Mesh, Normals};

/// The mesh with its smooth normals as directions. Triangles at a vertex whose normals cancel are flat, since
/// zero is no direction.
pub(crate) fn with_directions(mesh: &Mesh) -> Mesh {
    let mut mesh = mesh.clone();
    if mesh.normals == Normals::Smooth {
        let mut sums = vec![DVec3::ZERO; mesh.vertices.len()];
        for triangle in &mesh.triangles {
            let [a, b, c] = triangle.map(|index| DVec3::from(mesh.vertices[index as usize]));
            let twice_area = (b - a).cross(c - a);
            triangle.iter().for_each(|&index| sums[index as usize] += twice_area);
        }
        let directions: Vec<DVec3> = sums.into_iter().map(DVec3::normalize_or_zero).collect();
        let is_smooth = |t: &[u32; 3]| t.iter().all(|&i| directions[i as usize] != DVec3::ZERO);
        let triangles = mesh.triangles.iter().map(|t| is_smooth(t).then_some(*t)).collect();
        // No triangle has those that would be zero, which nobody reads.
        let readable = |d: &DVec3| if *d == DVec3::ZERO { DVec3::Z } else { *d };
        let directions = directions.iter().map(|d| readable(d).to_array()).collect();
        mesh.normals = Normals::Given { directions, triangles };
    }
    mesh
}
