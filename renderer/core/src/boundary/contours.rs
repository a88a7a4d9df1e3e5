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
#[derive(Clone)]
pub struct Contours<'a> {
    geometry: &'a Geometry<'a>,
    /// 3 times a triangle, plus the side of it; those in one place follow each other.
    sides: Vec<u32>,
    silhouettes: Table,
    ridges: Table,
}

/// Edges, and by how much they are chosen.
#[derive(Clone, Default)]
struct Table {
    /// With the measure of the rays along each.
    entries: Vec<(Entry, f64)>,
    /// The sums of their weights.
    sums: Vec<f64>,
}

/// An edge that was chosen.
#[derive(Clone, Copy)]
struct Chosen {
    entry: Entry,
    /// The measure of the rays along it.
    measure: f64,
    weight: f64,
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
    /// Adds an edge; weights and measures of silhouettes are the same.
    fn add(&mut self, entry: Entry, measure: f64, weight: f64) {
        if weight > 0.0 && measure.is_finite() {
            self.entries.push((entry, measure));
            self.sums.push(self.total() + weight);
        }
    }

    /// Multiplies the weights.
    fn weigh(&mut self, factor: impl Fn(Entry) -> f64) {
        let (mut before, mut total) = (0.0, 0.0);
        for ((entry, _), sum) in self.entries.iter().zip(&mut self.sums) {
            total += (*sum - before) * factor(*entry);
            before = std::mem::replace(sum, total);
        }
    }

