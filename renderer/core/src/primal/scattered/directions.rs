//! Directions that surfaces scatter to, and how likely they are.

use ad::lanes::Lanes;
use ad::vector::Vector3;
use ad::{Fields, Real, Vec3, select};

use crate::number::{MAX_LANES, Number, constant_vector, primal_vector};
use crate::primal::integrator::Integrator;
use crate::primal::lanes::lanes_of_numbers;
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::{LaneGroup, Wavefront};
use crate::transport::direction::{cosine_direction, turn};
use crate::transport::emitter::cosine_density;
use crate::transport::material::Bsdf;
use crate::transport::microfacet::{Sampling, sampling, scattered_density, scattered_direction};
use crate::transport::surface::SurfacePoint;

/// Directions that a group of surfaces is scattered to.
pub struct Scattered<L: Lanes> {
    pub direction: Vec3<L>,
    /// The probability density by solid angle, times π: the cosine, where a surface scatters as Lambert's.
    pub likelihood: L,
}

/// How a group of metallic-roughness surfaces scatters.
#[derive(Clone, Copy)]
pub struct Facets<L: Lanes> {
    pub surface: SurfacePoint<L>,
    pub sampling: Sampling<L>,
}

/// A group of surfaces, and how it scatters. Where it does not by facets, it does by the cosine.
pub struct Scatterer<'a, S: Number> {
    pub group: &'a LaneGroup<S>,
    /// By lane: the probability with which a path is not scattered.
    pub unscattered: [f64; MAX_LANES],
    pub facets: Option<Facets<S::Lanes>>,
}

impl<'a, S: Number> Integrator<'a, S> {
    /// How the surfaces of a vertex scatter.
    pub fn scatterer(&self, vertex: &Vertex<'a, S>) -> Scatterer<'a, S> {
        let group = vertex.group;
        Scatterer { group, unscattered: self.unscattered(group), facets: self.facets(vertex) }
    }

    /// How a group scatters, of which vertices are gathered only if that depends on them.
    pub(super) fn scatterer_of(
        &self,
        wavefront: &'a Wavefront<S>,
        group: &'a LaneGroup<S>,
    ) -> Scatterer<'a, S> {
        match group.bsdf {
            Bsdf::MetallicRoughness => self.scatterer(&self.vertex(group, wavefront, None)),
            Bsdf::BlinnPhong | Bsdf::Dielectric => {
                Scatterer { group, unscattered: self.unscattered(group), facets: None }
            }
        }
    }

    /// How the surfaces of a vertex scatter by their facets, if they have any.
    fn facets(&self, vertex: &Vertex<'_, S>) -> Option<Facets<S::Lanes>> {
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

impl<S: Number> Scatterer<'_, S> {
    /// Directions that three numbers from 0 to 1 choose, of which the first decides between the diffuse part and
    /// facets.
    pub fn scatter(&self, lobe: S::Lanes, numbers: [S::Lanes; 2]) -> Scattered<S::Lanes> {
        match self.facets {
            None => {
                let local = cosine_direction::<S::Lanes>(numbers);
                let direction = turn::<S::Lanes>(self.normal(), local);
                Scattered { direction, likelihood: local.z() }
            }
            Some(Facets { surface, sampling }) => {
                let direction = scattered_direction::<S::Lanes>(sampling, surface, lobe, numbers);
                let density = scattered_density::<S::Lanes>(sampling, surface, direction);
                Scattered { direction, likelihood: density * S::Lanes::PI }
            }
        }
    }

    /// The probability density of directions, by solid angle. It varies with these alone.
    pub fn density(&self, direction: Vec3<S>) -> S {
        let probability = S::constant(self.probability_towards(primal_vector::<S>(direction)));
        match &self.facets {
            None => {
                let normal = constant_vector::<S>(self.normal());
                cosine_density::<S>(normal, probability, direction)
            }
            Some(Facets { surface, sampling }) => {
                let (surface, sampling) = (surface.map(S::constant), sampling.map(S::constant));
                scattered_density::<S>(sampling, surface, direction) * probability
            }
        }
    }

    /// The probability with which a path is scattered.
    pub fn probability(&self) -> S::Lanes {
        lanes_of_numbers::<S::Lanes>(&self.unscattered.map(|part| 1.0 - part))
    }

    /// The same, if paths go on in a direction: into the geometry none does.
    pub fn probability_towards(&self, direction: Vec3<S::Lanes>) -> S::Lanes {
        match self.group.is_smooth {
            false => self.probability(),
            true => {
                let leaves = S::Lanes::mask_from_bits(self.group.leave_surface(direction));
                select(leaves, self.probability(), S::Lanes::ZERO)
            }
        }
    }

    /// The normals about which a diffuse surface scatters.
    pub fn normal(&self) -> Vec3<S::Lanes> {
        self.group.scattering_surface(S::Lanes::ONE).normal
    }
}
