//! The edges of surfaces, and the rays along them that see something else if they are moved aside.
//!
//! The rays along a straight edge are an integral over its points and over directions. A ray moves over an edge of the
//! length `l` as fast as the edge moves along their common normal, times the sine of the angle between them; so that
//! angle is chosen evenly by its cosine, and the azimuth evenly among those that matter. At a silhouette these have
//! both faces on one side: an edge where a surface turns by little has few, and a smooth mesh is no more costly than
//! the ball that it stands for. A ball has tangents, of which a point of it has one in each azimuth, by the curvature.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use glam::DVec3;

use crate::edges::{Edge, Geometry};
use crate::trace::adjacency::sides;

/// Where surfaces turn by less, in radians, they are flat.
const LEAST_TURN: f64 = 1e-5;

/// Where rays see something else on either side.
pub struct Contours<'a> {
    geometry: &'a Geometry<'a>,
    /// 3 times a triangle, plus the side of it; those in one place follow each other.
    sides: Vec<u32>,
    silhouettes: Table,
    ridges: Table,
}

/// Edges with the sums of their measures, by which they are chosen.
#[derive(Default)]
struct Table {
    entries: Vec<Entry>,
    sums: Vec<f64>,
}

#[derive(Clone, Copy)]
enum Entry {
    /// Some sides in one place.
    Sides { first: u32, count: u32, azimuths: Azimuths },
    /// A sphere, by its index.
    Sphere(u32),
}

/// The azimuths of the common normals of an edge and the rays along it.
#[derive(Clone, Copy, PartialEq)]
enum Azimuths {
    All,
    /// Those that have both faces on one side.
    OneSide,
    /// Those that have a face on either side, which may look different.
    BothSides,
}

/// A ray along an edge.
pub struct Contour<'a> {
    /// The point of the edge.
    pub point: DVec3,
    /// A unit vector.
    pub direction: DVec3,
    /// The common normal of edge and ray, a unit vector.
    pub normal: DVec3,
    /// How fast the point moves along the normal by the [number](Geometry::margin()) of each of its edges.
    pub slope: f64,
    /// One over the density of rays that are drawn evenly, by the measure above.
    pub even: f64,
    /// The same of rays towards distant lights, by their spread in steradians.
    by_spread: f64,
    edges: Place<'a>,
}

#[derive(Clone, Copy)]
enum Place<'a> {
    Sides { geometry: &'a Geometry<'a>, sides: &'a [u32] },
    Sphere { primitive: u32, radius: f64 },
}

/// Where the light is that a ray goes to.
#[derive(Clone, Copy)]
pub enum Target {
    Point(DVec3),
    Direction(DVec3),
}

impl Target {
    /// The unit vector to it from a place.
    pub fn direction_from(self, place: DVec3) -> DVec3 {
        match self {
            Self::Point(point) => (point - place).normalize(),
            Self::Direction(direction) => direction,
        }
    }
}

impl Table {
    fn add(&mut self, entry: Entry, measure: f64) {
        if measure > 0.0 && measure.is_finite() {
            self.entries.push(entry);
            self.sums.push(self.total() + measure);
        }
    }

    fn total(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    /// The entry that a number from 0 up to the total chooses, and its measure.
    fn choose(&self, number: f64) -> Option<(Entry, f64)> {
        let index =
            self.sums.partition_point(|&sum| sum <= number).min(self.sums.len().wrapping_sub(1));
        let before = index.checked_sub(1).map_or(0.0, |before| self.sums[before]);
        Some((*self.entries.get(index)?, self.sums[index] - before))
    }
}

impl<'a> Contours<'a> {
    pub fn new(geometry: &'a Geometry<'a>) -> Self {
        let mut contours = Self {
            geometry,
            sides: Vec::new(),
            silhouettes: Table::default(),
            ridges: Table::default(),
        };
        contours.add_triangles();
        for index in 0..geometry.layout.spheres {
            let measure = 2.0 * TAU * TAU * geometry.sphere(index).radius;
            contours.silhouettes.add(Entry::Sphere(index as u32), measure);
        }
        contours
    }

