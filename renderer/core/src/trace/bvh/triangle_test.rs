//! A watertight test of a ray against triangles.
//!
//! Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: corners are
//! sheared into a space in which the ray is an axis. An edge shared by two triangles gives both
//! the same sheared corners and thus edge functions of exactly opposite sign, so no ray slips
//! through between them. Where an edge function is 0 in single precision it is taken again in
//! double, in which products of two `f32` are exact.

use glam::Vec3;
use wide::f32x8;

use super::triangle_leaf::TriangleLeaf;

/// A ray, prepared. What it finds are depths: along its major axis, on which its direction has the
/// length 1.
#[derive(Clone, Copy)]
pub struct TriangleTest {
    pub origin: Vec3,
    /// The major axis, along which the ray advances.
    pub major: usize,
    /// 1 if the ray advances towards greater coordinates on that axis, else -1.
    pub sign: f32,
    /// How much the ray advances on the two axes after the major one for each unit of depth.
    pub slope: [f32; 2],
    /// Distance, in lengths of the direction, for each unit of depth.
    pub scale: f32,
}

impl TriangleTest {
    /// Prepares a ray; nothing if its direction is zero (or less than the least normal number) or not
    /// finite.
    #[inline]
    pub fn new(origin: Vec3, direction: Vec3) -> Option<Self> {
        let [x, y, z] = direction.abs().to_array();
        let major = if x >= y && x >= z { 0 } else { 1 + usize::from(z > y) };
        Self::along(origin, direction, major)
    }

    /// Prepares a ray with a choice of axis, on which it has to advance.
    #[inline]
    pub fn along(origin: Vec3, direction: Vec3, major: usize) -> Option<Self> {
        let length = direction[major].abs();
        if !direction.is_finite() || length < f32::MIN_POSITIVE {
            return None;
        }
        let [a, b] = minor_axes(major);
        let scale = 1.0 / length;
        Some(Self {
            origin,
            major,
            sign: 1.0_f32.copysign(direction[major]),
            slope: [direction[a] * scale, direction[b] * scale],
            scale,
        })
    }

    /// The depth at which the ray meets the triangle; infinite if it misses it or runs along it.
    pub fn depth(&self, corners: [Vec3; 3]) -> f32 {
        let [a, b, c] = corners.map(|corner| self.shear(corner));

        // Signed areas, each opposite to a corner.
        let mut u = c.x * b.y - c.y * b.x;
        let mut v = a.x * c.y - a.y * c.x;
        let mut w = b.x * a.y - b.y * a.x;
        if u == 0.0 || v == 0.0 || w == 0.0 {
            u = exact_area(c, b);
            v = exact_area(a, c);
            w = exact_area(b, a);
        }
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return f32::INFINITY;
        }
        let area = u + v + w;
        if area == 0.0 {
            return f32::INFINITY;
        }

        let inverse = 1.0 / area;
        let depth = (u * inverse) * a.z + (v * inverse) * b.z + (w * inverse) * c.z;
        if depth > 0.0 { depth } else { f32::INFINITY }
    }

    /// The same for every triangle of a leaf, with the same roundings.
    #[inline]
    pub fn depths(&self, leaf: &TriangleLeaf) -> f32x8 {
        let [a, b, c] = &leaf.corners;
        let (a, b, c) = (self.shear_all(a), self.shear_all(b), self.shear_all(c));

        // Not fused: the two triangles at an edge have to get exactly opposite values.
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let (low, high) = (u.fast_min(v).fast_min(w), u.fast_max(v).fast_max(w));
        let zero = f32x8::ZERO;
        let inside = low.simd_ge(zero) | high.simd_le(zero);
        let bits = inside.to_bitmask() & leaf.mask;
        if bits == 0 {
            return f32x8::INFINITY;
        }
        let inverse = f32x8::ONE / (u + v + w);
        let depth = (u * inverse) * a[2] + (v * inverse) * b[2] + (w * inverse) * c[2];
        let hit = inside & depth.simd_gt(zero);
        let mut depths = hit.select(depth, f32x8::INFINITY);

        let on_edge = u.simd_eq(zero) | v.simd_eq(zero) | w.simd_eq(zero);
        let mut unsure = on_edge.to_bitmask() & bits;
        while unsure != 0 {
            let lane = unsure.trailing_zeros() as usize;
            unsure &= unsure - 1;
            depths.as_mut_array()[lane] = self.depth(leaf.triangle(lane));
        }
        depths
    }

    /// Corners side by side in the space of the ray.
    // Always inline: a call passes everything through memory.
    #[inline(always)]
    fn shear_all(&self, corners: &[f32x8; 3]) -> [f32x8; 3] {
        let [a, b] = minor_axes(self.major);
        let from_origin = |axis: usize| corners[axis] - f32x8::splat(self.origin[axis]);
        let depth = from_origin(self.major) * f32x8::splat(self.sign);
        [
            from_origin(a) - f32x8::splat(self.slope[0]) * depth,
            from_origin(b) - f32x8::splat(self.slope[1]) * depth,
            depth,
        ]
    }

    /// A corner in the space of the ray.
    fn shear(&self, corner: Vec3) -> Vec3 {
        let [a, b] = minor_axes(self.major);
        let p = corner - self.origin;
        let depth = p[self.major] * self.sign;
        Vec3::new(p[a] - self.slope[0] * depth, p[b] - self.slope[1] * depth, depth)
    }
}

/// The two axes after an axis.
#[inline]
pub fn minor_axes(major: usize) -> [usize; 2] {
    [[1, 2], [2, 0], [0, 1]][major]
}

fn exact_area(p: Vec3, q: Vec3) -> f32 {
    (f64::from(p.x) * f64::from(q.y) - f64::from(p.y) * f64::from(q.x)) as f32
}
