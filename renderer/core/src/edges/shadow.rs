//! The search for edges of shadows, between samples that see the same surfaces.
//!
//! Outlines of what is in the way of a light are left one after the other, with a shadow ray beyond each, until
//! the light is seen, or comes through other materials. Facing away from a light counts as not blocked: what
//! changes there is continuous.

use super::crossing::{BEYOND, Layer, Link, Part, Path, SEAM, Search, crossing, slopes};
use super::geometry::{Edge, Met};
use super::lit::BESIDE;
use super::outline::{Exit, root};
use super::rays::Shadow;
use crate::primal::known::KnownHit;

/// How many surfaces a shadow edge is followed over.
const MOST_BLOCKERS: usize = 64;

/// How many times as far from an edge it is looked again, where rays of single precision still meet what it belongs to.
const FARTHER: f64 = 10.0;

/// How far past a lit sample, in lengths of the way to it, the edge of a shadow may be that it is beyond.
const LATE: f64 = 0.5;

/// What a light comes to along a link: a surface point on each place of it.
#[derive(Clone, Copy)]
struct Receiver<'a> {
    link: &'a Link,
    /// A path that meets the surface at this depth.
    path: Path,
    depth: usize,
    light: usize,
    known: KnownHit,
}

/// A part of a link on which one primitive receives light, from the first place to the last.
type Stretch<'a> = (Receiver<'a>, [f64; 2]);

