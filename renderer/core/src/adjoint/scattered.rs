//! The chain rule along the paths that light takes where it takes all.
//!
//! From the camera outwards, the cotangent of what leaves a vertex goes to its material, to lights and
//! emitters, and to the radiance beyond. Of surface points only texture coordinates and normals that maps bend
//! have cotangents: nothing that moves the points has a gradient here.

use ad::{Additive, Tangent, Vec3};
use glam::DVec3;

use super::chain::{AdjointState, Chain, SurfaceCotangent, nonzero_lanes};
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::primal::coalesce::select_lanes;
use crate::primal::image::add_radiance;
use crate::primal::integrator::{Integrator, ZeroWeight};
use crate::primal::path::Path;
use crate::primal::scattered::{EmitterSample, EmitterSource, Event, SkyLight, missed};
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::{RayLanes, Wavefront, clear_blocks, samples};
use crate::trace::bvh::PACKET_RAYS;
use crate::trace::tile::Tile;
use crate::transport::dielectric::sent_on_by_dielectric;
use crate::transport::direct::direct;
use crate::transport::emitter::{found_emission, illuminate_by_emitter};
use crate::transport::environment::{Environment, map_radiance};
use crate::transport::material::{Bsdf, Material};
use crate::transport::scatter::{gathered, sent_on, sent_on_mapped};
use crate::transport::surface::SurfacePoint;

/// About how many bytes the paths take that a thread keeps; more, where materials of many kinds split groups.
const KEPT_BYTES: usize = 16 << 20;

/// By ray.
type Cotangents = [DVec3; PACKET_RAYS];

