//! Terms of the loss that are not of images.

use std::ops::Range;

use crate::experiment::{LaplacianTerm, TunedParameter};
use crate::laplacian::Laplacian;
use crate::optimize::Evaluation;
use crate::scene::{Object, Scene};

/// What vertices cost that differ from their neighbours.
#[derive(Clone, Debug)]
pub(super) struct Regularizer {
    weight: f64,
    laplacian: Laplacian,
    /// The numbers of the vertices among those that vary.
    block: Range<usize>,
}

/// The terms of parameters, whose numbers follow one another.
pub(super) fn of(scene: &Scene, parameters: &[TunedParameter]) -> Vec<Regularizer> {
    let mut end = 0;
    let mut terms = Vec::new();
    for tuned in parameters {
        let start = end;
        end += scene.get(tuned.id).len();
        if let (Some(LaplacianTerm { weight, weights }), Object::Mesh(mesh)) =
            (tuned.laplacian, tuned.id.object)
        {
            let mesh = &scene.meshes()[mesh];
            let laplacian = Laplacian::new(&mesh.vertices, &mesh.triangles, weights);
            terms.push(Regularizer { weight, laplacian, block: start..end });
        }
    }
    terms
}

impl Regularizer {
    /// Adds the term at `x` to an evaluation there.
    pub fn add(&self, x: &[f64], to: &mut Evaluation) {
        let (value, gradient) = self.laplacian.energy(&x[self.block.clone()]);
        to.loss += self.weight * value;
        let of_block = to.gradient[self.block.clone()].iter_mut();
        of_block.zip(gradient).for_each(|(to, g)| *to += self.weight * g);
    }
}
