//! Tests of traversal: single rays, packets, moving shapes.

mod batches;
mod packets;
mod refit;
mod single;

use std::fmt;

use glam::Vec3;
use proptest::prelude::*;

use super::*;

fn point(range: std::ops::Range<f32>) -> impl Strategy<Value = Vec3> {
    proptest::array::uniform3(range).prop_map(Vec3::from)
}

fn shape() -> impl Strategy<Value = Shape> {
    let triangle = (point(-5.0..5.0), proptest::array::uniform2(point(-1.0..1.0)))
        .prop_map(|(a, [b, c])| Shape::Triangle([a, a + b, a + c]));
    let sphere = (point(-5.0..5.0), 0.1..0.8_f32).prop_map(|(c, r)| Shape::Sphere(c, r));
    let custom = (point(-5.0..5.0), 0.1..0.8_f32).prop_map(|(c, r)| custom_ball(c, r));
    prop_oneof![4 => triangle, 1 => sphere, 1 => custom]
}

impl fmt::Debug for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Triangle(corners) => write!(f, "triangle {corners:?}"),
            Self::Sphere(center, radius) => write!(f, "sphere {center} {radius}"),
            Self::Custom(shape) => write!(f, "custom shape {:?}", shape.bounds()),
        }
    }
}

/// A ball that traversal knows as a custom shape. Rays start on it or come from outside.
struct Ball {
    center: Vec3,
    radius: f32,
}

fn custom_ball(center: Vec3, radius: f32) -> Shape {
    Shape::Custom(Arc::new(Ball { center, radius }))
}

impl CustomShape for Ball {
    fn bounds(&self) -> (Vec3, Vec3) {
        (self.center - self.radius, self.center + self.radius)
    }

    fn distance(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        let (distance, _) = sphere_distance(origin, direction, self.center, self.radius);
        distance.is_finite().then_some(distance)
    }
}

/// A closed surface of triangles: an octahedron, each side subdivided and pushed to the sphere.
fn closed_surface(subdivisions: u32) -> Vec<[Vec3; 3]> {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z];
    let mut triangles = Vec::new();
    for signs in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|i| if signs >> i & 1 == 0 { axes[i] } else { -axes[i] });
        triangles.push([x, y, z]);
    }
    for _ in 0..subdivisions {
        triangles = triangles
            .into_iter()
            .flat_map(|[a, b, c]| {
                let middle = |p: Vec3, q: Vec3| (p + q).normalize();
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    triangles
}

/// The triangles of a surface, scaled, then moved.
fn placed(triangles: &[[Vec3; 3]], scale: f32, offset: Vec3) -> Vec<[Vec3; 3]> {
    triangles.iter().map(|corners| corners.map(|corner| corner * scale + offset)).collect()
}

/// Corners of a triangle and points on its edges.
fn edge_points([a, b, c]: [Vec3; 3]) -> [Vec3; 6] {
    [a, b, c, a.midpoint(b), b.midpoint(c), a.lerp(c, 0.3)]
}

fn scaled(shape: &Shape, scale: f32) -> Shape {
    mapped(shape, |point| point * scale, scale)
}

fn moved(shape: &Shape, step: Vec3) -> Shape {
    mapped(shape, |point| point + step, 1.0)
}

/// A shape whose points are elsewhere, and whose radius is `scale` times as large.
fn mapped(shape: &Shape, place: impl Fn(Vec3) -> Vec3, scale: f32) -> Shape {
    match shape {
        &Shape::Triangle(corners) => Shape::Triangle(corners.map(place)),
        &Shape::Sphere(center, radius) => Shape::Sphere(place(center), radius * scale),
        Shape::Custom(ball) => {
            let (low, high) = ball.bounds();
            custom_ball(place(low.midpoint(high)), 0.5 * (high.x - low.x) * scale)
        }
    }
}
