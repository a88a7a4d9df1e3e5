//! Triangle meshes of a scene.

use std::borrow::Cow;

use ad::{Field, Fields};
use glam::DVec3;

use super::normals::Normals;
use super::numbers::Numbers;
use crate::transport::transform::{Transform, place};

/// A triangle mesh, its place and its materials.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// The name, unique among meshes.
    pub name: String,
    /// The vertices before the transform.
    pub vertices: Vec<[f64; 3]>,
    /// Three indices into `vertices` for each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// The index of each triangle's material.
    pub materials: Vec<u32>,
    /// Texture coordinates: to the right and upwards, from 0 to 1 over the texture. Empty if no
    /// material of the mesh has a texture.
    pub texture_coordinates: Vec<[f64; 2]>,
    /// For each triangle three indices into `texture_coordinates`, if it has any; empty if no triangle
    /// has.
    pub texture_triangles: Vec<Option<[u32; 3]>>,
    /// What it is shaded with.
    pub normals: Normals,
    /// The place in the world.
    pub transform: Transform<f64>,
}

impl Mesh {
    /// A mesh whose triangles have the material of index 0.
    pub fn new(name: impl Into<String>, vertices: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        Self {
            name: name.into(),
            vertices,
            materials: vec![0; triangles.len()],
            triangles,
            texture_coordinates: Vec::new(),
            texture_triangles: Vec::new(),
            normals: Normals::Flat,
            transform: Transform::IDENTITY,
        }
    }

    /// The mesh with one material, by index, for all triangles.
    #[must_use]
    pub fn material(mut self, material: u32) -> Self {
        self.materials.fill(material);
        self
    }

    /// The mesh at another place.
    #[must_use]
    pub fn transform(self, transform: Transform<f64>) -> Self {
        Self { transform, ..self }
    }

    /// The mesh with texture coordinates, three indices into them for each triangle.
    #[must_use]
    pub fn texture_coordinates(
        mut self,
        coordinates: Vec<[f64; 2]>,
        triangles: Vec<[u32; 3]>,
    ) -> Self {
        self.texture_coordinates = coordinates;
        self.texture_triangles = triangles.into_iter().map(Some).collect();
        self
    }

    /// Whether its transform turns the mesh into its mirror image, whose corners go round the other way.
    pub fn is_mirrored(&self) -> bool {
        self.transform.scale.element_product() < 0.0
    }

    /// The mesh with [smooth](Normals::Smooth) normals.
    #[must_use]
    pub fn smooth(self) -> Self {
        Self { normals: Normals::Smooth, ..self }
    }

    /// The mesh with normals of its own, three indices into them for each triangle.
    #[must_use]
    pub fn normals(self, directions: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        let triangles = triangles.into_iter().map(Some).collect();
        Self { normals: Normals::Given { directions, triangles }, ..self }
    }

    /// How many normals it is shaded with.
    pub(crate) fn normal_count(&self) -> usize {
        match &self.normals {
            Normals::Flat => 0,
            Normals::Smooth => self.vertices.len(),
            Normals::Given { directions, .. } => directions.len(),
        }
    }

    /// For each triangle the indices of the normals that it is shaded with, if it has any.
    pub(crate) fn normal_triangles(&self) -> Cow<'_, [Option<[u32; 3]>]> {
        match &self.normals {
            Normals::Flat => Cow::Borrowed(&[]),
            Normals::Smooth => self.triangles.iter().copied().map(Some).collect(),
            Normals::Given { triangles, .. } => Cow::Borrowed(triangles),
        }
    }

    /// The vertices in the world.
    pub fn world_vertices(&self) -> impl Iterator<Item = DVec3> + '_ {
        let is_placed = self.transform != Transform::IDENTITY;
        self.vertices.iter().map(move |&vertex| match is_placed {
            true => place::<f64>(self.transform, vertex.into()),
            false => vertex.into(),
        })
    }

    /// The lowest and the highest corner of the box around the mesh in the world; nothing if it has no vertices.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let corners = self.world_vertices().map(|vertex| (vertex, vertex));
        corners.reduce(|(low, high), (vertex, _)| (low.min(vertex), high.max(vertex)))
    }
}

impl Numbers for Mesh {
    fn fields(&self) -> Vec<Field> {
        let mut fields = vec![Field { name: "vertices", len: 3 * self.vertices.len() }];
        if !self.texture_coordinates.is_empty() {
            let len = 2 * self.texture_coordinates.len();
            fields.push(Field { name: "texture_coordinates", len });
        }
        if let Normals::Given { directions, .. } = &self.normals {
            fields.push(Field { name: "normals", len: 3 * directions.len() });
        }
        fields.extend_from_slice(Transform::<f64>::FIELDS);
        fields
    }

    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>> {
        match field {
            "vertices" => Some(Cow::Borrowed(self.vertices.as_flattened())),
            "texture_coordinates" => Some(Cow::Borrowed(self.texture_coordinates.as_flattened())),
            "normals" => Some(Cow::Borrowed(self.normals.directions().as_flattened())),
            _ => Numbers::get(&self.transform, field),
        }
    }

    fn set(&mut self, field: &str, first: usize, numbers: &[f64]) {
        let all = match field {
            "vertices" => self.vertices.as_flattened_mut(),
            "texture_coordinates" => self.texture_coordinates.as_flattened_mut(),
            "normals" => self.normals.directions_mut().as_flattened_mut(),
            _ => return Numbers::set(&mut self.transform, field, first, numbers),
        };
        all[first..][..numbers.len()].copy_from_slice(numbers);
    }
}
