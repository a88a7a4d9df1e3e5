//! How bright the pixels of a group are, and what their cotangents say of the scene.

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Additive, Tangent, Vec3, select};

use super::crossings::Passed;
use super::prepared::Prepared;
use super::settings::Pass;
use super::shadows::Lit;
use super::sharing::Sharing;
use super::textures::Textured;
use super::transparency::{Cover, PulledCover};
use super::view::{Group, View};
use crate::counts::count;
use crate::kernels::light::{
    DistantLight, DistantLightTangent, Illumination, PointLight, PointLightTangent,
    distant_illumination, point_illumination,
};
use crate::kernels::material::{
    Material, matte_reflection, reflection, reflection_of_distant_light, reflection_of_point_light,
};
use crate::kernels::surface::SurfacePoint;
use crate::scene::Light;

/// The cotangent of a light of either kind.
#[derive(Clone, Copy)]
pub(super) enum LightCotangent<'a, L: Lanes> {
    Point(&'a PointLightTangent<L>),
    Distant(&'a DistantLightTangent<L>),
}

/// The cotangents of what a group shows. They are large: they stay where pullbacks leave them, and
/// references to them go round.
pub(super) struct Pulled<'a, L: Lanes> {
    pub material: &'a mut Tangent<Material<L>>,
    pub surface: &'a mut Tangent<SurfacePoint<L>>,
}

/// The cotangents of what is seen in mirrors, but for what is behind transparent surfaces.
pub(super) struct PulledMirror<L: Lanes> {
    /// Of the materials' reflection.
    pub reflection: Vec3<L>,
    /// Of the radiance from the mirror direction.
    pub radiance: Vec3<L>,
}

/// What a group is made of, and what comes from lights that users add.
pub(super) struct Appearance<'a, L: Lanes> {
    /// The lanes by material.
    pub materials: &'a Sharing,
    pub textured: Option<Textured<L>>,
    /// If a surface is transparent.
    pub cover: Option<Cover<L>>,
    illuminations: Vec<Illumination<L>>,
}

impl<L: Lanes> Prepared<'_, L> {
    #[inline]
    pub(super) fn appearance<'a>(
        &self,
        group: &Group<L>,
        materials: &'a Sharing,
    ) -> Appearance<'a, L> {
        let textured = self.textured(group, materials);
        Appearance {
            materials,
            cover: self.cover(materials, textured.as_ref()),
            textured,
            illuminations: self.custom_illuminations(group),
        }
    }
}

/// A group under its lights.
pub(super) struct Shaded<'a, L: Lanes> {
    pass: Pass,
    group: &'a Group<L>,
    material: Material<L>,
    /// Whether no material of the group has a highlight.
    matte: bool,
    lights: &'a [Light<L>],
    /// What comes from lights that users add.
    illuminations: &'a [Illumination<L>],
    /// The rays that each light reaches, those of users last.
    lit: &'a [Lit],
    /// What transparent surfaces leave of each light; empty if there are none.
    passed: &'a [Passed<L>],
    cover: Option<Cover<L>>,
    /// The radiance from where rays go on, from the mirror direction or from behind, where it was
    /// traced.
    beyond: Option<&'a Vec3<L>>,
}

impl<'a, L: Lanes> Shaded<'a, L> {
    pub fn new(
        prepared: &'a Prepared<'_, L>,
        group: &'a Group<L>,
        appearance: &'a Appearance<'_, L>,
        view: &'a View<L>,
        beyond: Option<&'a View<L>>,
    ) -> Self {
        let &Appearance { materials, ref textured, cover, ref illuminations } = appearance;
        count(|counts| &counts.shaded, u64::from(group.alive.count_ones()));
        Self {
            pass: prepared.pass,
            group,
            material: match textured {
                Some(textured) => textured.material(),
                None => prepared.material(materials),
            },
            illuminations,
            matte: materials.iter().all(|(material, _)| prepared.is_matte(material)),
            lights: &prepared.shining,
            lit: &view.lit,
            passed: &view.passed,
            cover,
            beyond: beyond.map(|view| &view.radiance[group.first / L::COUNT]),
        }
    }

    /// The radiance of the pixels.
    #[inline(always)]
    pub fn radiance(&self) -> Vec3<L> {
        self.seen(self.radiance_by(self.lights))
    }

    /// The radiance of the pixels whose surfaces show `own`, with what is seen through them.
    #[inline(always)]
    pub fn seen(&self, own: Vec3<L>) -> Vec3<L> {
        match &self.cover {
            None => own,
            Some(cover) => cover.seen(own, self.beyond.copied().unwrap_or(Additive::zero())),
        }
    }

