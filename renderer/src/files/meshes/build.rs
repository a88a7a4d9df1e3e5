//! From what files hold to meshes.

use crate::files::model::{DEFAULT_MATERIAL, Model, ModelMaps, ModelMaterial};
use crate::files::warnings::Warnings;
use crate::scene::{Material, Mesh};

/// Builds meshes out of the vertices and the texture coordinates of a file.
pub(in crate::files) struct MeshBuilder<'a> {
    vertices: Numbering<'a, 3>,
    texture_coordinates: Numbering<'a, 2>,
}

impl<'a> MeshBuilder<'a> {
    /// For the numbers that indices refer to.
    pub fn new(vertices: &'a [[f64; 3]], texture_coordinates: &'a [[f64; 2]]) -> Self {
        Self {
            vertices: Numbering::new(vertices),
            texture_coordinates: Numbering::new(texture_coordinates),
        }
    }

    /// A mesh of `triangles`, all indices in range: it keeps what is used, in the order of its first
    /// use. `texture_triangles` may be empty; otherwise these and `materials` have one entry for each
    /// triangle.
    pub fn build(
        &mut self,
        name: String,
        mut triangles: Vec<[u32; 3]>,
        mut texture_triangles: Vec<Option<[u32; 3]>>,
        materials: Vec<u32>,
    ) -> Mesh {
        let vertices = self.vertices.renumber(triangles.as_flattened_mut().iter_mut());
        let corners = texture_triangles.iter_mut().flatten().flatten();
        let texture_coordinates = self.texture_coordinates.renumber(corners);
        if texture_coordinates.is_empty() {
            texture_triangles = Vec::new();
        }
        let mesh = Mesh::new(name, vertices, triangles);
        Mesh { materials, texture_coordinates, texture_triangles, ..mesh }
    }
}

/// Points, numbered anew for each mesh.
struct Numbering<'a, const N: usize> {
    points: &'a [[f64; N]],
    /// The new number of each point that the mesh uses.
    numbers: Vec<Option<u32>>,
}

impl<'a, const N: usize> Numbering<'a, N> {
    fn new(points: &'a [[f64; N]]) -> Self {
        Self { points, numbers: vec![None; points.len()] }
    }

    /// The points that `indices` use, in the order of first use, by which the indices are replaced.
    fn renumber<'b>(&mut self, indices: impl Iterator<Item = &'b mut u32>) -> Vec<[f64; N]> {
        let mut used = Vec::new();
        for index in indices {
            let old = *index;
            let number = self.numbers[old as usize].get_or_insert_with(|| {
                used.push(old);
                used.len() as u32 - 1
            });
            *index = *number;
        }
        // The next mesh finds no numbers, at no more cost than this one has had.
        used.iter().for_each(|&old| self.numbers[old as usize] = None);
        used.iter().map(|&old| self.points[old as usize]).collect()
    }
}

/// The default material.
pub(in crate::files) fn plain_material() -> ModelMaterial {
    ModelMaterial {
        name: DEFAULT_MATERIAL.to_owned(),
        material: Ok(Material::default().into()),
        maps: ModelMaps::default(),
    }
}

/// A model of meshes that all wear the default material.
pub(in crate::files) fn default_model(meshes: Vec<Mesh>, warnings: Warnings) -> Model {
    Model { meshes, materials: vec![plain_material()], warnings: warnings.finish() }
}
