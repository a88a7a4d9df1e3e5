//! Crossings: the places on a link between two neighbouring samples where what they see changes.
//!
//! A link is searched without rays where its samples say what lies on both sides: the ray is followed
//! analytically through the surfaces that both have in common, and the outlines of the two surfaces that
//! differ are left at roots of the [numbers of their edges](crate::transport::edge). One path is traced
//! on the far side of each silhouette, to find what else comes between. Where both sides see the same
//! surfaces, the edges of [shadows](super::shadow) are looked for.

use super::code::code;
use super::geometry::{Edge, Geometry};
use super::outline::root;
use super::turned::AllTurned;
use super::walk::Step;
use crate::number::Number;
use crate::primal::known::KnownHit;
use crate::primal::wavefront::Wavefront;
use crate::trace::bvh::NO_PRIMITIVE;
use crate::transport::camera::Ray;

/// How far beyond an edge what lies behind it is looked for, as a part of the link.
pub(super) const BEYOND: f64 = 1e-4;

/// Within this distance of a seam, or of where surfaces pierce each other, as a part of the link, rays that start there
/// cannot tell on which side of it they are.
pub(super) const SEAM: f64 = 1e-2;

/// Up to this distance, as a part of the link, two outlines meet in an edge that they share.
const SHARED: f64 = 1e-9;

/// How often a link is divided.
const MOST_DIVISIONS: usize = 14;

/// Edges that are shorter in the image than this, in distances between samples, count crossing by
/// crossing: which of them a cell joins would depend on which it happens to see.
const SHORT: f64 = 2.0;

/// The step for differences of numbers of edges by place, as a part of the link.
const STEP: f64 = 1e-5;

/// A path among those of a row of links.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    start: u32,
    end: u32,
}

impl Path {
    /// Its surfaces.
    pub fn of(self, hits: &[KnownHit]) -> impl Iterator<Item = KnownHit> {
        hits[self.start as usize..self.end as usize].iter().copied()
    }
}

/// What a curve of crossings is an edge of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    /// Of the surface at this depth of the path.
    Surface(u32),
    /// Of the shadow of a light, the second number, on the surface at this depth.
    Shadow(u32, u32),
}

impl Layer {
    /// What tells curves apart that do not end at each other: all edges of surfaces do.
    pub fn family(self) -> Option<Self> {
        match self {
            Self::Surface(_) => None,
            Self::Shadow(..) => Some(self),
        }
    }
}

/// A place where what the samples see changes.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// In pixels from the upper left corner of the image.
    pub place: [f64; 2],
    /// How far it is from the first sample of its link to the second one.
    pub at: f64,
    pub layer: Layer,
    pub edge: Edge,
    /// The paths on the side of the first sample and on that of the second one.
    pub sides: [Path; 2],
    /// The unit normal of the edge in the image, from the first side to the second one as far as the
    /// link has it.
    pub normal: [f64; 2],
    /// The derivative of the number of the edge along the normal.
    pub slope: f64,
    /// Whether the edge is so short in the image that it may not reach from cell to cell.
    pub is_short: bool,
    /// Where what its sides are [lit through](super::lit::LitThrough) starts and ends.
    pub lit_through: [u32; 2],
}

impl Crossing {
    /// The place so many pixels from it on one of its sides.
    pub(super) fn beside(&self, side: usize, away: f64) -> [f64; 2] {
        let away = [-away, away][side];
        [0, 1].map(|axis| self.place[axis] + away * self.normal[axis])
    }

    /// Whether a ray on one of the sides grazes a curved surface in a wavefront: one that is transparent is grazed
    /// twice.
    pub fn grazes<S: Number>(&self, wavefront: &Wavefront<S>, ray: usize) -> bool {
        match (self.layer, self.edge) {
            (Layer::Surface(_), Edge::Silhouette(grazed)) => {
                wavefront.hits.primitive[ray] == grazed
            }
            _ => false,
        }
    }
}

/// The line between two neighbouring samples.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// The place of the first sample, in pixels.
    pub start: [f64; 2],
    /// 0 if it runs to the right, 1 if it runs downwards.
    pub axis: usize,
    /// Its length in pixels.
    pub length: f64,
}

impl Link {
    pub(super) fn place(&self, at: f64) -> [f64; 2] {
        let mut place = self.start;
        place[self.axis] += at * self.length;
        place
    }
}

/// A part of a link, with what is seen at its ends.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub from: f64,
    pub to: f64,
    pub first: Path,
    pub last: Path,
}

