//! The chain rule along paths: a path that was traced is walked backwards through generated pullbacks.
//!
//! Radiance comes from where a ray goes on, so its cotangents flow from the camera outwards; rays come
//! from the camera, so theirs flow back. Each tile is therefore walked twice: first outwards, from the
//! radiance of each wavefront to materials, lights, surface points and the radiance beyond; then back,
//! from the [surface points](super::surfaces) to primitives and rays.

use ad::vector::{Vector, Vector3};
use ad::{Additive, Tangent, Vec3};
use glam::DVec3;

use super::request::Request;
use super::scatter::{Scatter, Sums};
use crate::counts::count;
use crate::loss::{PixelLoss, PixelRadiance};
use crate::number::{MAX_LANES, Plain};
use crate::primal::coalesce::{Coalesced, select_lanes};
use crate::primal::gather::Lookup;
use crate::primal::image::add_radiance;
use crate::primal::inputs::LightInputs;
use crate::primal::integrator::{Integrator, ZeroWeight};
use crate::primal::lanes::{lanes_of_vectors, vectors_of_lanes};
use crate::primal::path::Path;
use crate::primal::vertex::{Textured, Vertex};
use crate::primal::wavefront::{LaneGroup, Source, Wavefront, clear_blocks, samples};
use crate::scene::{Scene, Slot};
use crate::settings::Pass;
use crate::trace::bvh::{PACKET_RAYS, rays};
use crate::trace::tile::{Tile, for_each_strip};
use crate::transport::camera::Ray;
use crate::transport::depth::depth;
use crate::transport::direct::direct;
use crate::transport::illumination::Illumination;
use crate::transport::material::Material;
use crate::transport::surface::SurfacePoint;
use crate::transport::texture::{Uv, modulate, modulate_facets, modulate_opacity};
use crate::transport::vertex::outgoing;

/// The sums of each strip of the image.
pub fn sweep<L: Plain>(
    integrator: Integrator<'_, L>,
    scene: &Scene,
    loss: &dyn PixelLoss,
    request: &Request,
) -> Vec<Sums> {
    let (width, height) = (integrator.layout.width, integrator.layout.height);
    let integrator = integrator.with_zero_weight(request.zero_weight);
    for_each_strip(
        width,
        height,
        || Chain::new(integrator, scene, request),
        |chain, strip| {
            strip.tiles().for_each(|tile| chain.tile(loss, &tile));
            chain.scatter.take()
        },
    )
}

/// The work on strips that follow each other on a thread.
pub(super) struct Chain<'a, L: Plain> {
    pub integrator: Integrator<'a, L>,
    pub scene: &'a Scene,
    pub path: Path<L>,
    /// Where light takes all paths: those of the samples of a tile that are kept.
    pub kept: Vec<Path<L>>,
    /// The adjoint state of each wavefront, by depth.
    pub states: Vec<AdjointState<L>>,
    pub scatter: Scatter<'a>,
}

/// By ray.
pub(super) type Cotangents = [DVec3; PACKET_RAYS];

/// The cotangents of the radiance of each sample of the pixels of a tile.
pub(super) struct SampleCotangents {
    /// By the radiance of all samples.
    pub of_all: Cotangents,
    /// Those of the samples of each [part](crate::trace::sampling::Sampling::parts): by the radiance of the other one,
    /// if there are two.
    pub of_parts: [Cotangents; 2],
}

impl Default for SampleCotangents {
    fn default() -> Self {
        let zero = [DVec3::ZERO; PACKET_RAYS];
        Self { of_all: zero, of_parts: [zero; 2] }
    }
}

/// The cotangents of the surface points of a group.
#[derive(Clone, Copy)]
pub(super) struct SurfaceCotangent<L: Plain> {
    pub surface: Tangent<SurfacePoint<L>>,
    /// The cotangents of the texture coordinates of the points, if they have any.
    pub uv: Option<Tangent<Uv<L>>>,
}

/// What flows back to a wavefront.
pub(super) struct AdjointState<L: Plain> {
    /// By group: the cotangents of the surface points, unless they are zero.
    pub surfaces: Vec<Option<SurfaceCotangent<L>>>,
    /// By block, first of the wavefront before: the cotangents of the radiance that rays bring which go on.
    pub radiance: Vec<Vec3<L>>,
    /// By block: the cotangents of the rays that go on.
    pub rays: Vec<Tangent<Ray<L>>>,
    /// A bit for each ray that grazes what it meets: its surface point has no derivative.
    pub grazing: u64,
}

