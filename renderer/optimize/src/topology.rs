//! Variables whose elements change in the course of a run.

use serde::{Deserialize, Serialize};

use super::Variable;

/// The mesh that a variable is the vertices of, where its triangles change in the course of a run. The optimiser only
/// keeps it: for the [objective](super::Objective::restore), when a run is resumed, and for whoever shows the outcome.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Topology {
    /// Which variable.
    pub variable: usize,
    /// Where the vertices were when the triangles were last changed.
    pub vertices: Vec<[f64; 3]>,
    /// Three indices into `vertices` for each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// The index of each triangle's material.
    pub materials: Vec<u32>,
}

/// From numbers of some elements to those of others.
pub type Carry = dyn Fn(&[f64]) -> Vec<f64>;

/// What is optimised from an iteration on.
pub struct Change {
    /// The meshes that have changed since the beginning of the run.
    pub topologies: Vec<Topology>,
    /// As many variables as before, in the same order; their initial values count for nothing.
    pub variables: Vec<Variable>,
    /// The elements of all variables.
    pub x: Vec<f64>,
    /// From numbers that the elements had before, such as means of gradients, to those of the elements now.
    pub carry: Box<Carry>,
}
