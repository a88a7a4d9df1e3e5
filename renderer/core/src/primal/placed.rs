//! A mesh in the world.

use ad::vector::{Vector, Vector3};
use ad::{Fields, Real, Vec3, select};

use super::varying::{Varying, lifted, narrow_vector};
use crate::number::Number;
use crate::parallel;
use crate::scene::{Mesh, Normals, Object, Transform};
use crate::transport::smooth::{mean_normal, place_normal, weighted_normal};
use crate::transport::transform::place;
use crate::transport::triangle::Triangle;

/// How many vertices are placed one after the other.
const CHUNK: usize = 1024;

/// How much of the lengths of normals their sum has if they cancel but for rounding.
const CANCELLATION: f64 = 1e-12;

/// A mesh some of whose numbers may vary.
pub struct PlacedMesh<'a, S: Number> {
    mesh: &'a Mesh,
    object: Object,
    varying: &'a Varying<S::Wide>,
    is_placed: bool,
    transform: Transform<S::Wide>,
}

impl<'a, S: Number> PlacedMesh<'a, S> {
    pub fn new(index: usize, mesh: &'a Mesh, varying: &'a Varying<S::Wide>) -> Self {
        let object = Object::Mesh(index);
        let varies = Transform::<f64>::FIELDS
            .iter()
            .any(|field| varying.block(object, field.name).is_some());
        Self {
            mesh,
            object,
            varying,
            is_placed: varies || mesh.transform != Transform::IDENTITY,
            transform: varying.lift(object, &mesh.transform),
        }
    }

    /// Replaces the vertices, relative to an origin; returns whether one has moved.
    pub fn replace_vertices(&self, origin: Vec3<S::Wide>, vertices: &mut [Vec3<S::Lane>]) -> bool {
        let block = self.block("vertices");
        let world = |own: &[S::Wide; 3]| narrow_vector::<S>(self.world(own) - origin);
        let replace = |(first, vertices): (usize, &mut [Vec3<S::Lane>])| {
            let mut moved = false;
            for (vertex, slot) in (first..).zip(vertices) {
                let new = match block {
                    Some(block) => world(&block[vertex]),
                    None => world(&lifted::<S, 3>(&self.mesh.vertices[vertex])),
                };
                moved |= std::mem::replace(slot, new) != new;
            }
            moved
        };
        // The variables of a tape stay on their thread.
        let moved = match self.varying.blocks.is_empty() {
            true => {
                let chunks = (0..).step_by(CHUNK).zip(vertices.chunks_mut(CHUNK)).collect();
                parallel::map(chunks, replace).contains(&true)
            }
            false => replace((0, vertices)),
        };
        for (vertex, block) in self.varying.single_vertices(self.object) {
            vertices[vertex] = world(&block.as_chunks().0[0]);
        }
        moved
    }

    /// Replaces the unit normals. Those that follow the vertices have to be replaced if these have `moved`.
    pub fn replace_normals(&self, moved: bool, normals: &mut [Vec3<S::Lane>]) {
        match &self.mesh.normals {
            Normals::Flat => {}
            Normals::Smooth if !moved => {}
            Normals::Smooth => {
                let sums = normal_sums::<S::Wide>(&self.world_vertices(), &self.mesh.triangles);
                for (normal, sum) in normals.iter_mut().zip(sums) {
                    *normal = narrow_vector::<S>(mean_normal::<S::Wide>(sum));
                }
            }
            Normals::Given { directions, .. } => {
                let block = self.block("normals");
                for (index, (normal, own)) in normals.iter_mut().zip(directions).enumerate() {
                    let own = vector(&block.map_or_else(|| lifted::<S, 3>(own), |b| b[index]));
                    let placed = place_normal::<S::Wide>(self.transform, own);
                    *normal = narrow_vector::<S>(placed);
                }
            }
        }
    }

    fn world_vertices(&self) -> Vec<Vec3<S::Wide>> {
        let own = self.mesh.vertices.iter();
        let mut vertices: Vec<_> = match self.block("vertices") {
            Some(block) => block.iter().map(|own| self.world(own)).collect(),
            None => own.map(|own| self.world(&lifted::<S, 3>(own))).collect(),
        };
        for (vertex, block) in self.varying.single_vertices(self.object) {
            vertices[vertex] = self.world(&block.as_chunks().0[0]);
        }
        vertices
    }

    fn block(&self, field: &str) -> Option<&'a [[S::Wide; 3]]> {
        self.varying.block(self.object, field).map(|block| block.as_chunks().0)
    }

    #[inline]
    fn world(&self, own: &[S::Wide; 3]) -> Vec3<S::Wide> {
        let own = vector(own);
        if self.is_placed { place::<S::Wide>(self.transform, own) } else { own }
    }
}

/// For each vertex the sum of what the triangles around it add to its normal; zero if they cancel but for rounding, as
/// where each triangle is there twice, once for either side.
pub fn normal_sums<W: Real>(vertices: &[Vec3<W>], triangles: &[[u32; 3]]) -> Vec<Vec3<W>> {
    let zero = Vec3::<W>::splat(W::ZERO);
    let mut sums = vec![(zero, W::ZERO); vertices.len()];
    for corners in triangles {
        let [a, b, c] = corners.map(|vertex| vertices[vertex as usize]);
        let normal = weighted_normal::<W>(Triangle { a, b, c });
        let length = normal.length();
        for &vertex in corners {
            let (sum, lengths) = &mut sums[vertex as usize];
            (*sum, *lengths) = (*sum + normal, *lengths + length);
        }
    }
    let cancel = |(sum, lengths): (Vec3<W>, W)| {
        let is_rounding = sum.length().cmplt(lengths * W::from_f64(CANCELLATION));
        select(is_rounding, zero, sum)
    };
    sums.into_iter().map(cancel).collect()
}

#[inline]
fn vector<W: Real>(&[x, y, z]: &[W; 3]) -> Vec3<W> {
    Vector3::new(x, y, z)
}
