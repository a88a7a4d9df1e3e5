//! Directions that surfaces scatter to, and how likely they are.

use ad::lanes::Lanes;
use ad::vector::{Vector, Vector3};
use ad::{Fields, Real, Vec3, select};

use crate::number::{Number, constant_vector, primal_vector};
use crate::primal::integrator::Integrator;
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::LaneGroup;
use crate::transport::direction::{cosine_direction, turn};
use crate::transport::material::Bsdf;
use crate::transport::microfacet::{Sampling, sampling, scattered_density, scattered_direction};
use crate::transport::positive_part;
use crate::transport::surface::SurfacePoint;

/// Directions that a group of surfaces is scattered to.
pub struct Scattered<S: Number> {
    pub direction: Vec3<S>,
    /// The probability density by solid angle, times π: the cosine, where a surface scatters as Lambert's.
    pub likelihood: S::Lanes,
    /// The cosine over the density: π, where a surface scatters as Lambert's. Without the cosine where a map
    /// bends normals.
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
        let sampling = sampling::<S::Lanes>(material, surface, have_base);
        Some(Facets { surface: vertex.group.scattering_surface(sampling.width), sampling })
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
            let likelihood = local.z();
            if group.mapped.is_some() {
                let normal = group.scattering_surface(S::Lanes::ONE).normal;
                let direction = constant_vector::<S>(turn::<S::Lanes>(normal, local));
                return Scattered { direction, likelihood, weight: S::Lanes::PI / likelihood };
            }
            Scattered {
                direction: turn::<S>(group.surface.normal, constant_vector::<S>(local)),
                likelihood,
                weight: S::Lanes::PI,
            }
        }
        Some(facets) => {
            let Facets { surface, sampling } = *facets;
            let direction = scattered_direction::<S::Lanes>(sampling, surface, lobe, numbers);
            let likelihood = facets.likelihood(direction);
            let weight = match group.mapped {
                None => surface.normal.dot(direction) * S::Lanes::PI / likelihood,
                Some(_) => {
                    let is_possible = likelihood.cmpgt(S::Lanes::ZERO);
                    select(is_possible, S::Lanes::PI / likelihood, S::Lanes::ZERO)
                }
            };
            Scattered { direction: constant_vector::<S>(direction), likelihood, weight }
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
        None if group.mapped.is_some() => {
            let normal = group.scattering_surface(S::Lanes::ONE).normal;
            S::constant(positive_part::<S::Lanes>(normal.dot(primal_vector::<S>(direction))))
        }
        None => group.surface.normal.dot(direction),
        Some(facets) => S::constant(facets.likelihood(primal_vector::<S>(direction))),
    }
}
