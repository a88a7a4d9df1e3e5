//! From surface points back to primitives and rays: the second walk along paths.

use ad::{Additive, Tangent, Vec3};
use glam::DVec3;

use super::chain::{AdjointState, Chain, SurfaceCotangent};
use crate::counts::count;
use crate::number::Plain;
use crate::primal::coalesce::{Coalesced, select_lanes};
use crate::primal::lanes::{sum_of_lanes, sum_of_vectors};
use crate::primal::wavefront::{LaneGroup, Wavefront};
use crate::scene::Transform;
use crate::trace::layout::Kind;
use crate::transport::camera::{CameraFrame, Ray, primary_ray};
use crate::transport::hit::{Primitive, hit, surface_uv};
use crate::transport::smooth::{SmoothPoint, next_ray_outward};
use crate::transport::surface::SurfacePoint;
use crate::transport::texture::Uv;
use crate::transport::transform::place;
use crate::transport::vertex::next_ray;

impl<L: Plain> Chain<'_, L> {
    /// From the surface points of all wavefronts, the deepest first, to primitives and to the camera.
    pub(super) fn pull_rays(
        &mut self,
        wavefronts: &[Wavefront<L>],
        states: &mut [AdjointState<L>],
    ) {
        let mut to_frame = Tangent::<CameraFrame<L>>::zero();
        for depth in (0..wavefronts.len()).rev() {
            let (states, deeper) = states.split_at_mut(depth + 1);
            let AdjointState { rays, surfaces, grazing, .. } = &mut states[depth];
            let beyond = deeper.first().filter(|_| depth + 1 < wavefronts.len());
            let wavefront = &wavefronts[depth];
            for (group, surface) in wavefront.groups.iter().zip(surfaces) {
                let Some(SurfaceCotangent { mut surface, mut uv }) = *surface else { continue };
                count(|counts| &counts.surface_pullbacks, u64::from(group.alive.count_ones()));
                let mut outward = Vec3::<L>::zero();
                if let Some(state) = beyond {
                    let of_ray = select_lanes::<L, _>(
                        group.alive,
                        &state.rays[group.block()],
                        &Additive::zero(),
                    );
                    let of_point = match self.integrator.layout.path_tracing {
                        None => self.pull_next_ray(group, &of_ray, self.straight(group)),
                        Some(_) => self.pull_event(group, wavefront, &of_ray),
                    };
                    surface.accumulate(of_point.surface);
                    outward = of_point.outward;
                }
                let grazing = group.lanes_of(*grazing);
                if grazing != 0 {
                    surface = select_lanes::<L, _>(grazing, &Additive::zero(), &surface);
                    outward = select_lanes::<L, _>(grazing, &Additive::zero(), &outward);
                    uv = uv.map(|uv| select_lanes::<L, _>(grazing, &Additive::zero(), &uv));
                }
                let film = (depth == 0).then(|| wavefront.film[group.block()]);
                let ray = self.pull_surface(group, surface, outward, uv);
                if depth > 0 {
                    rays[group.block()].accumulate(ray);
                } else if let Some((x, y)) = film.filter(|_| self.scatter.request.camera) {
                    let frame = self.integrator.inputs.frame;
                    let (_, pullback) = primary_ray::vjp::<L>(frame, x, y);
                    to_frame.accumulate(pullback(ray).0);
                }
            }
            if let Some(packing) = &wavefront.scattering.packing {
                packing.unpack_blocks::<L, _>(rays);
            }
        }
        if self.scatter.request.camera {
            self.scatter.frame::<L>(&to_frame);
        }
    }

    /// The lanes of a group from which rays go straight on.
    fn straight(&self, group: &LaneGroup<L>) -> L::Mask {
        let materials = self.integrator.materials(&group.primitives);
        L::mask(self.integrator.transparent_lanes(&materials))
    }

    /// From the rays that go on from a group, `straight` or mirrored, to its surface points, and to the normals
    /// of flat triangles where these are smooth.
    pub(super) fn pull_next_ray(
        &self,
        group: &LaneGroup<L>,
        ray: &Tangent<Ray<L>>,
        straight: L::Mask,
    ) -> Tangent<SmoothPoint<L>> {
        match group.bent_points() {
            None => {
                let (_, pullback) = next_ray::vjp::<L>(group.surface, straight);
                Tangent::<SmoothPoint<L>> { surface: pullback(*ray).0, ..Additive::zero() }
            }
            Some(point) => {
                let (_, pullback) = next_ray_outward::vjp::<L>(point, straight);
                pullback(*ray).0
            }
        }
    }

    /// Pulls the cotangents of surface points, and of their texture coordinates, back to primitives;
    /// returns that of the rays.
    #[inline]
    fn pull_surface(
        &mut self,
        group: &LaneGroup<L>,
        mut surface: Tangent<SurfacePoint<L>>,
        outward: Vec3<L>,
        mut uv: Option<Tangent<Uv<L>>>,
    ) -> Tangent<Ray<L>> {
        let LaneGroup { kind, primitives, inside, ray, .. } = group;
        let Some(primitive) = self.integrator.primitive(*kind, primitives) else {
            return self.pull_custom_surface(group, surface);
        };
        let of_normal = group.mapped.as_ref().map(|mapped| {
            let (triangle, of_uv) = self.pull_mapped_normal(group, mapped, &mut surface);
            uv.get_or_insert_with(Additive::zero).accumulate(of_uv);
            triangle
        });
        let of_uv = uv.map(|uv| {
            let (primitive, point) = self.pull_uv(group, primitive, uv);
            surface.point.accumulate(point);
            primitive
        });
        let (mut primitive, ray) = if group.is_smooth {
            self.pull_smooth_surface(group, surface, outward)
        } else {
            let (_, pullback) = hit::vjp::<L>(primitive, L::mask(*inside), *ray);
            let (primitive, (), ray) = pullback(surface);
            (primitive, ray)
        };
        if let Some(of_uv) = of_uv {
            primitive.accumulate(of_uv);
        }
        if let Some(of_normal) = of_normal {
            primitive.Triangle.0.accumulate(of_normal);
        }
        self.scatter_primitive(group.kind, primitives, &primitive);
        ray
    }

    /// Pulls the cotangents of the texture coordinates of surface points back to those of corners; returns
    /// those of the primitives and of the points.
    pub(super) fn pull_uv(
        &mut self,
        group: &LaneGroup<L>,
        primitive: Primitive<L>,
        uv: Tangent<Uv<L>>,
    ) -> (Tangent<Primitive<L>>, Vec3<L>) {
        let corners = self.integrator.corner_uvs(group.kind, &group.primitives);
        let (_, pullback) = surface_uv::vjp::<L>(primitive, corners, group.surface.point);
        let (primitive, corners, point) = pullback(uv);
        self.scatter_uvs(group.kind, &group.primitives, corners);
        (primitive, point)
    }

    /// Adds the cotangents of the texture coordinates of the corners of triangles.
    pub(super) fn scatter_uvs(
        &mut self,
        kind: Kind,
        primitives: &Coalesced,
        corners: [Tangent<Uv<L>>; 3],
    ) {
        if kind != Kind::Triangle || self.scatter.request.uvs.is_empty() {
            return;
        }
        for (triangle, lanes) in primitives.iter() {
            let mask = L::mask_from_bits(lanes);
            let indices = self.integrator.layout.uvs.of(triangle).into_iter().flatten();
            for (uv, corner) in indices.zip(&corners) {
                let sum = |x: L| sum_of_lanes::<L>(x, mask);
                self.scatter.uv(uv as usize, [sum(corner.u), sum(corner.v)]);
            }
        }
    }

    /// Adds the cotangents of primitives.
    #[inline]
    pub(super) fn scatter_primitive(
        &mut self,
        kind: Kind,
        primitives: &Coalesced,
        cotangent: &Tangent<Primitive<L>>,
    ) {
        match kind {
            Kind::Triangle => {
                let triangle = &cotangent.Triangle.0;
                let corners = [triangle.a, triangle.b, triangle.c];
                for (triangle, lanes) in primitives.iter() {
                    let mask = L::mask_from_bits(lanes);
                    self.scatter_corners(triangle, |corner| {
                        sum_of_vectors::<L>(corners[corner], mask)
                    });
                }
            }
            Kind::Sphere => {
                for (primitive, lanes) in primitives.iter() {
                    let (_, index) = self.integrator.layout.kind_of(primitive);
                    self.scatter.sphere::<L>(index, lanes, &cotangent.Sphere.0);
                }
            }
            Kind::Custom => {}
        }
    }

    /// Adds the cotangents of the corners of a triangle to those of vertices or of the transform of its
    /// mesh.
    #[inline]
    fn scatter_corners(&mut self, triangle: usize, cotangent: impl Fn(usize) -> DVec3) {
        let request = self.scatter.request;
        if request.vertices.is_empty() && !request.moves_transforms() {
            return;
        }
        for (corner, vertex) in self.integrator.layout.triangles[triangle].into_iter().enumerate() {
            self.scatter_vertex(vertex, cotangent(corner));
        }
    }

    /// Adds the cotangent of a vertex in the world to that of the vertex or of the transform of its mesh.
    #[inline]
    pub(super) fn scatter_vertex(&mut self, vertex: u32, cotangent: DVec3) {
        self.scatter.vertex(vertex as usize, cotangent);
        if !self.scatter.request.moves_transforms() {
            return;
        }
        let layout = self.integrator.layout;
        let mesh = layout.mesh_of_vertex(vertex);
        let Some(to) = self.scatter.request.transforms[mesh] else { return };
        let (first, mesh) = (layout.first_vertices[mesh], &self.scene.meshes[mesh]);
        let own = DVec3::from(mesh.vertices[(vertex - first) as usize]);
        let (_, pullback) = place::vjp::<f64>(mesh.transform, own);
        let (transform, _): (Tangent<Transform<f64>>, _) = pullback(cotangent);
        self.scatter.dense_sum(to, &transform);
    }

    /// Pulls the cotangents of the points of custom shapes back to their numbers; returns that of
    /// the rays.
    fn pull_custom_surface(
        &mut self,
        group: &LaneGroup<L>,
        surface: Tangent<SurfacePoint<L>>,
    ) -> Tangent<Ray<L>> {
        let integrator = self.integrator;
        let mut to_ray = Tangent::<Ray<L>>::zero();
        for (primitive, lanes) in group.primitives.iter() {
            let (_, index) = integrator.layout.kind_of(primitive);
            let shape = &integrator.inputs.shapes[index];
            let ray = self.scatter.shape(index, shape.numbers.len(), lanes, |to_number| {
                shape.pull_point(group.ray, surface, to_number)
            });
            to_ray = select_lanes::<L, _>(lanes, &ray, &to_ray);
        }
        to_ray
    }
}
