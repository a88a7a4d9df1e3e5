//! Directions that surfaces scatter to, and how likely they are.

use ad::lanes::Lanes;
use ad::vector::{Vector, Vector3};
use ad::{Fields, Real, Vec3};

use crate::number::{Number, constant_vector, primal_vector};
use crate::primal::integrator::Integrator;
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::LaneGroup;
use crate::transport::direction::{cosine_direction, turn};
use crate::transport::material::Bsdf;
use crate::transport::microfacet::{Sampling, sampling, scattered_density, scattered_direction};
use crate::transport::surface::SurfacePoint;

/// Directions that a group of surfaces is scattered to.
pub struct Scattered<S: Number> {
    pub direction: Vec3<S>,
    /// The probability density by solid angle, times π: the cosine, where a surface scatters as Lambert's.
    pub likelihood: S::Lanes,
    /// The cosine over the density: π, where a surface scatters as Lambert's.
    pub weight: S::Lanes,
}

/// How a group of metallic-roughness surfaces scatters.
pub struct Facets<L: Lanes> {
    surface: SurfacePoint<L>,
    sampling: Sampling<L>,
}

impl<L: Lanes> Facets<L> {
    /// The likelihood of directions, as in [`Scattered`].
    pub fn likelihood(&self, direction: Vec3<L>) -> L {
        scattered_density::<L>(self.sampling, self.surface, direction) * L::PI
    }
}

impl<S: Number> Integrator<'_, S> {
    /// How the surfaces of a vertex scatter by their facets, if they have any.
    pub fn facets(&self, vertex: &Vertex<'_, S>) -> Option<Facets<S::Lanes>> {
        if vertex.group.bsdf != Bsdf::MetallicRoughness {
            return None;
        }
        let has_base =
            |material: usize| self.zero_weight.bases || !self.layout.materials[material].is_metal;
        let have_base = S::Lanes::mask_from_bits(vertex.materials.lanes_where(has_base));
        let surface = vertex.group.surface.map(S::primal);
        let material = vertex.material.map(S::primal);
        Some(Facets { surface, sampling: sampling::<S::Lanes>(material, surface, have_base) })
    }
}

/// Directions that three numbers from 0 to 1 choose for a group, of which the first decides between the
/// diffuse part and facets.
pub fn scatter<S: Number>(
    group: &LaneGroup<S>,
    facets: Option<&Facets<S::Lanes>>,
    lobe: S::Lanes,
    numbers: [S::Lanes; 2],
) -> Scattered<S> {
    match facets {
        None => {
            let local = cosine_direction::<S::Lanes>(numbers);
            Scattered {
                direction: turn::<S>(group.surface.normal, constant_vector::<S>(local)),
                likelihood: local.z(),
                weight: S::Lanes::PI,
            }
        }
        Some(facets) => {
            let Facets { surface, sampling } = *facets;
            let direction = scattered_direction::<S::Lanes>(sampling, surface, lobe, numbers);
            let likelihood = facets.likelihood(direction);
            let cosine = surface.normal.dot(direction);
            Scattered {
                direction: constant_vector::<S>(direction),
                likelihood,
                weight: cosine * S::Lanes::PI / likelihood,
            }
        }
    }
}

/// The likelihood of directions, as in [`Scattered`], from a group.
pub fn likelihood<S: Number>(
    group: &LaneGroup<S>,
    facets: Option<&Facets<S::Lanes>>,
    direction: Vec3<S>,
) -> S {
    match facets {
        None => group.surface.normal.dot(direction),
        Some(facets) => S::constant(facets.likelihood(primal_vector::<S>(direction))),
    }
}