/// The search along the links of a row.
pub struct Search<'a> {
    pub(super) geometry: Geometry<'a>,
    pub(super) turned: &'a AllTurned<'a>,
    /// The paths, one after the other.
    pub hits: Vec<KnownHit>,
    pub crossings: Vec<Crossing>,
    steps: Vec<Step>,
}

impl<'a> Search<'a> {
    pub fn new(geometry: Geometry<'a>, turned: &'a AllTurned<'a>) -> Self {
        Self { geometry, turned, hits: Vec::new(), crossings: Vec::new(), steps: Vec::new() }
    }

    /// Adds a path whose surfaces `fill` appends.
    pub fn path(&mut self, fill: impl FnOnce(&mut Vec<KnownHit>)) -> Path {
        let start = self.hits.len() as u32;
        fill(&mut self.hits);
        Path { start, end: self.hits.len() as u32 }
    }

    /// Finds the crossings of a link in order, given what is seen at both ends and where else something may
    /// be seen.
    pub fn link(&mut self, link: &Link, [first, last]: [Path; 2], between: &[f64]) {
        let before = self.crossings.len();
        let mut part = Part { from: 0.0, to: 1.0, first, last };
        for &at in between {
            let seen = self.traced(link, at);
            if self.of(seen) == self.of(part.first) {
                self.hits.truncate(seen.start as usize);
                continue;
            }
            self.part(link, Part { to: at, last: seen, ..part });
            part = Part { from: at, first: seen, ..part };
        }
        self.part(link, part);
        self.crossings[before..].sort_by(|a, b| a.at.total_cmp(&b.at));
    }

    fn part(&mut self, link: &Link, part: Part) {
        if !self.over_surface(link, part) && !self.over_mirror(link, part) {
            self.search(link, part, 0);
        }
    }

    /// Adds the edges between two triangles that end their paths and are parts of one surface, seen straight
    /// or in flat mirrors: by far the most links are such. Returns whether it is so.
    fn over_surface(&mut self, link: &Link, part: Part) -> bool {
        let Part { from: start, to: end, first, last } = part;
        let [one, other] = [first, last].map(|path| self.of(path).split_last());
        let (Some((&a, passed)), Some((&b, same))) = (one, other) else { return false };
        let (depth, primitives) = (passed.len(), [a.primitive, b.primitive]);
        let are_triangles =
            primitives.iter().all(|&primitive| self.geometry.is_triangle(primitive));
        if a.primitive == b.primitive || !are_triangles || passed != same {
            return false;
        }
        let Some(camera) = self.geometry.camera_after(passed) else { return false };
        let geometry = self.geometry;
        let ray = |at: f64| geometry.linear_ray(camera, link.place(start + at * (end - start)));
        let mut steps = std::mem::take(&mut self.steps);
        let leads = geometry.walk(primitives, [ray(0.0), ray(1.0)], &mut steps);
        if !leads {
            self.steps = steps;
            return false;
        }
        let starts = steps.iter().map(|step| (step.triangles[1], step.at));
        let ends = steps.iter().map(|step| step.at).chain([1.0]);
        let starts = [(a.primitive, 0.0)].into_iter().chain(starts);
        let facets = starts.zip(ends).map(|((triangle, start), end)| (triangle, [start, end]));
        if let Some((at, between)) = self.own_shadow(link, part, (depth, camera), facets) {
            self.steps = steps;
            self.part(link, Part { to: at, last: between, ..part });
            self.part(link, Part { from: at, first: between, ..part });
            return true;
        }
        // Where on the way over several triangles another shadow ends is not known, nor what is in the way of lights that
        // only those between face.
        let is_continuous = || self.geometry.are_continuous(a.primitive, b.primitive);
        let is_over = match steps.len() {
            1 => have_same_light(&a, &b) || is_continuous(),
            _ => have_same_light(&a, &b) && !geometry.turn_to_light([a, b], &steps, ray),
        };
        if !is_over {
            steps.clear();
        }
        let mut before = first;
        for (index, &Step { at, edge, triangles: [from, to] }) in steps.iter().enumerate() {
            let after = match index + 1 == steps.len() {
                true => last,
                false => {
                    let mut hits = self.of(first).to_vec();
                    hits[depth] = KnownHit { primitive: to, ..a };
                    self.path(|path| path.extend(hits))
                }
            };
            if !self.geometry.are_continuous(from, to) {
                let at = start + at * (end - start);
                // From whichever side a link comes to a ridge, it is the same edge.
                let [p, q] = edge;
                let ridge = Edge::Segment([p.min(q), p.max(q)]);
                self.emit(link, at, (depth, before), ridge, [before, after]);
            } else if !have_same_light(&a, &b) {
                self.shadows(link, part);
            }
            before = after;
        }
        self.steps = steps;
        is_over
    }

