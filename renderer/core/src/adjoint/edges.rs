//! Gradients with edges: the interior term of the samples and of both sides of edges, and what pixels
//! gain and lose when edges move.

use ad::{Additive, Fields, Tangent, Vec3};
use glam::DVec3;

use super::chain::{AdjointState, Chain, Cotangents, SurfaceCotangent, nonzero_lanes};
use super::request::Request;
use super::scatter::Sums;
use crate::edges::{Crossing, Edge, Finer, Geometry, Layer, Limb, View};
use crate::loss::PixelLoss;
use crate::number::{MAX_LANES, Plain, splat_vector, widen};
use crate::parallel;
use crate::primal::coalesce::select_lanes;
use crate::primal::integrator::Integrator;
use crate::primal::known::KnownPaths;
use crate::primal::lanes::{lanes_of_numbers, lanes_of_vectors, vectors_of_lanes};
use crate::primal::wavefront::{LaneGroup, Source, TileSample, Wavefront, blocks};
use crate::scene::Scene;
use crate::trace::bvh::{PACKET_RAYS, rays};
use crate::trace::layout::Kind;
use crate::trace::tile::for_each_strip;
use crate::transport::camera::{CameraFrame, Ray, primary_ray};
use crate::transport::edge::{ball_margin, plane_margin, segment_margin, sphere_margin};
use crate::transport::triangle::Triangle;

/// The sums of the strips of the image, and of packets of crossings.
pub fn sweep_with_edges<L: Plain>(
    integrator: Integrator<'_, L>,
    scene: &Scene,
    loss: &dyn PixelLoss,
    request: &Request,
) -> Vec<Sums> {
    let (width, height) = (integrator.layout.width, integrator.layout.height);
    let integrator = integrator.with_zero_weight(request.zero_weight);
    let geometry = Geometry::new(integrator);
    let mut view = View::new(&geometry, integrator);
    let limb = Limb::new(&view, &geometry, request.is_steep_at_silhouettes());
    let mut cotangents = std::mem::take(&mut view.pixels);
    let rows = cotangents.chunks_mut(width as usize).enumerate().collect();
    let losses = parallel::map(rows, |(y, row): (usize, &mut [DVec3])| {
        let mut loss_of_row = 0.0;
        for (x, pixel) in row.iter_mut().enumerate() {
            let (value, cotangent) = loss.evaluate(x as u32, y as u32, *pixel);
            loss_of_row += value;
            *pixel = cotangent;
        }
        loss_of_row
    });
    let mut sums = vec![Sums { loss: losses.iter().sum(), ..Sums::default() }];

    let grid = integrator.layout.sampling.as_grid();
    let start = || (Chain::new(integrator, scene, request), KnownPaths::default());
    let part = 1.0 / f64::from(grid.count());
    sums.extend(for_each_strip(width, height, start, |(chain, known), strip| {
        for tile in strip.tiles() {
            let mut of_tile = [DVec3::ZERO; PACKET_RAYS];
            for ray in rays(tile.rays()) {
                let (x, y) = tile.pixel(ray);
                let pixel = y as usize * width as usize + x as usize;
                if !limb.holds(pixel) {
                    of_tile[ray] = cotangents[pixel] * part;
                }
            }
            for index in 0..grid.count() {
                view.sights.paths(&tile, index, known);
                let sample = TileSample { tile: &tile, sampling: grid, index };
                chain.pull_sample(Source::Traced(sample, known), &of_tile);
            }
        }
        for Finer { film, parts } in limb.packets(&geometry, strip.tiles()) {
            let mut of_limb = [DVec3::ZERO; PACKET_RAYS];
            for (to, &(pixel, part)) in of_limb.iter_mut().zip(&parts) {
                *to = cotangents[pixel] * part;
            }
            chain.pull_sample(Source::Film(&film), &of_limb);
        }
        chain.scatter.take()
    }));

    let counts = |pixel: usize| !limb.holds(pixel);
    sums.extend(sweep_crossings(&view, &geometry, start, &cotangents, counts));
    sums.extend(parallel::map_init(limb.bands(), start, |(chain, _), band| {
        visit_strips((&view, &limb, &geometry), band, &cotangents, |(_, film), of_rays| {
            chain.pull_sample(Source::Film(film), of_rays);
        });
        chain.scatter.take()
    }));
    view.pixels = cotangents;
    view.recycle(integrator.frames);
    sums
}

