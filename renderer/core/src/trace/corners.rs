//! What corners of triangles have beside vertices, by indices of its own: texture coordinates, normals.

use std::borrow::Cow;
use std::iter;
use std::ops::Range;

use crate::scene::Mesh;

/// For each triangle three indices, if it has any.
type Triangles<'a> = Cow<'a, [Option<[u32; 3]>]>;

/// What the corners of the triangles of all meshes have, one mesh after the other.
pub struct Corners {
    /// The first index of each mesh, then the number of all.
    first: Vec<u32>,
    /// Three indices for each triangle that has any; empty if none has.
    triangles: Vec<Option<[u32; 3]>>,
}

impl Corners {
    /// By what meshes have: how many, and which of them each triangle has. Those of triangles at the end
    /// may be left out.
    pub fn new<'a>(meshes: &'a [Mesh], of: impl Fn(&'a Mesh) -> (usize, Triangles<'a>)) -> Self {
        let mut corners = Self { first: vec![0], triangles: Vec::new() };
        let mut first = 0;
        for mesh in meshes {
            let (count, triangles) = of(mesh);
            let moved = |corners: &Option<[u32; 3]>| corners.map(|c| c.map(|index| index + first));
            corners.triangles.extend(triangles.iter().map(moved));
            let bare = mesh.triangles.len() - triangles.len();
            corners.triangles.extend(iter::repeat_n(None, bare));
            first += count as u32;
            corners.first.push(first);
        }
        if first == 0 {
            corners.triangles = Vec::new();
        }
        corners
    }

    /// Returns `true` if no triangle has corners of this kind.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// The indices of a triangle.
    #[inline]
    pub fn of(&self, triangle: usize) -> Option<[u32; 3]> {
        self.triangles.get(triangle).copied().flatten()
    }

    /// How many there are in all meshes.
    pub fn count(&self) -> usize {
        self.first.last().map_or(0, |&end| end as usize)
    }

    /// The range of a mesh's entries among those of all meshes.
    pub fn of_mesh(&self, mesh: usize) -> Range<usize> {
        self.first[mesh] as usize..self.first[mesh + 1] as usize
    }
}