impl<L: Plain> Default for AdjointState<L> {
    fn default() -> Self {
        Self { surfaces: Vec::new(), radiance: Vec::new(), rays: Vec::new(), grazing: 0 }
    }
}

/// From the radiance of a group to its cotangent, unless that is zero.
pub(super) type Respond<'a, L> = dyn FnMut(&LaneGroup<L>, Vec3<L>) -> Option<Vec3<L>> + 'a;

impl<'a, L: Plain> Chain<'a, L> {
    pub(super) fn new(
        integrator: Integrator<'a, L>,
        scene: &'a Scene,
        request: &'a Request,
    ) -> Self {
        let scatter = Scatter::new(request);
        Self {
            integrator,
            scene,
            path: Path::default(),
            kept: Vec::new(),
            states: Vec::new(),
            scatter,
        }
    }

    fn tile(&mut self, loss: &dyn PixelLoss, tile: &Tile) {
        if self.integrator.layout.path_tracing.is_some() {
            self.scattered_tile(loss, tile, None);
            return;
        }
        let sampling = self.integrator.layout.sampling;
        if sampling.count() == 1 {
            // The radiance of the ray is that of the pixel: one pass is enough.
            for sample in samples(tile, sampling) {
                let mut sum = 0.0;
                self.sample(sample, &mut |group, radiance| {
                    let (value, cotangent) = respond(loss, tile, group, radiance);
                    sum += value;
                    cotangent
                });
                let missed = self.path.wavefronts()[0].missed;
                self.scatter.sums.loss += sum + loss_of_black(loss, tile, missed);
            }
        } else {
            let cotangents = self.cotangents(loss, tile, &mut []);
            // In direct light noise is that of edges and fine textures: the second half alone is enough, twice.
            let (last, of_last) = match sampling.parts().nth(1) {
                None => (sampling, cotangents.of_parts[0]),
                Some(second) => (second, cotangents.of_parts[1].map(|cotangent| 2.0 * cotangent)),
            };
            for sample in samples(tile, last) {
                self.pull_sample(sample, &of_last);
            }
        }
    }

    /// Adds the loss of the pixels of a tile, the first of whose samples have their paths kept; the cotangents of the
    /// radiance of the samples.
    pub(super) fn cotangents(
        &mut self,
        loss: &dyn PixelLoss,
        tile: &Tile,
        kept: &mut [Path<L>],
    ) -> SampleCotangents {
        let primal = self.integrator.with_zero_weight(ZeroWeight::default());
        let sampling = primal.layout.sampling;
        let mut sums = [[DVec3::ZERO; PACKET_RAYS]; 2];
        let mut kept = kept.iter_mut();
        for (sum, part) in sums.iter_mut().zip(sampling.parts()) {
            for sample in samples(tile, part) {
                let path = kept.next().unwrap_or(&mut self.path);
                add_radiance(primal, sample, path, sum);
            }
        }
        let counts: Vec<f64> = sampling.parts().map(|part| part.count().into()).collect();
        let count: f64 = counts.iter().sum();
        let mut cotangents = SampleCotangents::default();
        for ray in rays(tile.rays()) {
            let (x, y) = tile.pixel(ray);
            let cotangent = |radiance| {
                let (value, derivative) = loss.evaluate(x, y, radiance);
                (value, derivative / count)
            };
            let (value, of_all) = cotangent((sums[0][ray] + sums[1][ray]) / count);
            self.scatter.sums.loss += value;
            cotangents.of_all[ray] = of_all;
            let [first, second] = &mut cotangents.of_parts;
            (first[ray], second[ray]) = match counts[..] {
                [of_first, of_second] => {
                    (cotangent(sums[1][ray] / of_second).1, cotangent(sums[0][ray] / of_first).1)
                }
                _ => (of_all, of_all),
            };
        }
        cotangents
    }

    /// Adds what flows back from one sample of the pixels of a tile, by the cotangents of its radiance.
    pub(super) fn pull_sample(&mut self, source: Source<'_>, cotangents: &Cotangents) {
        self.sample(source, &mut |group, _| {
            nonzero_lanes::<L>(group.rays().map(|(lane, ray)| (lane, cotangents[ray])))
        });
    }