    /// Pulls the cotangent of [`seen`](Self::seen) back, to that of `own` and to the rest.
    #[inline(always)]
    pub fn pull_back_seen(
        &self,
        own: Vec3<L>,
        cotangent: Vec3<L>,
    ) -> (Vec3<L>, Option<PulledCover<L>>) {
        match &self.cover {
            None => (cotangent, None),
            Some(cover) => {
                let behind = self.beyond.copied().unwrap_or(Additive::zero());
                let (own, pulled) = cover.pull_back(own, behind, cotangent);
                (own, Some(pulled))
            }
        }
    }

    /// The radiance of the surfaces themselves under the first of the lights alone.
    // A call would move more than it computes: 3 % of an image.
    #[inline(always)]
    fn radiance_by(&self, lights: &[Light<L>]) -> Vec3<L> {
        let mut total = self.own_radiance();
        for (index, light) in lights.iter().enumerate() {
            let reflected = match light {
                Light::Point(light) => light.reflect(self),
                Light::Distant(light) => light.reflect(self),
            };
            total = total + self.where_lit(index, reflected);
        }
        total
    }

    /// What shows without any light.
    #[inline]
    fn own_radiance(&self) -> Vec3<L> {
        if self.pass == Pass::Albedo {
            return self.material.diffuse;
        }
        let mut total = self.material.ambient;
        if let Some(mirrored) = self.beyond {
            total = total + self.material.reflection * *mirrored;
        }
        for (index, &illumination) in self.illuminations.iter().enumerate() {
            let reflected = reflection::<L>(self.material, self.group.surface, illumination);
            total = total + self.where_lit(self.lights.len() + index, reflected);
        }
        total
    }

    /// Pulls the cotangent of [`own_radiance`](Self::own_radiance) back to the colour that shows.
    /// To mirrors and lights that users add it flows apart: where a scene has none, that costs
    /// nothing.
    #[inline]
    fn pull_back_own(&self, cotangent: Vec3<L>, material: &mut Tangent<Material<L>>) {
        let shown = match self.pass {
            Pass::Albedo => &mut material.diffuse,
            Pass::Radiance => &mut material.ambient,
        };
        shown.accumulate(cotangent);
    }

    /// Pulls the cotangent of the radiance back to what is seen in mirrors, where the rays that they
    /// send on were traced.
    pub fn pull_back_mirror(&self, cotangent: Vec3<L>) -> Option<PulledMirror<L>> {
        let mirrored = self.beyond.filter(|_| self.pass == Pass::Radiance);
        mirrored.map(|&mirrored| PulledMirror {
            reflection: cotangent * mirrored,
            radiance: cotangent * self.material.reflection,
        })
    }

    /// Pulls the cotangent of the radiance back to what comes from lights that users add, and adds to
    /// the rest.
    pub fn pull_back_custom_lights(
        &self,
        cotangent: Vec3<L>,
        pulled: &mut Pulled<'_, L>,
        mut to_light: impl FnMut(usize, Tangent<Illumination<L>>) -> Vec3<L>,
    ) {
        for (index, &illumination) in self.illuminations.iter().enumerate() {
            let (_, pullback) =
                reflection::vjp::<L>(self.material, self.group.surface, illumination);
            let cotangent = self.where_lit(self.lights.len() + index, cotangent);
            let (material, surface, illumination) = pullback(cotangent);
            pulled.material.accumulate(material);
            pulled.surface.accumulate(surface);
            pulled.surface.point.accumulate(to_light(index, illumination));
        }
    }

    /// Pulls the cotangent of the radiance of the surfaces themselves back to what transparent surfaces
    /// leave of each light, by its index.
    pub fn pull_back_passed(&self, cotangent: Vec3<L>, mut to_passed: impl FnMut(usize, L)) {
        for (index, passed) in self.passed.iter().enumerate() {
            if !passed.concerns(self.group) {
                continue;
            }
            let reflected = match self.lights.get(index) {
                Some(Light::Point(light)) => light.reflect(self),
                Some(Light::Distant(light)) => light.reflect(self),
                None => {
                    let illumination = self.illuminations[index - self.lights.len()];
                    reflection::<L>(self.material, self.group.surface, illumination)
                }
            };
            to_passed(index, cotangent.dot(reflected));
        }
    }

