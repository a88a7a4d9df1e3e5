//! How bright the pixels of a group are, and what their cotangents say of the scene.

use ad::lanes::Lanes;
use ad::{Additive, Tangent, Vec3, select};

use super::shadows::Lit;
use super::view::Group;
use crate::kernels::light::{DistantLight, DistantLightTangent, PointLight, PointLightTangent};
use crate::kernels::material::{Material, reflection_of_distant_light, reflection_of_point_light};
use crate::kernels::surface::SurfacePoint;
use crate::scene::Light;

/// The cotangent of a light of either kind.
#[derive(Clone, Copy)]
pub(super) enum LightCotangent<L: Lanes> {
    Point(PointLightTangent<L>),
    Distant(DistantLightTangent<L>),
}

/// The cotangents of what a group shows.
pub(super) struct Pulled<L: Lanes> {
    pub material: Tangent<Material<L>>,
    pub surface: Tangent<SurfacePoint<L>>,
}

/// A light of one kind, as it is reflected.
trait Reflected<L: Lanes> {
    fn reflect(&self, group: &Group<L>) -> Vec3<L>;

    /// With the pullback to the group and the light.
    fn reflect_vjp(
        &self,
        group: &Group<L>,
    ) -> (Vec3<L>, impl FnOnce(Vec3<L>) -> (Pulled<L>, LightCotangent<L>));
}

macro_rules! reflected {
    ($($light:ident, $kernel:ident, $variant:ident;)*) => {$(
        impl<L: Lanes> Reflected<L> for $light<f64> {
            #[inline]
            fn reflect(&self, group: &Group<L>) -> Vec3<L> {
                $kernel::<L>(group.material, group.surface, self.narrow())
            }

            #[inline]
            fn reflect_vjp(
                &self,
                group: &Group<L>,
            ) -> (Vec3<L>, impl FnOnce(Vec3<L>) -> (Pulled<L>, LightCotangent<L>)) {
                let (value, pullback) =
                    $kernel::vjp::<L>(group.material, group.surface, self.narrow());
                let pullback = move |cotangent| {
                    let (material, surface, light) = pullback(cotangent);
                    (Pulled { material, surface }, LightCotangent::$variant(light))
                };
                (value, pullback)
            }
        }
    )*};
}

reflected! {
    PointLight, reflection_of_point_light, Point;
    DistantLight, reflection_of_distant_light, Distant;
}

/// The radiance of the pixels of a group; `lit` says which rays each light reaches.
#[inline]
pub(super) fn radiance<L: Lanes>(group: &Group<L>, lights: &[Light<f64>], lit: &[Lit]) -> Vec3<L> {
    let mut total = group.material.ambient;
    for (light, lit) in lights.iter().zip(lit) {
        let reflected: Vec3<L> = match light {
            Light::Point(light) => light.reflect(group),
            Light::Distant(light) => light.reflect(group),
        };
        total = total + select(lit.of(group), reflected, Additive::zero());
    }
    total
}

/// [`radiance`], and the pullback of the cotangent that `respond` gives for it, if any. The
/// cotangent of each light goes to `to_light`, with its index.
///
/// Of the last light, mostly the only one, the pullback is kept while `respond` is asked; that of
/// the others is computed afterwards, because there is no saying how many there are.
#[inline]
pub(super) fn shade_and_pull_back<L: Lanes>(
    group: &Group<L>,
    lights: &[Light<f64>],
    lit: &[Lit],
    respond: impl FnOnce(Vec3<L>) -> Option<Vec3<L>>,
    to_light: impl FnMut(usize, LightCotangent<L>),
) -> Option<Pulled<L>> {
    let (Some((last, lights)), Some((last_lit, lit))) = (lights.split_last(), lit.split_last())
    else {
        let cotangent = respond(group.material.ambient)?;
        let mut pulled = Pulled::zero();
        pulled.material.ambient = cotangent;
        return Some(pulled);
    };
    let others = Others { group, lights, lit };
    match last {
        Light::Point(last) => others.with_last(last, *last_lit, respond, to_light),
        Light::Distant(last) => others.with_last(last, *last_lit, respond, to_light),
    }
}

/// All lights but the last.
struct Others<'a, L: Lanes> {
    group: &'a Group<L>,
    lights: &'a [Light<f64>],
    lit: &'a [Lit],
}

impl<L: Lanes> Others<'_, L> {
    #[inline]
    fn with_last(
        &self,
        last: &impl Reflected<L>,
        last_lit: Lit,
        respond: impl FnOnce(Vec3<L>) -> Option<Vec3<L>>,
        mut to_light: impl FnMut(usize, LightCotangent<L>),
    ) -> Option<Pulled<L>> {
        let &Self { group, lights, lit } = self;
        let masked = |lit: Lit, value: Vec3<L>| -> Vec3<L> {
            select(lit.of(group), value, Additive::zero())
        };
        let (reflected, pullback) = last.reflect_vjp(group);
        let cotangent = respond(radiance(group, lights, lit) + masked(last_lit, reflected))?;
        let (mut pulled, light) = pullback(masked(last_lit, cotangent));
        to_light(lights.len(), light);
        pulled.material.ambient = cotangent;

        for (index, (light, &lit)) in lights.iter().zip(lit).enumerate() {
            let cotangent = masked(lit, cotangent);
            let (other, light) = match light {
                Light::Point(light) => light.reflect_vjp(group).1(cotangent),
                Light::Distant(light) => light.reflect_vjp(group).1(cotangent),
            };
            pulled.material.accumulate(other.material);
            pulled.surface.accumulate(other.surface);
            to_light(index, light);
        }
        Some(pulled)
    }
}

impl<L: Lanes> Pulled<L> {
    fn zero() -> Self {
        Self { material: Additive::zero(), surface: Additive::zero() }
    }
}