    /// Adds what flows back from the rays of a packet. `respond` gives the cotangent of the radiance of a
    /// group, unless it is zero.
    fn sample(&mut self, source: Source<'_>, respond: &mut Respond<'_, L>) {
        let (mut path, mut states) =
            (std::mem::take(&mut self.path), std::mem::take(&mut self.states));
        self.integrator.trace_path(source, &mut path);
        let wavefronts = path.wavefronts();
        self.pull_path(wavefronts, &mut states, respond);
        if self.scatter.request.moves_surfaces() {
            self.pull_rays(wavefronts, &mut states);
        }
        (self.path, self.states) = (path, states);
    }

    /// From the radiance of the camera rays to everything that it is made of but rays: to surface
    /// points.
    pub(super) fn pull_path(
        &mut self,
        wavefronts: &[Wavefront<L>],
        states: &mut Vec<AdjointState<L>>,
        respond: &mut Respond<'_, L>,
    ) {
        let request = self.scatter.request;
        states.resize_with(wavefronts.len().max(states.len()), AdjointState::default);

        let few_vertices = wavefronts.len() == 1
            && request.is_few_vertices()
            && !self.integrator.layout.has_transparency;
        for depth in 0..wavefronts.len() {
            let (states, deeper) = states.split_at_mut(depth + 1);
            let AdjointState { radiance, surfaces, .. } = &mut states[depth];
            let beyond = wavefronts.get(depth + 1).zip(deeper.first_mut());
            if depth > 0 {
                self.pull_radiance(&wavefronts[depth], beyond, surfaces, &mut |group, _| {
                    let zero = Vec3::<L>::splat(L::ZERO);
                    Some(select_lanes::<L, _>(group.alive, &radiance[group.block()], &zero))
                });
            } else if few_vertices {
                let layout = self.integrator.layout;
                self.pull_radiance(&wavefronts[0], beyond, surfaces, &mut |group, radiance| {
                    let triangles = group.primitives.iter();
                    let mut corners =
                        triangles.filter_map(|(index, _)| layout.triangles.get(index));
                    let is_requested =
                        |&vertex: &u32| request.vertices.slot(vertex as usize).is_some();
                    let cotangent = respond(group, radiance);
                    cotangent.filter(|_| corners.any(|corners| corners.iter().any(is_requested)))
                });
            } else {
                self.pull_radiance(&wavefronts[0], beyond, surfaces, respond);
            }
        }
    }

    /// From the radiance of a wavefront, whose cotangents `respond` gives, to its materials and lights,
    /// to its surface points, and to the radiance of the rays that go on.
    #[inline]
    fn pull_radiance(
        &mut self,
        wavefront: &Wavefront<L>,
        beyond: Option<(&Wavefront<L>, &mut AdjointState<L>)>,
        surfaces: &mut Vec<Option<SurfaceCotangent<L>>>,
        respond: &mut Respond<'_, L>,
    ) {
        let (beyond, mut state) = beyond.unzip();
        if let Some(state) = &mut state {
            clear_blocks::<L, _>(&mut state.radiance);
            clear_blocks::<L, _>(&mut state.rays);
        }
        let moves_surfaces = self.scatter.request.moves_surfaces();
        surfaces.clear();
        for group in &wavefront.groups {
            let vertex = self.integrator.vertex(group, wavefront, beyond);
            let mut radiance = state.as_mut().map(|state| &mut state.radiance[group.block()]);
            let to_surface = moves_surfaces.then(|| push(surfaces));
            self.pull_vertex(&vertex, respond, &mut radiance, to_surface);
        }
    }

