//! A low-poly conifer: a trunk, and three tiers of branches as jittered cones.

use std::f64::consts::TAU;

/// A tree that stands on the plane y = 0, about 3.5 units tall.
#[derive(Clone, Debug, PartialEq)]
pub struct LowPolyTree {
    /// The vertices, in the order in which the triangles first use them.
    pub vertices: Vec<[f64; 3]>,
    /// Three indices into `vertices` for each triangle, counterclockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// How many of the triangles, the first ones, are the trunk; the others are the leaves.
    pub trunk: usize,
}

/// The vertices around the trunk.
const TRUNK_SIDES: usize = 7;
/// The vertices around a tier.
const TIER_SIDES: usize = 11;
/// Heights of the rim and the tip of each tier, and the radius of its rim.
const TIERS: [(f64, f64, f64); 3] = [(0.7, 2.2, 1.1), (1.5, 2.9, 0.9), (2.25, 3.5, 0.65)];

/// Makes the tree; always the same one.
pub fn low_poly_tree() -> LowPolyTree {
    let mut solid = Solid::default();
    let foot = solid.ring(TRUNK_SIDES, 0.0, 0.2, 0.0);
    let neck = solid.ring(TRUNK_SIDES, 0.95, 0.13, 0.1);
    let ground = solid.vertex([0.0, 0.0, 0.0]);
    solid.band(&foot, &neck);
    solid.underside(ground, &foot);
    let trunk = solid.triangles.len();

    for (rim, tip, radius) in TIERS {
        let height = tip - rim;
        let skirt = solid.ring(TIER_SIDES, rim, radius, 0.15);
        let middle = solid.ring(TIER_SIDES, rim + 0.4 * height, 0.55 * radius, 0.1);
        let below = solid.vertex([0.0, rim + 0.12 * height, 0.0]);
        let tip = solid.vertex([0.0, tip, 0.0]);
        solid.band(&skirt, &middle);
        solid.cap(&middle, tip);
        solid.underside(below, &skirt);
    }
    solid.into_tree(trunk)
}

/// Vertices and triangles as they are added.
#[derive(Default)]
struct Solid {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Solid {
    fn vertex(&mut self, position: [f64; 3]) -> u32 {
        self.vertices.push(position);
        (self.vertices.len() - 1) as u32
    }

    /// Vertices around the y axis, each moved by up to `jitter` times the radius.
    fn ring(&mut self, sides: usize, y: f64, radius: f64, jitter: f64) -> Vec<u32> {
        let vertex = |i| {
            let seed = 3 * self.vertices.len() as u64;
            let [angle, stretch, lift] = [seed, seed + 1, seed + 2].map(jittered);
            let angle = TAU * (i as f64 + jitter * angle) / sides as f64;
            let stretched = radius * (1.0 + jitter * stretch);
            let (sin, cos) = angle.sin_cos();
            self.vertex([stretched * cos, y + jitter * radius * lift, stretched * sin])
        };
        (0..sides).map(vertex).collect()
    }

    /// Two triangles for each side between a ring and the one above it.
    fn band(&mut self, lower: &[u32], upper: &[u32]) {
        for i in 0..lower.len() {
            let j = (i + 1) % lower.len();
            self.triangles.push([lower[i], upper[i], lower[j]]);
            self.triangles.push([lower[j], upper[i], upper[j]]);
        }
    }

    /// A triangle for each side between a ring and a point above it.
    fn cap(&mut self, ring: &[u32], tip: u32) {
        for i in 0..ring.len() {
            self.triangles.push([ring[i], tip, ring[(i + 1) % ring.len()]]);
        }
    }

    /// A triangle for each side between a ring and a point within it, seen from below.
    fn underside(&mut self, center: u32, ring: &[u32]) {
        for i in 0..ring.len() {
            self.triangles.push([ring[i], ring[(i + 1) % ring.len()], center]);
        }
    }

    /// Sorts the vertices by their first use, as files do.
    fn into_tree(self, trunk: usize) -> LowPolyTree {
        let mut order = vec![None; self.vertices.len()];
        let mut vertices = Vec::new();
        let mut renumber = |old: u32| {
            *order[old as usize].get_or_insert_with(|| {
                vertices.push(self.vertices[old as usize]);
                (vertices.len() - 1) as u32
            })
        };
        let triangles = self.triangles.iter().map(|corners| corners.map(&mut renumber)).collect();
        LowPolyTree { vertices, triangles, trunk }
    }
}

/// A number in [-1, 1) that looks random (the finaliser of SplitMix64).
fn jittered(seed: u64) -> f64 {
    let mut bits = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^= bits >> 31;
    // The upper 53 bits, exactly.
    (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use glam::DVec3;

    use super::*;

    #[test]
    fn the_tree_stands_on_the_ground() {
        let tree = low_poly_tree();
        assert!((100..=250).contains(&tree.triangles.len()), "{}", tree.triangles.len());
        let heights = tree.vertices.iter().map(|v| v[1]);
        assert_eq!(heights.clone().fold(f64::INFINITY, f64::min), 0.0);
        assert_eq!(heights.fold(0.0, f64::max), 3.5);
        // Two crowded vertices would be a fault in the jitter.
        for triangle in &tree.triangles {
            let [a, b, c] = triangle.map(|i| DVec3::from_array(tree.vertices[i as usize]));
            assert!((b - a).cross(c - a).length() > 1e-3);
        }
    }

    #[test]
    fn the_surface_is_oriented() {
        let tree = low_poly_tree();
        // Within a closed surface, every edge is passed once each way; only the trunk is open, at
        // its upper end.
        let mut passes: HashMap<(u32, u32), i32> = HashMap::new();
        for [a, b, c] in &tree.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *passes.entry((*from.min(to), *from.max(to))).or_default() +=
                    if from < to { 1 } else { -1 };
            }
        }
        assert_eq!(passes.values().filter(|&&sum| sum != 0).count(), TRUNK_SIDES);
        // The sides of the lowest tier face away from the axis.
        let [a, b, c] =
            tree.triangles[tree.trunk].map(|i| DVec3::from_array(tree.vertices[i as usize]));
        let outward = DVec3::new(a.x + b.x + c.x, 0.0, a.z + b.z + c.z);
        assert!((b - a).cross(c - a).dot(outward) > 0.0);
    }
}
