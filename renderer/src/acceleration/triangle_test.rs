//! A watertight test of a ray against triangles.
//!
//! Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: corners are
//! sheared into a space in which the ray is the z axis. An edge shared by two triangles gives both
//! the same sheared corners and thus edge functions of exactly opposite sign, so no ray slips
//! through between them. Where an edge function is 0 in single precision it is taken again in
//! double, in which products of two `f32` are exact.

use glam::Vec3;

/// A ray, prepared.
pub struct TriangleTest {
    origin: Vec3,
    /// The axis along which the ray advances most, and the other two so that the handedness stays.
    axes: [usize; 3],
    shear: Vec3,
}

impl TriangleTest {
    /// Prepares a ray; nothing if its direction is zero or not finite.
    pub fn new(origin: Vec3, direction: Vec3) -> Option<Self> {
        let magnitude = direction.abs();
        let z = magnitude.max_position();
        if !direction.is_finite() || magnitude[z] == 0.0 {
            return None;
        }
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        if direction[z] < 0.0 {
            std::mem::swap(&mut x, &mut y);
        }
        let shear = Vec3::new(direction[x], direction[y], 1.0) / direction[z];
        Some(Self { origin, axes: [x, y, z], shear })
    }

    /// The distance at which the ray meets the triangle, in lengths of the ray's direction;
    /// infinite if it misses it or runs along it.
    pub fn distance(&self, corners: [Vec3; 3]) -> f32 {
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

        let distance = self.shear.z * (u * a.z + v * b.z + w * c.z) / area;
        if distance > 0.0 { distance } else { f32::INFINITY }
    }

    /// A corner in the space of the ray; its z is not scaled yet.
    fn shear(&self, corner: Vec3) -> Vec3 {
        let [x, y, z] = self.axes;
        let p = corner - self.origin;
        Vec3::new(p[x] - self.shear.x * p[z], p[y] - self.shear.y * p[z], p[z])
    }
}

fn exact_area(p: Vec3, q: Vec3) -> f32 {
    (f64::from(p.x) * f64::from(q.y) - f64::from(p.y) * f64::from(q.x)) as f32
}