    /// From the radiance of the path vertices of a group to everything that it is made of.
    ///
    /// Of the last light, mostly the only one, the residuals of the pullback are kept while `respond` is
    /// asked; those of the others are computed afterwards, because there is no saying how many there
    /// are.
    #[inline(always)]
    fn pull_vertex(
        &mut self,
        vertex: &Vertex<'_, L>,
        respond: &mut Respond<'_, L>,
        beyond: &mut Option<&mut Vec3<L>>,
        to_surface: Option<&mut Option<SurfaceCotangent<L>>>,
    ) {
        let (surface, lights) = (vertex.group.surface, vertex.lights());
        match lights.split_last() {
            Some((last, others)) if vertex.transmittance(others.len()).is_none() => {
                let light = last.illuminate(surface.point);
                let visible = vertex.visible(others.len());
                let (reflected, pullback) = direct::vjp::<L>(
                    vertex.material,
                    vertex.lobes,
                    surface,
                    light,
                    visible,
                    L::ONE,
                );
                let own = vertex.own(others) + reflected;
                let Some(radiance) = respond(vertex.group, vertex.outgoing(own)) else { return };
                let (own, of_outgoing) = pull_outgoing(vertex, own, radiance, beyond);
                // Cotangents are large: they stay where the pullback leaves them.
                let mut cotangents = pullback(own);
                let (material, _, of_surface, illumination, ..) = &mut cotangents;
                let (at, to_point) = ((vertex.group, surface.point), &mut of_surface.point);
                self.pull_illumination(others.len(), last, at, *illumination, to_point);
                for (light, inputs) in others.iter().enumerate() {
                    self.pull_light(vertex, light, inputs, own, (material, of_surface));
                }
                self.pull_material(vertex, own, of_outgoing, material, of_surface, to_surface);
            }
            _ => {
                let own = vertex.own(lights);
                let Some(radiance) = respond(vertex.group, vertex.outgoing(own)) else { return };
                let (own, of_outgoing) = pull_outgoing(vertex, own, radiance, beyond);
                let (mut material, mut surface) = (Additive::zero(), Additive::zero());
                for (light, inputs) in lights.iter().enumerate() {
                    let to = (&mut material, &mut surface);
                    self.pull_light(vertex, light, inputs, own, to);
                }
                let surface = &mut surface;
                self.pull_material(vertex, own, of_outgoing, &mut material, surface, to_surface);
            }
        }
    }

    /// Adds what flows back through the direct light of one light to the cotangents of materials and
    /// surface points.
    pub(super) fn pull_light(
        &mut self,
        vertex: &Vertex<'_, L>,
        index: usize,
        inputs: &LightInputs<L>,
        own: Vec3<L>,
        (to_material, to_surface): (&mut Tangent<Material<L>>, &mut Tangent<SurfacePoint<L>>),
    ) {
        let (surface, left) = (vertex.group.surface, vertex.transmittance(index));
        let light = inputs.illuminate(surface.point);
        let (_, pullback) = direct::vjp::<L>(
            vertex.material,
            vertex.lobes,
            surface,
            light,
            vertex.visible(index),
            left.unwrap_or(L::ONE),
        );
        let (material, _, of_surface, illumination, (), transmittance) = &pullback(own);
        to_material.accumulate(*material);
        to_surface.accumulate(*of_surface);
        let at = (vertex.group, surface.point);
        self.pull_illumination(index, inputs, at, *illumination, &mut to_surface.point);
        let varies =
            self.scatter.request.has_opacities() || self.integrator.layout.has_opacity_textures;
        if left.is_some() && varies {
            let point = self.pull_transmission(vertex, index, *transmittance);
            to_surface.point.accumulate(point);
        }
    }

    /// From the illumination of points, those of a group or where its shadow rays start, to the light and to
    /// the points.
    #[inline]
    pub(super) fn pull_illumination(
        &mut self,
        index: usize,
        light: &LightInputs<L>,
        (group, point): (&LaneGroup<L>, Vec3<L>),
        cotangent: Tangent<Illumination<L>>,
        to_point: &mut Vec3<L>,
    ) {
        let to = self.scatter.request.light(self.integrator.layout.lights[index].object);
        if to.is_none() && !self.scatter.request.moves_surfaces() {
            return;
        }
        if let LightInputs::Shining(shining) = light {
            let (primitive, of_point) = shining.pull_illuminate(point, cotangent);
            to_point.accumulate(of_point);
            let (kind, _) = self.integrator.layout.kind_of(shining.index);
            let primitives = Coalesced::all(shining.index, group.alive);
            return self.scatter_primitive(kind, &primitives, &primitive);
        }
        let scatter = &mut self.scatter;
        let of_point = light.pull_illuminate(point, cotangent, |number, cotangent| {
            if let Some(to) = to {
                scatter.number(to, number, group.alive, cotangent);
            }
        });
        to_point.accumulate(of_point);
    }