    /// The surfaces of a path.
    pub(super) fn of(&self, path: Path) -> &[KnownHit] {
        &self.hits[path.start as usize..path.end as usize]
    }

    pub(super) fn traced(&mut self, link: &Link, at: f64) -> Path {
        let geometry = self.geometry;
        self.path(|hits| geometry.trace(link.place(at), hits))
    }

    /// The first depth at which two paths meet other surfaces.
    pub(super) fn parting(&self, first: Path, last: Path) -> Option<usize> {
        let [passed, other] = [first, last].map(|path| self.of(path));
        (0..passed.len().min(other.len())).find(|&depth| {
            let [a, b] = [passed, other].map(|path| path[depth]);
            (a.primitive, a.leaves) != (b.primitive, b.leaves)
                && !self.are_one_surface([a.primitive, b.primitive], &passed[..depth])
        })
    }

    /// Whether two primitives that are met after some others are parts of one surface, and show the same side of it.
    pub(super) fn are_one_surface(&self, primitives: [u32; 2], passed: &[KnownHit]) -> bool {
        let [a, b] = primitives;
        let is_unfolded = || {
            let camera = self.geometry.camera_after(passed);
            camera.is_none_or(|camera| self.geometry.show_one_side(primitives, camera.origin))
        };
        self.geometry.are_continuous(a, b) && is_unfolded()
    }

    /// Whether two paths meet the same primitives up to a depth.
    fn meet_same(&self, first: Path, last: Path, depth: usize) -> bool {
        let surfaces = |path: Path| self.of(path).iter().take(depth + 1);
        surfaces(first).map(code).eq(surfaces(last).map(code))
    }

    pub(super) fn search(&mut self, link: &Link, part: Part, divisions: usize) {
        let Part { from, to, first, last } = part;
        if divisions > MOST_DIVISIONS {
            return;
        }
        let Some(depth) = self.parting(first, last) else {
            self.shadows(link, part);
            return;
        };
        let surface =
            |path: Path| Some(self.of(path)[depth]).filter(|hit| hit.primitive != NO_PRIMITIVE);
        let (a, b) = (surface(first), surface(last));
        let camera = self.geometry.camera_after(&self.of(first)[..depth]);
        let exit = |surface: Option<KnownHit>, ends: [f64; 2]| {
            let primitive = surface?.primitive;
            if let Some(camera) = camera
                && self.geometry.is_triangle(primitive)
            {
                let ray = |at: f64| self.geometry.linear_ray(camera, link.place(at));
                return self.geometry.linear_exit(primitive as usize, ends, ray);
            }
            self.geometry.exit(primitive, ends, |at: f64| self.ray(link, first, depth, at))
        };
        let (of_a, of_b) = (exit(a, [from, to]), exit(b, [to, from]));
        let in_front = |at: f64, one: Option<KnownHit>, other: Option<KnownHit>| match (one, other)
        {
            (None, _) => false,
            (Some(_), None) => true,
            (Some(one), Some(other)) => {
                let ray = self.ray(link, first, depth, at);
                let (one, other) =
                    (self.geometry.depth(&one, ray), self.geometry.depth(&other, ray));
                one <= other
            }
        };
        if let (Some((end_of_a, edge)), Some((end_of_b, _))) = (of_a, of_b) {
            if (end_of_a - end_of_b).abs() <= SHARED {
                self.between(link, end_of_a, depth, edge, part, divisions);
                return;
            }
            if end_of_a < end_of_b {
                let middle = 0.5 * (end_of_a + end_of_b);
                let between = self.traced(link, middle);
                if self.meet_same(first, between, depth) || self.meet_same(between, last, depth) {
                    // Rounding: there is nothing between.
                    self.emit(link, middle, (depth, first), edge, [first, last]);
                    return;
                }
                let divisions = divisions + 1;
                self.search(link, Part { to: middle, last: between, ..part }, divisions);
                self.search(link, Part { from: middle, first: between, ..part }, divisions);
                return;
            }
        }
        match (of_a, of_b) {
            (_, Some((at, edge))) if in_front(at, b, a) => {
                self.silhouette(link, part, depth, (at, edge), false, divisions);
            }
            (Some((at, edge)), _) if in_front(at, a, b) => {
                self.silhouette(link, part, depth, (at, edge), true, divisions);
            }
            _ => {
                if let (Some(a), Some(b)) = (a, b) {
                    let low = of_b.map_or(from, |(at, _)| at);
                    let high = of_a.map_or(to, |(at, _)| at);
                    let surfaces = [a, b];
                    if let Some(at) = self.pierced(link, (depth, surfaces), [low, high], first) {
                        let edge = Edge::Intersection(surfaces.map(|hit| code(&hit)));
                        self.between(link, at, depth, edge, part, divisions);
                    }
                }
            }
        }
    }

