//! Which triangles share edges.

use rayon::prelude::*;

/// Where an edge has no other triangle, or more than one.
const NONE: u32 = !SEAM;

/// The bit of a neighbour that says that the surface goes on smoothly.
const SEAM: u32 = 1 << 31;

/// The neighbours of triangles.
pub struct Adjacency(Vec<[u32; 3]>);

impl Adjacency {
    /// The neighbours of triangles that are given by the indices of their corners; `is_seam` tells of two of them
    /// whether the surface goes on smoothly, whatever numbers the scene has.
    pub fn new(triangles: &[[u32; 3]], is_seam: impl Fn(u32, u32) -> bool) -> Self {
        let sides = triangles.par_iter().enumerate().flat_map_iter(|(triangle, &corners)| {
            sides(corners).into_iter().enumerate().map(move |(side, [a, b])| {
                (u64::from(a.min(b)) << 32 | u64::from(a.max(b)), 3 * triangle + side)
            })
        });
        let mut sides: Vec<(u64, usize)> = sides.collect();
        sides.par_sort_unstable();
        let mut neighbours = vec![[NONE; 3]; triangles.len()];
        for of_edge in sides.chunk_by(|a, b| a.0 == b.0) {
            if let &[(_, a), (_, b)] = of_edge {
                let [first, second] = [a, b].map(|side| (side / 3) as u32);
                let seam = if is_seam(first, second) { SEAM } else { 0 };
                neighbours[a / 3][a % 3] = second | seam;
                neighbours[b / 3][b % 3] = first | seam;
            }
        }
        Self(neighbours)
    }

    /// The other triangle at a [side](sides) of a triangle, if there is just one.
    pub fn across(&self, triangle: u32, side: usize) -> Option<u32> {
        let neighbour = self.0[triangle as usize][side] & !SEAM;
        (neighbour != NONE).then_some(neighbour)
    }

    /// Whether the surface goes on smoothly at a side of a triangle.
    pub fn is_seam(&self, triangle: u32, side: usize) -> bool {
        self.0[triangle as usize][side] & SEAM != 0
    }
}

/// The edges of a triangle.
pub fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

#[cfg(test)]
mod tests {
    use super::Adjacency;

    #[test]
    fn neighbours_share_an_edge_with_one_other_triangle() {
        // A strip of two triangles, and a fin of three at the edge of 4 and 5.
        let triangles = [[0, 1, 2], [2, 1, 3], [4, 5, 6], [5, 4, 7], [4, 5, 8]];
        let adjacency = Adjacency::new(&triangles, |a, b| [a, b] == [0, 1]);
        assert_eq!([0, 1, 2].map(|side| adjacency.across(0, side)), [None, Some(1), None]);
        assert_eq!([0, 1, 2].map(|side| adjacency.across(1, side)), [Some(0), None, None]);
        let seams = (0..3).filter(|&side| adjacency.is_seam(1, side));
        assert!(adjacency.is_seam(0, 1) && seams.eq([0]));
        assert!(
            (2..5).all(|triangle| (0..3).all(|side| adjacency.across(triangle, side).is_none()))
        );
    }
}