    /// From the cotangents of what the surfaces emit, or show of their albedo, and of their materials to
    /// materials and textures.
    #[inline(always)]
    pub(super) fn pull_material(
        &mut self,
        vertex: &Vertex<'_, L>,
        emitted: Vec3<L>,
        of_outgoing: Option<(L, Vec3<L>)>,
        material: &mut Tangent<Material<L>>,
        surface: &mut Tangent<SurfacePoint<L>>,
        to_surface: Option<&mut Option<SurfaceCotangent<L>>>,
    ) {
        count(|counts| &counts.shading_pullbacks, u64::from(vertex.group.alive.count_ones()));
        match self.integrator.layout.pass {
            Pass::Radiance => material.emission.accumulate(emitted),
            Pass::Albedo => material.diffuse.accumulate(emitted),
            _ => self.pull_shown(vertex, emitted, surface),
        }
        if let Some((opacity, mirror)) = of_outgoing {
            material.opacity.accumulate(opacity);
            material.mirror.accumulate(mirror);
        }
        let uv = vertex.textured.as_deref();
        let mut uv = uv.map(|textured| self.pull_textures(textured, material));
        if self.integrator.layout.pass == Pass::Uv {
            let shown = Tangent::<Uv<L>> { u: emitted.x(), v: emitted.y() };
            uv.get_or_insert_with(Additive::zero).accumulate(shown);
        }
        if !self.scatter.request.materials.is_empty() {
            self.scatter.materials::<L>(&vertex.materials, material);
        }
        if let Some(to_surface) = to_surface {
            *to_surface = Some(SurfaceCotangent { surface: *surface, uv });
        }
    }

    /// From what passes show of the geometry of surfaces to their points, and to the camera.
    #[inline(never)]
    fn pull_shown(
        &mut self,
        vertex: &Vertex<'_, L>,
        shown: Vec3<L>,
        surface: &mut Tangent<SurfacePoint<L>>,
    ) {
        match self.integrator.layout.pass {
            Pass::Depth => {
                let (frame, point) = (self.integrator.inputs.frame, vertex.group.surface.point);
                let (_, pullback) = depth::vjp::<L>(frame, point);
                let (frame, point) = pullback(shown.x() + shown.y() + shown.z());
                surface.point.accumulate(point);
                if self.scatter.request.camera {
                    self.scatter.frame::<L>(&frame);
                }
            }
            Pass::Position => surface.point.accumulate(shown),
            Pass::Normals => surface.normal.accumulate(shown),
            Pass::Radiance | Pass::Albedo | Pass::Coverage | Pass::Uv | Pass::Ids => {}
        }
    }

    /// Turns the cotangent of materials with textures into that of the materials without; returns that of
    /// the texture coordinates.
    pub(super) fn pull_textures(
        &mut self,
        textured: &Textured<L>,
        material: &mut Tangent<Material<L>>,
    ) -> Tangent<Uv<L>> {
        let plain = &textured.plain;
        let mut to_uv = Tangent::<Uv<L>>::zero();
        let colors = [
            (Slot::Emission, plain.emission, &mut material.emission),
            (Slot::Diffuse, plain.diffuse, &mut material.diffuse),
            (Slot::Specular, plain.specular, &mut material.specular),
        ];
        for (slot, color, cotangent) in colors {
            if let Some(lookup) = &textured.lookups[slot as usize] {
                let (_, pullback) = modulate::vjp::<L>(color, lookup.footprint, textured.uv);
                let (color, footprint, uv) = pullback(*cotangent);
                *cotangent = color;
                self.scatter_texels(lookup, lookup.lanes, footprint.texels);
                to_uv.accumulate(uv);
            }
        }
        if let Some(lookup) = &textured.lookups[Slot::Opacity as usize] {
            let (_, pullback) =
                modulate_opacity::vjp::<L>(plain.opacity, lookup.footprint, textured.uv);
            let (opacity, footprint, uv) = pullback(material.opacity);
            material.opacity = opacity;
            self.scatter_texels(lookup, lookup.lanes, footprint.texels);
            to_uv.accumulate(uv);
        }
        if let Some(lookup) = &textured.lookups[Slot::MetallicRoughness as usize] {
            let (roughness, metallic) = (plain.roughness, plain.metallic);
            let (_, pullback) =
                modulate_facets::vjp::<L>(roughness, metallic, lookup.footprint, textured.uv);
            let (roughness, metallic, footprint, uv) =
                pullback((material.roughness, material.metallic));
            (material.roughness, material.metallic) = (roughness, metallic);
            self.scatter_texels(lookup, lookup.lanes, footprint.texels);
            to_uv.accumulate(uv);
        }
        to_uv
    }