    /// The ray of a place on a link after the surfaces before `depth`.
    pub(super) fn ray(&self, link: &Link, path: Path, depth: usize, at: f64) -> Ray<f64> {
        self.geometry.ray(&self.of(path)[..depth], link.place(at))
    }

    /// Adds the silhouette of the surface at the first end of a part, or of that at its last end, and
    /// what lies between it and the other end.
    fn silhouette(
        &mut self,
        link: &Link,
        part: Part,
        depth: usize,
        (at, edge): (f64, Edge),
        is_first: bool,
        divisions: usize,
    ) {
        let (near, far, end) = match is_first {
            true => (part.first, part.last, part.to),
            false => (part.last, part.first, part.from),
        };
        let beyond = at + BEYOND * (end - at).signum();
        let is_far = (end - at).abs() <= 2.0 * BEYOND;
        let mut behind = if is_far { far } else { self.traced(link, beyond) };
        if self.meet_same(near, behind, depth) {
            // Rounding: the ray still meets what is in front.
            behind = far;
        }
        let split = |at: f64, path: Path| {
            let before = Part { to: at, last: path, ..part };
            let after = Part { from: at, first: path, ..part };
            if is_first { [before, after] } else { [after, before] }
        };
        if self.parting(near, behind).is_none_or(|parting| parting > depth) {
            // The surface goes on.
            let [passed, rest] = split(beyond, behind);
            self.part(link, passed);
            if !is_far {
                self.search(link, rest, divisions + 1);
            }
            return;
        }
        let start = if is_first { part.from } else { part.to };
        let shaded = self.own_shadow_before(link, [start, at], (depth, near));
        if let Some((at, path)) = shaded {
            let [lit, _] = split(at, path);
            self.part(link, lit);
        }
        let (start, near) = shaded.unwrap_or((start, near));
        // What else casts shadows that end before a silhouette is left out.
        let step = BEYOND.max(self.resolution(link, near, depth));
        let near = self.settled(link, (at, step), (start, near), Some(near), depth, divisions);
        let sides = if is_first { [near, behind] } else { [behind, near] };
        let ray = self.ray(link, near, depth, at);
        let edge = match [near, behind].map(|path| self.of(path).get(depth)) {
            [Some(a), Some(b)]
                if matches!(edge, Edge::Segment(_)) && self.geometry.touch([a, b], ray) =>
            {
                Edge::Intersection(sides.map(|path| code(&self.of(path)[depth])))
            }
            _ => edge,
        };
        self.emit(link, at, (depth, near), edge, sides);
        if !is_far {
            let [_, rest] = split(beyond, behind);
            self.search(link, rest, divisions + 1);
        }
    }

    /// How far from an edge single precision tells whether light comes to what a path meets at a depth.
    fn resolution(&self, link: &Link, path: Path, depth: usize) -> f64 {
        let known = self.of(path)[depth];
        let ends = [0.0, 1.0].map(|at| self.geometry.meet(&known, self.ray(link, path, depth, at)));
        self.geometry.resolution(&ends[0], &ends[1])
    }

    /// Adds an edge between the surfaces at the ends of a part.
    fn between(
        &mut self,
        link: &Link,
        at: f64,
        depth: usize,
        edge: Edge,
        part: Part,
        divisions: usize,
    ) {
        let Part { from, to, first, last } = part;
        // Rays that start where surfaces pierce each other, or in a valley, may start beyond the other surface, and so may
        // those that start above smooth ones.
        let surfaces = [first, last].map(|path| self.of(path)[depth].primitive);
        let geometry = &self.geometry;
        let is_fold = matches!(edge, Edge::Segment(_))
            && surfaces.into_iter().all(|surface| geometry.is_flat(surface));
        let is_ridge = is_fold && {
            let viewer = self.ray(link, first, depth, at).origin;
            geometry.is_behind(surfaces.map(|triangle| triangle as usize), viewer)
        };
        let step = if is_ridge { BEYOND } else { SEAM };
        // Where surfaces pierce each other, one may be in the shadow of the other that no sample is in.
        let pierces = matches!(edge, Edge::Intersection(_));
        let across = |path: Path| (!pierces).then_some(path);
        let sides = [
            self.settled(link, (at, step), (from, first), across(last), depth, divisions),
            self.settled(link, (at, step), (to, last), across(first), depth, divisions),
        ];
        self.emit(link, at, (depth, first), edge, sides);
    }