    fn add_triangles(&mut self) {
        let geometry = self.geometry;
        let layout = geometry.layout;
        // Vertices in one place count as one.
        let mut places = HashMap::new();
        let first_in_place = |vertex: u32| {
            let place = (geometry.vertex(vertex) + 0.0).to_array().map(f64::to_bits);
            u64::from(*places.entry(place).or_insert(vertex))
        };
        let vertices: Vec<u64> = (0..layout.vertices() as u32).map(first_in_place).collect();
        let mut found = Vec::new();
        for (triangle, &corners) in layout.triangles.iter().enumerate() {
            if geometry.has_area(triangle) {
                for (side, edge) in sides(corners).into_iter().enumerate() {
                    let [a, b] = edge.map(|end| vertices[end as usize]);
                    found.push((a.min(b) << 32 | a.max(b), (3 * triangle + side) as u32));
                }
            }
        }
        found.sort_unstable();
        for of_edge in found.chunk_by(|a, b| a.0 == b.0) {
            let (first, count) = (self.sides.len() as u32, of_edge.len() as u32);
            self.sides.extend(of_edge.iter().map(|(_, side)| side));
            let [a, b] = ends(geometry, of_edge[0].1);
            let entry = |azimuths| Entry::Sides { first, count, azimuths };
            let measure = |azimuths: f64| 2.0 * a.distance(b) * azimuths;
            let &[(_, one), (_, other)] = of_edge else {
                self.silhouettes.add(entry(Azimuths::All), measure(TAU));
                continue;
            };
            let angle = inwards(geometry, one).angle_between(inwards(geometry, other));
            let turn = PI - angle;
            if turn > LEAST_TURN {
                self.silhouettes.add(entry(Azimuths::OneSide), measure(2.0 * turn));
            }
            let jump = jump(geometry, [one / 3, other / 3], turn);
            self.ridges.add(entry(Azimuths::BothSides), measure(2.0 * angle * jump));
        }
    }

    /// A ray along an edge, by numbers from 0 to 1: one that chooses the edge, and three that choose the ray.
    pub fn evenly(&self, choice: f64, [along, around, across]: [f64; 3]) -> Option<Contour<'_>> {
        let number = choice * self.total();
        let of_silhouettes = self.silhouettes.total();
        let (entry, measure) = match number < of_silhouettes {
            true => self.silhouettes.choose(number)?,
            false => self.ridges.choose(number - of_silhouettes)?,
        };
        let (sides, azimuths) = match entry {
            Entry::Sphere(index) => {
                let normal = on_sphere([around, across]);
                let (u, v) = normal.any_orthonormal_pair();
                let (sin, cos) = (TAU * along).sin_cos();
                return Some(self.of_sphere(index, measure, (normal, u * cos + v * sin)));
            }
            Entry::Sides { first, count, azimuths } => (self.sides_of(first, count), azimuths),
        };
        let [a, b] = ends(self.geometry, sides[0]);
        let edge = (b - a).normalize();
        let (middle, width) = self.azimuths(sides, azimuths);
        let middle = if around < 0.5 { middle } else { -middle };
        let (sin, cos) = (width * ((2.0 * around).fract() - 0.5)).sin_cos();
        let normal = middle * cos + edge.cross(middle) * sin;
        let cosine = 2.0 * across - 1.0;
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let direction = edge * cosine + normal.cross(edge) * sine;
        let contour = self.of_sides(sides, measure, along, (normal, direction));
        // Ridges are drawn less often than their rays are many.
        let times = 4.0 * a.distance(b) * width / measure;
        Some(Contour { even: contour.even * times, ..contour })
    }

    /// A ray along a silhouette towards a light, by two numbers from 0 to 1; nothing if the edge that the first one
    /// chooses is not seen as one from there.
    pub fn towards(&self, choice: f64, along: f64, target: Target) -> Option<Contour<'_>> {
        let (entry, measure) = self.silhouettes.choose(choice * self.silhouettes.total())?;
        match entry {
            Entry::Sphere(index) => {
                let sphere = self.geometry.sphere(index as usize);
                // The silhouette is a circle around the axis; inside of the sphere there is none.
                let (axis, sine) = match target {
                    Target::Direction(direction) => (direction, 0.0),
                    Target::Point(point) => {
                        let away = point - sphere.center;
                        (away.normalize(), sphere.radius / away.length())
                    }
                };
                let cosine = (1.0 - sine * sine).sqrt();
                let (u, v) = axis.any_orthonormal_pair();
                let (sin, cos) = (TAU * along).sin_cos();
                let outwards = u * cos + v * sin;
                let normal = axis * sine + outwards * cosine;
                let direction = axis * cosine - outwards * sine;
                let contour = self.of_sphere(index, measure, (normal, direction));
                (cosine > 0.0).then_some(contour)
            }
            Entry::Sides { first, count, .. } => {
                let sides = self.sides_of(first, count);
                let [a, b] = ends(self.geometry, sides[0]);
                let direction = target.direction_from(a.lerp(b, along));
                let normal = (b - a).cross(direction).normalize();
                let contour = self.of_sides(sides, measure, along, (normal, direction));
                contour.lit_side().is_some().then_some(contour)
            }
        }
    }

    fn total(&self) -> f64 {
        self.silhouettes.total() + self.ridges.total()
    }

    fn sides_of(&self, first: u32, count: u32) -> &[u32] {
        &self.sides[first as usize..(first + count) as usize]
    }

    /// Of two opposite ranges of azimuths of the same width: the middle of one, and the width.
    fn azimuths(&self, sides: &[u32], azimuths: Azimuths) -> (DVec3, f64) {
        let [one, other] =
            [sides[0], sides[sides.len() - 1]].map(|side| inwards(self.geometry, side));
        let angle = one.angle_between(other);
        match azimuths {
            Azimuths::All => (one, PI),
            Azimuths::OneSide => ((one + other).normalize(), PI - angle),
            Azimuths::BothSides => ((one - other).normalize(), angle),
        }
    }

    /// A ray along an edge that is chosen with the silhouettes by this measure.
    fn of_sides<'b>(
        &'b self,
        sides: &'b [u32],
        measure: f64,
        along: f64,
        (normal, direction): (DVec3, DVec3),
    ) -> Contour<'b> {
        let [a, b] = ends(self.geometry, sides[0]);
        let length = a.distance(b);
        Contour {
            point: a.lerp(b, along),
            direction,
            normal,
            slope: length.recip() / sides.len() as f64,
            even: self.total(),
            by_spread: self.silhouettes.total() / measure * length,
            edges: Place::Sides { geometry: self.geometry, sides },
        }
    }

    /// A tangent of a sphere, which is chosen by this measure.
    fn of_sphere(
        &self,
        index: u32,
        measure: f64,
        (normal, direction): (DVec3, DVec3),
    ) -> Contour<'_> {
        let radius = self.geometry.sphere(index as usize).radius;
        Contour {
            point: self.geometry.sphere(index as usize).center + normal * radius,
            direction,
            normal,
            slope: 0.5 / radius,
            even: self.total(),
            by_spread: self.silhouettes.total() / measure * TAU * radius,
            edges: Place::Sphere {
                primitive: index + self.geometry.layout.triangles.len() as u32,
                radius,
            },
        }
    }
}

