//! Triangles that know their neighbours.

use glam::DVec3;
use renderer_core::scene::Mesh;

use super::Remeshed;

/// In place of the corners of a triangle that is no more.
const GONE: [u32; 3] = [u32::MAX; 3];

/// A surface whose triangles change.
pub(super) struct Surface {
    pub points: Vec<DVec3>,
    pub origins: Vec<Vec<(u32, f64)>>,
    /// Whether a vertex stays where it is: on borders, between materials, where the surface is none.
    pub is_fixed: Vec<bool>,
    pub triangles: Vec<[u32; 3]>,
    materials: Vec<u32>,
    /// The triangles at each vertex.
    around: Vec<Vec<u32>>,
}

/// A triangle at an edge, and its third vertex.
#[derive(Clone, Copy)]
pub(super) struct Side {
    pub triangle: u32,
    pub apex: u32,
}

/// What is on both sides of an edge from one vertex to another.
pub(super) enum Edge {
    /// Two triangles of one material that face the same way: the one that goes along the edge, and the one against it.
    Inner(Side, Side),
    /// A border, or two materials.
    Line(Side, Option<Side>),
    /// No surface.
    Other,
}

impl Surface {
    pub fn new(mesh: &Mesh) -> Self {
        let count = mesh.vertices.len();
        let mut around = vec![Vec::new(); count];
        for (index, corners) in (0..).zip(&mesh.triangles) {
            for (place, &corner) in corners.iter().enumerate() {
                if !corners[..place].contains(&corner) {
                    around[corner as usize].push(index);
                }
            }
        }
        let mut surface = Self {
            points: mesh.vertices.iter().map(|&vertex| vertex.into()).collect(),
            origins: (0..count as u32).map(|index| vec![(index, 1.0)]).collect(),
            is_fixed: vec![false; count],
            triangles: mesh.triangles.clone(),
            materials: mesh.materials.clone(),
            around,
        };
        surface.is_fixed = (0..count as u32).map(|vertex| !surface.is_disc(vertex)).collect();
        surface
    }

    /// Whether the triangles around a vertex are one closed fan of one material.
    fn is_disc(&self, vertex: u32) -> bool {
        let around = &self.around[vertex as usize];
        let Some(&first) = around.first() else { return false };
        let (mut triangle, mut steps) = (first, 0);
        loop {
            let corners = self.triangles[triangle as usize];
            let Some(place) = corners.iter().position(|&corner| corner == vertex) else {
                return false;
            };
            let last = corners[(place + 2) % 3];
            // From the vertex to the last corner the next triangle goes.
            let Edge::Inner(next, _) = self.edge(vertex, last) else { return false };
            (triangle, steps) = (next.triangle, steps + 1);
            if triangle == first || steps > around.len() {
                return steps == around.len();
            }
        }
    }

    /// The triangles around a vertex.
    pub fn around(&self, vertex: u32) -> &[u32] {
        &self.around[vertex as usize]
    }

    /// What lies at the edge from `a` to `b`.
    pub fn edge(&self, a: u32, b: u32) -> Edge {
        let (mut along, mut against) = (None, None);
        for &triangle in self.around(a) {
            let corners = self.triangles[triangle as usize];
            if !corners.contains(&b) {
                continue;
            }
            let Some(&apex) = corners.iter().find(|&&corner| corner != a && corner != b) else {
                return Edge::Other;
            };
            let place = corners.iter().position(|&corner| corner == a).unwrap_or(0);
            let side = if corners[(place + 1) % 3] == b { &mut along } else { &mut against };
            if side.is_some() {
                return Edge::Other;
            }
            *side = Some(Side { triangle, apex });
        }
        match (along, against) {
            (Some(one), Some(other)) if one.apex == other.apex => Edge::Other,
            (Some(one), Some(other)) if self.material(one) == self.material(other) => {
                Edge::Inner(one, other)
            }
            (Some(one), other) | (other, Some(one)) => Edge::Line(one, other),
            (None, None) => Edge::Other,
        }
    }

    fn material(&self, side: Side) -> u32 {
        self.materials[side.triangle as usize]
    }

    /// All edges, each once, from the vertex of the smaller index.
    pub fn edges(&self) -> Vec<[u32; 2]> {
        let alive = self.triangles.iter().filter(|corners| **corners != GONE);
        let of_triangle = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        let mut edges: Vec<_> = alive
            .flat_map(of_triangle)
            .filter(|[a, b]| a != b)
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// The vertices that share a triangle with a vertex, in ascending order.
    pub fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let corners = self.around(vertex).iter().flat_map(|&index| self.triangles[index as usize]);
        let mut neighbours: Vec<u32> = corners.filter(|&corner| corner != vertex).collect();
        neighbours.sort_unstable();
        neighbours.dedup();
        neighbours
    }

    pub fn length(&self, [a, b]: [u32; 2]) -> f64 {
        self.points[a as usize].distance(self.points[b as usize])
    }

    /// The places of corners.
    pub fn places(&self, corners: [u32; 3]) -> [DVec3; 3] {
        corners.map(|corner| self.points[corner as usize])
    }

    /// Twice the area of a triangle with these corners, along its normal.
    pub fn normal_of(&self, corners: [u32; 3]) -> DVec3 {
        normal(self.places(corners))
    }

    /// That of a triangle.
    pub fn normal(&self, triangle: u32) -> DVec3 {
        self.normal_of(self.triangles[triangle as usize])
    }

