//! The light that goes through transparent surfaces.
//!
//! Every surface on the way leaves `1 - d` of it, where `d` is its opacity at the place where the
//! light goes through. What shadow rays meet is looked for a second time, one by one, where the
//! tree said that there is something: a scene without transparent materials is rendered as if there
//! were none. How far light goes through is not limited by the depth of the scene. The places are
//! computed in double precision, whatever the lanes are.

use ad::lanes::Lanes;
use ad::{Real, Scalar};
use glam::DVec3;

use super::mirrors::{Dark, blocks};
use super::prepared::Prepared;
use super::shadows::Lit;
use super::view::{Group, View};
use crate::acceleration::PACKET_RAYS;
use crate::counts::count;
use crate::kernels::camera::Ray;
use crate::kernels::sphere::Sphere;
use crate::kernels::texture::{
    Uv, bilinear, sphere_crossing, texel_position, triangle_crossing, varied_opacity,
};
use crate::precision::{vectors_of_lanes, widen};
use crate::scene::Light;

/// A transparent surface on the way from a point to a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crossing {
    /// The index of the primitive: of a triangle, counted through all meshes, then of a sphere.
    pub primitive: usize,
    /// For a sphere: whether the way to the light leaves it there.
    pub leaves: bool,
}

/// What transparent surfaces leave of a light, by ray of a view.
pub(super) struct Passed<L: Lanes> {
    /// The part that is left, in vectors of lanes; 1 where nothing is in the way.
    weights: Vec<L>,
    /// A ray, a surface that its light goes through, and the part that this one leaves; ray by ray.
    crossings: Vec<(usize, Crossing, f64)>,
}

impl<L: Lanes> Passed<L> {
    fn nothing() -> Self {
        Self { weights: vec![L::ONE; blocks::<L>()], crossings: Vec::new() }
    }

    /// What is left in the lanes of a group.
    pub fn weight(&self, group: &Group<L>) -> L {
        self.weights[group.first / L::COUNT]
    }

    /// The surfaces that the light of a ray goes through, and the part that each leaves.
    pub fn crossed(&self, ray: usize) -> impl Iterator<Item = (Crossing, f64)> {
        let crossings = self.crossings.iter().filter(move |(of, ..)| *of == ray);
        crossings.map(|&(_, crossing, left)| (crossing, left))
    }

    /// Whether the light of a ray of a group goes through anything.
    pub fn concerns(&self, group: &Group<L>) -> bool {
        self.crossings.iter().any(|(ray, ..)| group.rays().any(|(_, of_group)| of_group == *ray))
    }
}

/// The texels of an opacity around a place.
pub(super) struct OpacityTexels {
    /// Among those of all textures.
    pub indices: [u32; 4],
    pub colors: [DVec3; 4],
    pub width: f64,
    pub height: f64,
}

/// A primitive as light goes through it: the places on textures are those of the corners.
pub(super) enum Crossed {
    Triangle([DVec3; 3], [Uv<f64>; 3]),
    Sphere(Sphere<f64>),
}

