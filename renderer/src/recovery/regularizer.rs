//! Terms of the loss that are not of images.

use std::ops::Range;

use renderer_surfaces::energy::{EdgeLengths, NormalConsistency, TotalVariation};

use crate::experiment::{Term, TunedParameter, WeightedTerm};
use crate::laplacian::Laplacian;
use crate::optimize::Evaluation;
use crate::scene::{Invalid, Object, ParameterId, Scene};

/// A term of some of the numbers that vary.
#[derive(Clone, Debug)]
pub(super) struct Regularizer {
    weight: f64,
    energy: Energy,
    /// Its numbers among those that vary.
    block: Range<usize>,
}

/// What numbers cost by themselves.
#[derive(Clone, Debug)]
enum Energy {
    Laplacian(Laplacian),
    EdgeLengths(EdgeLengths),
    NormalConsistency(NormalConsistency),
    TotalVariation(TotalVariation),
}

/// The terms of parameters, whose numbers follow one another; a parameter with a term that is for others is an
/// error.
pub(super) fn of(
    scene: &Scene,
    parameters: &[TunedParameter],
) -> Result<Vec<Regularizer>, Invalid> {
    let mut end = 0;
    let mut regularizers = Vec::new();
    for tuned in parameters {
        let start = end;
        end += scene.get(tuned.id).len();
        for &WeightedTerm { term, weight } in &tuned.terms {
            let energy = energy(scene, tuned.id, term).ok_or_else(|| Invalid {
                path: scene.path(tuned.id).to_string(),
                problem: format!("has a term that is for other parameters: {term:?}"),
            })?;
            regularizers.push(Regularizer { weight, energy, block: start..end });
        }
    }
    Ok(regularizers)
}

/// A term of a parameter; nothing if it is for parameters of another kind.
fn energy(scene: &Scene, id: ParameterId, term: Term) -> Option<Energy> {
    if let (Term::TotalVariation, Object::Texture(texture)) = (term, id.object) {
        let map = scene.environment.and_then(|environment| environment.texture);
        let is_environment = map == Some(texture as u32);
        let variation = TotalVariation::new(&scene.textures()[texture], is_environment);
        return Some(Energy::TotalVariation(variation));
    }
    let mesh = &scene.meshes()[id.whole_mesh()?];
    let (vertices, triangles) = (&mesh.vertices, &mesh.triangles);
    match term {
        Term::Laplacian(weights) => {
            Some(Energy::Laplacian(Laplacian::new(vertices, triangles, weights)))
        }
        Term::EdgeLength => Some(Energy::EdgeLengths(EdgeLengths::new(vertices, triangles))),
        Term::NormalConsistency => {
            Some(Energy::NormalConsistency(NormalConsistency::new(triangles)))
        }
        Term::TotalVariation => None,
    }
}

impl Regularizer {
    /// The term at `x`.
    pub fn value(&self, x: &[f64]) -> f64 {
        self.weight * self.energy(x).0
    }

    fn energy(&self, x: &[f64]) -> (f64, Vec<f64>) {
        let x = &x[self.block.clone()];
        match &self.energy {
            Energy::Laplacian(laplacian) => laplacian.energy(x),
            Energy::EdgeLengths(lengths) => lengths.energy(x),
            Energy::NormalConsistency(normals) => normals.energy(x),
            Energy::TotalVariation(variation) => variation.energy(x),
        }
    }

    /// Adds the term at `x` to an evaluation there.
    pub fn add(&self, x: &[f64], to: &mut Evaluation) {
        let (value, gradient) = self.energy(x);
        to.loss += self.weight * value;
        let of_block = to.gradient[self.block.clone()].iter_mut();
        of_block.zip(gradient).for_each(|(to, g)| *to += self.weight * g);
    }
}
