//! From what transparent surfaces leave of a light to these surfaces, to the light, and to the points
//! that it reaches.

use ad::{Additive, Tangent, Vec3};

use super::chain::Chain;
use crate::number::Plain;
use crate::primal::coalesce::select_lanes;
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::LaneGroup;
use crate::primal::wavefront::Occluder;
use crate::scene::Slot;
use crate::transport::camera::Ray;
use crate::transport::direct::attenuate;
use crate::transport::hit::{hit, surface_uv};
use crate::transport::illumination::Illumination;
use crate::transport::material::Material;
use crate::transport::surface::SurfacePoint;
use crate::transport::texture::modulate_opacity;

impl<L: Plain> Chain<'_, L> {
    /// Pulls the cotangent of the transmittance between a light and the points of a group back; returns
    /// that of the points.
    pub(super) fn pull_transmission(
        &mut self,
        vertex: &Vertex<'_, L>,
        light: usize,
        mut transmittance: L,
    ) -> Vec3<L> {
        let mut to_points = Vec3::<L>::zero();
        for occluder in vertex.occluders(light).iter().rev() {
            let (_, pullback) = attenuate::vjp::<L>(occluder.before, occluder.opacity);
            let (before, opacity) = pullback(transmittance);
            let zero = L::zero();
            let opacity = select_lanes::<L, L>(occluder.lanes, &opacity, &zero);
            transmittance = select_lanes::<L, L>(occluder.lanes, &before, &transmittance);
            to_points.accumulate(self.pull_opacity(vertex.group, light, occluder, opacity));
        }
        to_points
    }

    /// Pulls the cotangent of the opacity of surfaces where the light of a group goes through them back;
    /// returns that of the points of the group.
    fn pull_opacity(
        &mut self,
        group: &LaneGroup<L>,
        light: usize,
        occluder: &Occluder<L>,
        cotangent: L,
    ) -> Vec3<L> {
        let integrator = self.integrator;
        let Occluder { lanes, primitives, kind, inside, .. } = occluder;
        let materials = integrator.materials(primitives);
        let plain = integrator.material(&materials).opacity;
        let mut of_material = Tangent::<Material<L>>::zero();
        let mut to_point = Vec3::<L>::zero();

        let ray = integrator.shadow_ray(light, group);
        let point = integrator.surface(*kind, primitives, *inside, ray).point;
        let corners = integrator.corner_uvs(*kind, primitives);
        let primitive = integrator.primitive(*kind, primitives);
        let is_textured = |material: usize| {
            integrator.layout.materials[material].textures.get(Slot::Opacity).is_some()
        };
        match primitive.filter(|_| materials.lanes_where(is_textured) != 0) {
            None => of_material.opacity = cotangent,
            Some(primitive) => {
                let (uv, to_place) = surface_uv::vjp::<L>(primitive, corners, point);
                let Some(lookup) = integrator.lookup(Slot::Opacity, *kind, &materials, uv) else {
                    return to_point;
                };
                let (_, pullback) = modulate_opacity::vjp::<L>(plain, lookup.footprint, uv);
                let (opacity, footprint, uv) = pullback(cotangent);
                of_material.opacity = opacity;
                self.scatter_texels(&lookup, *lanes, footprint.texels);

                let (mut of_primitive, corners, point) = to_place(uv);
                self.scatter_uvs(*kind, primitives, corners);
                let (_, pullback) = hit::vjp::<L>(primitive, L::mask(*inside), ray);
                let surface = Tangent::<SurfacePoint<L>> { point, ..Additive::zero() };
                let (of_hit, (), ray) = pullback(surface);
                let ray = select_lanes::<L, Tangent<Ray<L>>>(*lanes, &ray, &Additive::zero());
                of_primitive.accumulate(of_hit);
                self.scatter_primitive(*kind, primitives, &of_primitive);
                to_point = self.pull_shadow_ray(light, group, ray);
            }
        }
        self.scatter.materials::<L>(&materials, &of_material);
        to_point
    }

    /// Pulls the cotangents of the rays from the points of a group to a light back to the light; returns those
    /// of the points.
    pub(super) fn pull_shadow_ray(
        &mut self,
        light: usize,
        group: &LaneGroup<L>,
        ray: Tangent<Ray<L>>,
    ) -> Vec3<L> {
        let origin = self.integrator.shadow_origin(group);
        let mut to_origin = ray.origin;
        let illumination =
            Tangent::<Illumination<L>> { direction: ray.direction, ..Additive::zero() };
        let inputs = &self.integrator.inputs.lights[light];
        self.pull_illumination(light, inputs, (group, origin), illumination, &mut to_origin);
        self.pull_shadow_origin(group, to_origin)
    }
}
