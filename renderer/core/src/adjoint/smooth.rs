//! From smooth triangles to their corners, to the normals there, and from these to vertices.

use ad::{Additive, Tangent, Vec3};
use glam::DVec3;

use super::chain::Chain;
use crate::number::Plain;
use crate::primal::coalesce::Coalesced;
use crate::primal::lanes::sum_of_vectors;
use crate::primal::placed::normal_sums;
use crate::primal::wavefront::LaneGroup;
use crate::transport::camera::Ray;
use crate::transport::hit::Primitive;
use crate::transport::smooth::{
    SmoothPoint, curved_point, mean_normal, smooth_point, weighted_normal,
};
use crate::transport::surface::SurfacePoint;
use crate::transport::triangle::Triangle;

impl<L: Plain> Chain<'_, L> {
    /// Pulls the cotangents of points of smooth triangles, and of the normals of the flat ones, back;
    /// returns those of the triangles and of the rays.
    pub(super) fn pull_smooth_surface(
        &mut self,
        group: &LaneGroup<L>,
        surface: Tangent<SurfacePoint<L>>,
        outward: Vec3<L>,
    ) -> (Tangent<Primitive<L>>, Tangent<Ray<L>>) {
        let integrator = self.integrator;
        let triangle = integrator.triangle(&group.primitives);
        let normals = integrator.corner_normals(&group.primitives);
        let (_, pullback) = smooth_point::vjp::<L>(triangle, normals, group.ray);
        let (triangle, normals, ray) = pullback(Tangent::<SmoothPoint<L>> { surface, outward });
        self.scatter_normals(&group.primitives, normals);
        let mut primitive = Tangent::<Primitive<L>>::zero();
        primitive.Triangle.0 = triangle;
        (primitive, ray)
    }

    /// Pulls the cotangents of where the shadow rays of a group start back to smooth triangles; returns those of
    /// the points of the group.
    pub(super) fn pull_shadow_origin(&mut self, group: &LaneGroup<L>, origin: Vec3<L>) -> Vec3<L> {
        let Some(SmoothPoint { surface, outward }) = group.bent_points() else { return origin };
        if !group.is_smooth || !self.scatter.request.moves_surfaces() {
            return origin;
        }
        let triangle = self.integrator.triangle(&group.primitives);
        let normals = self.integrator.corner_normals(&group.primitives);
        let (_, pullback) = curved_point::vjp::<L>(triangle, normals, surface.point, outward);
        let (triangle, normals, point, _) = pullback(origin);
        self.scatter_normals(&group.primitives, normals);
        let mut primitive = Tangent::<Primitive<L>>::zero();
        primitive.Triangle.0 = triangle;
        self.scatter_primitive(group.kind, &group.primitives, &primitive);
        point
    }

    /// Adds the cotangents of the normals of the corners of triangles.
    fn scatter_normals(&mut self, primitives: &Coalesced, corners: [Vec3<L>; 3]) {
        if self.scatter.request.normals.is_empty() {
            return;
        }
        for (triangle, lanes) in primitives.iter() {
            let mask = L::mask_from_bits(lanes);
            let indices = self.integrator.layout.normals.of(triangle).into_iter().flatten();
            for (normal, &corner) in indices.zip(&corners) {
                self.scatter.normal(normal as usize, sum_of_vectors::<L>(corner, mask));
            }
        }
    }
}

/// From the normals of a mesh that follow its vertices to these: calls `to_vertex` with the cotangents.
pub fn pull_normals(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    normals: &[[f64; 3]],
    mut to_vertex: impl FnMut(u32, DVec3),
) {
    let sums = normal_sums::<f64>(vertices, triangles).into_iter().zip(normals);
    let to_sums = sums.map(|(sum, &normal)| {
        let (_, pullback) = mean_normal::vjp::<f64>(sum);
        pullback(normal.into())
    });
    let to_sums: Vec<DVec3> = to_sums.collect();
    for corners in triangles {
        let normal: DVec3 = corners.iter().map(|&vertex| to_sums[vertex as usize]).sum();
        // Most triangles of a large mesh are not in the image.
        if normal == DVec3::ZERO {
            continue;
        }
        let [a, b, c] = corners.map(|vertex| vertices[vertex as usize]);
        let (_, pullback) = weighted_normal::vjp::<f64>(Triangle { a, b, c });
        let triangle: Tangent<Triangle<f64>> = pullback(normal);
        for (&vertex, corner) in corners.iter().zip([triangle.a, triangle.b, triangle.c]) {
            to_vertex(vertex, corner);
        }
    }
}
