//! Bands: some rows of samples with the crossings of the links that start in them, the unit of parallel
//! work.

use glam::DVec3;

use super::code::code;
use super::crossing::{Crossing, Layer, Link, Search};
use super::geometry::{Edge, Geometry};
use super::links::{Starts, links};
use super::lit::{self, LitThrough};
use super::projection::Projection;
use super::sight::Sights;
use super::slender::Slender;
use super::strip::Strip;
use super::turned::AllTurned;
use crate::number::Plain;
use crate::primal::image::add_radiance;
use crate::primal::integrator::Integrator;
use crate::primal::known::{KnownHit, KnownPaths};
use crate::primal::path::Path;
use crate::primal::rounds::Round;
use crate::primal::wavefront::Source;
use crate::trace::bvh::{NO_PRIMITIVE, PACKET_RAYS};
use crate::trace::layout::StandIns;
use crate::trace::random::PathNumbers;
use crate::transport::material::Bsdf;

/// How many rows of samples make a band. Fixed, because the order of summation depends on it.
pub const BAND: usize = 8;

/// How far within the silhouette of a custom shape its normal is certain, in pixels.
const WITHIN: f64 = 1e-3;

/// How many crossings make a packet of paths, two each.
pub const PACKET_CROSSINGS: usize = PACKET_RAYS / 2;

/// The crossings of the links that start in a band of rows of samples.
pub struct Band {
    /// In the order of their links.
    pub crossings: Vec<Crossing>,
    /// By crossing: the radiance on both sides.
    pub radiance: Vec<[DVec3; 2]>,
    /// The surfaces of the paths on the sides.
    pub(super) hits: Vec<KnownHit>,
    /// What lights come through there, crossing by crossing.
    lit_through: Vec<LitThrough>,
    /// Which of them are on which link.
    pub(super) starts: Starts,
}

impl Band {
    /// The crossings of a band of the samples, without radiance.
    pub fn new(
        geometry: &Geometry<'_>,
        sights: &Sights,
        (projection, slender, turned): (&Projection<'_>, &Slender, &AllTurned<'_>),
        band: usize,
    ) -> Self {
        let mut search = Search::new(*geometry, turned);
        let rows = band * BAND..((band + 1) * BAND).min(sights.rows);
        let mut next_slender = slender.start_of(sights.link([0, rows.start], 0));
        let mut starts = Starts::new(sights.columns);
        let length = 1.0 / sights.side as f64;
        let (mut differ, mut between) = (Vec::new(), Vec::new());
        for row in rows {
            sights.differences(row, &mut differ);
            slender.mark(row, sights, &mut differ);
            for (set, &differ) in differ.iter().enumerate() {
                starts.next_set();
                for (column, axis) in links(set, differ) {
                    between.clear();
                    let index = sights.link([column, row], axis);
                    between.extend(slender.of_link(index, &mut next_slender));
                    let sample = row * sights.columns + column;
                    let ends = [sample, sample + [1, sights.columns][axis]];
                    let link = Link { start: sights.place(column, row), axis, length };
                    let places = [link.start, link.place(1.0)];
                    if between.is_empty()
                        && sights.are_over_surface(ends, places, projection, turned)
                    {
                        continue;
                    }
                    let before = search.crossings.len();
                    let ends = ends.map(|at| search.path(|hits| hits.extend(sights.hits(at))));
                    search.link(&link, ends, &between);
                    if search.crossings.len() > before {
                        starts.push(column, axis, before);
                    }
                }
            }
        }
        starts.finish(search.crossings.len());
        let Search { mut crossings, hits, .. } = search;
        let lit_through = lit::find_lit_through(geometry, &mut crossings, &hits, length);
        Self { crossings, radiance: Vec::new(), hits, lit_through, starts }
    }

    /// Takes the radiance of direct light on both sides of each crossing. `known` and `path` are room for the work.
    pub fn shade<L: Plain>(
        &mut self,
        geometry: &Geometry<'_>,
        integrator: Integrator<'_, L>,
        (known, path): &mut (KnownPaths, Path<L>),
    ) {
        let mut sides = vec![[DVec3::ZERO; 2]; self.crossings.len()];
        for (first, crossings) in self.packets() {
            self.paths(geometry, crossings, known);
            let to = sides[first..first + crossings.len()].as_flattened_mut();
            add_radiance(integrator, Source::Known(known), path, to);
        }
        self.radiance = sides;
    }