    /// Adds the cotangents of the texels of a lookup in some lanes.
    pub(super) fn scatter_texels(&mut self, lookup: &Lookup<L>, lanes: u32, texels: [Vec3<L>; 4]) {
        if self.scatter.request.texels.is_empty() {
            return;
        }
        let texels = texels.map(vectors_of_lanes::<L>);
        for lane in rays((lanes & lookup.lanes).into()) {
            for (index, texel) in lookup.indices[lane].iter().zip(&texels) {
                self.scatter.texel(*index as usize, texel[lane]);
            }
        }
    }
}

/// From the radiance that leaves to that of the surfaces themselves, and to the radiance beyond; with
/// the cotangents of opacity and mirror, if a ray goes on.
#[inline(always)]
fn pull_outgoing<L: Plain>(
    vertex: &Vertex<'_, L>,
    own: Vec3<L>,
    radiance: Vec3<L>,
    to_beyond: &mut Option<&mut Vec3<L>>,
) -> (Vec3<L>, Option<(L, Vec3<L>)>) {
    let Some(beyond) = vertex.goes_on() else { return (radiance, None) };
    let Material { opacity, mirror, .. } = vertex.material;
    let transparent = L::mask(vertex.transparent);
    let (_, pullback) = outgoing::vjp::<L>(opacity, mirror, transparent, own, beyond);
    let (opacity, mirror, (), own, beyond) = pullback(radiance);
    if let Some(to_beyond) = to_beyond {
        to_beyond.accumulate(beyond);
    }
    (own, Some((opacity, mirror)))
}

/// A new place at the end of a list.
pub(super) fn push<T>(list: &mut Vec<Option<T>>) -> &mut Option<T> {
    list.push(None);
    let last = list.len() - 1;
    &mut list[last]
}

/// The loss of the pixels of a group, and the cotangent of their radiance, unless it is zero: what
/// the loss does not care about has no gradient.
#[inline]
fn respond<L: Plain>(
    loss: &dyn PixelLoss,
    tile: &Tile,
    group: &LaneGroup<L>,
    radiance: Vec3<L>,
) -> (f64, Option<Vec3<L>>) {
    let radiance = vectors_of_lanes::<L>(radiance);
    let mut pixels = [PixelRadiance::default(); MAX_LANES];
    let mut count = 0;
    for (lane, ray) in group.rays() {
        let (x, y) = tile.pixel(ray);
        pixels[count] = PixelRadiance { x, y, radiance: radiance[lane] };
        count += 1;
    }
    let sum = loss.evaluate_all(&mut pixels[..count]);
    let cotangents = pixels.iter().map(|pixel| pixel.radiance);
    (sum, nonzero_lanes::<L>(group.rays().map(|(lane, _)| lane).zip(cotangents)))
}

/// The loss of the pixels of a tile that show nothing.
fn loss_of_black(loss: &dyn PixelLoss, tile: &Tile, missed: u64) -> f64 {
    let pixels = rays(missed).map(|ray| tile.pixel(ray));
    pixels.map(|(x, y)| loss.evaluate(x, y, DVec3::ZERO).0).sum()
}

/// Vectors, by lane; the other lanes are zero. Nothing if all are zero.
#[inline]
pub(super) fn nonzero_lanes<L: Plain>(
    vectors: impl Iterator<Item = (usize, DVec3)>,
) -> Option<Vec3<L>> {
    let mut lanes = [DVec3::ZERO; MAX_LANES];
    vectors.for_each(|(lane, vector)| lanes[lane] = vector);
    let matters = lanes.iter().any(|&vector| vector != DVec3::ZERO);
    matters.then(|| lanes_of_vectors::<L>(&lanes))
}
