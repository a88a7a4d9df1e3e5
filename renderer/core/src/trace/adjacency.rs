//! Which triangles share edges.

use rayon::prelude::*;

/// Where an edge has no other triangle, or more than one.
const NONE: u32 = u32::MAX;

/// The neighbours of triangles.
pub struct Adjacency(Vec<[u32; 3]>);

impl Adjacency {
    /// The neighbours of triangles that are given by the indices of their corners.
    pub fn new(triangles: &[[u32; 3]]) -> Self {
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
                neighbours[a / 3][a % 3] = (b / 3) as u32;
                neighbours[b / 3][b % 3] = (a / 3) as u32;
            }
        }
        Self(neighbours)
    }

    /// The other triangle at a [side](sides) of a triangle, if there is just one.
    pub fn across(&self, triangle: u32, side: usize) -> Option<u32> {
        Some(self.0[triangle as usize][side]).filter(|&neighbour| neighbour != NONE)
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
        let adjacency = Adjacency::new(&triangles);
        assert_eq!([0, 1, 2].map(|side| adjacency.across(0, side)), [None, Some(1), None]);
        assert_eq!([0, 1, 2].map(|side| adjacency.across(1, side)), [Some(0), None, None]);
        assert!(
            (2..5).all(|triangle| (0..3).all(|side| adjacency.across(triangle, side).is_none()))
        );
    }
}