    /// Whether neighbours would face against each other, if triangles with these corners, at these places, took the
    /// place of the `replaced` ones, where no neighbours do now.
    pub fn adds_folds(
        &self,
        replaced: &[u32],
        triangles: &[[u32; 3]],
        place: impl Fn(u32) -> DVec3,
    ) -> bool {
        let now: Vec<_> = replaced.iter().map(|&index| self.triangles[index as usize]).collect();
        self.has_folds(replaced, triangles, place)
            && !self.has_folds(replaced, &now, |corner| self.points[corner as usize])
    }

    fn has_folds(
        &self,
        replaced: &[u32],
        triangles: &[[u32; 3]],
        place: impl Fn(u32) -> DVec3,
    ) -> bool {
        let normals: Vec<DVec3> =
            triangles.iter().map(|corners| normal(corners.map(&place))).collect();
        (0..triangles.len()).any(|index| {
            let is_against = |other: DVec3| other.dot(normals[index]) < 0.0;
            let [a, b, c] = triangles[index];
            let is_neighbour = |other: &[u32; 3]| {
                [a, b, c].iter().filter(|corner| other.contains(corner)).count() == 2
            };
            let mut among = triangles[..index].iter().zip(&normals);
            let mut sides = [[a, b], [b, c], [c, a]].into_iter();
            among.any(|(other, &normal)| is_against(normal) && is_neighbour(other))
                || sides.any(|[from, to]| {
                    self.around(from).iter().any(|triangle| {
                        self.triangles[*triangle as usize].contains(&to)
                            && !replaced.contains(triangle)
                            && is_against(self.normal(*triangle))
                    })
                })
        })
    }

    /// Adds a vertex in the middle of two.
    pub fn add_middle(&mut self, a: u32, b: u32, is_fixed: bool) -> u32 {
        let [one, other] = [a, b].map(|vertex| self.points[vertex as usize]);
        self.points.push(one.midpoint(other));
        self.origins.push(middle(&self.origins[a as usize], &self.origins[b as usize]));
        self.is_fixed.push(is_fixed);
        self.around.push(Vec::new());
        self.points.len() as u32 - 1
    }

    /// Adds a triangle of the material of another.
    pub fn add(&mut self, corners: [u32; 3], like: u32) {
        let index = self.triangles.len() as u32;
        self.triangles.push(corners);
        self.materials.push(self.materials[like as usize]);
        corners.iter().for_each(|&corner| self.around[corner as usize].push(index));
    }

    /// Takes a triangle away.
    pub fn remove(&mut self, triangle: u32) {
        for corner in self.triangles[triangle as usize] {
            self.around[corner as usize].retain(|&other| other != triangle);
        }
        self.triangles[triangle as usize] = GONE;
    }

    /// Puts another vertex in the place of a corner.
    pub fn replace(&mut self, triangle: u32, from: u32, to: u32) {
        for corner in &mut self.triangles[triangle as usize] {
            if *corner == from {
                *corner = to;
            }
        }
        self.around[from as usize].retain(|&other| other != triangle);
        self.around[to as usize].push(triangle);
    }

    /// What is left, without holes in the numbers.
    pub fn finish(self, mesh: &Mesh) -> Remeshed {
        let mut places = vec![u32::MAX; self.points.len()];
        let (mut vertices, mut origins) = (Vec::new(), Vec::new());
        let (mut triangles, mut materials) = (Vec::new(), Vec::new());
        for (corners, material) in self.triangles.into_iter().zip(self.materials) {
            if corners == GONE {
                continue;
            }
            triangles.push(corners);
            materials.push(material);
        }
        let mut is_used = vec![false; self.points.len()];
        triangles.as_flattened().iter().for_each(|&corner| is_used[corner as usize] = true);
        for (vertex, origin) in
            self.origins.into_iter().enumerate().filter(|(vertex, _)| is_used[*vertex])
        {
            places[vertex] = vertices.len() as u32;
            vertices.push(self.points[vertex].to_array());
            origins.push(origin);
        }
        triangles
            .as_flattened_mut()
            .iter_mut()
            .for_each(|corner| *corner = places[*corner as usize]);
        let mesh = Mesh {
            vertices,
            triangles,
            materials,
            texture_coordinates: Vec::new(),
            texture_triangles: Vec::new(),
            name: mesh.name.clone(),
            normals: mesh.normals.clone(),
            transform: mesh.transform,
        };
        Remeshed { mesh, origins }
    }
}

/// The mean of two weighted lists.
pub(super) fn middle(one: &[(u32, f64)], other: &[(u32, f64)]) -> Vec<(u32, f64)> {
    let mut all: Vec<(u32, f64)> =
        one.iter().chain(other).map(|&(index, weight)| (index, 0.5 * weight)).collect();
    all.sort_by_key(|(index, _)| *index);
    all.dedup_by(|(index, weight), (kept, sum)| {
        let is_same = index == kept;
        *sum += if is_same { *weight } else { 0.0 };
        is_same
    });
    all
}

/// No triangle becomes narrower than this, by its [`width`], unless it has been so before: the normal of one that is
/// almost a line is rounding, and says nothing of whether it turns over.
pub(super) const LEAST_WIDTH: f64 = 0.05;

/// Twice the area of a triangle with corners at these places, along its normal.
pub(super) fn normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// The height of a triangle over its longest side, in units of that.
pub(super) fn width([a, b, c]: [DVec3; 3]) -> f64 {
    let longest = a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a));
    if longest > 0.0 { normal([a, b, c]).length() / longest } else { 0.0 }
}

/// Whether two normals, of any length above 0, are within 60 degrees of each other.
pub(super) fn are_alike(one: DVec3, other: DVec3) -> bool {
    let product = one.dot(other);
    product > 0.5 * one.length() * other.length() && product > 0.0
}
