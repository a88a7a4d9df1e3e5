//! From surface points to primitives and rays.

use ad::lanes::Lanes;
use ad::{Additive, Tangent, Vec3};
use glam::DVec3;

use super::flow::{Flow, ToSurface};
use super::{PixelLoss, Sweep};
use crate::counts::count;
use crate::integrator::mirrors::pull_next_ray;
use crate::integrator::view::{Group, Shape, View};
use crate::kernels::camera::Ray;
use crate::kernels::sphere::{Sphere, sphere_surface};
use crate::kernels::surface::SurfacePoint;
use crate::kernels::texture::{Uv, UvTangent, sphere_uv, triangle_uv};
use crate::kernels::triangle::triangle_surface;
use crate::precision::sum_of_vectors;

impl<L: Lanes, P: PixelLoss> Sweep<'_, L, P> {
    /// From the surface points of a view to its primitives, and to its rays, whose cotangents
    /// `to_ray` takes. `beyond` is what flows back from the rays that go on.
    #[inline]
    pub(super) fn pull_surfaces(
        &mut self,
        view: &View<L>,
        beyond: Option<&Flow<L>>,
        surfaces: &[Option<ToSurface<L>>],
        mut to_ray: impl FnMut(&Group<L>, Tangent<Ray<L>>),
    ) {
        for (group, surface) in view.groups.iter().zip(surfaces) {
            let Some(ToSurface { mut surface, uv }) = *surface else { continue };
            count(|counts| &counts.surface_pullbacks, u64::from(group.alive.count_ones()));
            if let Some(flow) = beyond {
                let transparent = self.prepared.transparent_among(&self.prepared.materials(group));
                let cotangent = flow.rays[group.first / L::COUNT];
                surface.accumulate(pull_next_ray(group, transparent, cotangent));
            }
            to_ray(group, self.pull_surface(group, surface, uv));
        }
    }

    /// Pulls the cotangents of surface points, and of their places on textures, back to primitives;
    /// returns that of the rays.
    #[inline]
    fn pull_surface(
        &mut self,
        group: &Group<L>,
        mut surface: Tangent<SurfacePoint<L>>,
        uv: Option<Tangent<Uv<L>>>,
    ) -> Tangent<Ray<L>> {
        let prepared = self.prepared;
        match group.shape {
            Shape::Triangles => {
                let corners @ [a, b, c] = prepared.corners(&group.primitives);
                let mut to_corners = [Vec3::<L>::zero(); 3];
                if let Some(uv) = uv {
                    let (to_point, corners) = self.pull_uv(group, corners, uv);
                    surface.point.accumulate(to_point);
                    to_corners = corners;
                }
                let (_, pullback) = triangle_surface::vjp::<L>(group.ray, a, b, c);
                let (ray, a, b, c) = pullback(surface);
                to_corners.accumulate([a, b, c]);
                if self.wanted.vertices {
                    for (triangle, lanes) in group.primitives.iter() {
                        let mask = L::mask_from_bits(lanes);
                        let sums = to_corners.map(|corner| sum_of_vectors::<L>(corner, mask));
                        self.add_to_corners(triangle, sums);
                    }
                }
                ray
            }
            Shape::Custom => prepared.pull_custom_surface(group, surface, &mut self.sums.shapes),
            Shape::Spheres(leaves) => {
                let spheres = prepared.spheres(&group.primitives);
                let mut to_sphere = Tangent::<Sphere<L>>::zero();
                if let Some(uv) = uv {
                    let (_, pullback) = sphere_uv::vjp::<L>(group.surface.point, spheres);
                    let (point, sphere) = pullback(uv);
                    surface.point.accumulate(point);
                    to_sphere = sphere;
                }
                let Self { prepared, wanted, sums, .. } = self;
                let (_, pullback) = sphere_surface::vjp::<L>(group.ray, spheres, leaves);
                let (ray, sphere, ()) = pullback(surface);
                to_sphere.accumulate(sphere);
                if wanted.spheres {
                    for (primitive, lanes) in group.primitives.iter() {
                        let sum = to_sphere.sum(L::mask_from_bits(lanes));
                        let index = prepared.sphere_of(primitive);
                        self.spheres.add(&mut sums.spheres, index, sum);
                    }
                }
                ray
            }
        }
    }

    /// Pulls the cotangent of places on textures back to texture coordinates; returns those of the
    /// surface points and of the corners of their triangles.
    fn pull_uv(
        &mut self,
        group: &Group<L>,
        [a, b, c]: [Vec3<L>; 3],
        cotangent: Tangent<Uv<L>>,
    ) -> (Vec3<L>, [Vec3<L>; 3]) {
        let corners = self.prepared.uv_of_corners(&group.primitives);
        let (_, pullback) = triangle_uv::vjp::<L>(group.surface.point, a, b, c, corners);
        let (point, a, b, c, corners) = pullback(cotangent);
        if self.wanted.texture_coordinates {
            for (triangle, lanes) in group.primitives.iter() {
                let mask = L::mask_from_bits(lanes);
                self.add_to_places(triangle, corners.map(|corner| corner.sum(mask)));
            }
        }
        (point, [a, b, c])
    }

    /// Adds the cotangents of the corners of a triangle to those of vertices.
    #[inline]
    pub(super) fn add_to_corners(&mut self, triangle: usize, corners: [DVec3; 3]) {
        for (vertex, corner) in self.prepared.triangles[triangle].into_iter().zip(corners) {
            self.vertices.add(&mut self.sums.vertices, vertex as usize, corner);
        }
    }

    /// Adds the cotangents of the places on textures of the corners of a triangle.
    #[inline]
    pub(super) fn add_to_places(&mut self, triangle: usize, places: [UvTangent<f64>; 3]) {
        let indices = self.prepared.uv_triangles[triangle].into_iter().flatten();
        for (uv, place) in indices.zip(places) {
            self.uvs.add(&mut self.sums.uvs, uv as usize, place);
        }
    }
}
