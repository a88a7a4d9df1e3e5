//! The chain rule along the paths that light takes where it takes all.
//!
//! From the camera outwards, the cotangent of what leaves a vertex goes to its material, to lights and
//! emitters, and to the radiance beyond. Of surface points only texture coordinates have cotangents:
//! nothing that moves the points has a gradient here.

use ad::{Additive, Tangent, Vec3};
use glam::DVec3;

use super::chain::{AdjointState, Chain, SurfaceCotangent, nonzero_lanes};
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::primal::coalesce::select_lanes;
use crate::primal::scattered::{EmitterSample, Event, missed};
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::{RayLanes, Source, Wavefront, clear_blocks, samples};
use crate::trace::bvh::PACKET_RAYS;
use crate::trace::tile::Tile;
use crate::transport::direct::direct;
use crate::transport::emitter::{found_emission, illuminate_by_emitter};
use crate::transport::environment::Environment;
use crate::transport::material::Material;
use crate::transport::scatter::{gathered, sent_on};
use crate::transport::surface::SurfacePoint;

/// By ray.
type Cotangents = [DVec3; PACKET_RAYS];

impl<L: Plain> Chain<'_, L> {
    /// Adds the loss of the pixels of a tile, and what flows back from it.
    pub(super) fn scattered_tile(&mut self, loss: &dyn PixelLoss, tile: &Tile) {
        let cotangents = self.cotangents(loss, tile);
        if cotangents.iter().all(|&cotangent| cotangent == DVec3::ZERO) {
            return;
        }
        for sample in samples(tile, self.integrator.layout.sampling.of_gradient()) {
            self.pull_scattered_sample(sample, &cotangents);
        }
    }

    /// Adds what flows back from one path through each pixel, by the cotangents of its radiance.
    fn pull_scattered_sample(&mut self, source: Source<'_>, cotangents: &Cotangents) {
        let (mut path, mut states) =
            (std::mem::take(&mut self.path), std::mem::take(&mut self.states));
        self.integrator.trace_path(source, &mut path);
        let wavefronts = path.wavefronts();
        states.resize_with(wavefronts.len().max(states.len()), AdjointState::default);
        for depth in 0..wavefronts.len() {
            let (states, deeper) = states.split_at_mut(depth + 1);
            let beyond = wavefronts.get(depth + 1);
            let mut to_beyond = match (beyond, deeper.first_mut()) {
                (Some(_), Some(state)) => {
                    clear_blocks::<L, _>(&mut state.radiance);
                    Some(&mut state.radiance)
                }
                _ => None,
            };
            let radiance = &states[depth].radiance;
            let of_rays = |lanes: RayLanes| match depth {
                0 => nonzero_lanes::<L>(lanes.rays().map(|(lane, ray)| (lane, cotangents[ray]))),
                _ => {
                    let zero = Vec3::<L>::zero();
                    Some(select_lanes::<L, _>(lanes.alive, &radiance[lanes.block::<L>()], &zero))
                }
            };
            let wavefront = &wavefronts[depth];
            for group in &wavefront.groups {
                let Some(cotangent) = of_rays(group.lanes()) else { continue };
                let vertex = self.integrator.vertex(group, wavefront, beyond);
                let to_beyond = to_beyond.as_mut().map(|blocks| &mut blocks[group.block()]);
                self.pull_scattered_vertex(&vertex, cotangent, to_beyond);
            }
            self.pull_missed(wavefront, of_rays);
        }
        (self.path, self.states) = (path, states);
    }

    /// From the radiance that leaves the vertices of a group to everything that it is made of.
    fn pull_scattered_vertex(
        &mut self,
        vertex: &Vertex<'_, L>,
        cotangent: Vec3<L>,
        to_beyond: Option<&mut Vec3<L>>,
    ) {
        let own = vertex.scattered_own();
        let Event { direction, straight, mirrored, factor } = vertex.event();
        let (part, pull_part) = sent_on::vjp::<L>(
            vertex.material,
            vertex.lobes,
            vertex.group.surface,
            direction,
            L::mask(straight),
            L::mask(mirrored),
            factor,
        );
        let opacity = vertex.material.opacity;
        let (_, pullback) = gathered::vjp::<L>(opacity, own, part, vertex.scattered_beyond());
        let (opacity, own, part, beyond) = pullback(cotangent);
        let (mut material, ..) = pull_part(part);
        material.opacity.accumulate(opacity);
        if let Some(to_beyond) = to_beyond {
            to_beyond.accumulate(beyond);
        }
        let mut surface = Tangent::<SurfacePoint<L>>::zero();
        let scattering = &vertex.wavefront().scattering;
        if !scattering.events.is_empty() {
            for (light, inputs) in vertex.lights().iter().enumerate() {
                let to = (&mut material, &mut surface);
                self.pull_light(vertex.group.index, vertex, light, inputs, own, to);
            }
        }
        for sample in scattering.emitters_of(vertex.group.index) {
            self.pull_emitter(vertex, sample, own, &mut material);
        }
        let weight = scattering.found[vertex.group.block()];
        let (_, pullback) = found_emission::vjp::<L>(vertex.material.emission, weight);
        let (emitted, _) = pullback(own);
        let mut to_surface = None;
        self.pull_material(vertex, emitted, None, &mut material, &surface, Some(&mut to_surface));
        let group = vertex.group;
        let primitive = self.integrator.primitive(group.kind, &group.primitives);
        if let (Some(SurfaceCotangent { uv: Some(uv), .. }), Some(primitive)) =
            (to_surface, primitive)
            && self.scatter.request.moves_surfaces()
        {
            let (primitive, _) = self.pull_uv(group, primitive, uv);
            self.scatter_primitive(group.kind, &group.primitives, &primitive);
        }
    }

    /// From what the surfaces reflect of emitters that were looked for to both materials.
    fn pull_emitter(
        &mut self,
        vertex: &Vertex<'_, L>,
        sample: &EmitterSample<L>,
        own: Vec3<L>,
        to_material: &mut Tangent<Material<L>>,
    ) {
        let (_, pullback) = direct::vjp::<L>(
            vertex.material,
            vertex.lobes,
            vertex.group.surface,
            sample.illumination,
            L::mask(sample.lanes),
            L::ONE,
        );
        let (material, _, _, illumination, (), _) = pullback(own);
        to_material.accumulate(material);
        let EmitterSample { emission, weighted, illumination: of, .. } = *sample;
        let (_, pullback) =
            illuminate_by_emitter::vjp::<L>(emission, of.direction, of.distance, weighted);
        let (emission, ..) = pullback(illumination);
        let to_emitter = Tangent::<Material<L>> { emission, ..Additive::zero() };
        self.scatter.materials::<L>(&sample.materials, &to_emitter);
    }

    /// From what rays bring that meet nothing to the environment.
    fn pull_missed(
        &mut self,
        wavefront: &Wavefront<L>,
        cotangent: impl Fn(RayLanes) -> Option<Vec3<L>>,
    ) {
        let Some(to) = self.scatter.request.environment else { return };
        for lanes in missed::<L>(wavefront) {
            if let Some(radiance) = cotangent(lanes) {
                let environment = Environment::<L> { radiance };
                self.scatter.dense::<L, _>(to, lanes.alive, &environment);
            }
        }
    }
}