    /// Pulls the cotangent back that `respond` gives for the radiance of the surfaces themselves, of
    /// which [`seen`](Self::seen) is what the pixels show, if any: that
    /// of each light goes to `to_light`, with its index, the rest to `to_shown`.
    ///
    /// Of the last light, mostly the only one, the pullback is kept while `respond` is asked; that
    /// of the others is computed afterwards, because there is no saying how many there are.
    #[inline]
    pub fn pull_back(
        &self,
        respond: impl FnOnce(Vec3<L>) -> Option<Vec3<L>>,
        to_light: impl FnMut(usize, LightCotangent<'_, L>),
        to_shown: impl FnOnce(Vec3<L>, Pulled<'_, L>),
    ) {
        match self.lights.last() {
            Some(Light::Point(last)) => self.pull_back_from(last, respond, to_light, to_shown),
            Some(Light::Distant(last)) => self.pull_back_from(last, respond, to_light, to_shown),
            None => {
                if let Some(cotangent) = respond(self.own_radiance()) {
                    let (mut material, mut surface) = (Additive::zero(), Additive::zero());
                    self.pull_back_own(cotangent, &mut material);
                    let pulled = Pulled { material: &mut material, surface: &mut surface };
                    to_shown(cotangent, pulled);
                }
            }
        }
    }

    #[inline]
    fn pull_back_from<K: Reflected<L>>(
        &self,
        last: &K,
        respond: impl FnOnce(Vec3<L>) -> Option<Vec3<L>>,
        mut to_light: impl FnMut(usize, LightCotangent<'_, L>),
        to_shown: impl FnOnce(Vec3<L>, Pulled<'_, L>),
    ) {
        let index = self.lights.len() - 1;
        let others = &self.lights[..index];
        let (reflected, pullback) = last.reflect_vjp(self);
        let radiance = self.radiance_by(others) + self.where_lit(index, reflected);
        let Some(cotangent) = respond(radiance) else { return };
        let mut cotangents = pullback(self.where_lit(index, cotangent));
        let (mut pulled, light) = K::parts(&mut cotangents);
        self.pull_back_own(cotangent, pulled.material);
        to_light(index, light);

        for (index, light) in others.iter().enumerate() {
            let cotangent = self.where_lit(index, cotangent);
            let to_light = |light: LightCotangent<'_, L>| to_light(index, light);
            match light {
                Light::Point(light) => self.pull_back_to(light, cotangent, &mut pulled, to_light),
                Light::Distant(light) => self.pull_back_to(light, cotangent, &mut pulled, to_light),
            }
        }
        to_shown(cotangent, pulled);
    }

    /// Adds what flows back through one more light.
    fn pull_back_to<K: Reflected<L>>(
        &self,
        light: &K,
        cotangent: Vec3<L>,
        pulled: &mut Pulled<'_, L>,
        to_light: impl FnOnce(LightCotangent<'_, L>),
    ) {
        let mut cotangents = light.reflect_vjp(self).1(cotangent);
        let (Pulled { material, surface }, light) = K::parts(&mut cotangents);
        pulled.material.accumulate(*material);
        pulled.surface.accumulate(*surface);
        to_light(light);
    }

    /// `value` where a light, those of users last, reaches the surface, times what is left of it there.
    #[inline]
    fn where_lit(&self, light: usize, value: Vec3<L>) -> Vec3<L> {
        let value = select(self.lit[light].of(self.group), value, Additive::zero());
        match self.passed.get(light) {
            None => value,
            Some(passed) => value * passed.weight(self.group),
        }
    }
}

/// A light of one kind, as it is reflected.
trait Reflected<L: Lanes> {
    /// What flows back to material, surface and light.
    type Cotangents;

    fn reflect(&self, shaded: &Shaded<'_, L>) -> Vec3<L>;

    fn reflect_vjp(
        &self,
        shaded: &Shaded<'_, L>,
    ) -> (Vec3<L>, impl FnOnce(Vec3<L>) -> Self::Cotangents);

    fn parts(cotangents: &mut Self::Cotangents) -> (Pulled<'_, L>, LightCotangent<'_, L>);
}

macro_rules! reflected {
    ($($light:ident, $tangent:ident, $kernel:ident, $illumination:expr, $variant:ident;)*) => {$(
        impl<L: Lanes> Reflected<L> for $light<L> {
            type Cotangents = (Tangent<Material<L>>, Tangent<SurfacePoint<L>>, $tangent<L>);

            #[inline]
            fn reflect(&self, shaded: &Shaded<'_, L>) -> Vec3<L> {
                let Shaded { material, group: &Group { surface, .. }, matte, .. } = *shaded;
                if matte {
                    let illumination = $illumination(*self, surface.point);
                    matte_reflection::<L>(material.diffuse, surface, illumination)
                } else {
                    $kernel::<L>(material, surface, *self)
                }
            }

            #[inline]
            fn reflect_vjp(
                &self,
                shaded: &Shaded<'_, L>,
            ) -> (Vec3<L>, impl FnOnce(Vec3<L>) -> Self::Cotangents) {
                $kernel::vjp::<L>(shaded.material, shaded.group.surface, *self)
            }

            #[inline]
            fn parts(
                (material, surface, light): &mut Self::Cotangents,
            ) -> (Pulled<'_, L>, LightCotangent<'_, L>) {
                (Pulled { material, surface }, LightCotangent::$variant(light))
            }
        }
    )*};
}

reflected! {
    PointLight, PointLightTangent, reflection_of_point_light, point_illumination::<L>, Point;
    DistantLight, DistantLightTangent, reflection_of_distant_light,
        |light, _| distant_illumination::<L>(light), Distant;
}
