//! Groups of smooth triangles.

use ad::vector::Vector;
use ad::{Fields, Vec3};

use super::coalesce::Coalesced;
use super::integrator::Integrator;
use super::wavefront::{Bent, LaneGroup};
use crate::number::{Number, primal_vector, splat_vector};
use crate::trace::bvh::rays;
use crate::transport::camera::Ray;
use crate::transport::smooth::{SmoothPoint, curved_point, next_ray_outward, smooth_point};
use crate::transport::surface::SurfacePoint;
use crate::transport::vertex::next_ray;

impl<S: Number> Integrator<'_, S> {
    /// A bit for each of the rays, all of which hit triangles, that hits a smooth one.
    #[inline]
    pub fn on_smooth(&self, primitives: &[u32], hits: u64) -> u64 {
        let normals = &self.layout.normals;
        if normals.is_empty() {
            return 0;
        }
        let is_smooth = |&ray: &usize| normals.of(primitives[ray] as usize).is_some();
        rays(hits).filter(is_smooth).fold(0, |bits, ray| bits | 1 << ray)
    }

    /// The points where rays meet smooth triangles.
    pub fn smooth_surface(
        &self,
        primitives: &Coalesced,
        ray: Ray<S>,
    ) -> (SurfacePoint<S>, Bent<S>) {
        let (triangle, normals) = (self.triangle(primitives), self.corner_normals(primitives));
        let SmoothPoint { surface, outward } = smooth_point::<S>(triangle, normals, ray);
        let curved = curved_point::<S::Lanes>(
            triangle.map(S::primal),
            normals.map(primal_vector::<S>),
            primal_vector::<S>(surface.point),
            primal_vector::<S>(outward),
        );
        (surface, Bent { outward, curved })
    }

    /// Where the shadow rays of a group start.
    pub fn shadow_origin(&self, group: &LaneGroup<S>) -> Vec3<S> {
        match group.bent_points() {
            Some(SmoothPoint { surface, outward }) if group.is_smooth => {
                let triangle = self.triangle(&group.primitives);
                let normals = self.corner_normals(&group.primitives);
                curved_point::<S>(triangle, normals, surface.point, outward)
            }
            _ => group.surface.point,
        }
    }

    /// The normals of the corners of smooth triangles.
    pub fn corner_normals(&self, primitives: &Coalesced) -> [Vec3<S>; 3] {
        let normal = |index: u32| splat_vector::<S>(self.inputs.normals[index as usize]);
        primitives.gather::<S, [Vec3<S>; 3]>(|triangle| {
            let corners = self.layout.normals.of(triangle);
            corners.map_or([Vec3::<S>::splat(S::ZERO); 3], |corners| corners.map(normal))
        })
    }
}

impl<S: Number> LaneGroup<S> {
    /// The points, if they have other shading normals than those of flat triangles.
    #[inline]
    pub fn bent_points(&self) -> Option<SmoothPoint<S>> {
        let bent = self.bent.as_ref()?;
        Some(SmoothPoint { surface: self.surface, outward: bent.outward })
    }

    /// The rays that go on from the surface points: straight on in the lanes that are `transparent`,
    /// mirrored in the others.
    pub fn next_rays(&self, transparent: u32) -> Ray<S> {
        let transparent = S::mask(transparent);
        match self.bent_points() {
            None => next_ray::<S>(self.surface, transparent),
            Some(point) => next_ray_outward::<S>(point, transparent),
        }
    }
}
