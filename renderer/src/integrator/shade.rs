//! How bright the pixels of a group are, and what their cotangents say of the scene.

use ad::lanes::Lanes;
use ad::{Additive, Tangent, Vec3, select};

use super::shadows::Lit;
use super::view::Group;
use crate::kernels::light::{DistantLightTangent, PointLightTangent};
use crate::kernels::material::{Material, reflection_of_distant_light, reflection_of_point_light};
use crate::kernels::surface::SurfacePoint;
use crate::scene::Light;

/// The cotangent of a light of either kind.
pub(super) enum LightCotangent<L: Lanes> {
    Point(PointLightTangent<L>),
    Distant(DistantLightTangent<L>),
}

/// The radiance of the pixels of a group; `lit` says which pixels each light reaches.
pub(super) fn radiance<L: Lanes>(group: &Group<L>, lights: &[Light<f64>], lit: &[Lit]) -> Vec3<L> {
    let Group { material, surface, .. } = group;
    let mut total = material.ambient;
    for (light, &lit) in lights.iter().zip(lit) {
        let reflected: Vec3<L> = match light {
            Light::Point(light) => {
                reflection_of_point_light::<L>(*material, *surface, light.narrow())
            }
            Light::Distant(light) => {
                reflection_of_distant_light::<L>(*material, *surface, light.narrow())
            }
        };
        total = total + select(lit.of(group), reflected, Additive::zero());
    }
    total
}

/// Pulls the cotangent of [`radiance`] back to material and surface; the cotangent of each light
/// goes to `to_light`, with its index.
#[allow(clippy::type_complexity)]
pub(super) fn pull_back<L: Lanes>(
    group: &Group<L>,
    lights: &[Light<f64>],
    lit: &[Lit],
    cotangent: Vec3<L>,
    mut to_light: impl FnMut(usize, LightCotangent<L>),
) -> (Tangent<Material<L>>, Tangent<SurfacePoint<L>>) {
    let mut to_material = <Tangent<Material<L>>>::zero();
    let mut to_surface = <Tangent<SurfacePoint<L>>>::zero();
    to_material.ambient = cotangent;
    for (index, (light, &lit)) in lights.iter().zip(lit).enumerate() {
        let cotangent: Vec3<L> = select(lit.of(group), cotangent, Additive::zero());
        let (material, surface) = match light {
            Light::Point(light) => {
                let (_, pullback) = reflection_of_point_light::vjp::<L>(
                    group.material,
                    group.surface,
                    light.narrow(),
                );
                let (material, surface, light) = pullback(cotangent);
                to_light(index, LightCotangent::Point(light));
                (material, surface)
            }
            Light::Distant(light) => {
                let (_, pullback) = reflection_of_distant_light::vjp::<L>(
                    group.material,
                    group.surface,
                    light.narrow(),
                );
                let (material, surface, light) = pullback(cotangent);
                to_light(index, LightCotangent::Distant(light));
                (material, surface)
            }
        };
        to_material.accumulate(material);
        to_surface.accumulate(surface);
    }
    (to_material, to_surface)
}
