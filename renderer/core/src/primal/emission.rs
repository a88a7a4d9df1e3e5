//! What is seen of the emission of surfaces, which textures and opacities vary.

use ad::{Fields, Vec3};
use glam::DVec3;

use super::coalesce::Coalesced;
use super::inputs::Inputs;
use super::integrator::Integrator;
use super::lanes::{numbers_of_lanes, vectors_of_lanes};
use super::scattered::EmitterPoints;
use super::vertex::Textured;
use crate::number::{Number, primal_vector, splat_vector};
use crate::scene::Slot;
use crate::trace::layout::{Kind, Layout, TextureLayout};
use crate::transport::emitter::{seen_emission, uv_of_sight};
use crate::transport::material::Material;
use crate::transport::sphere::sphere_uv;
use crate::transport::texture::{Footprint, Uv, modulate, modulate_opacity, texel_position};
use crate::transport::triangle::interpolated_uv;

/// What varies the emission of points that shine.
pub struct VariedEmission<S: Number> {
    /// The lanes by material.
    pub materials: Coalesced,
    /// The materials, with the textures of their emission and opacity.
    pub material: Material<S>,
    pub textured: Option<Box<Textured<S>>>,
}

impl<S: Number> VariedEmission<S> {
    /// The radiance that is seen of the points.
    fn radiance(&self) -> Vec3<S> {
        seen_emission::<S>(self.material.emission, self.material.opacity)
    }
}

impl<S: Number> Integrator<'_, S> {
    /// The radiance of points of surfaces that shine, which are seen from points in directions at distances.
    pub fn emission(
        &self,
        points: &EmitterPoints<S::Lanes>,
        from: Vec3<S>,
        seen: (Vec3<S>, S),
    ) -> Vec3<S> {
        match self.varied_emission(points, from, seen) {
            Some(varied) => varied.radiance(),
            None => self.materials(&points.primitives).gather::<S, Vec3<S>>(|material| {
                splat_vector::<S>(self.inputs.materials[material].emission)
            }),
        }
    }

    /// What varies it; nothing if it is that of the materials.
    pub fn varied_emission(
        &self,
        points: &EmitterPoints<S::Lanes>,
        from: Vec3<S>,
        (direction, distance): (Vec3<S>, S),
    ) -> Option<VariedEmission<S>> {
        let EmitterPoints { kind, primitives, at, .. } = points;
        let materials = self.materials(primitives);
        if materials.lanes_where(|material| self.layout.materials[material].varies_emission()) == 0
        {
            return None;
        }
        let mut material = self.material(&materials);
        let uv = || {
            let primitive = self.primitive(*kind, primitives)?;
            let corners = self.corner_uvs(*kind, primitives);
            let at = at.map(S::constant);
            Some(uv_of_sight::<S>(primitive, corners, at, direction, distance, from))
        };
        let textured = self.textured(&Slot::OF_EMISSION, (*kind, &materials), uv, &mut material);
        Some(VariedEmission { materials, material, textured })
    }
}

impl<S: Number> Inputs<S> {
    /// The part that is seen of the emission of the material of a primitive, at a point that `at` chooses: barycentric
    /// coordinates, or the direction from the centre of a sphere.
    pub fn seen_part(&self, layout: &Layout, primitive: usize, at: [f64; 3]) -> DVec3 {
        let textures = layout.traits_of(primitive).textures;
        let material = layout.material_of[primitive] as usize;
        let opacity = number::<S>(self.materials[material].opacity);
        if !textures.any_of(&Slot::OF_EMISSION) {
            return DVec3::splat(opacity);
        }
        let (kind, index) = layout.kind_of(primitive);
        let uv = match kind {
            Kind::Sphere => {
                let sphere = self.spheres[index].map(number::<S>);
                let on_sphere = sphere.center + DVec3::from(at) * sphere.radius;
                sphere_uv::<f64>(sphere, on_sphere)
            }
            Kind::Triangle | Kind::Custom => {
                let none = [Uv { u: 0.0, v: 0.0 }; 3];
                let uv = |corner: u32| self.uvs[corner as usize].map(number::<S>);
                let corners = layout.uvs.of(index).map_or(none, |corners| corners.map(uv));
                interpolated_uv::<f64>(corners, at)
            }
        };
        let footprint = |slot: Slot| {
            let texture = textures.get(slot)? as usize;
            Some(self.footprint((texture, layout.textures[texture].on(kind)), uv))
        };
        let emission = footprint(Slot::Emission)
            .map_or(DVec3::ONE, |footprint| modulate::<f64>(DVec3::ONE, footprint, uv));
        let opacity = footprint(Slot::Opacity)
            .map_or(opacity, |footprint| modulate_opacity::<f64>(opacity, footprint, uv));
        seen_emission::<f64>(emission, opacity)
    }

    /// The texels of a texture around a point.
    fn footprint(
        &self,
        (texture, of_texture): (usize, TextureLayout),
        uv: Uv<f64>,
    ) -> Footprint<f64> {
        let (width, height) = (f64::from(of_texture.width), f64::from(of_texture.height));
        let (x, y) = texel_position::<f64>(uv, width, height);
        let texels = of_texture.around(x, y).map(|index| {
            let texel = self.texels[texture].at(index as usize - of_texture.first_texel);
            vectors_of_lanes::<S::Lanes>(primal_vector::<S>(splat_vector::<S>(texel)))[0]
        });
        Footprint { texels, width, height }
    }
}

/// The value of a number of the scene.
fn number<S: Number>(number: S::Lane) -> f64 {
    numbers_of_lanes::<S::Lanes>(S::splat(number).primal())[0]
}
