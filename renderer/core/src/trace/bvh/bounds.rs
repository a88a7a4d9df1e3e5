//! Boxes around shapes.

use glam::Vec3A;
use obvhs::aabb::Aabb;

use super::Shape;

/// The box around a shape.
pub fn bounds(shape: &Shape) -> Aabb {
    widened(match shape {
        &Shape::Triangle(corners) => Aabb::from_points(&corners.map(Vec3A::from)),
        &Shape::Sphere(center, radius) => {
            Aabb::new((center - radius).into(), (center + radius).into())
        }
        Shape::Custom(shape) => {
            let (low, high) = shape.bounds();
            Aabb::new(low.into(), high.into())
        }
    })
}

/// A box a few rounding errors wider: a slab test that rounds must not miss what lies on the face
/// of a box.
pub fn widened(exact: Aabb) -> Aabb {
    let margin = 4.0 * f32::EPSILON * exact.min.abs().max(exact.max.abs()).max_element();
    Aabb::new(exact.min - margin, exact.max + margin)
}
