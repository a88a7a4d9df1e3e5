//! The chain rule along the paths that light takes where it takes all.
//!
//! From the camera outwards, the cotangent of what leaves a vertex goes to its material and surface point, to
//! lights and emitters, and to the radiance beyond; then back, from the surface points to primitives and rays.
//! Directions that were scattered stay, as the path moves; mirrored, refracted and straight ones follow.

use ad::{Additive, Tangent, Vec3};
use glam::DVec3;

use super::chain::{
    AdjointState, Chain, Cotangents, SampleCotangents, SurfaceCotangent, nonzero_lanes, push,
};
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::primal::coalesce::select_lanes;
use crate::primal::emission::VariedEmission;
use crate::primal::image::{Weight, weigh};
use crate::primal::integrator::{Integrator, ZeroWeight};
use crate::primal::path::Path;
use crate::primal::scattered::{
    Chosen, EmitterPoints, EmitterSample, EmitterSource, Event, Facets, SkyLight, missed,
};
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::{LaneGroup, RayLanes, Source, Wavefront, clear_blocks, samples};
use crate::trace::tile::Tile;
use crate::transport::camera::{CameraFrame, Ray, film_point};
use crate::transport::dielectric::{refracted_direction, sent_on_by_dielectric};
use crate::transport::direct::direct;
use crate::transport::emitter::{
    Sight, cosine_density, emitter_spread, found_emission, found_spread, illuminate_by_emitter,
    seen_emission, sight_of, uv_of_sight,
};
use crate::transport::environment::{Environment, map_radiance};
use crate::transport::material::{Bsdf, Material};
use crate::transport::microfacet::scattered_density;
use crate::transport::scatter::{gathered, sent_on};
use crate::transport::smooth::SmoothPoint;
use crate::transport::surface::SurfacePoint;

/// About how many bytes the paths take that a thread keeps; more, where materials of many kinds split groups.
const KEPT_BYTES: usize = 16 << 20;