    fn total(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    /// The edge that a number from 0 up to the total chooses.
    fn choose(&self, number: f64) -> Option<Chosen> {
        let index =
            self.sums.partition_point(|&sum| sum <= number).min(self.sums.len().wrapping_sub(1));
        let before = index.checked_sub(1).map_or(0.0, |before| self.sums[before]);
        let &(entry, measure) = self.entries.get(index)?;
        Some(Chosen { entry, measure, weight: self.sums[index] - before })
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
            contours.silhouettes.add(Entry::Sphere(index as u32), measure, measure);
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
                self.silhouettes.add(entry(Azimuths::All), measure(TAU), measure(TAU));
                continue;
            };
            let angle = inwards(geometry, one).angle_between(inwards(geometry, other));
            let turn = PI - angle;
            if turn > LEAST_TURN {
                let measure = measure(2.0 * turn);
                self.silhouettes.add(entry(Azimuths::OneSide), measure, measure);
            }
            let jump = jump(geometry, [one / 3, other / 3], turn);
            let measure = measure(2.0 * angle);
            self.ridges.add(entry(Azimuths::BothSides), measure, measure * jump);
        }
    }

    /// A ray along an edge, by numbers from 0 to 1: one that chooses the edge, and three that choose the ray.
    pub fn evenly(&self, choice: f64, [along, around, across]: [f64; 3]) -> Option<Contour<'_>> {
        let number = choice * self.total();
        let of_silhouettes = self.silhouettes.total();
        let chosen = match number < of_silhouettes {
            true => self.silhouettes.choose(number)?,
            false => self.ridges.choose(number - of_silhouettes)?,
        };
        let (sides, azimuths) = match chosen.entry {
            Entry::Sphere(index) => {
                let normal = on_sphere([around, across]);
                let (u, v) = normal.any_orthonormal_pair();
                let (sin, cos) = (TAU * along).sin_cos();
                return Some(self.of_sphere(index, chosen, (normal, u * cos + v * sin)));
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
        Some(self.of_sides(sides, chosen, along, (normal, direction)))
    }

    /// A ray along a silhouette towards a light, by two numbers from 0 to 1; nothing if the edge that the first one
    /// chooses is not seen as one from there.
    pub fn towards(&self, choice: f64, along: f64, target: Target) -> Option<Contour<'_>> {
        let chosen = self.silhouettes.choose(choice * self.silhouettes.total())?;
        match chosen.entry {
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
                let contour = self.of_sphere(index, chosen, (normal, direction));
                (cosine > 0.0).then_some(contour)
            }
            Entry::Sides { first, count, .. } => {
                let sides = self.sides_of(first, count);
                let [a, b] = ends(self.geometry, sides[0]);
                let direction = target.direction_from(a.lerp(b, along));
                let normal = (b - a).cross(direction).normalize();
                let contour = self.of_sides(sides, chosen, along, (normal, direction));
                contour.lit_side().is_some().then_some(contour)
            }
        }
    }

    /// Chooses edges of the primitives of objects more or less often.
    pub fn weigh(&mut self, factor: impl Fn(u32) -> f64) {
        let triangles = self.geometry.layout.triangles.len() as u32;
        let sides = &self.sides;
        let of_entry = |entry: Entry| match entry {
            Entry::Sides { first, .. } => factor(sides[first as usize] / 3),
            Entry::Sphere(index) => factor(triangles + index),
        };
        self.silhouettes.weigh(of_entry);
        self.ridges.weigh(of_entry);
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

    /// A ray along an edge.
    fn of_sides<'b>(
        &'b self,
        sides: &'b [u32],
        chosen: Chosen,
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
            even: self.total() * chosen.measure / chosen.weight,
            by_spread: self.silhouettes.total() / chosen.weight * length,
            edges: Place::Sides { geometry: self.geometry, sides },
        }
    }

    /// A tangent of a sphere.
    fn of_sphere(
        &self,
        index: u32,
        chosen: Chosen,
        (normal, direction): (DVec3, DVec3),
    ) -> Contour<'_> {
        let radius = self.geometry.sphere(index as usize).radius;
        Contour {
            point: self.geometry.sphere(index as usize).center + normal * radius,
            direction,
            normal,
            slope: 0.5 / radius,
            even: self.total() * chosen.measure / chosen.weight,
            by_spread: self.silhouettes.total() / chosen.weight * TAU * radius,
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

    /// A primitive that has the edge.
    pub fn primitive(&self) -> u32 {
        match self.edges {
            Place::Sphere { primitive, .. } => primitive,
            Place::Sides { sides, .. } => sides[0] / 3,
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

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use ad::lanes::f64x8;
    use glam::{DVec3, dvec3};

    use super::{Contour, Contours, Target, on_sphere};
    use crate::edges::{Edge, Geometry};
    use crate::primal::integrator::Prepared;
    use crate::scene::{Camera, Material, Mesh, Scene, SphereObject};
    use crate::settings::Settings;
    use crate::trace::random::path_numbers;

    /// A box of this size about the origin, with corners of its own in each face if it is `loose`.
    fn add_box(scene: &mut Scene, size: DVec3, loose: bool) {
        let corner = |i: u32| {
            let sign = |axis: u32| if i >> axis & 1 == 0 { -0.5 } else { 0.5 };
            (size * dvec3(sign(0), sign(1), sign(2))).to_array()
        };
        let faces: [[u32; 4]; 6] =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let (vertices, faces): (Vec<_>, Vec<_>) = match loose {
            false => ((0..8).map(corner).collect(), faces.to_vec()),
            true => {
                let of_faces = faces.as_flattened().iter().map(|&i| corner(i)).collect();
                (of_faces, (0..6).map(|i| [0, 1, 2, 3].map(|j| 4 * i + j)).collect())
            }
        };
        let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
        scene.add_mesh(Mesh::new("box", vertices, triangles.collect())).unwrap();
    }

    fn with_contours(scene: &Scene, test: impl Fn(&Contours<'_>)) {
        let prepared = Prepared::<f64x8>::new(scene, Settings::default());
        let geometry = Geometry::new(prepared.integrator());
        test(&Contours::new(&geometry));
    }

    /// How fast the shadow of a convex body about the origin grows with it, as a ray along its outline tells.
    fn growth(contours: &Contours<'_>, contour: &Contour<'_>) -> f64 {
        let Some(side) = contour.lit_side() else { return 0.0 };
        let outwards = if side == 1 { contour.normal } else { -contour.normal };
        let sine = match contour.edges()[0] {
            Edge::Segment(ends) => {
                let [a, b] = ends.map(|end| contours.geometry.vertex(end));
                (b - a).normalize().cross(contour.direction).length()
            }
            _ => 1.0,
        };
        sine * outwards.dot(contour.point)
    }

    /// The mean shadow of a convex body is a quarter of its surface (Cauchy), and twice as much is how fast it grows:
    /// over all directions, 2 pi times the surface, however rays are drawn.
    #[test]
    fn the_shadows_of_convex_bodies_are_a_quarter_of_their_surface() {
        let size = dvec3(1.0, 0.6, 1.5);
        let surface = 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
        let mut scene = Scene::new(1, 1, Camera::looking(DVec3::Z * 5.0, DVec3::ZERO));
        scene.add_material("grey", Material::lambertian(DVec3::ONE)).unwrap();
        add_box(&mut scene, size, false);
        let mut loose = scene.clone();
        loose.meshes.clear();
        add_box(&mut loose, size, true);
        let mut ball = scene.clone();
        ball.meshes.clear();
        ball.add_sphere(SphereObject::new("ball", DVec3::ZERO, 0.7)).unwrap();
        for (scene, surface) in
            [(&scene, surface), (&loose, surface), (&ball, 4.0 * PI * 0.7 * 0.7)]
        {
            with_contours(scene, |contours| {
                let count = 1 << 14;
                let (mut evenly, mut towards) = (0.0, 0.0);
                for index in 0..count {
                    let [choice, along, u, v] = path_numbers(index, 0, 1);
                    if let Some(contour) = contours.evenly(choice, [along, u, v]) {
                        evenly += contour.even * growth(contours, &contour);
                    }
                    let target = Target::Direction(on_sphere([u, v]));
                    if let Some(contour) = contours.towards(choice, along, target) {
                        let density = contour.towards_light(f64::INFINITY, 4.0 * PI);
                        towards += density * growth(contours, &contour);
                    }
                }
                for sum in [evenly, towards] {
                    let (mean, expected) = (sum / f64::from(count), 2.0 * PI * surface);
                    assert!((mean - expected).abs() < 0.01 * expected, "{mean} {expected}");
                }
            });
        }
    }
}
