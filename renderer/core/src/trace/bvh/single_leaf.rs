//! Leaves of one primitive that single rays are tested against: spheres, and custom shapes.

use std::sync::Arc;

use glam::Vec3;
use obvhs::aabb::Aabb;

use super::bounds::bounds;
use super::node::Leaf;
use super::{CustomShape, Shape, Shapes};

/// A leaf of one primitive.
pub trait SingleLeaf: Leaf {
    /// The index that the user knows the primitive by.
    fn id(&self) -> u32;

    /// The distance at which a ray enters the primitive or, from inside, leaves it, in lengths of its
    /// direction, and whether it leaves it; infinite if it misses it.
    fn distance(&self, origin: Vec3, direction: Vec3) -> (f32, bool);

    /// The times that a ray goes through the surface before `limit`, which is in lengths of its
    /// direction: for each whether it leaves the primitive.
    fn crossings(&self, origin: Vec3, direction: Vec3, limit: f32) -> impl Iterator<Item = bool>;
}

/// A sphere.
#[derive(Clone)]
pub struct SphereLeaf {
    id: u32,
    center: Vec3,
    radius: f32,
}

impl SingleLeaf for SphereLeaf {
    fn id(&self) -> u32 {
        self.id
    }

    fn distance(&self, origin: Vec3, direction: Vec3) -> (f32, bool) {
        sphere_distance(origin, direction, self.center, self.radius)
    }

    fn crossings(&self, origin: Vec3, direction: Vec3, limit: f32) -> impl Iterator<Item = bool> {
        let distances = sphere_distances(origin, direction, self.center, self.radius);
        let times = distances.into_iter().flatten().zip([false, true]);
        let is_hit = move |distance: f64| distance > 0.0 && (distance as f32) < limit;
        times.filter_map(move |(distance, leaves)| is_hit(distance).then_some(leaves))
    }
}

impl Leaf for SphereLeaf {
    const CAPACITY: usize = 1;

    fn new(members: &[u32]) -> Self {
        Self { id: members[0], center: Vec3::ZERO, radius: 0.0 }
    }

    fn load(&mut self, shapes: &dyn Shapes) -> bool {
        let Shape::Sphere(center, radius) = shapes.shape(self.id) else { return false };
        (self.center, self.radius) = (center, radius);
        true
    }

    fn bounds(&self) -> Aabb {
        bounds(&Shape::Sphere(self.center, self.radius))
    }
}

/// See [`SingleLeaf::distance`].
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

/// A custom shape.
#[derive(Clone)]
pub struct CustomLeaf {
    id: u32,
    shape: Option<Arc<dyn CustomShape>>,
}

impl SingleLeaf for CustomLeaf {
    fn id(&self) -> u32 {
        self.id
    }

    fn distance(&self, origin: Vec3, direction: Vec3) -> (f32, bool) {
        let distance = self.shape.as_ref().and_then(|shape| shape.distance(origin, direction));
        (distance.unwrap_or(f32::INFINITY), false)
    }

    fn crossings(&self, origin: Vec3, direction: Vec3, limit: f32) -> impl Iterator<Item = bool> {
        (self.distance(origin, direction).0 < limit).then_some(false).into_iter()
    }
}

impl Leaf for CustomLeaf {
    const CAPACITY: usize = 1;

    fn new(members: &[u32]) -> Self {
        Self { id: members[0], shape: None }
    }

    fn load(&mut self, shapes: &dyn Shapes) -> bool {
        let Shape::Custom(shape) = shapes.shape(self.id) else { return false };
        self.shape = Some(shape);
        true
    }

    fn bounds(&self) -> Aabb {
        match &self.shape {
            Some(shape) => bounds(&Shape::Custom(shape.clone())),
            None => Aabb::INVALID,
        }
    }
}