impl<L: Plain> Chain<'_, L> {
    /// Adds the loss of the pixels of a tile, and what flows back from it; returns the cotangents of the radiance
    /// of each of their samples, by that of all. `weight` tells how much the derivative of a sample
    /// counts, if not all count the same.
    pub(super) fn scattered_tile(
        &mut self,
        loss: &dyn PixelLoss,
        tile: &Tile,
        weight: Option<&Weight<'_>>,
    ) -> Cotangents {
        let mut kept = std::mem::take(&mut self.kept);
        kept.resize_with(self.kept_samples(), Path::default);
        let SampleCotangents { of_all, of_parts } = self.cotangents(loss, tile, &mut kept);
        let mut kept_paths = kept.iter();
        for (part, cotangents) in self.integrator.layout.sampling.parts().zip(&of_parts) {
            let is_zero = cotangents.iter().all(|&cotangent| cotangent == DVec3::ZERO);
            for sample in samples(tile, part) {
                let kept = kept_paths.next();
                if is_zero {
                    continue;
                }
                let weighted = |path: &Path<L>| {
                    let mut weighted = *cotangents;
                    weigh(&mut weighted, weight, tile, path);
                    weighted
                };
                if let Some(path) = kept {
                    self.pull_scattered_path(path, &weighted(path));
                    continue;
                }
                self.pull_scattered(sample, weighted);
            }
        }
        self.kept = kept;
        of_all
    }

    /// Traces paths, and adds what flows back from them, by the cotangents that are found for them.
    pub(super) fn pull_scattered(
        &mut self,
        source: Source<'_>,
        cotangents: impl FnOnce(&Path<L>) -> Cotangents,
    ) {
        let mut path = std::mem::take(&mut self.path);
        self.integrator.trace_path(source, &mut path);
        self.pull_scattered_path(&path, &cotangents(&path));
        self.path = path;
    }

    /// How many samples of a tile have their paths kept, so that they need not be traced again: those that fit
    /// into a bounded memory, unless the gradient has other paths than the image.
    fn kept_samples(&self) -> usize {
        let Integrator { layout, zero_weight, .. } = &self.integrator;
        if *zero_weight != ZeroWeight::default() {
            return 0;
        }
        let fits = KEPT_BYTES / Path::<L>::bytes(self.integrator.depths());
        fits.min(layout.sampling.count() as usize)
    }

    /// Adds what flows back from one path through each pixel, by the cotangents of its radiance.
    fn pull_scattered_path(&mut self, path: &Path<L>, cotangents: &Cotangents) {
        let mut states = std::mem::take(&mut self.states);
        let wavefronts = path.wavefronts();
        states.resize_with(wavefronts.len().max(states.len()), AdjointState::default);
        states[0].rays.clear();
        for depth in 0..wavefronts.len() {
            let (states, deeper) = states.split_at_mut(depth + 1);
            let beyond = wavefronts.get(depth + 1);
            let wavefront = &wavefronts[depth];
            let AdjointState { surfaces, radiance, rays, .. } = &mut states[depth];
            if let Some(packing) = &wavefront.scattering.packing {
                packing.pack_blocks::<L, _>(radiance);
            }
            let mut to_beyond = match (beyond, deeper.first_mut()) {
                (Some(_), Some(state)) => {
                    clear_blocks::<L, _>(&mut state.radiance);
                    clear_blocks::<L, _>(&mut state.rays);
                    Some(&mut state.radiance)
                }
                _ => None,
            };
            let of_rays = |lanes: RayLanes| match depth {
                0 => nonzero_lanes::<L>(lanes.rays().map(|(lane, ray)| (lane, cotangents[ray]))),
                _ => {
                    let zero = Vec3::<L>::zero();
                    Some(select_lanes::<L, _>(lanes.alive, &radiance[lanes.block::<L>()], &zero))
                }
            };
            surfaces.clear();
            for group in &wavefront.groups {
                let to_surface = push(surfaces);
                let Some(cotangent) = of_rays(group.lanes()) else { continue };
                let vertex = self.integrator.vertex(group, wavefront, beyond);
                let to_beyond = to_beyond.as_mut().map(|blocks| &mut blocks[group.block()]);
                self.pull_scattered_vertex(&vertex, cotangent, to_beyond, to_surface);
            }
            self.pull_missed(wavefront, of_rays, rays);
        }
        if self.scatter.request.moves_surfaces() {
            self.pull_rays(wavefronts, &mut states);
        }
        self.states = states;
    }

    /// From the radiance that leaves the vertices of a group to everything that it is made of.
    fn pull_scattered_vertex(
        &mut self,
        vertex: &Vertex<'_, L>,
        cotangent: Vec3<L>,
        to_beyond: Option<&mut Vec3<L>>,
        to_surface: &mut Option<SurfaceCotangent<L>>,
    ) {
        let (own, group) = (vertex.scattered_own(), vertex.group);
        let Event { direction, straight, mirrored, factor } = vertex.event();
        let (of_material, of_surface) = (vertex.material, vertex.group.surface);
        let gathered = |part: Vec3<L>| {
            let opacity = vertex.material.opacity;
            let (_, pullback) = gathered::vjp::<L>(opacity, own, part, vertex.scattered_beyond());
            pullback(cotangent)
        };
        let (mirrored, straight) = (L::mask(mirrored), L::mask(straight));
        let ((mut material, mut surface), (opacity, own, _, beyond)) = match group.bsdf {
            Bsdf::Dielectric => {
                let inside = L::mask(group.inside);
                let (part, pullback) = sent_on_by_dielectric::vjp::<L>(
                    of_material,
                    of_surface,
                    inside,
                    mirrored,
                    factor,
                );
                let gathered = gathered(part);
                let (material, surface, ..) = pullback(gathered.2);
                ((material, surface), gathered)
            }
            Bsdf::BlinnPhong | Bsdf::MetallicRoughness => {
                let (part, pullback) = sent_on::vjp::<L>(
                    of_material,
                    vertex.lobes,
                    of_surface,
                    direction,
                    straight,
                    mirrored,
                    factor,
                );
                let gathered = gathered(part);
                let (material, _, surface, ..) = pullback(gathered.2);
                ((material, surface), gathered)
            }
        };
        material.opacity.accumulate(opacity);
        if let Some(to_beyond) = to_beyond {
            to_beyond.accumulate(beyond);
        }
        let scattering = &vertex.wavefront().scattering;
        if vertex.looks_for_light() {
            for (light, inputs) in vertex.lights().iter().enumerate() {
                let to = (&mut material, &mut surface);
                self.pull_light(vertex, light, inputs, own, to);
            }
        }
        for sample in scattering.emitters_of(vertex.group.index) {
            self.pull_emitter(vertex, sample, own, &mut material, &mut surface);
        }
        let weight = scattering.found[vertex.group.block()];
        let (_, pullback) = found_emission::vjp::<L>(vertex.material.emission, weight);
        let (emitted, _) = pullback(own);
        let to_surface = self.scatter.request.moves_surfaces().then_some(to_surface);
        self.pull_material(vertex, emitted, None, &mut material, &mut surface, to_surface);
    }

    /// From what the surfaces reflect of emitters that were looked for to both materials and places.
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
        to_surface.accumulate(surface);
        let EmitterSample { emission, weighted, illumination: of, .. } = *sample;
        let (_, pullback) =
            illuminate_by_emitter::vjp::<L>(emission, of.direction, of.distance, weighted);
        let (emission, mut direction, mut distance, weighted) = pullback(illumination);
        match &sample.source {
            EmitterSource::Surfaces(points) => {
                let (from, seen) = (vertex.group.surface.point, (of.direction, of.distance));
                let of_uv = self.pull_emission(points, from, seen, emission);
                if self.scatter.request.moves_surfaces() {
                    let (of_direction, of_distance, of_point) = of_uv;
                    direction.accumulate(of_direction);
                    distance.accumulate(of_distance);
                    to_surface.point.accumulate(of_point);
                    let cotangents = (direction, distance, weighted);
                    to_surface.point.accumulate(self.pull_sight(vertex, points, cotangents));
                }
            }
            EmitterSource::Sky if !self.scatter.request.has_environment() => {}
            EmitterSource::Sky => {
                let light = self.integrator.sky_light(sample.lanes, of.direction);
                self.pull_sky(light, sample.lanes, emission);
            }
        }
    }

    /// From the radiance of points that shine to their materials and textures, and where texture coordinates move, to
    /// these; returns the cotangents of the directions and distances in which the points are seen, and of where they are
    /// seen from.
    fn pull_emission(
        &mut self,
        points: &EmitterPoints<L>,
        from: Vec3<L>,
        (direction, distance): (Vec3<L>, L),
        emission: Vec3<L>,
    ) -> (Vec3<L>, L, Vec3<L>) {
        let EmitterPoints { kind, primitives, at, .. } = points;
        let varied = self.integrator.varied_emission(points, from, (direction, distance));
        let Some(VariedEmission { materials, material, textured }) = varied else {
            let to_material = Tangent::<Material<L>> { emission, ..Additive::zero() };
            let materials = self.integrator.materials(primitives);
            self.scatter.materials::<L>(&materials, &to_material);
            return Additive::zero();
        };
        let (_, pullback) = seen_emission::vjp::<L>(material.emission, material.opacity);
        let (emission, opacity) = pullback(emission);
        let mut to_material = Tangent::<Material<L>> { emission, opacity, ..Additive::zero() };
        let uv = textured.map(|textured| self.pull_textures(&textured, &mut to_material));
        self.scatter.materials::<L>(&materials, &to_material);
        let primitive = self.integrator.primitive(*kind, primitives);
        let (Some(uv), Some(primitive), true) =
            (uv, primitive, self.scatter.request.moves_surfaces())
        else {
            return Additive::zero();
        };
        let corners = self.integrator.corner_uvs(*kind, primitives);
        let (_, pullback) =
            uv_of_sight::vjp::<L>(primitive, corners, *at, direction, distance, from);
        let (primitive, corners, _, direction, distance, from) = pullback(uv);
        self.scatter_uvs(*kind, primitives, corners);
        self.scatter_primitive(*kind, primitives, &primitive);
        (direction, distance, from)
    }

    /// From the directions and distances of points that shine, and what their directions count for, to the
    /// surfaces of these points; returns the cotangents of the points that they were looked for from.
    fn pull_sight(
        &mut self,
        vertex: &Vertex<'_, L>,
        points: &EmitterPoints<L>,
        (mut direction, distance, weighted): (Vec3<L>, L, L),
    ) -> Vec3<L> {
        let from = vertex.group.surface.point;
        let Some(sight) = self.integrator.sight(points, from) else { return Additive::zero() };
        let scatterer = self.integrator.scatterer(vertex);
        let density = scatterer.density(sight.direction);
        let (spread, density) = match points.chosen {
            Chosen::LookedFor => {
                let (_, pullback) = emitter_spread::vjp::<L>(sight.spread, density);
                pullback(weighted)
            }
            Chosen::Scattered { spread, factor } => {
                let (_, pullback) = found_spread::vjp::<L>(sight.spread, density, spread, factor);
                let (spread, density, ..) = pullback(weighted);
                (spread, density)
            }
        };
        let probability = scatterer.probability_towards(sight.direction);
        direction.accumulate(match scatterer.facets {
            None => {
                let normal = scatterer.normal();
                let (_, pullback) = cosine_density::vjp::<L>(normal, probability, sight.direction);
                pullback(density).2
            }
            Some(Facets { surface, sampling }) => {
                let (_, pullback) = scattered_density::vjp::<L>(sampling, surface, sight.direction);
                pullback(density * probability).2
            }
        });
        self.pull_sight_of(points, from, Tangent::<Sight<L>> { direction, distance, spread })
    }

    /// From how points of surfaces are seen that shine to these surfaces; returns the cotangents of the points that
    /// see them.
    pub(super) fn pull_sight_of(
        &mut self,
        points: &EmitterPoints<L>,
        from: Vec3<L>,
        cotangent: Tangent<Sight<L>>,
    ) -> Vec3<L> {
        let &EmitterPoints { kind, inside, choices, at, .. } = points;
        let Some(primitive) = self.integrator.primitive(kind, &points.primitives) else {
            return Additive::zero();
        };
        let (_, pullback) = sight_of::vjp::<L>(primitive, L::mask(inside), at, choices, from);
        let (to_primitive, (), _, _, point) = pullback(cotangent);
        self.scatter_primitive(kind, &points.primitives, &to_primitive);
        point
    }

    /// From the rays that go on from a group to its surface points, and to the normals of flat triangles
    /// where these are smooth or mapped.
    pub(super) fn pull_event(
        &mut self,
        group: &LaneGroup<L>,
        wavefront: &Wavefront<L>,
        ray: &Tangent<Ray<L>>,
    ) -> Tangent<SmoothPoint<L>> {
        let Some(event) = wavefront.scattering.events.get(group.block()) else {
            return Additive::zero();
        };
        let (straight, refracted) = match group.bsdf {
            Bsdf::Dielectric => (0, event.straight & group.alive),
            Bsdf::BlinnPhong | Bsdf::MetallicRoughness => (event.straight, 0),
        };
        let in_lanes = |lanes: u32| select_lanes::<L, _>(lanes, &ray.direction, &Vec3::<L>::zero());
        let followed = Tangent::<Ray<L>> {
            origin: ray.origin,
            direction: in_lanes(straight | event.mirrored),
        };
        let mut point = self.pull_next_ray(group, &followed, L::mask(straight));
        if refracted != 0 {
            let vertex = self.integrator.vertex(group, wavefront, None);
            let inside = L::mask(group.inside);
            let (_, pullback) =
                refracted_direction::vjp::<L>(vertex.material, group.surface, inside);
            let (material, surface, ()) = pullback(in_lanes(refracted));
            point.surface.accumulate(surface);
            if !self.scatter.request.materials.is_empty() {
                self.scatter.materials::<L>(&vertex.materials, &material);
            }
        }
        point
    }

    /// From what rays bring that meet nothing to the environment and to the rays: those of the camera go
    /// back to it.
    fn pull_missed(
        &mut self,
        wavefront: &Wavefront<L>,
        cotangent: impl Fn(RayLanes) -> Option<Vec3<L>>,
        rays: &mut [Tangent<Ray<L>>],
    ) {
        let request = self.scatter.request;
        if !request.has_environment() && !request.moves_surfaces() {
            return;
        }
        let mut to_frame = Tangent::<CameraFrame<L>>::zero();
        for lanes in missed::<L>(wavefront) {
            let Some((light, weight)) = self.integrator.missed_light(wavefront, lanes) else {
                continue;
            };
            let Some(cotangent) = cotangent(lanes) else { continue };
            let (_, pullback) = found_emission::vjp::<L>(light.radiance(), weight);
            let (radiance, _) = pullback(cotangent);
            let direction = self.pull_sky(Some(light), lanes.alive, radiance);
            match (rays.get_mut(lanes.block::<L>()), wavefront.film.get(lanes.block::<L>())) {
                (Some(ray), _) => ray.direction.accumulate(direction),
                (None, Some(&(x, y))) if request.camera => {
                    let frame = self.integrator.inputs.frame;
                    let (_, pullback) = film_point::vjp::<L>(frame, x, y);
                    to_frame.accumulate(pullback(direction).0);
                }
                (None, _) => {}
            }
        }
        if request.camera {
            self.scatter.frame::<L>(&to_frame);
        }
    }

    /// From what the environment brings in some lanes to its numbers and texels; returns the cotangents of
    /// the directions.
    fn pull_sky(&mut self, light: Option<SkyLight<L>>, lanes: u32, radiance: Vec3<L>) -> Vec3<L> {
        let Some(SkyLight { environment, direction, lookup }) = light else {
            return Additive::zero();
        };
        let (to_environment, direction) = match lookup {
            None => (Tangent::<Environment<L>> { radiance, ..Additive::zero() }, Additive::zero()),
            Some(lookup) => {
                let (_, pullback) =
                    map_radiance::vjp::<L>(environment, lookup.footprint, direction);
                let (environment, footprint, direction) = pullback(radiance);
                self.scatter_texels(&lookup, lanes, footprint.texels);
                (environment, direction)
            }
        };
        if let Some(to) = self.scatter.request.environment {
            self.scatter.dense::<L, _>(to, lanes, &to_environment);
        }
        direction
    }
}