    /// Takes the part of a round in the radiance on both sides of crossings. At the edges of surfaces that the camera
    /// sees first, that is what light brings that takes all paths, in place of direct light. What refracts has no
    /// shadows, nor has what paths end at. `index` is that of the band, samples are `length` pixels apart.
    ///
    /// The sides are looked at beside the edge: where surfaces pierce each other, rays that leave one of them at the
    /// edge itself cannot tell whether the other is in the way.
    pub fn scatter<L: Plain>(
        &mut self,
        geometry: &Geometry<'_>,
        (integrator, round): (Integrator<'_, L>, Round),
        (index, length): (usize, f64),
        (known, path): &mut (KnownPaths, Path<L>),
    ) {
        let layout = geometry.layout;
        let limits = integrator.layout.path_tracing;
        let ends_at = |depth: u32| limits.is_some_and(|limits| depth + 1 >= limits.max_depth);
        let is_glass =
            |primitive: u32| layout.traits_of(primitive as usize).bsdf == Bsdf::Dielectric;
        let is_silhouette_of_glass = |crossing: &Crossing| match crossing.edge {
            Edge::Silhouette(grazed) => is_glass(grazed),
            _ => false,
        };
        let stands_everywhere = layout.stand_ins() == StandIns::Everywhere;
        let is_found_elsewhere = |light: u32, edge: Edge| {
            light as usize >= layout.first_stand_in()
                && !stands_everywhere
                && !matches!(edge, Edge::Start(_))
        };
        let mut seen = Vec::new();
        let part = 1.0 / f64::from(round.count);
        for radiance in self.radiance.as_flattened_mut() {
            *radiance *= part;
        }
        for (index, crossing) in self.crossings.iter().enumerate() {
            let depth = match crossing.layer {
                Layer::Shadow(0, light) if is_found_elsewhere(light, crossing.edge) => {
                    self.radiance[index] = [DVec3::ZERO; 2];
                    continue;
                }
                Layer::Shadow(depth, _) => depth,
                // The shadow of a light ends at an edge of the surface that it falls on.
                Layer::Surface(0) if self.shows_one_surface(crossing) => 0,
                // Light that grazes curved glass goes on as if there were none: nothing jumps.
                Layer::Surface(0) if is_silhouette_of_glass(crossing) => {
                    self.radiance[index] = [DVec3::ZERO; 2];
                    continue;
                }
                Layer::Surface(0) => {
                    seen.push(index);
                    continue;
                }
                Layer::Surface(_) => continue,
            };
            let on = crossing.sides[0].of(&self.hits).nth(depth as usize);
            if on.is_some_and(|hit| is_glass(hit.primitive)) || ends_at(depth) {
                self.radiance[index] = [DVec3::ZERO; 2];
            }
        }
        let sampling = integrator.layout.sampling;
        let count = round.paths;
        for packet in seen.chunks(PACKET_CROSSINGS) {
            let crossings: Vec<Crossing> =
                packet.iter().map(|&index| self.crossings[index]).collect();
            let beside = |crossing: &Crossing, side: usize| {
                let surface = crossing.sides[side].of(&self.hits).next();
                let surface = surface.filter(|hit| hit.primitive != NO_PRIMITIVE);
                let is_grazed = |hit: &KnownHit| crossing.edge == Edge::Silhouette(hit.primitive);
                if surface.as_ref().is_some_and(is_grazed) {
                    return self.place_of_side(geometry, crossing, side);
                }
                let distance =
                    |hit| lit::resolution(geometry, crossing, side, &[hit], length) * length;
                crossing.beside(side, surface.map_or(0.0, distance).max(WITHIN))
            };
            self.paths_through(geometry, &crossings, beside, known);
            let mut total = [[DVec3::ZERO; 2]; PACKET_CROSSINGS];
            let first = (index << 16 | packet[0]) as u32;
            for sample in round.paths_on_sides() {
                let numbers = PathNumbers::on_sides(first, sampling.seed(), sample);
                let (source, to) = (Source::Scattered(known, &numbers), total.as_flattened_mut());
                add_radiance(integrator, source, path, to);
            }
            for (&index, total) in packet.iter().zip(total) {
                self.radiance[index] = total.map(|radiance| radiance / f64::from(count));
            }
        }
    }

    /// Whether the camera sees the same surface first on both sides of a crossing.
    fn shows_one_surface(&self, crossing: &Crossing) -> bool {
        let [one, other] = crossing.sides.map(|side| side.of(&self.hits).next());
        one.as_ref().map(code) == other.as_ref().map(code)
    }

    /// Whether a crossing is of the silhouette of a curved surface, or of an edge of one that is smooth on one side or
    /// the other.
    pub fn is_of_curved(&self, crossing: usize, geometry: &Geometry<'_>) -> bool {
        let Crossing { layer: Layer::Surface(depth), edge, sides, .. } = self.crossings[crossing]
        else {
            return false;
        };
        matches!(edge, Edge::Silhouette(_))
            || sides.into_iter().any(|side| {
                let hit = side.of(&self.hits).nth(depth as usize);
                hit.is_some_and(|hit| geometry.is_smooth(hit.primitive))
            })
    }

    /// The strips along the silhouettes of smooth meshes, of curved surfaces and of flat triangles that the camera grazes,
    /// as they are seen, through transparent surfaces and in flat mirrors too, with their crossings. Each of the three
    /// kinds has a width, in pixels. Those of curved surfaces have so many parts. Strips within one flat
    /// triangle are left out: samples there are right.
    pub fn strips(
        &self,
        geometry: &Geometry<'_>,
        [of_smooth, of_curved, of_flat]: [f64; 3],
        curved_parts: usize,
    ) -> Vec<(usize, Strip)> {
        let crossings = self.crossings.iter().enumerate();
        let strip = |(index, crossing): (usize, &Crossing)| {
            let Crossing { layer, edge, sides, place, at, normal, .. } = *crossing;
            let Layer::Surface(depth) = layer else { return None };
            let ends = sides.map(|side| {
                let hit = side.of(&self.hits).nth(depth as usize);
                hit.map(|hit| hit.primitive).filter(|&hit| match edge {
                    Edge::Segment(edge) => geometry.is_side(hit, edge),
                    Edge::Silhouette(grazed) => hit == grazed,
                    Edge::Intersection(_) | Edge::Start(_) => false,
                })
            });
            let (side, primitive, inward) = match ends {
                [Some(primitive), None] => (sides[0], primitive, normal.map(|part| -part)),
                [None, Some(primitive)] => (sides[1], primitive, normal),
                _ => return None,
            };
            // The other side may have left the surfaces before.
            let before: Vec<_> = side.of(&self.hits).take(depth as usize).collect();
            let camera = geometry.camera_after(&before)?;
            let start = (place, inward);
            let strip = match edge {
                Edge::Segment(edge) => {
                    let of_facets =
                        |width| Strip::of_facets(geometry, (camera, primitive, edge), start, width);
                    if geometry.is_smooth(primitive) {
                        of_facets(of_smooth)
                    } else if geometry.is_grazed(primitive, geometry.linear_ray(camera, place)) {
                        Some(of_facets(of_flat)).filter(|strip| !strip.parts.is_empty())?
                    } else {
                        return None;
                    }
                }
                Edge::Silhouette(_) => Strip::curved(start, of_curved, (curved_parts, at)),
                _ => return None,
            };
            Some((index, strip))
        };
        crossings.filter_map(strip).collect()
    }

    /// The crossings in packets, with the first one of each.
    pub fn packets(&self) -> impl Iterator<Item = (usize, &[Crossing])> {
        let starts = (0..self.crossings.len()).step_by(PACKET_CROSSINGS);
        starts.zip(self.crossings.chunks(PACKET_CROSSINGS))
    }

    /// The paths on both sides of crossings, the first ones and their others in turns.
    pub fn paths(&self, geometry: &Geometry<'_>, crossings: &[Crossing], paths: &mut KnownPaths) {
        let at = |crossing: &Crossing, side: usize| self.place_of_side(geometry, crossing, side);
        self.paths_through(geometry, crossings, at, paths);
    }

    /// The same, through other places of the image: `place` gives them for the sides of a crossing.
    fn paths_through(
        &self,
        geometry: &Geometry<'_>,
        crossings: &[Crossing],
        place: impl Fn(&Crossing, usize) -> [f64; 2],
        paths: &mut KnownPaths,
    ) {
        paths.clear();
        let lights = geometry.edged_lights();
        for crossing in crossings {
            for (index, side) in crossing.sides.into_iter().enumerate() {
                let film = geometry.film(place(crossing, index));
                paths.push(film, side.of(&self.hits), lights);
                for lit in self.lit_through(crossing, index) {
                    let LitThrough { light, ref surfaces, .. } = *lit;
                    let depth = lit.depth as usize;
                    match geometry.layout.comes_through(light, surfaces.len(), depth) {
                        true => paths.push_through(depth, light, surfaces),
                        false => paths.block(depth, light),
                    }
                }
            }
        }
    }

    /// What one side of a crossing is lit through.
    fn lit_through(&self, crossing: &Crossing, side: usize) -> impl Iterator<Item = &LitThrough> {
        let [start, end] = crossing.lit_through.map(|at| at as usize);
        self.lit_through[start..end].iter().filter(move |lit| lit.side == side)
    }

    /// Where one side of a crossing is looked at, in pixels. A ray that grazes a custom shape cannot tell on which side
    /// its normal is, so it goes through a place a little within the silhouette.
    fn place_of_side(&self, geometry: &Geometry<'_>, crossing: &Crossing, side: usize) -> [f64; 2] {
        let Edge::Silhouette(grazed) = crossing.edge else { return crossing.place };
        let is_grazed = |hit: KnownHit| hit.primitive == grazed;
        if !geometry.is_custom(grazed) || !crossing.sides[side].of(&self.hits).any(is_grazed) {
            return crossing.place;
        }
        crossing.beside(side, WITHIN)
    }
}