impl<L: Plain> Chain<'_, L> {
    /// Adds the loss of the pixels of a tile, and what flows back from it.
    pub(super) fn scattered_tile(&mut self, loss: &dyn PixelLoss, tile: &Tile) {
        let mut kept = std::mem::take(&mut self.kept);
        kept.resize_with(self.kept_samples(), Path::default);
        let cotangents = self.scattered_cotangents(loss, tile, &mut kept);
        if cotangents.iter().any(|&cotangent| cotangent != DVec3::ZERO) {
            let sampling = self.integrator.layout.sampling.of_gradient();
            for (index, sample) in samples(tile, sampling).enumerate() {
                let mut path = std::mem::take(kept.get_mut(index).unwrap_or(&mut self.path));
                if index >= kept.len() {
                    self.integrator.trace_path(sample, &mut path);
                }
                self.pull_scattered_path(&path, &cotangents);
                *kept.get_mut(index).unwrap_or(&mut self.path) = path;
            }
        }
        self.kept = kept;
    }

    /// How many samples of a tile have their paths kept, so that they need not be traced again: those that fit
    /// into a bounded memory, unless the gradient has others than the image.
    fn kept_samples(&self) -> usize {
        let Integrator { layout, zero_weight, .. } = &self.integrator;
        let sampling = layout.sampling;
        if *zero_weight != ZeroWeight::default() || sampling.of_gradient() != sampling {
            return 0;
        }
        (KEPT_BYTES / Path::<L>::bytes(self.integrator.depths())).min(sampling.count() as usize)
    }

    /// Adds the loss of the pixels of a tile; the cotangents of the radiance of their samples, the first of
    /// which have their paths kept.
    fn scattered_cotangents(
        &mut self,
        loss: &dyn PixelLoss,
        tile: &Tile,
        kept: &mut [Path<L>],
    ) -> Cotangents {
        let primal = self.integrator.with_zero_weight(ZeroWeight::default());
        let sampling = primal.layout.sampling;
        let mut total = [DVec3::ZERO; PACKET_RAYS];
        for (index, sample) in samples(tile, sampling).enumerate() {
            let path = kept.get_mut(index).unwrap_or(&mut self.path);
            add_radiance(primal, sample, path, &mut total);
        }
        let count = f64::from(sampling.count());
        self.cotangents_of(loss, tile, &total.map(|radiance| radiance / count))
    }

    /// Adds what flows back from one path through each pixel, by the cotangents of its radiance.
    fn pull_scattered_path(&mut self, path: &Path<L>, cotangents: &Cotangents) {
        let mut states = std::mem::take(&mut self.states);
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
        self.states = states;
    }

    /// From the radiance that leaves the vertices of a group to everything that it is made of.
    fn pull_scattered_vertex(
        &mut self,
        vertex: &Vertex<'_, L>,
        cotangent: Vec3<L>,
        to_beyond: Option<&mut Vec3<L>>,
    ) {
        let (own, group) = (vertex.scattered_own(), vertex.group);
        let Event { direction, straight, mirrored, factor } = vertex.event();
        let (of_material, surface) = (vertex.material, vertex.group.surface);
        let gathered = |part: Vec3<L>| {
            let opacity = vertex.material.opacity;
            let (_, pullback) = gathered::vjp::<L>(opacity, own, part, vertex.scattered_beyond());
            pullback(cotangent)
        };
        let (mirrored, straight) = (L::mask(mirrored), L::mask(straight));
        let mut to_surface = Tangent::<SurfacePoint<L>>::zero();
        let (mut material, (opacity, own, _, beyond)) = if group.bsdf == Bsdf::Dielectric {
            let inside = L::mask(group.inside);
            let (part, pullback) =
                sent_on_by_dielectric::vjp::<L>(of_material, surface, inside, mirrored, factor);
            let gathered = gathered(part);
            (pullback(gathered.2).0, gathered)
        } else if group.mapped.is_some() {
            let (part, pullback) = sent_on_mapped::vjp::<L>(
                of_material,
                vertex.lobes,
                surface,
                direction,
                straight,
                mirrored,
                factor,
            );
            let gathered = gathered(part);
            let (material, _, surface, ..) = pullback(gathered.2);
            to_surface.accumulate(surface);
            (material, gathered)
        } else {
            let (part, pullback) = sent_on::vjp::<L>(
                of_material,
                vertex.lobes,
                surface,
                direction,
                straight,
                mirrored,
                factor,
            );
            let gathered = gathered(part);
            (pullback(gathered.2).0, gathered)
        };
        material.opacity.accumulate(opacity);
        if let Some(to_beyond) = to_beyond {
            to_beyond.accumulate(beyond);
        }
        let scattering = &vertex.wavefront().scattering;
        if vertex.looks_for_light() {
            for (light, inputs) in vertex.lights().iter().enumerate() {
                let to = (&mut material, &mut to_surface);
                self.pull_light(vertex.group.index, vertex, light, inputs, own, to);
            }
        }
        for sample in scattering.emitters_of(vertex.group.index) {
            self.pull_emitter(vertex, sample, own, &mut material, &mut to_surface);
        }
        let weight = scattering.found[vertex.group.block()];
        let (_, pullback) = found_emission::vjp::<L>(vertex.material.emission, weight);
        let (emitted, _) = pullback(own);
        let mut shaded = None;
        self.pull_material(
            vertex,
            emitted,
            None,
            &mut material,
            &mut to_surface,
            Some(&mut shaded),
        );
        let Some(SurfaceCotangent { mut surface, mut uv }) = shaded else { return };
        if !self.scatter.request.moves_surfaces() {
            return;
        }
        if let Some(mapped) = &group.mapped {
            let (_, of_normal) = self.pull_mapped_normal(group, mapped, &mut surface);
            uv.get_or_insert_with(Additive::zero).accumulate(of_normal);
        }
        let primitive = self.integrator.primitive(group.kind, &group.primitives);
        if let (Some(uv), Some(primitive)) = (uv, primitive) {
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
        to_surface: &mut Tangent<SurfacePoint<L>>,
    ) {
        let (_, pullback) = direct::vjp::<L>(
            vertex.material,
            vertex.lobes,
            vertex.group.surface,
            sample.illumination,
            L::mask(sample.lanes),
            L::ONE,
        );
        let (material, _, surface, illumination, (), _) = pullback(own);
        to_material.accumulate(material);
        if vertex.group.mapped.is_some() {
            to_surface.accumulate(surface);
        }
        let EmitterSample { emission, weighted, illumination: of, .. } = *sample;
        let (_, pullback) =
            illuminate_by_emitter::vjp::<L>(emission, of.direction, of.distance, weighted);
        let (emission, ..) = pullback(illumination);
        match &sample.source {
            EmitterSource::Surfaces(materials) => {
                let to_emitter = Tangent::<Material<L>> { emission, ..Additive::zero() };
                self.scatter.materials::<L>(materials, &to_emitter);
            }
            EmitterSource::Sky if !self.scatter.request.has_environment() => {}
            EmitterSource::Sky => {
                let light = self.integrator.sky_light(sample.lanes, of.direction);
                self.pull_sky(light, sample.lanes, emission);
            }
        }
    }

    /// From what rays bring that meet nothing to the environment.
    fn pull_missed(
        &mut self,
        wavefront: &Wavefront<L>,
        cotangent: impl Fn(RayLanes) -> Option<Vec3<L>>,
    ) {
        if !self.scatter.request.has_environment() {
            return;
        }
        for lanes in missed::<L>(wavefront) {
            let Some((light, weight)) = self.integrator.missed_light(wavefront, lanes) else {
                continue;
            };
            if let Some(cotangent) = cotangent(lanes) {
                let (_, pullback) = found_emission::vjp::<L>(light.radiance(), weight);
                let (radiance, _) = pullback(cotangent);
                self.pull_sky(Some(light), lanes.alive, radiance);
            }
        }
    }

    /// From what the environment brings in some lanes to its numbers and texels.
    fn pull_sky(&mut self, light: Option<SkyLight<L>>, lanes: u32, radiance: Vec3<L>) {
        let Some(SkyLight { environment, direction, lookup }) = light else { return };
        let to_environment = match lookup {
            None => Tangent::<Environment<L>> { radiance, ..Additive::zero() },
            Some(lookup) => {
                let (_, pullback) =
                    map_radiance::vjp::<L>(environment, lookup.footprint, direction);
                let (environment, footprint, _) = pullback(radiance);
                self.scatter_texels(&lookup, lanes, footprint.texels);
                environment
            }
        };
        if let Some(to) = self.scatter.request.environment {
            self.scatter.dense::<L, _>(to, lanes, &to_environment);
        }
    }
}