impl<L: Lanes> Prepared<'_, L> {
    /// Adds to what lights reach of a view what they reach through transparent surfaces.
    pub(super) fn light_through(&self, dark: Dark, view: &mut View<L>) {
        view.passed.clear();
        if !self.has_transparency {
            return;
        }
        for index in 0..view.lit.len() {
            let is_black = self.lights.get(index).is_some_and(Light::is_black);
            let mut reached = view.lit[index];
            let mut passed = Passed::nothing();
            if !is_black || dark.lights {
                self.light_through_to(index, view, &mut reached, &mut passed);
            }
            view.lit[index] = reached;
            view.passed.push(passed);
        }
    }

    /// [`light_through`](Self::light_through) of one light.
    fn light_through_to(
        &self,
        light: usize,
        view: &View<L>,
        reached: &mut Lit,
        passed: &mut Passed<L>,
    ) {
        let mut left = [1.0; PACKET_RAYS];
        for group in &view.groups {
            let points = vectors_of_lanes::<L>(group.surface.point);
            let normals = vectors_of_lanes::<L>(group.surface.normal);
            let origins = group.origins();
            for (lane, ray) in group.rays().filter(|&(_, ray)| !view.lit[light].reaches(ray)) {
                let (direction, distance) = self.towards_light(light, points[lane]);
                if normals[lane].dot(direction) <= 0.0 {
                    continue;
                }
                count(|counts| &counts.shadow_rays, 1);
                let from = group.start(view, ray);
                let to_light = Ray { origin: points[lane], direction };
                let (origin, direction) = (origins[lane].as_vec3(), direction.as_vec3());
                let Some(crossed) = self.crossed(origin, direction, distance as f32, from) else {
                    continue;
                };
                for crossing in crossed {
                    let part = 1.0 - self.opacity_at(to_light, crossing);
                    left[ray] *= part;
                    passed.crossings.push((ray, crossing, part));
                }
                reached.add(ray);
            }
        }
        for (block, weights) in passed.weights.iter_mut().enumerate() {
            let weight = |lane: usize| L::Element::from_f64(left[block * L::COUNT + lane]);
            *weights = L::from_lanes(weight);
        }
    }

    /// What a ray meets before `limit`, but for `from`; nothing if any of it is opaque.
    fn crossed(
        &self,
        origin: glam::Vec3,
        direction: glam::Vec3,
        limit: f32,
        from: Option<u32>,
    ) -> Option<Vec<Crossing>> {
        if self.is_behind_custom_shape(origin, direction, limit) {
            return None;
        }
        let (mut crossed, mut is_blocked) = (Vec::new(), false);
        self.acceleration.visit_met(origin, direction, limit, from, |primitive, leaves| {
            let primitive = primitive as usize;
            is_blocked = self.is_opaque(self.material_of[primitive] as usize);
            crossed.push(Crossing { primitive, leaves });
            !is_blocked
        });
        (!is_blocked).then_some(crossed)
    }

    /// The opacity of a surface where a ray goes through it.
    fn opacity_at(&self, ray: Ray<f64>, crossing: Crossing) -> f64 {
        let Some((_, opacity)) = self.opacity_of(crossing) else { return 1.0 };
        let Some(texture) = self.opacity_texture(crossing) else { return opacity };
        count(|counts| &counts.texture_lookups, 1);
        let uv = match self.crossed_primitive(crossing) {
            Crossed::Triangle([a, b, c], uv) => triangle_crossing::<f64>(ray, a, b, c, uv),
            Crossed::Sphere(sphere) => sphere_crossing::<f64>(ray, sphere, crossing.leaves),
        };
        let OpacityTexels { colors, width, height, .. } = self.opacity_texels(texture, uv);
        varied_opacity::<f64>(opacity, bilinear::<f64>(colors, uv, width, height))
    }

    /// The opacity of the material of a surface, with its index.
    pub(super) fn opacity_of(&self, crossing: Crossing) -> Option<(usize, f64)> {
        let material = self.material_of[crossing.primitive] as usize;
        let index = self.scene.materials[material].opacity? as usize;
        Some((index, self.parameters.opacities[index]))
    }

    /// The index of the texture that varies it.
    pub(super) fn opacity_texture(&self, crossing: Crossing) -> Option<usize> {
        let material = self.material_of[crossing.primitive] as usize;
        self.scene.materials[material].textures.opacity.map(|index| index as usize)
    }

    pub(super) fn crossed_primitive(&self, crossing: Crossing) -> Crossed {
        let Some(corners) = self.triangles.get(crossing.primitive) else {
            let sphere = &self.spheres[self.sphere_of(crossing.primitive)];
            return Crossed::Sphere(Sphere {
                center: widen::<L::Element>(sphere.center),
                radius: sphere.radius.to_f64(),
            });
        };
        let corner = |vertex: u32| widen::<L::Element>(self.vertices[vertex as usize]);
        let uv = match self.uv_triangles[crossing.primitive] {
            Some(corners) => corners.map(|corner| {
                let Uv { u, v } = self.uvs[corner as usize];
                Uv { u: u.to_f64(), v: v.to_f64() }
            }),
            None => [Uv { u: 0.0, v: 0.0 }; 3],
        };
        Crossed::Triangle(corners.map(corner), uv)
    }

    pub(super) fn opacity_texels(&self, texture: usize, uv: Uv<f64>) -> OpacityTexels {
        let texture = &self.textures[texture];
        let (width, height) = (f64::from(texture.width), f64::from(texture.height));
        let (x, y) = texel_position::<f64>(uv, width, height);
        let indices = texture.around(x, y);
        let colors = indices.map(|index| widen::<L::Element>(self.texels[index as usize]));
        OpacityTexels { indices, colors, width, height }
    }
}