impl Search<'_> {
    /// Adds the shadow edges between two ends that see the same surfaces.
    pub(super) fn shadows(&mut self, link: &Link, part: Part) {
        let depths = self.of(part.first).len().min(self.of(part.last).len());
        for depth in 0..depths {
            let [first, last] = [part.first, part.last].map(|path| self.of(path)[depth]);
            let differs = first.blocked ^ last.blocked;
            let lights = 0..self.geometry.edged_lights();
            for light in lights.clone().filter(|light| differs >> light & 1 == 1) {
                self.opaque(link, part, depth, light);
            }
            if first.filters != last.filters {
                let dark = first.blocked | last.blocked;
                for light in lights.filter(|light| dark >> light & 1 == 0) {
                    let ends = [(part.first, part.from), (part.last, part.to)];
                    let (stretches, _) = self.stretches(link, ends, depth, light);
                    for (receiver, [from, to]) in stretches.into_iter().flatten() {
                        self.transparent(receiver, [from, to], true);
                        self.transparent(receiver, [to, from], false);
                    }
                }
            }
        }
    }

    /// The stretches of the way between two places on which one primitive receives light, and where two of them meet
    /// on it, as they do where the triangles of a surface differ at its ends.
    fn stretches<'a>(
        &self,
        link: &'a Link,
        [(first, from), (last, to)]: [(Path, f64); 2],
        depth: usize,
        light: usize,
    ) -> ([Option<Stretch<'a>>; 2], Option<Exit>) {
        let receivers = [first, last].map(|path| {
            let known = self.of(path)[depth];
            Receiver { link, path, depth, light, known }
        });
        let [on, other] = receivers.map(|receiver| receiver.known.primitive);
        let ray = |at| self.ray(link, first, depth, at);
        let seam = (on != other).then(|| self.geometry.exit(on, [from, to], ray)).flatten();
        let Some((at, _)) = seam else {
            return ([Some((receivers[0], [from, to])), None], None);
        };
        // Facets at a silhouette are narrower than that.
        let shorter = 0.1 * (at - from).abs().min((to - at).abs());
        let beside = SEAM.min(shorter) * (to - from).signum();
        ([Some((receivers[0], [from, at - beside])), Some((receivers[1], [at + beside, to]))], seam)
    }

    /// Adds the edge of the shadow of what is opaque. Where two triangles of a smooth surface meet on the way, it
    /// is on one of them, or the seam itself: one triangle may face the light, and the other be in its own
    /// shadow.
    fn opaque(&mut self, link: &Link, part: Part, depth: usize, light: usize) {
        let is_first = self.of(part.first)[depth].blocked >> light & 1 == 1;
        let ends = [(part.first, part.from), (part.last, part.to)];
        let ends = if is_first { ends } else { [ends[1], ends[0]] };
        let (stretches, seam) = self.stretches(link, ends, depth, light);
        let is_found = stretches.iter().flatten().any(|(on, ends)| self.leave(on, *ends));
        let (Some((at, edge)), [Some((dark, [from, to])), Some((lit, [beside, _]))]) =
            (seam, stretches)
        else {
            return;
        };
        // A sample that faces away from the light says nothing of the seam.
        let is_lit = || {
            let met = self.met(&lit, beside);
            self.geometry.face_each_other(light, &met)
                && matches!(self.geometry.shadow(light, &lit.known, &met), Shadow::Through(_))
        };
        if !is_found && is_lit() {
            let sides = self.sides(&dark, from < to);
            self.emit(link, at, (depth, dark.path), edge, sides);
        }
    }

    /// Leaves the outlines of what is in the way of a light one after the other, from a dark place on, until the
    /// light is seen, and adds the edge of the shadow there; returns whether there is one.
    fn leave(&mut self, receiver: &Receiver<'_>, [mut from, to]: [f64; 2]) -> bool {
        let blocker = |search: &Self, at: f64| match search.shadow(receiver, at) {
            Shadow::Of(primitive) => Some(primitive),
            Shadow::Through(_) => None,
        };
        let towards = (to - from).signum();
        let mut found = blocker(self, from);
        for _ in 0..MOST_BLOCKERS {
            let Some(in_front) = found else { return false };
            // Rays of a camera far away are not exact: those of a sample that they say is lit may be dark by a little.
            let is_sample = to == 0.0 || to == 1.0;
            let past = if is_sample { to + LATE * (to - from) } else { to };
            let Some((at, edge)) = self.exit(receiver, in_front, [from, past]) else {
                return false;
            };
            let at = if (at - to) * towards > 0.0 { to } else { at };
            let mut step = if let Edge::Start(_) = edge { SEAM } else { BEYOND };
            let beyond = loop {
                let beyond = at + step * towards;
                let is_last = (to - beyond) * (to - from) <= 0.0;
                found = if is_last { None } else { blocker(self, beyond) };
                if found != Some(in_front) {
                    break beyond;
                }
                step *= FARTHER;
            };
            if found.is_none() {
                let sides = self.sides(receiver, towards > 0.0);
                self.emit_shadow(receiver, (at, edge), sides);
                return true;
            }
            from = beyond;
        }
        false
    }

    /// The paths on both sides of the edge of a shadow, along the link.
    fn sides(&mut self, receiver: &Receiver<'_>, is_dark_first: bool) -> [Path; 2] {
        let Receiver { path, depth, light, .. } = *receiver;
        [is_dark_first, !is_dark_first]
            .map(|is_dark| self.lit_or_dark(path, (depth, light), is_dark))
    }

    /// A path on which a light is blocked at a depth, or is not.
    pub(super) fn lit_or_dark(
        &mut self,
        path: Path,
        (depth, light): (usize, usize),
        is_dark: bool,
    ) -> Path {
        let mut hits = self.of(path).to_vec();
        let blocked = &mut hits[depth].blocked;
        *blocked = *blocked & !(1 << light) | u64::from(is_dark) << light;
        self.path(|path| path.extend(hits))
    }

    /// Adds the edges of the shadows of transparent surfaces that end on the way between two places; those at which
    /// one material follows on another only if `is_forward`.
    fn transparent(&mut self, receiver: Receiver<'_>, [mut from, to]: [f64; 2], is_forward: bool) {
        let ends = [from, to].map(|at| self.met(&receiver, at));
        let way = to - from;
        let resolution = self.geometry.resolution(&ends[0], &ends[1]) * way.abs();
        let step = BESIDE.max(resolution) * way.signum();
        let within = |at: f64| if is_forward { at.min(to) } else { at.max(to) };
        for _ in 0..MOST_BLOCKERS {
            let Shadow::Through(surfaces) = self.shadow(&receiver, from) else { return };
            let exits = surfaces
                .iter()
                .filter_map(|surface| self.exit(&receiver, surface.primitive, [from, to]));
            let nearer = |a: &Exit, b: &Exit| (a.0 - from).abs().total_cmp(&(b.0 - from).abs());
            let Some((at, edge)) = exits.min_by(nearer) else { return };
            let beyond = within(at + step);
            let before = if (at - from).abs() <= step.abs() { from } else { at - step };
            let sides = [before, beyond].map(|at| self.shadow(&receiver, at));
            let [Shadow::Through(before), Shadow::Through(after)] = sides else { return };
            let light = receiver.light;
            let [of_before, of_after] =
                [&before, &after].map(|surfaces| self.geometry.filters(light, surfaces));
            let ends = before.len() > after.len() || is_forward && before.len() == after.len();
            if of_before != of_after && ends {
                self.emit_shadow(&receiver, (at, edge), [receiver.path; 2]);
            }
            if beyond == to {
                return;
            }
            from = beyond;
        }
    }

    /// The point of the receiver at a place.
    fn met(&self, receiver: &Receiver<'_>, at: f64) -> Met {
        let Receiver { link, path, depth, known, .. } = receiver;
        self.geometry.meet(known, self.ray(link, *path, *depth, at))
    }

    /// What is between the light and the receiver at a place.
    fn shadow(&self, receiver: &Receiver<'_>, at: f64) -> Shadow {
        self.geometry.shadow(receiver.light, &receiver.known, &self.met(receiver, at))
    }

    /// Where the ray to the light leaves a primitive on its way, or the place above a smooth triangle where it starts
    /// goes through it.
    fn exit(&self, receiver: &Receiver<'_>, primitive: u32, ends: [f64; 2]) -> Option<Exit> {
        let Receiver { link, path, depth, light, known } = receiver;
        let ray = |at| self.geometry.shadow_ray(*light, known, self.ray(link, *path, *depth, at));
        let outline = self.geometry.exit(primitive, ends, ray);
        if !self.geometry.is_smooth(known.primitive) || self.geometry.is_custom(primitive) {
            return outline;
        }
        let [from, to] = [ends[0], outline.map_or(ends[1], |(at, _)| at)];
        let edge = Edge::Start(primitive);
        let margin = |at: f64| self.geometry.margin(edge, ray(from + at * (to - from)));
        let (before, after) = (margin(0.0), margin(1.0));
        let signed = |at: f64| margin(at) * before.signum();
        let start = (before * after < 0.0).then(|| root(signed, before.abs(), -after.abs()));
        start.flatten().map(|at| (from + at * (to - from), edge)).or(outline)
    }

    fn emit_shadow(&mut self, receiver: &Receiver<'_>, (at, edge): (f64, Edge), sides: [Path; 2]) {
        let Receiver { link, depth, light, .. } = *receiver;
        let number = |place: [f64; 2]| {
            let path = self.of(sides[0]);
            let ray = self.geometry.ray(&path[..depth], place);
            let ray = self.geometry.shadow_ray(light, &path[depth], ray);
            self.geometry.margin(edge, ray)
        };
        let layer = Layer::Shadow(depth as u32, light as u32);
        let slopes = slopes(link, at, number);
        self.crossings.extend(crossing(link, at, layer, edge, sides, slopes));
    }
}
