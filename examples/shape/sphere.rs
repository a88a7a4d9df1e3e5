//! A sphere of triangles.

use std::collections::HashMap;

use glam::DVec3;

/// The corners and faces of an icosahedron whose faces are cut into four `level` times, on the unit sphere:
/// 10 times 4 to the power of the level, and 2 more, vertices.
pub fn icosphere(level: u32) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let t = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut corners: Vec<DVec3> = Vec::new();
    for axis in 0..3 {
        for [a, b] in [[-1.0, t], [1.0, t], [-1.0, -t], [1.0, -t]] {
            let mut corner = [0.0; 3];
            (corner[axis], corner[(axis + 1) % 3]) = (a, b);
            corners.push(DVec3::from(corner).normalize());
        }
    }
    // Three corners are a face if they are neighbours of each other.
    let edge = corners.iter().skip(1).map(|c| c.distance(corners[0])).fold(f64::MAX, f64::min);
    let near = |a: usize, b: usize| corners[a].distance(corners[b]) < 1.01 * edge;
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    let outward = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
                    let face = if outward.dot(corners[a]) > 0.0 { [a, b, c] } else { [a, c, b] };
                    faces.push(face.map(|corner| corner as u32));
                }
            }
        }
    }
    for _ in 0..level {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                corners.push((corners[a as usize] + corners[b as usize]).normalize());
                corners.len() as u32 - 1
            })
        };
        let mut finer = Vec::new();
        for [a, b, c] in faces {
            let [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
            finer.extend([[a, x, z], [b, y, x], [c, z, y], [x, y, z]]);
        }
        faces = finer;
    }
    (corners.into_iter().map(|corner| corner.to_array()).collect(), faces)
}