/// Calls `pull` with the rays of the strips of a band, [packet](Limb::of_strips) by packet, and with the cotangents of
/// their radiance, from those of pixels.
pub(super) fn visit_strips(
    (view, limb, geometry): (&View, &Limb, &Geometry<'_>),
    band: usize,
    cotangents: &[DVec3],
    mut pull: impl FnMut((u32, &[[f64; 2]]), &Cotangents),
) {
    let mut of_crossings = vec![DVec3::ZERO; view.bands[band].radiance.len()];
    for (crossing, share) in view.shares_of(band) {
        of_crossings[crossing] += cotangents[share.pixel as usize] * share.length;
    }
    limb.of_strips(geometry, band, |packet, rays| {
        let mut of_rays = [DVec3::ZERO; PACKET_RAYS];
        for (to, &(crossing, width)) in of_rays.iter_mut().zip(rays) {
            *to = of_crossings[crossing] * width;
        }
        pull(packet, &of_rays);
    });
}

/// The sums of packets of the crossings of a view, by the cotangents of pixels. The interior term of both sides
/// of edges counts in pixels for which `has_sides` holds.
pub(super) fn sweep_crossings<'a, L: Plain>(
    view: &View,
    geometry: &Geometry<'_>,
    start: impl Fn() -> (Chain<'a, L>, KnownPaths) + Sync,
    cotangents: &[DVec3],
    has_sides: impl Fn(usize) -> bool + Sync,
) -> Vec<Sums> {
    parallel::map_init((0..view.bands.len()).collect(), start, |(chain, known), band| {
        let pulled = pull_shares(view, band, cotangents, &has_sides);
        let band = &view.bands[band];
        for (first, crossings) in band.packets() {
            band.paths(geometry, crossings, known);
            chain.pull_crossings(known, crossings, &pulled[first..first + crossings.len()]);
        }
        chain.scatter.take()
    })
}

/// What flows back to a crossing.
#[derive(Clone, Copy, Default)]
struct Pulled {
    /// The cotangents of the radiance on both sides.
    radiance: [DVec3; 2],
    /// The cotangent of its place, along its normal.
    place: f64,
}

/// From the cotangents of pixels to the crossings of a band.
fn pull_shares(
    view: &View,
    band: usize,
    cotangents: &[DVec3],
    has_sides: impl Fn(usize) -> bool,
) -> Vec<Pulled> {
    let radiance = &view.bands[band].radiance;
    let mut pulled = vec![Pulled::default(); radiance.len()];
    for (crossing, share) in view.shares_of(band) {
        let to = &mut pulled[crossing];
        let cotangent = cotangents[share.pixel as usize];
        if has_sides(share.pixel as usize) {
            to.radiance[0] += cotangent * share.areas[0];
            to.radiance[1] += cotangent * share.areas[1];
        }
        let [a, b] = radiance[crossing];
        to.place += cotangent.dot(a - b) * share.length;
    }
    pulled
}

impl<L: Plain> Chain<'_, L> {
    /// Adds what flows back from crossings, whose sides are the paths of a packet.
    fn pull_crossings(&mut self, known: &KnownPaths, crossings: &[Crossing], pulled: &[Pulled]) {
        let (mut path, mut states) =
            (std::mem::take(&mut self.path), std::mem::take(&mut self.states));
        self.integrator.trace_path(Source::Known(known), &mut path);
        let wavefronts = path.wavefronts();
        self.pull_path(wavefronts, &mut states, &mut |group, _| {
            let side = |ray: usize| pulled[ray / 2].radiance[ray % 2];
            nonzero_lanes::<L>(group.rays().map(|(lane, ray)| (lane, side(ray))))
        });
        for (state, wavefront) in states.iter_mut().zip(wavefronts) {
            let is_steep = self.scatter.request.is_steep_at_silhouettes();
            state.grazing = if is_steep { grazing(crossings, wavefront) } else { 0 };
            state.surfaces.resize_with(wavefront.groups.len(), || None);
            for surface in &mut state.surfaces {
                surface.get_or_insert(SurfaceCotangent { surface: Additive::zero(), uv: None });
            }
        }
        // The number of an edge moves its crossings by minus its derivative over its slope.
        let seeds: Vec<f64> = crossings
            .iter()
            .zip(pulled)
            .map(|(crossing, pulled)| -pulled.place / crossing.slope)
            .collect();
        for (depth, wavefront) in wavefronts.iter().enumerate() {
            let state = &mut states[depth];
            self.pull_surface_edges(wavefront, depth, (crossings, &seeds), state);
            self.pull_shadow_edges(wavefront, depth, (crossings, &seeds), state);
        }
        if self.scatter.request.moves_surfaces() {
            self.pull_rays(wavefronts, &mut states);
        }
        (self.path, self.states) = (path, states);
    }

    /// From the edges of surfaces at one depth to primitives and to the rays that meet them.
    fn pull_surface_edges(
        &mut self,
        wavefront: &Wavefront<L>,
        depth: usize,
        (crossings, seeds): (&[Crossing], &[f64]),
        state: &mut AdjointState<L>,
    ) {
        let layer = Layer::Surface(depth as u32);
        for block in 0..blocks::<L>() {
            let first = block * L::COUNT;
            let mut edges = [None; MAX_LANES];
            let mut of_lanes = [0.0; MAX_LANES];
            for lane in (0..L::COUNT).step_by(2) {
                let index = (first + lane) / 2;
                let Some(crossing) = crossings.get(index) else { continue };
                if crossing.layer != layer || seeds[index] == 0.0 {
                    continue;
                }
                if let Edge::Intersection(_) = crossing.edge {
                    pull_intersection(wavefront, first + lane, seeds[index], state);
                } else {
                    edges[lane] = Some(crossing.edge);
                    of_lanes[lane] = seeds[index];
                }
            }
            if edges.iter().all(Option::is_none) {
                continue;
            }
            let seed = lanes_of_numbers::<L>(&of_lanes);
            if depth > 0 {
                let to_ray = self.pull_edges(&edges, wavefront.rays[block], seed);
                state.rays[block].accumulate(to_ray);
                continue;
            }
            let (x, y) = wavefront.film[block];
            let (ray, pullback) = primary_ray::vjp::<L>(self.integrator.inputs.frame, x, y);
            let to_ray = self.pull_edges(&edges, ray, seed);
            if self.scatter.request.camera {
                let to_frame: Tangent<CameraFrame<L>> = pullback(to_ray).0;
                self.scatter.frame::<L>(&to_frame);
            }
        }
    }

    /// From the edges of shadows on the surfaces at one depth to primitives, lights and surface points.
    fn pull_shadow_edges(
        &mut self,
        wavefront: &Wavefront<L>,
        depth: usize,
        (crossings, seeds): (&[Crossing], &[f64]),
        state: &mut AdjointState<L>,
    ) {
        for group in &wavefront.groups {
            for light in 0..self.integrator.inputs.lights.len() {
                let layer = Layer::Shadow(depth as u32, light as u32);
                let mut edges = [None; MAX_LANES];
                let mut of_lanes = [0.0; MAX_LANES];
                for (lane, ray) in group.rays().filter(|(_, ray)| ray % 2 == 0) {
                    let crossing = &crossings[ray / 2];
                    if crossing.layer == layer && seeds[ray / 2] != 0.0 {
                        edges[lane] = Some(crossing.edge);
                        of_lanes[lane] = seeds[ray / 2];
                    }
                }
                if edges.iter().all(Option::is_none) {
                    continue;
                }
                let seed = lanes_of_numbers::<L>(&of_lanes);
                self.pull_shadow_edge(light, group, (&edges, seed), state);
            }
        }
    }

    /// From the numbers of the edges that a light shines past to a group to these, to the light and to the points.
    pub(super) fn pull_shadow_edge(
        &mut self,
        light: usize,
        group: &LaneGroup<L>,
        (edges, seed): (&[Option<Edge>; MAX_LANES], L),
        state: &mut AdjointState<L>,
    ) {
        let ray = self.integrator.shadow_ray(light, group);
        let to_ray = self.pull_edges(edges, ray, seed);
        if let Some(SurfaceCotangent { surface, .. }) = &mut state.surfaces[group.index] {
            surface.point.accumulate(self.pull_shadow_ray(light, group, to_ray));
        }
    }

    /// From the numbers of edges, one in each lane that has one, to their primitives; returns the
    /// cotangents of the rays.
    pub(super) fn pull_edges(
        &mut self,
        edges: &[Option<Edge>; MAX_LANES],
        ray: Ray<L>,
        seed: L,
    ) -> Tangent<Ray<L>> {
        let mut to_ray = Tangent::<Ray<L>>::zero();
        let is_segment = |edge: &Option<Edge>| matches!(edge, Some(Edge::Segment(_)));
        let lanes = edges.iter().enumerate();
        let segments: u32 = lanes.map(|(lane, edge)| u32::from(is_segment(edge)) << lane).sum();
        if segments != 0 {
            let ends = |end: usize| {
                let mut places = [DVec3::ZERO; MAX_LANES];
                for (place, edge) in places.iter_mut().zip(edges) {
                    if let Some(Edge::Segment(ends)) = edge {
                        *place =
                            widen::<L::Lane>(self.integrator.inputs.vertices[ends[end] as usize]);
                    }
                }
                lanes_of_vectors::<L>(&places)
            };
            let (_, pullback) = segment_margin::vjp::<L>(ends(0), ends(1), ray);
            let (a, b, of_ray) = pullback(seed);
            to_ray = select_lanes::<L, _>(segments, &of_ray, &to_ray);
            let [a, b] = [a, b].map(vectors_of_lanes::<L>);
            for lane in rays(segments.into()) {
                let Some(Edge::Segment(ends)) = edges[lane] else { continue };
                for (vertex, cotangent) in ends.into_iter().zip([a[lane], b[lane]]) {
                    self.scatter_vertex(vertex, cotangent);
                }
            }
        }
        for (lane, edge) in edges.iter().enumerate() {
            let of_ray = match *edge {
                Some(Edge::Silhouette(primitive)) => {
                    self.pull_silhouette(primitive as usize, lane, ray, seed)
                }
                Some(Edge::Start(primitive)) => {
                    let origin = self.pull_start(primitive as usize, lane, ray.origin, seed);
                    Tangent::<Ray<L>> { origin, ..Additive::zero() }
                }
                _ => continue,
            };
            to_ray = select_lanes::<L, _>(1 << lane, &of_ray, &to_ray);
        }
        to_ray
    }

    /// From the number of a place on a primitive in one lane to the primitive; returns the cotangents of the
    /// places.
    fn pull_start(&mut self, primitive: usize, lane: usize, place: Vec3<L>, seed: L) -> Vec3<L> {
        let Integrator { layout, inputs, .. } = self.integrator;
        match layout.kind_of(primitive) {
            (Kind::Triangle, index) => {
                let corners = layout.triangles[index];
                let [a, b, c] =
                    corners.map(|vertex| splat_vector::<L>(inputs.vertices[vertex as usize]));
                let (_, pullback) = plane_margin::vjp::<L>(Triangle { a, b, c }, place);
                let (triangle, to_place) = pullback(seed);
                let Tangent::<Triangle<L>> { a, b, c } = triangle;
                for (vertex, cotangent) in corners.into_iter().zip([a, b, c]) {
                    self.scatter_vertex(vertex, vectors_of_lanes::<L>(cotangent)[lane]);
                }
                to_place
            }
            (_, index) => {
                let sphere = inputs.spheres[index].map(L::splat);
                let (_, pullback) = ball_margin::vjp::<L>(sphere, place);
                let (sphere, to_place) = pullback(seed);
                self.scatter.sphere::<L>(index, 1 << lane, &sphere);
                to_place
            }
        }
    }

    /// From the number of the silhouette of a primitive in one lane to the primitive; returns the
    /// cotangents of the rays.
    fn pull_silhouette(
        &mut self,
        primitive: usize,
        lane: usize,
        ray: Ray<L>,
        seed: L,
    ) -> Tangent<Ray<L>> {
        let inputs = self.integrator.inputs;
        match self.integrator.layout.kind_of(primitive) {
            (Kind::Custom, index) => {
                let shape = &inputs.shapes[index];
                self.scatter.shape(index, shape.numbers.len(), 1 << lane, |to_number| {
                    shape.pull_margin(ray, seed, to_number)
                })
            }
            (_, index) => {
                let sphere = inputs.spheres[index].map(L::splat);
                let (_, pullback) = sphere_margin::vjp::<L>(sphere, ray);
                let (sphere, of_ray) = pullback(seed);
                self.scatter.sphere::<L>(index, 1 << lane, &sphere);
                of_ray
            }
        }
    }
}

/// A bit for each side of a crossing whose ray grazes a curved surface in a wavefront.
fn grazing<L: Plain>(crossings: &[Crossing], wavefront: &Wavefront<L>) -> u64 {
    let grazes = |ray: usize| u64::from(crossings[ray / 2].grazes(wavefront, ray)) << ray;
    (0..2 * crossings.len()).fold(0, |bits, ray| bits | grazes(ray))
}

/// From the number of a curve in which the surfaces on both sides of a crossing pierce each other to the
/// points of these.
fn pull_intersection<L: Plain>(
    wavefront: &Wavefront<L>,
    first: usize,
    seed: f64,
    state: &mut AdjointState<L>,
) {
    for (ray, sign) in [(first, 1.0), (first + 1, -1.0)] {
        let Some(group) = wavefront.group_of(ray) else { continue };
        let mut seeds = [0.0; MAX_LANES];
        seeds[ray - group.first] = sign * seed;
        let seed = lanes_of_numbers::<L>(&seeds);
        if let Some(SurfaceCotangent { surface, .. }) = &mut state.surfaces[group.index] {
            surface.point.accumulate(group.ray.direction * seed);
        }
    }
}
