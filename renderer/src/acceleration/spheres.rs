//! Spheres.

use glam::Vec3;
use obvhs::aabb::Aabb;

use super::bounds::bounds;
use super::tree::Leaf;
use super::{Shape, Shapes};

/// A sphere, alone in its leaf.
pub struct SphereLeaf {
    /// The index that the user knows it by.
    pub id: u32,
    pub center: Vec3,
    pub radius: f32,
}

impl SphereLeaf {
    /// The distance at which a ray enters or, from inside, leaves the sphere, in lengths of its
    /// direction, and whether it leaves it; infinite if it misses it.
    pub fn distance(&self, origin: Vec3, direction: Vec3) -> (f32, bool) {
        sphere_distance(origin, direction, self.center, self.radius)
    }

    /// The times that a ray goes through the surface of the sphere before `limit`, which is in lengths of
    /// its direction: for each whether it leaves the sphere.
    pub fn crossings(
        &self,
        origin: Vec3,
        direction: Vec3,
        limit: f32,
    ) -> impl Iterator<Item = bool> {
        let distances = sphere_distances(origin, direction, self.center, self.radius);
        let times = distances.into_iter().flatten().zip([false, true]);
        let is_met = move |distance: f64| distance > 0.0 && (distance as f32) < limit;
        times.filter_map(move |(distance, leaves)| is_met(distance).then_some(leaves))
    }
}

impl Leaf for SphereLeaf {
    const CAPACITY: usize = 1;

    fn new(members: &[u32]) -> Self {
        Self { id: members[0], center: Vec3::ZERO, radius: 0.0 }
    }

    fn load(&mut self, shapes: &(impl Shapes + ?Sized)) -> bool {
        let Shape::Sphere(center, radius) = shapes.shape(self.id) else { return false };
        (self.center, self.radius) = (center, radius);
        true
    }

    fn bounds(&self) -> Aabb {
        bounds(&Shape::Sphere(self.center, self.radius))
    }
}

/// See [`SphereLeaf::distance`].
pub fn sphere_distance(origin: Vec3, direction: Vec3, center: Vec3, radius: f32) -> (f32, bool) {
    match sphere_distances(origin, direction, center, radius) {
        Some([near, _]) if near > 0.0 => (near as f32, false),
        Some([_, far]) if far > 0.0 => (far as f32, true),
        _ => (f32::INFINITY, false),
    }
}

/// The distances at which a line enters and leaves a sphere, in lengths of its direction. Computed in
/// double precision: a sphere that is small or far would lose its edge in single.
#[inline]
fn sphere_distances(origin: Vec3, direction: Vec3, center: Vec3, radius: f32) -> Option<[f64; 2]> {
    let (direction, radius) = (direction.as_dvec3(), f64::from(radius));
    let from_center = origin.as_dvec3() - center.as_dvec3();
    let along = -from_center.dot(direction) / direction.length_squared();
    let offset = from_center + direction * along;
    let discriminant = radius * radius - offset.length_squared();
    if discriminant < 0.0 {
        return None;
    }
    let half_chord = (discriminant / direction.length_squared()).sqrt();
    Some([along - half_chord, along + half_chord])
}
