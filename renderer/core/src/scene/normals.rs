//! Shading normals of meshes.

/// The normals that a mesh is shaded with.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Normals {
    /// Flat shading: every point has the normal of its triangle.
    #[default]
    Flat,
    /// Interpolated between the vertices, where they are means of the normals of the triangles around,
    /// weighted by area: they follow the vertices when these move, and so do gradients. Triangles have
    /// to be wound alike; an edge whose vertices are not shared stays sharp.
    Smooth,
    /// Interpolated between directions that are given, such as those of a file.
    Given {
        /// Normals before the transform of the mesh, of any length above 0.
        directions: Vec<[f64; 3]>,
        /// For each triangle three indices into `directions`; one that has none is flat.
        triangles: Vec<Option<[u32; 3]>>,
    },
}

impl Normals {
    /// The given directions; none if there are no such.
    pub fn directions(&self) -> &[[f64; 3]] {
        match self {
            Self::Given { directions, .. } => directions,
            Self::Flat | Self::Smooth => &[],
        }
    }

    pub(super) fn directions_mut(&mut self) -> &mut [[f64; 3]] {
        match self {
            Self::Given { directions, .. } => directions,
            Self::Flat | Self::Smooth => &mut [],
        }
    }
}
