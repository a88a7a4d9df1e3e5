//! From what transparent surfaces leave of a light to these surfaces, to the light, and to the points that
//! it reaches.

use ad::Vec3;
use ad::lanes::Lanes;
use glam::DVec3;

use super::{PixelLoss, Sweep};
use crate::integrator::crossings::{Crossed, Crossing, OpacityTexels};
use crate::integrator::view::{Group, View};
use crate::kernels::camera::{Ray, RayTangent};
use crate::kernels::light::{IlluminationTangent, ray_along, ray_to_position};
use crate::kernels::texture::{
    Uv, UvTangent, bilinear, sphere_crossing, triangle_crossing, varied_opacity,
};
use crate::precision::{MOST_LANES, lanes_of_vectors, numbers_of_lanes, vectors_of_lanes};
use crate::scene::Light;

impl<L: Lanes, P: PixelLoss> Sweep<'_, L, P> {
    /// Pulls the cotangent of what is left of a light in the lanes of a group back; returns that of the
    /// points.
    pub(super) fn pull_passed(
        &mut self,
        view: &View<L>,
        group: &Group<L>,
        light: usize,
        cotangent: L,
    ) -> Vec3<L> {
        let cotangents = numbers_of_lanes(cotangent);
        let points = vectors_of_lanes::<L>(group.surface.point);
        let mut to_points = [DVec3::ZERO; MOST_LANES];
        for (lane, ray) in group.rays() {
            let passed = &view.passed[light];
            for (i, (crossing, _)) in passed.crossed(ray).enumerate() {
                let others = passed.crossed(ray).enumerate().filter(|&(j, _)| j != i);
                let left: f64 = others.map(|(_, (_, left))| left).product();
                let to_opacity = -cotangents[lane] * left;
                to_points[lane] += self.pull_crossing(light, points[lane], crossing, to_opacity);
            }
        }
        lanes_of_vectors::<L>(&to_points)
    }

    /// Pulls the cotangent of the opacity back that a surface has between a point and a light; returns
    /// that of the point.
    fn pull_crossing(
        &mut self,
        light: usize,
        point: DVec3,
        crossing: Crossing,
        cotangent: f64,
    ) -> DVec3 {
        let prepared = self.prepared;
        let Some((index, plain)) = prepared.opacity_of(crossing) else { return DVec3::ZERO };
        let Some(texture) = prepared.opacity_texture(crossing) else {
            self.sums.opacities[index] += cotangent;
            return DVec3::ZERO;
        };
        let ray = Ray { origin: point, direction: prepared.towards_light(light, point).0 };
        let to_ray = match prepared.crossed_primitive(crossing) {
            Crossed::Triangle([a, b, c], places) => {
                let (uv, pullback) = triangle_crossing::vjp::<f64>(ray, a, b, c, places);
                let to_uv = self.pull_varied_opacity((index, plain), texture, uv, cotangent);
                let (ray, a, b, c, places) = pullback(to_uv);
                if self.wanted.vertices {
                    self.add_to_corners(crossing.primitive, [a, b, c]);
                }
                if self.wanted.texture_coordinates {
                    self.add_to_places(crossing.primitive, places);
                }
                ray
            }
            Crossed::Sphere(sphere) => {
                let (uv, pullback) = sphere_crossing::vjp::<f64>(ray, sphere, crossing.leaves);
                let to_uv = self.pull_varied_opacity((index, plain), texture, uv, cotangent);
                let (ray, sphere, ()) = pullback(to_uv);
                if self.wanted.spheres {
                    let index = prepared.sphere_of(crossing.primitive);
                    self.spheres.add(&mut self.sums.spheres, index, sphere);
                }
                ray
            }
        };
        self.pull_ray_to_light(light, point, to_ray)
    }

    /// From an opacity with its texture to the opacity without, which comes with its index, and to texels;
    /// returns the cotangent of the place on the texture.
    fn pull_varied_opacity(
        &mut self,
        (index, plain): (usize, f64),
        texture: usize,
        uv: Uv<f64>,
        cotangent: f64,
    ) -> UvTangent<f64> {
        let OpacityTexels { indices, colors, width, height } =
            self.prepared.opacity_texels(texture, uv);
        let (color, to_texels) = bilinear::vjp::<f64>(colors, uv, width, height);
        let (_, to_color) = varied_opacity::vjp::<f64>(plain, color);
        let (plain, color) = to_color(cotangent);
        let (colors, uv, _, _) = to_texels(color);
        self.sums.opacities[index] += plain;
        if self.wanted.texels {
            for (texel, color) in indices.into_iter().zip(colors) {
                self.texels.add(&mut self.sums.texels, texel as usize, color);
            }
        }
        uv
    }

    /// Pulls the cotangent of the ray from a point to a light back to the light; returns that of the
    /// point.
    fn pull_ray_to_light(&mut self, light: usize, point: DVec3, to_ray: RayTangent<f64>) -> DVec3 {
        let Self { prepared, wanted, sums, .. } = self;
        let (place, to_point) = match prepared.lights.get(light) {
            Some(Light::Point(light)) => {
                let (_, pullback) = ray_to_position::vjp::<f64>(light.position, point);
                pullback(to_ray)
            }
            Some(Light::Distant(light)) => {
                let (_, pullback) = ray_along::vjp::<f64>(light.direction, point);
                pullback(to_ray)
            }
            None => {
                let index = light - prepared.lights.len();
                let cotangent =
                    IlluminationTangent { direction: to_ray.direction, irradiance: DVec3::ZERO };
                let to_point = prepared.scene.custom_lights[index].light.illumination_pullback(
                    &prepared.parameters.custom_lights[index],
                    point + prepared.middle,
                    cotangent,
                    &mut sums.custom_lights[index],
                );
                return to_ray.origin + to_point;
            }
        };
        if wanted.light_places {
            *sums.lights[light].place() += place;
        }
        to_point
    }
}
