//! The numbers of a scene in double precision.
//!
//! Edges are searched for with one ray at a time in `f64`, whatever the lanes are that images are computed in. The
//! search sees the numbers of these without their type, so that it is compiled once: with a copy for each arithmetic it
//! was a sixth of the code of this crate. Vertices and normals are what it asks for most, and a call through a pointer
//! for each made it a tenth slower; they are matched on instead.

use ad::{Fields, Scalar};
use glam::DVec3;

use crate::number::{Number, Plain, Vectors, widen};
use crate::primal::inputs::{Inputs, ShapeInputs};
use crate::transport::camera::CameraFrame;
use crate::transport::sphere::Sphere;
use crate::transport::texture::Uv;

/// The [inputs](Inputs) of a pass.
#[derive(Clone, Copy)]
pub struct Numbers<'a> {
    pub vertices: Vectors<'a>,
    pub normals: Vectors<'a>,
    pub others: &'a dyn Others,
}

impl<'a> Numbers<'a> {
    pub fn new<L: Plain>(inputs: &'a Inputs<L>) -> Self {
        let [vertices, normals] = [&inputs.vertices, &inputs.normals].map(|of| L::vectors(of));
        Self { vertices, normals, others: inputs }
    }
}

/// All but vertices and normals, one by one.
pub trait Others: Sync {
    fn frame(&self) -> CameraFrame<f64>;

    fn uv(&self, index: u32) -> Uv<f64>;

    /// A texel of a texture, by its index there.
    fn texel(&self, texture: usize, index: usize) -> DVec3;

    fn sphere(&self, index: usize) -> Sphere<f64>;

    fn shape(&self, index: usize) -> ShapeInputs<f64>;
}

impl<L: Plain> Others for Inputs<L> {
    fn frame(&self) -> CameraFrame<f64> {
        self.frame.map(first_lane)
    }

    fn uv(&self, index: u32) -> Uv<f64> {
        self.uvs[index as usize].map(|number| number.to_f64())
    }

    fn texel(&self, texture: usize, index: usize) -> DVec3 {
        widen::<L::Lane>(self.texels[texture].at(index))
    }

    fn sphere(&self, index: usize) -> Sphere<f64> {
        self.spheres[index].map(|number| number.to_f64())
    }

    fn shape(&self, index: usize) -> ShapeInputs<f64> {
        let ShapeInputs { kernel, numbers, transform } = &self.shapes[index];
        ShapeInputs {
            kernel: kernel.clone(),
            numbers: numbers.iter().map(|number| number.to_f64()).collect(),
            transform: transform.map(first_lane),
        }
    }
}

/// What is the same in all lanes.
fn first_lane<S: Number<Lane: Scalar>>(number: S) -> f64 {
    number.lane(0).to_f64()
}
