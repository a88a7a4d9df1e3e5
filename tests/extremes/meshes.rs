//! Closed surfaces, and numbers without a pattern.

use glam::{DVec3, dvec3};

/// A closed surface of triangles: an octahedron, each side subdivided and pushed to the unit sphere.
pub struct Mesh {
    pub vertices: Vec<DVec3>,
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// With `8 * 4^subdivisions` triangles.
    pub fn sphere(subdivisions: u32) -> Self {
        let vertices = vec![DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z];
        let (up, down) = ([[0, 1], [1, 3], [3, 4], [4, 0]], 5);
        let mut triangles = Vec::new();
        for [a, b] in up {
            triangles.extend([[a, b, 2], [b, a, down]]);
        }
        let mut mesh = Self { vertices, triangles };
        for _ in 0..subdivisions {
            mesh.subdivide();
        }
        mesh
    }

    /// A sphere with bumps, whose vertices are no round numbers.
    pub fn bumpy(subdivisions: u32) -> Self {
        let mut mesh = Self::sphere(subdivisions);
        for v in &mut mesh.vertices {
            let bumps = (7.0 * v.x).sin() * (5.0 * v.y + 1.0).sin() * (6.0 * v.z + 2.0).cos();
            *v *= 1.0 + 0.3 * bumps;
        }
        mesh
    }

    fn subdivide(&mut self) {
        let mut middles = std::collections::HashMap::new();
        let vertices = &mut self.vertices;
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                vertices.push((vertices[a as usize] + vertices[b as usize]).normalize());
                vertices.len() as u32 - 1
            })
        };
        let split = |&[a, b, c]: &[u32; 3]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        self.triangles = self.triangles.iter().flat_map(split).collect();
    }

    /// The corners of each triangle.
    pub fn corners(&self) -> impl Iterator<Item = [DVec3; 3]> {
        self.triangles.iter().map(|t| t.map(|v| self.vertices[v as usize]))
    }
}

/// Numbers without a pattern (Steele, Lea & Flood, "Fast Splittable Pseudorandom Number Generators",
/// 2014).
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 to 1.
    pub fn number(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A point of the unit ball.
    pub fn in_ball(&mut self) -> DVec3 {
        loop {
            let mut coordinate = || 2.0 * self.number() - 1.0;
            let point = dvec3(coordinate(), coordinate(), coordinate());
            if point.length_squared() <= 1.0 {
                return point;
            }
        }
    }

    /// A unit vector.
    pub fn direction(&mut self) -> DVec3 {
        self.in_ball().normalize()
    }
}
