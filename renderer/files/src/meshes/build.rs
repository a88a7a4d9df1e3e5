//! From what files hold to meshes.

use glam::DVec3;
use renderer_core::scene::table::SMALLEST_LENGTH;
use renderer_core::scene::{Material, Mesh, Normals};

use super::model::{DEFAULT_MATERIAL, Model, ModelMaps, ModelMaterial};
use crate::warning::Warnings;

/// Builds meshes out of the vertices, the texture coordinates and the normals of a file.
pub(crate) struct MeshBuilder<'a> {
    vertices: Numbering<'a, 3>,
    texture_coordinates: Numbering<'a, 2>,
    normals: Numbering<'a, 3>,
}

/// The triangles of a mesh, all indices in range.
#[derive(Default)]
pub(crate) struct Triangles {
    pub vertices: Vec<[u32; 3]>,
    /// One entry for each triangle, or none at all.
    pub texture_coordinates: Vec<Option<[u32; 3]>>,
    /// One entry for each triangle, or none at all.
    pub normals: Vec<Option<[u32; 3]>>,
    /// One for each triangle.
    pub materials: Vec<u32>,
}

impl<'a> MeshBuilder<'a> {
    /// A builder for the vertices, texture coordinates and normals that indices refer to.
    pub fn new(
        vertices: &'a [[f64; 3]],
        texture_coordinates: &'a [[f64; 2]],
        normals: &'a [[f64; 3]],
    ) -> Self {
        Self {
            vertices: Numbering::new(vertices),
            texture_coordinates: Numbering::new(texture_coordinates),
            normals: Numbering::new(normals),
        }
    }

    /// A mesh that keeps what its triangles use, in the order of its first use.
    pub fn build(&mut self, name: String, triangles: Triangles) -> Mesh {
        let Triangles { vertices: mut corners, texture_coordinates, normals, materials } =
            triangles;
        let vertices = self.vertices.renumber(corners.as_flattened_mut().iter_mut());
        let (texture_coordinates, texture_triangles) =
            self.texture_coordinates.renumber_some(texture_coordinates);
        let (directions, triangles) = self.normals.renumber_some(normals);
        let normals = match directions.is_empty() {
            true => Normals::Flat,
            false => Normals::Given { directions, triangles },
        };
        let mesh = Mesh::new(name, vertices, corners);
        Mesh { materials, texture_coordinates, texture_triangles, normals, ..mesh }
    }
}

/// Whether a normal has a direction.
pub(crate) fn check_normal(normal: [f64; 3]) -> Result<(), String> {
    match DVec3::from(normal).length() < SMALLEST_LENGTH {
        true => Err("a normal is the zero vector, which has no direction".to_owned()),
        false => Ok(()),
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

    /// The points that triangles use which have any, and these triangles; nothing if none has.
    fn renumber_some(
        &mut self,
        mut triangles: Vec<Option<[u32; 3]>>,
    ) -> (Vec<[f64; N]>, Vec<Option<[u32; 3]>>) {
        let points = self.renumber(triangles.iter_mut().flatten().flatten());
        if points.is_empty() {
            triangles = Vec::new();
        }
        (points, triangles)
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
pub(crate) fn plain_material() -> ModelMaterial {
    ModelMaterial {
        name: DEFAULT_MATERIAL.to_owned(),
        material: Ok(Material::default().into()),
        full: None,
        maps: ModelMaps::default(),
    }
}

/// A model of meshes that all have the default material.
pub(crate) fn default_model(meshes: Vec<Mesh>, warnings: Warnings) -> Model {
    Model { meshes, materials: vec![plain_material()], warnings: warnings.finish() }
}