impl Contour<'_> {
    /// The edges in this place; the rays have the same number of each.
    pub fn edges(&self) -> Vec<Edge> {
        match self.edges {
            Place::Sphere { primitive, .. } => vec![Edge::Silhouette(primitive)],
            Place::Sides { geometry, sides } => {
                let [from, _] = ends(geometry, sides[0]);
                let edge = |&side: &u32| {
                    let [a, b] = vertices(geometry, side);
                    Edge::Segment(if geometry.vertex(a) == from { [a, b] } else { [b, a] })
                };
                sides.iter().map(edge).collect()
            }
        }
    }

    /// Whether a primitive has the edge.
    pub fn is_of(&self, primitive: u32) -> bool {
        match self.edges {
            Place::Sphere { primitive: sphere, .. } => primitive == sphere,
            Place::Sides { sides, .. } => sides.iter().any(|side| side / 3 == primitive),
        }
    }

    /// The side on which no face is: 0 against the normal, 1 along it.
    pub fn lit_side(&self) -> Option<usize> {
        match self.edges {
            Place::Sphere { .. } => Some(1),
            Place::Sides { geometry, sides } => {
                let along = |side: &u32| inwards(geometry, *side).dot(self.normal);
                let has = |sign: f64| sides.iter().any(|side| sign * along(side) >= 0.0);
                match [has(-1.0), has(1.0)] {
                    [true, true] => None,
                    [is_against, _] => Some(usize::from(is_against)),
                }
            }
        }
    }

    /// One over the density of rays that are drawn towards lights, where the light is at this distance and has this
    /// spread.
    pub fn towards_light(&self, distance: f64, spread: f64) -> f64 {
        let of_circle = match self.edges {
            Place::Sphere { radius, .. } if distance.is_finite() => {
                distance / distance.hypot(radius)
            }
            _ => 1.0,
        };
        self.by_spread * of_circle * spread
    }
}

/// What the jump of light between two faces is thought to be.
fn jump(geometry: &Geometry<'_>, [one, other]: [u32; 2], turn: f64) -> f64 {
    if geometry.are_continuous(one, other) {
        return 0.0;
    }
    match geometry.layout.look_alike(one as usize, other as usize) {
        true => turn.min(1.0),
        false => 1.0,
    }
}

fn vertices(geometry: &Geometry<'_>, side: u32) -> [u32; 2] {
    sides(geometry.layout.triangles[side as usize / 3])[side as usize % 3]
}

fn ends(geometry: &Geometry<'_>, side: u32) -> [DVec3; 2] {
    vertices(geometry, side).map(|end| geometry.vertex(end))
}

/// The unit vector from an edge into the triangle.
fn inwards(geometry: &Geometry<'_>, side: u32) -> DVec3 {
    let [a, b] = ends(geometry, side);
    let corners = geometry.layout.triangles[side as usize / 3];
    let apex = geometry.vertex(corners[(side as usize % 3 + 2) % 3]);
    let along = (b - a).normalize();
    (apex - a - along * along.dot(apex - a)).normalize()
}

/// The even point of the unit sphere that two numbers from 0 to 1 choose.
pub fn on_sphere([around, across]: [f64; 2]) -> DVec3 {
    let z = 2.0 * across - 1.0;
    let (sin, cos) = (TAU * around).sin_cos();
    let flat = (1.0 - z * z).max(0.0).sqrt();
    DVec3::new(flat * cos, flat * sin, z)
}