    /// Where two surfaces pierce each other, the first one in front at `low`.
    fn pierced(
        &self,
        link: &Link,
        (depth, surfaces): (usize, [KnownHit; 2]),
        [low, high]: [f64; 2],
        path: Path,
    ) -> Option<f64> {
        let behind = |at: f64| {
            let ray = self.ray(link, path, depth, low + at * (high - low));
            let [a, b] = surfaces.map(|surface| self.geometry.depth(&surface, ray));
            b - a
        };
        let (start, end) = (behind(0.0), behind(1.0));
        let is_between = start >= 0.0 && end < 0.0;
        let at = is_between.then(|| root(behind, start, end)).flatten()?;
        Some(low + at * (high - low))
    }

    /// A path on one side of an edge that the rays of a path meet at a depth, after the surfaces that these pass: it was
    /// found elsewhere, and may have passed their neighbours.
    fn past(&mut self, path: Path, depth: usize, side: Path) -> Path {
        if depth == 0 || self.of(side).len() <= depth || self.meet_same(path, side, depth - 1) {
            return side;
        }
        let hits = [&self.of(path)[..depth], &self.of(side)[depth..]].concat();
        self.path(|path| path.extend(hits))
    }

    /// Adds an edge of what a path meets at a depth. That on one of the sides may leave the surfaces before it.
    pub(super) fn emit(
        &mut self,
        link: &Link,
        at: f64,
        (depth, path): (usize, Path),
        edge: Edge,
        sides: [Path; 2],
    ) {
        let layer = Layer::Surface(depth as u32);
        let passed = &self.of(path)[..depth];
        if passed.last().is_some_and(|mirror| self.geometry.has_edge(mirror, edge)) {
            return;
        }
        let camera = self.geometry.camera_after(passed);
        let sides = sides.map(|side| self.past(path, depth, side));
        if let (Some(camera), Edge::Segment(ends)) = (camera, edge) {
            let slopes = self.geometry.linear_slopes(camera, ends, link.place(at));
            let is_short = self.geometry.is_short(camera, ends, SHORT * link.length);
            self.crossings.extend(
                crossing(link, at, layer, edge, sides, slopes)
                    .map(|crossing| Crossing { is_short, ..crossing }),
            );
            return;
        }
        let number = |place: [f64; 2]| {
            let ray = self.geometry.ray(&self.of(path)[..depth], place);
            self.geometry.margin(edge, ray)
        };
        let slopes = slopes(link, at, number);
        self.crossings.extend(crossing(link, at, layer, edge, sides, slopes));
    }
}

/// Whether the same lights are seen from two points, through the same materials.
pub(super) fn have_same_light(a: &KnownHit, b: &KnownHit) -> bool {
    (a.blocked, a.filters) == (b.blocked, b.filters)
}

/// The derivatives of the number of an edge by the place in the image, at a part of a link.
pub(super) fn slopes(link: &Link, at: f64, number: impl Fn([f64; 2]) -> f64) -> [f64; 2] {
    let (place, step) = (link.place(at), STEP * link.length);
    [0, 1].map(|axis| {
        let moved = |by: f64| {
            let mut place = place;
            place[axis] += by;
            number(place)
        };
        (moved(step) - moved(-step)) / (2.0 * step)
    })
}

/// A crossing at a part of a link, by the slopes of the number of its edge; nothing where these vanish.
pub(super) fn crossing(
    link: &Link,
    at: f64,
    layer: Layer,
    edge: Edge,
    sides: [Path; 2],
    slopes: [f64; 2],
) -> Option<Crossing> {
    let [x, y] = slopes;
    let length = (x * x + y * y).sqrt();
    let sign = if slopes[link.axis] < 0.0 { -1.0 } else { 1.0 };
    let normal = slopes.map(|part| sign * part / length);
    let is_usable = normal.iter().all(|part| part.is_finite());
    is_usable.then_some(Crossing {
        place: link.place(at),
        at,
        layer,
        edge,
        sides,
        normal,
        slope: sign * length,
        is_short: false,
        lit_through: [0; 2],
    })
}
